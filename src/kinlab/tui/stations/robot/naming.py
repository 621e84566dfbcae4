"""What joints and solutions are called."""

from collections.abc import Callable

Say = Callable[..., str]


def short(name: str, width: int) -> str:
    """A joint's name in as many characters: shoulder_pitch as sh.pitch."""
    if len(name) <= width or "_" not in name:
        return name[:width]
    first, _, rest = name.partition("_")
    return f"{first[:2]}.{rest}"[:width]


def solution_name(name: str, say: Say) -> str:
    """A solution by the core's own name; angles that a person gave, in the language of now."""
    return say("given") if name == "as given" else name
