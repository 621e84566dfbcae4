"""Rotations and homogeneous transforms, as functions of arrays that broadcast over leading dimensions."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[Any]


def rotation(axis: ArrayLike, angle: ArrayLike) -> Array:
    """The rotation by `angle` (rad, any shape) about the unit vector `axis`, of shape (..., 3, 3).

    Rodrigues' formula: R = I + sin(q) K + (1 - cos(q)) K K.
    """
    x, y, z = np.asarray(axis, dtype=float)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    q = np.asarray(angle, dtype=float)[..., None, None]
    return np.asarray(np.eye(3) + np.sin(q) * K + (1.0 - np.cos(q)) * (K @ K))


def rpy_to_rotation(rpy: ArrayLike) -> Array:
    """R = Rz(yaw) Ry(pitch) Rx(roll) for angles (..., 3) in rad, of shape (..., 3, 3)."""
    angles = np.asarray(rpy, dtype=float)
    cosines, sines = np.cos(angles), np.sin(angles)
    # One attitude is worked out in Python's floats, which numpy's scalars are ten times slower than.
    one = angles.ndim == 1
    cr, cp, cy = cosines.tolist() if one else np.moveaxis(cosines, -1, 0)
    sr, sp, sy = sines.tolist() if one else np.moveaxis(sines, -1, 0)
    R = np.empty((*angles.shape[:-1], 3, 3))
    R[..., 0, 0], R[..., 0, 1], R[..., 0, 2] = cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr
    R[..., 1, 0], R[..., 1, 1], R[..., 1, 2] = sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr
    R[..., 2, 0], R[..., 2, 1], R[..., 2, 2] = -sp, cp * sr, cp * cr
    return R


def rotation_to_rpy(R: ArrayLike) -> Array:
    """Roll, pitch, yaw (..., 3) of `R` (..., 3, 3), in rad; at pitch = +-90 deg the roll is taken as 0."""
    R = np.asarray(R, dtype=float)
    horizontal = np.hypot(R[..., 0, 0], R[..., 1, 0])
    gimbal = horizontal < 1e-12
    pitch = np.arctan2(-R[..., 2, 0], horizontal)
    yaw = np.where(gimbal, np.arctan2(-R[..., 0, 1], R[..., 1, 1]), np.arctan2(R[..., 1, 0], R[..., 0, 0]))
    # The roll with this very yaw taken out: near the gimbal both are ill-determined, and only angles
    # that belong together give the rotation back.
    sine, cosine = np.sin(yaw), np.cos(yaw)
    roll = np.arctan2(
        sine * R[..., 0, 2] - cosine * R[..., 1, 2], cosine * R[..., 1, 1] - sine * R[..., 0, 1]
    )
    return np.stack([roll, pitch, yaw], axis=-1)


def rotation_vector(R: ArrayLike) -> Array:
    """The axis times the angle (..., 3), in rad, of `R` (..., 3, 3); exact near 0 and near pi."""
    R = np.asarray(R, dtype=float)
    skew = np.stack(
        [R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]], axis=-1
    )
    sine = np.linalg.norm(skew, axis=-1) / 2
    cosine = (np.trace(R, axis1=-2, axis2=-1) - 1) / 2
    angle = np.arctan2(sine, cosine)
    # Towards half a turn the skew part vanishes, but the symmetric part, less cos I, is (1 - cos) a a^T.
    outer = (R + np.swapaxes(R, -1, -2)) / 2 - cosine[..., None, None] * np.eye(3)
    longest = np.argmax(np.einsum("...ii->...i", outer), axis=-1)
    column = np.take_along_axis(outer, longest[..., None, None], axis=-1)[..., 0]
    column *= np.where(np.sum(column * skew, axis=-1, keepdims=True) < 0, -1.0, 1.0)
    norm = np.linalg.norm(column, axis=-1)
    obtuse = np.divide(angle, norm, out=np.zeros_like(angle), where=norm > 0)[..., None] * column
    acute = np.divide(angle, 2 * sine, out=np.full_like(angle, 0.5), where=sine > 1e-9)[..., None] * skew
    return np.asarray(np.where(cosine[..., None] < 0, obtuse, acute))


def quaternion(vector: ArrayLike) -> Array:
    """The unit quaternion (..., 4), x y z w, of a rotation vector (..., 3): axis times angle, in rad."""
    vector = np.asarray(vector, dtype=float)
    half = np.linalg.norm(vector, axis=-1, keepdims=True) / 2
    return np.concatenate([vector / 2 * np.sinc(half / np.pi), np.cos(half)], axis=-1)


def homogeneous(R: ArrayLike, p: ArrayLike) -> Array:
    """The transform (..., 4, 4) with rotation `R` (..., 3, 3) and translation `p` (..., 3)."""
    R, p = np.asarray(R, dtype=float), np.asarray(p, dtype=float)
    lead = np.broadcast_shapes(R.shape[:-2], p.shape[:-1])
    T = np.zeros((*lead, 4, 4))
    T[..., :3, :3] = R
    T[..., :3, 3] = p
    T[..., 3, 3] = 1.0
    return T


def inverse(T: ArrayLike) -> Array:
    """The inverse of homogeneous transforms (..., 4, 4)."""
    T = np.asarray(T, dtype=float)
    Rt = np.swapaxes(T[..., :3, :3], -1, -2)
    return homogeneous(Rt, -(Rt @ T[..., :3, 3:])[..., 0])


def apply(T: ArrayLike, points: ArrayLike) -> Array:
    """Points (..., 3) carried by transforms `T` (..., 4, 4)."""
    T, points = np.asarray(T, dtype=float), np.asarray(points, dtype=float)
    return np.asarray((T[..., :3, :3] @ points[..., None])[..., 0] + T[..., :3, 3])


def wrap(angle: ArrayLike) -> Array:
    """Angles in rad, brought into (-pi, pi]."""
    angle = np.asarray(angle, dtype=float)
    return np.asarray(angle - 2 * np.pi * np.ceil((angle - np.pi) / (2 * np.pi)))
