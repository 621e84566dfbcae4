"""A foot in the air."""

import numpy as np

from kinlab.canvas import Canvas
from kinlab.gait import find_curve


def flight(
    stroke: float, lift: float, curve: str = "line-sine", columns: int = 40, ascii_only: bool = False
) -> Canvas:
    """The foot's way from the side, a mark at every tenth of the time."""
    shape = find_curve(curve)
    s = np.linspace(0.0, 1.0, 101)
    way, height = stroke * shape.along.value(s), lift * shape.height.value(s)
    canvas = Canvas(
        columns,
        10,
        [(0.0, 0.0), (stroke, 0.0), (0.0, lift), *zip(way, height, strict=True)],
        ascii_only=ascii_only,
    )
    canvas.line((0.0, 0.0), (stroke, 0.0), "axis", dashed=True)
    for i in range(100):
        canvas.line((way[i], height[i]), (way[i + 1], height[i + 1]), "link0")
    for i in range(0, 101, 10):
        canvas.mark((float(way[i]), float(height[i])), "o" if ascii_only else "●", "tip")
    return canvas
