"""Files that stand at the top of the repository and ship inside the wheel, and what may be installed besides."""

import shlex
import sys
from pathlib import Path

HERE = Path(__file__).parent


def shipped(name: str) -> Path:
    """The path of `robots.yaml` or `lessons`, in an installed wheel as well as in a checkout."""
    inside = HERE / name
    return inside if inside.exists() else HERE.parents[2] / name


def install_line(extra: str) -> str:
    """The command that adds an extra to the Python that runs: of this checkout, else of the installed KinLab."""
    checkout = HERE.parents[2]
    what = ["-e", f"{checkout}[{extra}]"] if (checkout / "pyproject.toml").is_file() else [f"kinlab[{extra}]"]
    return shlex.join([sys.executable, "-m", "pip", "install", *what])
