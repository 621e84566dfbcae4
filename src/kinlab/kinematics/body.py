"""The body over fixed feet: where the feet are, seen from a body that has moved and turned."""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array, rpy_to_rotation


def feet_from_body(feet: ArrayLike, xyz: ArrayLike, rpy: ArrayLike) -> Array:
    """Feet that stay on the ground, in the frame of a body that moved by `xyz` and turned by `rpy`.

    p' = R^T (p - t), with R = Rz(yaw) Ry(pitch) Rx(roll).

    Args:
        feet: their places (..., legs, 3) in the body frame before, metres.
        xyz: the body's displacement (..., 3) in its old frame, metres.
        rpy: its roll, pitch and yaw (..., 3), rad.
    """
    feet, xyz = np.asarray(feet, float), np.asarray(xyz, float)
    return np.asarray((feet - xyz[..., None, :]) @ rpy_to_rotation(rpy))
