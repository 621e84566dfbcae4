"""The three-joint leg: coxa about z, femur and tibia about -y, each link along x.

With angles (alpha, beta, gamma): r = c + f cos(beta) + t cos(beta + gamma), h = f sin(beta) +
t sin(beta + gamma), foot = (r cos(alpha), r sin(alpha), h). gamma < 0 is knee up.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.blocks import blocks
from kinlab.kinematics.transforms import Array

# A target this far (m) outside the workspace still counts as on its boundary: 1e-9 mm.
BOUNDARY = 1e-12


class LegAngles(NamedTuple):
    """Joint angles `q` (..., 3) in rad, NaN where not `reachable` (...)."""

    q: Array
    reachable: Array


def leg_fk(q: ArrayLike, coxa: float, femur: float, tibia: float) -> Array:
    """The foot (..., 3), in metres, for angles `q` (..., 3) in rad.

    >>> leg_fk([0.0, 0.0, 0.0], 0.025, 0.050, 0.070).round(3).tolist()
    [0.145, 0.0, 0.0]
    """
    q = np.asarray(q, float)
    flat = q.reshape(-1, 3)
    foot = np.empty_like(flat)
    for rows in blocks(len(flat)):
        alpha, beta, gamma = flat[rows].T.copy()
        gamma += beta
        r = np.cos(beta)
        r *= femur
        h = np.sin(beta, out=beta)
        h *= femur
        part = np.cos(gamma)
        part *= tibia
        r += part
        r += coxa
        np.sin(gamma, out=gamma)
        gamma *= tibia
        h += gamma
        block = foot[rows]
        block[:, 2] = h
        np.multiply(np.cos(alpha, out=part), r, out=block[:, 0])
        np.multiply(np.sin(alpha, out=alpha), r, out=block[:, 1])
    return foot.reshape(q.shape)


def leg_ik(
    foot: ArrayLike,
    coxa: float,
    femur: float,
    tibia: float,
    *,
    knee_up: bool = True,
    backwards: bool = False,
) -> LegAngles:
    """The one pose of the given kind that brings the foot to `foot` (..., 3), in metres.

    `backwards` turns the coxa away from the target and reaches behind its axis. The knee comes from
    half its angle, tan(gamma / 2) = sqrt(((f + t)^2 - d^2) / (d^2 - (f - t)^2)), which stays exact
    where the law of cosines loses half the digits: leg stretched, leg folded.

    >>> q, reachable = leg_ik([0.075, 0.010, -0.046], 0.025, 0.050, 0.070)
    >>> np.degrees(q).round(2).tolist()
    [7.59, 28.27, -112.84]
    """
    foot = np.asarray(foot, float)
    flat = foot.reshape(-1, 3)
    q = np.empty_like(flat)
    reachable = np.empty(len(flat), dtype=bool)
    for rows in blocks(len(flat)):
        _leg_ik_block(flat[rows], (coxa, femur, tibia), knee_up, backwards, q[rows], reachable[rows])
    return LegAngles(q.reshape(foot.shape), reachable.reshape(foot.shape[:-1]))


def _leg_ik_block(
    foot: Array,
    lengths: tuple[float, float, float],
    knee_up: bool,
    backwards: bool,
    q: Array,
    reachable: Array,
) -> None:
    coxa, femur, tibia = lengths
    x, y, h = foot.T.copy()
    if backwards:
        np.negative(x, out=x)
        np.negative(y, out=y)
    q[:, 0] = np.arctan2(y, x)
    x *= x
    y *= y
    x += y
    r = np.sqrt(x, out=x)
    if backwards:
        np.negative(r, out=r)
    r -= coxa
    d2 = r * r
    np.multiply(h, h, out=y)
    d2 += y
    stretch = (femur + tibia) ** 2 - d2
    fold = d2 - (femur - tibia) ** 2
    slack = 2 * BOUNDARY
    np.logical_and(stretch >= -slack * (femur + tibia), fold >= -slack * abs(femur - tibia), out=reachable)
    stretch = np.sqrt(np.maximum(stretch, 0.0, out=stretch), out=stretch)
    fold = np.sqrt(np.maximum(fold, 0.0, out=fold), out=fold)
    gamma = np.arctan2(stretch, fold)
    gamma *= -2.0 if knee_up else 2.0
    q[:, 2] = gamma
    # beta is the angle of (r, h) less that of (f + t cos gamma, t sin gamma), both scaled by 4 f.
    sine = np.multiply(stretch, fold, out=stretch)
    sine *= 2.0 if knee_up else -2.0
    cosine = d2
    cosine += femur * femur - tibia * tibia
    cosine *= 2.0
    np.multiply(h, cosine, out=fold)
    np.multiply(r, sine, out=gamma)
    fold += gamma
    r *= cosine
    h *= sine
    r -= h
    q[:, 1] = np.arctan2(fold, r)
    if not reachable.all():
        q[~reachable] = np.nan
