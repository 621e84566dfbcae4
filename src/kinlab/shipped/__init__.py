"""Files that stand at the top of the repository and ship inside the wheel."""

from pathlib import Path


def shipped(name: str) -> Path:
    """The path of `robots.yaml` or `lessons`, in an installed wheel as well as in a checkout."""
    here = Path(__file__).parent
    inside = here / name
    return inside if inside.exists() else here.parents[2] / name
