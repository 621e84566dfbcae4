"""The three-joint leg in small pictures."""

import numpy as np

from kinlab.canvas import Canvas
from kinlab.lessons.robots import load_robot
from kinlab.robots.drawing import draw_limb


def side(
    robot: str,
    alpha: float,
    beta: float,
    gamma: float,
    limb: str = "",
    columns: int = 40,
    ascii_only: bool = False,
) -> Canvas:
    """The leg in its own plane, z up, its links named."""
    return _views(robot, limb, (alpha, beta, gamma), columns, ascii_only)[0]


def top(
    robot: str,
    alpha: float,
    beta: float,
    gamma: float,
    limb: str = "",
    columns: int = 40,
    ascii_only: bool = False,
) -> Canvas:
    """The leg from above, x to the right, y up."""
    return _views(robot, limb, (alpha, beta, gamma), columns, ascii_only)[1]


def _views(
    robot: str, limb: str, angles_deg: tuple[float, float, float], columns: int, ascii_only: bool
) -> tuple[Canvas, Canvas]:
    leg = load_robot(robot).limb(limb or None)
    return draw_limb(leg, np.radians(angles_deg), columns=columns, rows=12, ascii_only=ascii_only)
