"""Inverse kinematics by iteration, for any chain: six methods with one signature and one kind of result.

All of them move the joints from a start until the tip is within `tolerance_m` of the target. What
they are asked to reach is a position, or a position and an attitude; an attitude counts as the arc
that it moves a point at the chain's length, so that the residual is a length in metres throughout.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array, rotation_vector, wrap
from kinlab.names import resolve

TOLERANCE_M = 1e-9
MAX_ITERATIONS = 200
# Nakamura and Hanafusa 1986: damping sets in where the smallest singular value falls below a bound.
SINGULAR = 0.02
# Buss and Kim 2005: damped steps go for at most this share of the chain's length at a time.
FARTHEST_STEP = 0.25
# The bound `e` (m) of step 5 of the arm paper's algorithm, and how often it may halve its step.
INVERSE_ERROR_M = 1e-6
HALVINGS = 40
# A method that has come no nearer for so many iterations is given up.
PATIENCE = 30
# |J^T e| / (|J| |e|) below which a point counts as stationary.
STATIONARY = 1e-6


class Step(NamedTuple):
    """One iteration: the angles (n,) in rad after it, the residual in metres, and what the method did."""

    q: Array
    residual_m: float
    note: str


@dataclass(frozen=True, eq=False)
class Solution:
    """What a method came to.

    Attributes:
        method: its name.
        q: the last angles (n,) in rad, in (-pi, pi].
        converged: whether the residual is within the tolerance.
        residual_m: distance of the tip from the target; with an attitude asked for, the arc included.
        iterations: how many steps were taken.
        trace: the start and every step.
        reason: why it stopped.
    """

    method: str
    q: Array
    converged: bool
    residual_m: float
    iterations: int
    trace: tuple[Step, ...]
    reason: str


class Problem:
    """A chain, a target, and what the methods need of both."""

    def __init__(
        self, axes: ArrayLike, links: ArrayLike, target: ArrayLike, rotation: ArrayLike | None
    ) -> None:
        self.axes, self.links = np.asarray(axes, float), np.asarray(links, float)
        self.target = np.asarray(target, float)
        self.rotation = None if rotation is None else np.asarray(rotation, float)
        self.length = float(np.linalg.norm(self.links, axis=1).sum())

    def error(self, q: Array) -> Array:
        """What is missing: (3,) in metres, or (6,) with the rotation vector times the chain's length."""
        T = chain.fk(self.axes, self.links, q)
        gap = self.target - T[:3, 3]
        if self.rotation is None:
            return np.asarray(gap)
        return np.concatenate([gap, self.length * rotation_vector(self.rotation @ T[:3, :3].T)])

    def jacobian(self, q: Array) -> Array:
        """The rows of the Jacobian that belong to `error`, (3, n) or (6, n), in m/rad."""
        J = chain.jacobian(self.axes, self.links, q)
        return J[:3] if self.rotation is None else np.concatenate([J[:3], self.length * J[3:]])

    def hessian(self, q: Array, e: Array) -> Array:
        """Second derivatives (n, n) of |e|^2 / 2, in m^2/rad^2; those of the attitude by J^T J alone."""
        J = self.jacobian(q)
        bent = np.einsum("i,ijk->jk", e[:3], chain.position_hessian(self.axes, self.links, q))
        return np.asarray(J.T @ J - bent)


def _stall(problem: Problem, q: Array, e: Array) -> str:
    """Why there is no progress at the angles `q`, where `e` is missing."""
    J = problem.jacobian(q)
    if np.linalg.norm(J.T @ e) > STATIONARY * np.linalg.norm(J) * np.linalg.norm(e):
        return f"no nearer in {PATIENCE} iterations: its steps overshoot"
    if np.linalg.eigvalsh(problem.hessian(q, e))[0] < 0:
        return "caught at a saddle or a maximum of the distance, short of the target"
    return "at the nearest point around, short of the target"


class Stop(Exception):  # noqa: N818 - not an error: a method's reason to give up
    """A method cannot go on."""


def resolved_motion_rate(problem: Problem, q: Array, e: Array, memory: dict[str, float]) -> tuple[Array, str]:
    """The arm paper's algorithm (section 3.3, equations 3.16 to 3.22): step J^-1 dX, halved while inaccurate.

    Steps 4 and 5 measure how inaccurate the inverse is, |(I - J J^-1) dX|, and halve dX until that is
    below a bound. Where J is not square its pseudo-inverse J^T (J J^T)^-1 stands in (3.19).
    """
    J = problem.jacobian(q)
    if J.shape[0] > J.shape[1]:
        raise Stop(f"the Jacobian has no inverse: {J.shape[1]} joints cannot follow {J.shape[0]} coordinates")
    try:
        inverse = np.linalg.inv(J) if J.shape[0] == J.shape[1] else J.T @ np.linalg.inv(J @ J.T)
    except np.linalg.LinAlgError:
        raise Stop("the Jacobian is singular: it has no inverse") from None
    dX, halved = e, 0
    while not np.linalg.norm((np.eye(len(dX)) - J @ inverse) @ dX) <= INVERSE_ERROR_M:
        dX, halved = dX / 2, halved + 1
        if halved > HALVINGS:
            raise Stop("the Jacobian is so near singular that its inverse is useless")
    return q + inverse @ dX, f"dX halved {halved} times" if halved else ""


def damped_least_squares(problem: Problem, q: Array, e: Array, memory: dict[str, float]) -> tuple[Array, str]:
    """dq = J^T (J J^T + k I)^-1 e, with damping k only near singularities (Nakamura and Hanafusa 1986).

    The error is cut to a share of the chain's length (Buss and Kim 2005), as its linear model holds no further.
    """
    U, s, Vt = np.linalg.svd(problem.jacobian(q), full_matrices=False)
    bound = SINGULAR * problem.length
    damping = 0.0
    if s[-1] < bound:
        damping = (bound**2) * (1 - (s[-1] / bound) ** 2)
    e = e * min(1.0, FARTHEST_STEP * problem.length / float(np.linalg.norm(e)))
    dq = Vt.T @ (s / (s * s + damping) * (U.T @ e))
    return q + dq, f"damped, k = {damping:.2e} m2" if damping else ""


def gauss_newton(problem: Problem, q: Array, e: Array, memory: dict[str, float]) -> tuple[Array, str]:
    """dq = J+ e, the least-squares step with the pseudo-inverse, at full length."""
    return q + np.linalg.pinv(problem.jacobian(q)) @ e, ""


def newton(problem: Problem, q: Array, e: Array, memory: dict[str, float]) -> tuple[Array, str]:
    """Newton's method on |e|^2 / 2 with the exact second derivatives: dq = (J^T J - sum e_i H_i)^-1 J^T e.

    Quadratic near a solution, but drawn to any stationary point: a saddle or a maximum as well.
    """
    H = problem.hessian(q, e)
    try:
        step = np.linalg.solve(H, problem.jacobian(q).T @ e)
    except np.linalg.LinAlgError:
        raise Stop("the matrix of second derivatives is singular") from None
    return q + step, "" if np.linalg.eigvalsh(H)[0] > 0 else "uphill: towards a saddle or a maximum"


def levenberg_marquardt(problem: Problem, q: Array, e: Array, memory: dict[str, float]) -> tuple[Array, str]:
    """Gauss-Newton with damping that grows when a step fails and shrinks when it succeeds (Nielsen 1999)."""
    J = problem.jacobian(q)
    A, g = J.T @ J, J.T @ e
    scale = float(np.diag(A).max())
    # Below the rounding of A it would not keep a singular A invertible, nor an A of zeros at zero.
    damping = max(memory.get("damping", 1e-3 * scale), 1e-14 * scale, 1e-300)
    growth = 2.0
    for _ in range(HALVINGS):
        dq = np.linalg.solve(A + damping * np.eye(len(q)), g)
        new = problem.error(q + dq)
        gain = (e @ e - new @ new) / max(float(dq @ (damping * dq + g)), 1e-300)
        if gain > 0:
            memory["damping"] = damping * max(1 / 3, 1 - (2 * gain - 1) ** 3)
            return q + dq, f"damping {damping:.1e}"
        damping *= growth
        growth *= 2
        if np.linalg.norm(dq) < 1e-15:
            break
    raise Stop(_stall(problem, q, e))


def cyclic_coordinate_descent(
    problem: Problem, q: Array, e: Array, memory: dict[str, float]
) -> tuple[Array, str]:
    """One sweep from tip to base, each joint set to the best angle given the others (Wang and Chen 1991)."""
    q = q.copy()
    for i in reversed(range(len(q))):
        T = chain.frames(problem.axes, problem.links, q)
        origin, a = T[i, :3, 3], T[i, :3, :3] @ problem.axes[i]
        has = [T[-1, :3, 3] - origin]
        wants = [problem.target - origin]
        if problem.rotation is not None:
            has += list(problem.length * T[-1, :3, :3].T)
            wants += list(problem.length * problem.rotation.T)
        along = sum((h @ a) * (w @ a) for h, w in zip(has, wants, strict=True))
        dot = sum(h @ w for h, w in zip(has, wants, strict=True))
        cross = sum(a @ np.cross(h, w) for h, w in zip(has, wants, strict=True))
        q[i] += np.arctan2(cross, dot - along)
    return q, ""


Method = Callable[[Problem, Array, Array, dict[str, float]], tuple[Array, str]]

METHODS: dict[str, Method] = {
    "rmrc": resolved_motion_rate,
    "dls": damped_least_squares,
    "newton": newton,
    "gauss-newton": gauss_newton,
    "lm": levenberg_marquardt,
    "ccd": cyclic_coordinate_descent,
}


# A target too large to square is a stated failure, and no reason to warn.
@np.errstate(over="ignore", invalid="ignore")
def solve(
    axes: ArrayLike,
    links: ArrayLike,
    target: ArrayLike,
    start: ArrayLike,
    *,
    method: str = "lm",
    rotation: ArrayLike | None = None,
    tolerance_m: float = TOLERANCE_M,
    max_iterations: int = MAX_ITERATIONS,
) -> Solution:
    """Joint angles for one target, by the method named, from the angles `start`.

    Args:
        axes, links: the chain, see `kinlab.kinematics.chain`.
        target: position (3,) of the tip, metres, base frame.
        start: angles (n,) in rad.
        method: a key of METHODS.
        rotation: attitude (3, 3) of the tip, where it is asked for too.
        tolerance_m: the residual, a length in metres, below which the target counts as reached.
        max_iterations: after which it is given up.

    Raises:
        UsageError: no such method.
    """
    method = resolve(method, METHODS, "method")
    problem = Problem(axes, links, target, rotation)
    q = wrap(start)
    e = problem.error(q)
    residual = float(np.linalg.norm(e))
    trace = [Step(q, residual, "start")]
    memory: dict[str, float] = {}
    best_ago, best = 0, residual
    reason = "" if np.isfinite(residual) else "the target or the start is not finite"
    while residual > tolerance_m and not reason:
        if len(trace) > max_iterations:
            reason = f"not there after {max_iterations} iterations"
            break
        try:
            q, note = METHODS[method](problem, q, e, memory)
            # Angles of a million turns have no digits left: the residual is that of the angles given back.
            q = wrap(q)
        except Stop as stop:
            reason = str(stop)
            break
        e = problem.error(q)
        residual = float(np.linalg.norm(e))
        trace.append(Step(q, residual, note))
        best_ago = 0 if residual < best * (1 - 1e-6) else best_ago + 1
        best = min(best, residual)
        if not np.isfinite(residual):
            reason = "the angles ran away"
        elif residual > tolerance_m and best_ago >= PATIENCE:
            reason = _stall(problem, q, e)
    converged = residual <= tolerance_m
    return Solution(
        method,
        q,
        converged,
        residual,
        len(trace) - 1,
        tuple(trace),
        "converged" if converged else reason,
    )
