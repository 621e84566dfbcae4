"""The three-joint arm of the receptionist robot: two crossed shoulder axes in one point, then the elbow.

Written in the axes of its paper: shoulder about z, then about y, upper arm along x, elbow about z,
forearm along x: p = Rz(q1) Ry(q2) (L1 + L2 cos(q3), L2 sin(q3), 0). (Equation 3.13 of the paper.)
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.leg import BOUNDARY
from kinlab.kinematics.transforms import Array, wrap

NAMES = ("elbow-in", "elbow-in, shoulder over", "elbow-out", "elbow-out, shoulder over")


def shoulder_arm_ik(tip: ArrayLike, upper: float, fore: float) -> tuple[Array, Array]:
    """All poses that bring the hand to `tip` (..., 3), in metres and the axes above.

    Returns:
        Angles (..., 4, 3) in rad, in the order of NAMES and NaN where unreachable, and the
        reachability (...). The arm's plane cannot turn further than the hand's distance X from the
        second axis allows, so that |z| <= |X| is a condition beside the two circles of the reach.
    """
    tip = np.asarray(tip, float)
    x, y, z = tip[..., 0], tip[..., 1], tip[..., 2]
    d2 = x * x + y * y + z * z
    stretch, fold = (upper + fore) ** 2 - d2, d2 - (upper - fore) ** 2
    slack = 2 * BOUNDARY
    within = (stretch >= -slack * (upper + fore)) & (fold >= -slack * abs(upper - fore))
    elbow = 2 * np.arctan2(np.sqrt(np.maximum(stretch, 0)), np.sqrt(np.maximum(fold, 0)))
    # X = L1 + L2 cos(q3), from the triangle: the hand's distance along the upper arm.
    X = (d2 + upper * upper - fore * fore) / (2 * upper)
    reachable = within & (np.abs(z) <= np.abs(X) + BOUNDARY)
    h = np.hypot(x, y)
    Y = np.minimum(fore * np.sin(elbow), h)
    elbow = np.arctan2(Y, X - upper)
    # The hand's distance from the plane of both axes follows from (h, Y) as well as from (X, z); the
    # pair of larger numbers leaves the smaller error in it.
    depth2 = np.where(np.abs(X) > Y, (h - Y) * (h + Y), (X - z) * (X + z))
    depth = np.sqrt(np.maximum(depth2, 0))
    solutions = []
    for side in (1.0, -1.0):
        for over in (1.0, -1.0):
            forward = over * np.where(X < 0, -1.0, 1.0) * depth
            swing = np.where(np.abs(X) < BOUNDARY, 0.0, np.arctan2(-z * np.sign(X), forward * np.sign(X)))
            shoulder = wrap(np.arctan2(y, x) - np.arctan2(side * Y, forward))
            solutions.append(np.stack([shoulder, swing, side * elbow], axis=-1))
    q = np.stack(solutions, axis=-2)
    q[~reachable] = np.nan
    return q, reachable
