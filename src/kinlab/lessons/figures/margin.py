"""What a robot stands on."""

from itertools import pairwise

import numpy as np

from kinlab.canvas import Canvas
from kinlab.lessons.answers.margin import feet


def tripod(robot: str, back: float, columns: int = 40, ascii_only: bool = False) -> Canvas:
    """The support triangle of one tripod from above, forwards up; the cross is the centre of mass."""
    places = {name: (-y, x) for name, (x, y) in feet(robot, back).items()}
    corners = list(places.values())
    canvas = Canvas(columns, 14, [*corners, (0.0, 0.0)], ascii_only=ascii_only)
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        canvas.line(start, end, "link0")
    for name, place in places.items():
        canvas.mark(place, "V" if ascii_only else "■", "tip")
        canvas.label(place, name, "joint")
    canvas.mark((0.0, 0.0), "+" if ascii_only else "✚", "target")
    return canvas


def tipping(distance: float, height: float, columns: int = 40, ascii_only: bool = False) -> Canvas:
    """The centre of mass over the ground from the side, the edge, and the arc on which it would rise."""
    radius = float(np.hypot(distance, height))
    start = float(np.arctan2(height, -distance))
    arc = [
        (distance + radius * float(np.cos(a)), radius * float(np.sin(a)))
        for a in np.linspace(start, np.pi / 2, 40)
    ]
    canvas = Canvas(columns, 12, [(-distance, 0.0), (2 * distance, 0.0), *arc], ascii_only=ascii_only)
    canvas.line((-distance, 0.0), (2 * distance, 0.0), "axis", dashed=True)
    for one, other in pairwise(arc):
        canvas.line(one, other, "link1")
    canvas.line((0.0, height), (distance, 0.0), "link0")
    canvas.mark((0.0, height), "+" if ascii_only else "✚", "target")
    canvas.mark((distance, 0.0), "V" if ascii_only else "■", "tip")
    return canvas
