"""Gaits over one cycle."""

from kinlab.gait.drawing import bars as draw_bars
from kinlab.lessons.robots import find_gait, load_robot


def bars(robot: str, gait: str, columns: int = 40, ascii_only: bool = False) -> str:
    """A line for each leg: blocks where it swings, dots where it stands."""
    width = 12 * max(1, min(columns - 4, 60) // 12)
    one = load_robot(robot)
    drawn = draw_bars(find_gait(one, gait), width, ascii_only=ascii_only)
    return "\n".join(f"{leg.name}  {drawn[leg.name]}" for leg in one.legs)
