"""A gait in characters: bars over the cycle, the feet from above, a margin over the cycle."""

from fractions import Fraction

import numpy as np

from kinlab.canvas import Canvas, Point
from kinlab.gait.schedule import Gait
from kinlab.gait.stability import Stability
from kinlab.gait.support import hull
from kinlab.kinematics.transforms import Array


def bars(gait: Gait, columns: int, *, ascii_only: bool = False) -> dict[str, str]:
    """For each leg one cycle, `columns` characters wide: blocks where it swings, dots where it stands.

    krsri-hexapod, figure 7. Events are rounded to a character; none disappears in a cycle of as many.
    """
    air, ground = ("#", ".") if ascii_only else ("█", "·")
    middles = [Fraction(2 * i + 1, 2 * columns) for i in range(columns)]
    return {leg: "".join(air if gait.swings(leg, at) else ground for at in middles) for leg in gait.legs}


def draw_support(state: Stability, *, columns: int = 36, rows: int = 14, ascii_only: bool = False) -> Canvas:
    """The feet of one frame from above, x up and y to the left: what stands, what swings, what they carry."""
    motion = state.motion
    legs = motion.walk.robot.legs
    feet = [_above(p) for p in motion.level]
    standing = np.repeat(state.down, len(state.contacts) // len(legs))
    corners = [_above(p) for p in hull(state.contacts[standing])] if standing.any() else []
    canvas = Canvas(columns, rows, [*feet, *[_above(p) for p in state.contacts]], ascii_only=ascii_only)
    for start, end in zip(corners, [*corners[1:], *corners[:1]], strict=True):
        canvas.line(start, end, "link0")
    down, up, centre = ("V", "o", "+") if ascii_only else ("■", "□", "✚")
    for foot, stands in zip(feet, state.down, strict=True):
        canvas.mark(foot, down if stands else up, "tip")
    canvas.mark(_above(state.centre), centre, "target")
    for leg, foot in zip(legs, feet, strict=True):
        canvas.label(foot, leg.name, "joint")
    return canvas


def _above(place: Array) -> Point:
    return -float(place[1]) * 1000, float(place[0]) * 1000
