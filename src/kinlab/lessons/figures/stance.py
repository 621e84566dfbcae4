"""Feet that stay while the body turns."""

import numpy as np

from kinlab.canvas import Canvas
from kinlab.kinematics.transforms import rpy_to_rotation
from kinlab.lessons.robots import load_robot


def turned(robot: str, yaw: float, columns: int = 40, ascii_only: bool = False) -> Canvas:
    """From above, forwards up: where each foot stands, and its leg from the hip of the turned body to it."""
    one = load_robot(robot)
    R = rpy_to_rotation(np.radians([0.0, 0.0, yaw]))
    hips = np.array([leg.mount[:3, 3] for leg in one.legs]) @ R.T * 1000
    feet = one.standing_feet * 1000
    points = [(-float(y), float(x)) for x, y, _ in [*hips, *feet]]
    canvas = Canvas(columns, 16, points, ascii_only=ascii_only)
    outline = points[: len(hips)]
    around = sorted(outline, key=lambda p: np.arctan2(p[1], p[0]))
    for start, end in zip(around, [*around[1:], around[0]], strict=True):
        canvas.line(start, end, "link0")
    for leg, hip, foot in zip(one.legs, outline, points[len(hips) :], strict=True):
        canvas.line(hip, foot, "link1")
        canvas.mark(foot, "V" if ascii_only else "■", "tip")
        canvas.label(foot, leg.name, "joint")
    ahead = R @ np.array([40.0, 0.0, 0.0])
    canvas.mark((-float(ahead[1]), float(ahead[0])), "^" if ascii_only else "▲", "target")
    return canvas
