"""The body over fixed feet: where the feet are, seen from a body that has moved and turned."""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array


def feet_from_body(feet: ArrayLike, xyz: ArrayLike, R: ArrayLike) -> Array:
    """Feet that stay on the ground, in the frame of a body that moved by `xyz` and turned by `R`.

    p' = R^T (p - t).

    Args:
        feet: their places (..., legs, 3) in the body frame before, metres.
        xyz: the body's displacement (..., 3) in its old frame, metres.
        R: its attitude (..., 3, 3) in that frame.
    """
    feet, xyz = np.asarray(feet, float), np.asarray(xyz, float)
    return np.asarray((feet - xyz[..., None, :]) @ np.asarray(R, float))
