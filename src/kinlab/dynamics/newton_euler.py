"""Inverse dynamics by the recursive Newton-Euler equations (Luh, Walker and Paul 1980; the arm paper's 2.41 to 2.50).

Outwards, from the base to the tip, the motion of each link; inwards, from the tip to the base, the force
and moment in each joint. Each link's vectors stand in its own frame, component by component.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamics.mechanism import Mechanism
from kinlab.kinematics.blocks import blocks
from kinlab.kinematics.columns import (
    ZERO,
    Column,
    Vector,
    add,
    cross,
    dot,
    minus,
    scale,
    turn,
)
from kinlab.kinematics.transforms import Array


class Contact(NamedTuple):
    """Where the outside touches the chain: a link, and a point (3,) of it in its frame, m; None: its end."""

    link: int = -1
    point: tuple[float, float, float] | None = None


TIP = Contact()


class Load(NamedTuple):
    """What acts there: force (N) and moment (N m), as columns in the base frame."""

    force: Vector
    moment: Vector
    at: Contact


def inverse_dynamics(
    mechanism: Mechanism,
    q: ArrayLike,
    qd: ArrayLike,
    qdd: ArrayLike,
    wrench: ArrayLike | None = None,
    at: Contact = TIP,
) -> Array:
    """The torques (..., n), in N m, that the joints must give for a motion; forces in N where they slide.

    Args:
        q, qd, qdd: positions, rates and accelerations (..., n), in rad, rad/s, rad/s2 (m where they slide).
        wrench: what the outside exerts on the chain, (..., 6): force (N), then moment (N m) about the
            point of contact, both in the base frame.
        at: the point of contact; the tip where not given.

    Raises:
        UsageError: wrong number of joints.
    """
    given = [mechanism.check(*pair) for pair in (("positions", q), ("rates", qd), ("accelerations", qdd))]
    if wrench is not None:
        given.append(np.asarray(wrench, float))
    lead = np.broadcast_shapes(*(array.shape[:-1] for array in given))
    flat = [np.broadcast_to(a, (*lead, a.shape[-1])).reshape(-1, a.shape[-1]) for a in given]
    out = np.empty((len(flat[0]), mechanism.count))
    for rows in blocks(len(out)):
        motion = [_columns(array[rows]) for array in flat]
        sines, cosines = [np.sin(c) for c in motion[0]], [np.cos(c) for c in motion[0]]
        load = Load(motion[3][:3], motion[3][3:], at) if wrench is not None else None
        torques = newton_euler(mechanism, motion[0], sines, cosines, motion[1], motion[2], load)
        for i, torque in enumerate(torques):
            out[rows, i] = torque
    return out.reshape(*lead, mechanism.count)


def _columns(array: Array) -> list[Column]:
    # A column of zeros, as of joints at rest, is left out of the arithmetic.
    return [np.ascontiguousarray(column) if column.any() else 0.0 for column in array.T]


def gravity_torque(mechanism: Mechanism, q: ArrayLike) -> Array:
    """The torques (..., n), in N m, that hold the chain still at `q` (..., n)."""
    return inverse_dynamics(mechanism, q, np.zeros(mechanism.count), np.zeros(mechanism.count))


def newton_euler(
    mechanism: Mechanism,
    q: Sequence[Column],
    sines: Sequence[Column],
    cosines: Sequence[Column],
    qd: Sequence[Column],
    qdd: Sequence[Column],
    load: Load | None = None,
    weight: float = 1.0,
) -> list[Column]:
    """The recursion itself, on columns of any kind: one for each joint in, one for each joint out.

    Args:
        weight: 1.0, or 0.0 to leave gravity out.
    """
    rows = mechanism.rows
    # A base that accelerates upwards stands for gravity.
    spin, turning, rise = ZERO, ZERO, scale(mechanism.gravity.tolist(), -weight)
    outside = [load.force, load.moment] if load else []
    touched = load.at.link % len(rows) if load else -1
    link: Vector = ZERO
    arms: list[Vector] = []
    forces: list[Vector] = []
    moments: list[Vector] = []
    for i, (axis, next_link, mass, centre, inertia, slides) in enumerate(rows):
        rise = add(rise, cross(turning, link), cross(spin, cross(spin, link)))
        arm = link
        if slides:
            slip, rate = scale(axis, q[i]), scale(axis, qd[i])
            arm = add(link, slip)
            rise = add(rise, cross(turning, slip), cross(spin, cross(spin, slip)))
            rise = add(rise, scale(cross(spin, rate), 2.0), scale(axis, qdd[i]))
        else:
            back = -sines[i]
            spin, turning, rise = (turn(axis, back, cosines[i], v) for v in (spin, turning, rise))
            if i <= touched:
                outside = [turn(axis, back, cosines[i], v) for v in outside]
            rate = scale(axis, qd[i])
            turning = add(turning, cross(spin, rate), scale(axis, qdd[i]))
            spin = add(spin, rate)
        arms.append(arm)
        link = next_link
        force = scale(add(rise, cross(turning, centre), cross(spin, cross(spin, centre))), mass)
        momentum = [dot(row, spin) for row in inertia]
        moment = add([dot(row, turning) for row in inertia], cross(spin, momentum), cross(centre, force))
        if i == touched and load:
            point = link if load.at.point is None else list(load.at.point)
            moment = _less(_less(moment, outside[1]), cross(point, outside[0]))
            force = _less(force, outside[0])
        forces.append(force)
        moments.append(moment)

    torques: list[Column] = [0.0] * len(rows)
    force, moment = ZERO, ZERO
    for i in reversed(range(len(rows))):
        axis, slides = rows[i][0], rows[i][-1]
        force, moment = add(forces[i], force), add(moments[i], moment)
        torques[i] = dot(axis, force if slides else moment)
        if not slides:
            force, moment = (turn(axis, sines[i], cosines[i], v) for v in (force, moment))
        moment = add(moment, cross(arms[i], force))
    return torques


def _less(u: Vector, v: Vector) -> Vector:
    return [minus(a, b) for a, b in zip(u, v, strict=True)]
