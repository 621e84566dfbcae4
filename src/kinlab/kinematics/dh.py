"""Denavit-Hartenberg parameters, derived from a chain of axes and links, for those who think in them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array, homogeneous, inverse, rotation


class DH(NamedTuple):
    """Standard parameters, T_i = Rz(q_i + theta) Tz(d) Tx(a) Rx(alpha), metres and radians.

    Attributes:
        theta, d, a, alpha: of each joint (n,).
        base: from the base frame to the first DH frame (4, 4).
        tool: from the last DH frame to the tip (4, 4).
    """

    theta: Array
    d: Array
    a: Array
    alpha: Array
    base: Array
    tool: Array


def from_chain(axes: ArrayLike, links: ArrayLike) -> DH:
    """The standard DH parameters of a chain, by its common normals at the zero pose.

    Hartenberg and Denavit 1955; classic (distal) convention. Where neighbouring axes are parallel the
    normal through the joint's own origin is taken; where they meet, their cross product.
    """
    axes, links = np.asarray(axes, float), np.asarray(links, float)
    count = len(axes)
    T = chain.frames(axes, links, np.zeros(count))
    points = T[:, :3, 3]
    tip = T[-1, :3, 3]
    x = _perpendicular(axes[0], links[0])
    base = homogeneous(np.stack([x, np.cross(axes[0], x), axes[0]], axis=-1), points[0])
    current = base
    rows = []
    for i in range(count):
        z, origin = current[:3, 2], current[:3, 3]
        if i + 1 < count:
            z_next, point = axes[i + 1], points[i + 1]
        else:
            # The last frame stands in the tip, as far as one row of parameters can bring it there.
            z_next, point = z, tip
        normal = np.cross(z, z_next)
        if np.linalg.norm(normal) < 1e-9:
            across = point - origin - ((point - origin) @ z) * z
            x = across / np.linalg.norm(across) if np.linalg.norm(across) > 1e-12 else current[:3, 0]
            foot = point
            d = float((point - origin) @ z)
        else:
            x = normal / np.linalg.norm(normal)
            # Feet of the common normal on both axes.
            s, t, u = np.linalg.solve(np.stack([z, -z_next, x], axis=-1), point - origin)
            if u < 0:
                x, u = -x, -u
            foot, d = point + t * z_next, float(s)
        theta = _angle(current[:3, 0], x, z)
        a = float((foot - origin - d * z) @ x)
        alpha = _angle(z, z_next, x)
        rows.append((theta, d, a, alpha))
        current = homogeneous(np.stack([x, np.cross(z_next, x), z_next], axis=-1), foot)
    theta_, d_, a_, alpha_ = np.array(rows).T
    return DH(theta_, d_, a_, alpha_, base, inverse(current) @ T[-1])


def fk(dh: DH, q: ArrayLike) -> Array:
    """The pose of the tip (..., 4, 4) by the DH parameters, for angles `q` (..., n) in rad."""
    q = np.asarray(q, float)
    T = np.broadcast_to(dh.base, (*q.shape[:-1], 4, 4))
    for i in range(len(dh.a)):
        turn = homogeneous(rotation((0, 0, 1), q[..., i] + dh.theta[i]), np.zeros(3))
        rest = homogeneous(rotation((1, 0, 0), dh.alpha[i]), [dh.a[i], 0.0, dh.d[i]])
        T = T @ turn @ rest
    return np.asarray(T @ dh.tool)


def _perpendicular(z: Array, hint: Array) -> Array:
    for candidate in (hint, np.eye(3)[0], np.eye(3)[1]):
        across = candidate - (candidate @ z) * z
        if np.linalg.norm(across) > 1e-9:
            return np.asarray(across / np.linalg.norm(across))
    raise AssertionError("x and y cannot both lie along z")


def _angle(start: Array, end: Array, axis: Array) -> float:
    return float(np.arctan2(np.cross(start, end) @ axis, start @ end))
