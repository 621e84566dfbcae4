"""Resolved motion rate control: joint angles along a path of the tip, one step of the Jacobian's inverse each.

Whitney 1969; the arm paper's section 3.3. Close to a singularity the step is damped, and says so.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import chain
from kinlab.kinematics.numeric import SINGULAR
from kinlab.kinematics.transforms import Array


class Step(NamedTuple):
    """One step of the inverse.

    Attributes:
        dq: (n,) in rad.
        damping: k in dq = J^T (J J^T + k I)^-1 dX, in m2; 0 where there is no need of it.
        lost: the joint that moves the tip no more, by number, where damping is needed; else None.
    """

    dq: Array
    damping: float
    lost: int | None


def inverse_step(axes: ArrayLike, links: ArrayLike, q: ArrayLike, dX: ArrayLike) -> Step:
    """The joints' step for a step dX (3,) of the tip, in m, damped near singularities (Nakamura, Hanafusa 1986)."""
    U, s, Vt = np.linalg.svd(chain.jacobian(axes, links, q)[:3], full_matrices=False)
    bound = SINGULAR * float(np.linalg.norm(np.asarray(links, float), axis=1).sum())
    damping = 0.0 if s[-1] >= bound else bound**2 - s[-1] ** 2
    dq = Vt.T @ (s / (s * s + damping) * (U.T @ np.asarray(dX, float)))
    return Step(dq, float(damping), int(np.argmax(np.abs(Vt[-1]))) if damping else None)


@dataclass(frozen=True, eq=False)
class Track:
    """A path of N points in joint angles.

    Attributes:
        points: (N, 3) that were asked for, m.
        q, qd, qdd: (N, n), in rad, rad/s, rad/s2.
        tip: (N, 3) where the angles put the tip, m.
        damping: (N,) used at each step, m2.
        lost: (N,) the number of the joint that moved the tip no more, or -1.
    """

    points: Array
    q: Array
    qd: Array
    qdd: Array
    tip: Array
    damping: Array
    lost: Array

    @property
    def off(self) -> Array:
        """(N,) how far the tip is from the path, m."""
        return np.asarray(np.linalg.norm(self.tip - self.points, axis=-1))


def follow(
    axes: ArrayLike,
    links: ArrayLike,
    start: ArrayLike,
    points: ArrayLike,
    dt: float,
    step: Callable[[Array, Array], Step] | None = None,
) -> Track:
    """Follow `points` (N, 3), in m and the base frame, from the angles `start` (n,) at the first of them.

    Every cycle makes one step towards the next point, so that an error is made good in the next cycle.

    Args:
        dt: of a cycle, s.
        step: another inverse, from (q, dX) to a `Step`.
    """
    points = np.asarray(points, float)
    step = step or (lambda q, dX: inverse_step(axes, links, q, dX))
    q = np.array(start, float)
    angles, damping, lost = [q], [0.0], [-1]
    for point in points[1:]:
        taken = step(q, point - chain.fk(axes, links, q)[:3, 3])
        q = q + taken.dq
        angles.append(q)
        damping.append(taken.damping)
        lost.append(-1 if taken.lost is None else taken.lost)
    found = np.array(angles)
    qd = np.gradient(found, dt, axis=0) if len(found) > 1 else np.zeros_like(found)
    qdd = np.gradient(qd, dt, axis=0) if len(found) > 1 else np.zeros_like(found)
    tip = chain.fk(axes, links, found)[..., :3, 3]
    return Track(points, found, qd, qdd, tip, np.array(damping), np.array(lost))


def straight_line(
    start: ArrayLike, end: ArrayLike, profile: Callable[[ArrayLike, float], Array], duration: float, dt: float
) -> tuple[Array, Array]:
    """Times (N,) in s, and points (N, 3) in m, every `dt` along a line that is run through in `duration`."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    count = max(round(duration / dt), 1)
    t = np.arange(count + 1) * dt
    return t, start + profile(t, count * dt)[0][:, None] * (end - start)
