"""Serial chains of revolute joints: T = prod_i Rot(axis_i, q_i) Trans(link_i).

A chain is given by `axes` (n, 3), unit vectors, and `links` (n, 3), metres: joint i turns about
its axis, then its fixed link follows. Angles `q` are (..., n), in rad; leading dimensions broadcast.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.blocks import blocks
from kinlab.kinematics.columns import ZERO, Vector, add, turn
from kinlab.kinematics.transforms import Array, homogeneous, rotation


def fk(axes: ArrayLike, links: ArrayLike, q: ArrayLike) -> Array:
    """The pose of the tip in the chain's base frame, of shape (..., 4, 4)."""
    axes, links, q = np.asarray(axes, float), np.asarray(links, float), np.asarray(q, float)
    flat = q.reshape(-1, q.shape[-1])
    T = np.zeros((len(flat), 4, 4))
    T[:, 3, 3] = 1.0
    for rows in blocks(len(flat)):
        _fk_block(axes, links, flat[rows], T[rows])
    return T.reshape(*q.shape[:-1], 4, 4)


def _fk_block(axes: Array, links: Array, q: Array, out: Array) -> None:
    # From the tip to the base, the three columns of the rotation and the position are four vectors
    # that every joint turns alike. Component by component, so that numpy works on whole columns.
    vectors: list[Vector] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], ZERO]
    for i in reversed(range(len(axes))):
        sine, cosine = np.sin(q[:, i]), np.cos(q[:, i])
        vectors[3] = add(vectors[3], links[i].tolist())
        vectors = [turn(axes[i], sine, cosine, v) for v in vectors]
    for column, vector in enumerate(vectors):
        for row in range(3):
            out[:, row, column] = vector[row]


def frames(axes: ArrayLike, links: ArrayLike, q: ArrayLike) -> Array:
    """Every frame along the chain, of shape (..., n + 1, 4, 4): the base, then the end of each link."""
    axes, links, q = np.asarray(axes, float), np.asarray(links, float), np.asarray(q, float)
    count = len(axes)
    T = np.empty((*q.shape[:-1], count + 1, 4, 4))
    T[..., 0, :, :] = np.eye(4)
    for i in range(count):
        R = rotation(axes[i], q[..., i])
        step = homogeneous(R, R @ links[i])
        T[..., i + 1, :, :] = T[..., i, :, :] @ step
    return T


def jacobian(axes: ArrayLike, links: ArrayLike, q: ArrayLike) -> Array:
    """The geometric Jacobian of the tip in the base frame, (..., 6, n): linear rows (m/rad), then angular.

    Column i is (a x (p - o), a), with a the joint's axis and o its origin in the base frame.
    """
    axes = np.asarray(axes, float)
    T = frames(axes, links, q)
    origins = T[..., :-1, :3, 3]
    a = (T[..., :-1, :3, :3] @ axes[:, :, None])[..., 0]
    arms = T[..., -1:, :3, 3] - origins
    return np.concatenate([np.swapaxes(np.cross(a, arms), -1, -2), np.swapaxes(a, -1, -2)], axis=-2)


def position_hessian(axes: ArrayLike, links: ArrayLike, q: ArrayLike) -> Array:
    """Second derivatives of the tip's position, (..., 3, n, n), in m/rad^2.

    d2p / dq_i dq_j = a_i x (a_j x (p - o_j)) for i <= j, and symmetric.
    """
    axes = np.asarray(axes, float)
    T = frames(axes, links, q)
    a = (T[..., :-1, :3, :3] @ axes[:, :, None])[..., 0]
    linear = np.cross(a, T[..., -1:, :3, 3] - T[..., :-1, :3, 3])
    count = len(axes)
    H = np.empty((*linear.shape[:-2], 3, count, count))
    for i in range(count):
        for j in range(i, count):
            H[..., i, j] = H[..., j, i] = np.cross(a[..., i, :], linear[..., j, :])
    return H


def manipulability(J: ArrayLike) -> Array:
    """Yoshikawa's measure sqrt(det(A A^T)) of a Jacobian (..., m, n), for the smaller side where n < m.

    Yoshikawa 1985, Int. J. Robotics Research 4(2). Computed as the product of the singular values.
    """
    return np.asarray(np.prod(np.linalg.svd(np.asarray(J, float), compute_uv=False), axis=-1))
