"""Inverse kinematics of a limb: all solutions, chosen by the limits, for one target or a million."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics import chain
from kinlab.kinematics.blocks import blocks
from kinlab.kinematics.transforms import Array, homogeneous, wrap
from kinlab.robots.model import LIMIT_SLACK, Limb
from kinlab.units import finite

# Iterated solutions (limbs without a closed form): polished as far as the arithmetic goes, taken as
# exact below EXACT_M, in metres, and as one where no joint differs by SAME, in rad.
POLISHED_M = 1e-17
EXACT_M = 1e-12
SAME = 1e-5
# They start from the poses, out of SAMPLES, that bring the tip nearest, each APART (rad) from the others.
SAMPLES = 4096
STARTS = 12
APART = 0.5
# Lengths of a limb, see `nearest`.
FAR = 1e9


@dataclass(frozen=True, eq=False, repr=False)
class Inverse:
    """Joint angles for targets (...).

    Attributes:
        q: the chosen solution (..., n) in rad, the first within the limits; NaN where there is none.
        reachable: whether there is a solution within the limits (...).
        exists: whether there is one at all (...), limits aside.
        solutions: all of them (..., k, n), NaN where there are fewer.
        within_limits: for each solution (..., k).
        chosen: index of the chosen solution (...), -1 where there is none.
        names: of the k solutions.
    """

    q: Array
    reachable: Array
    exists: Array
    solutions: Array
    within_limits: Array
    chosen: Array
    names: tuple[str, ...]

    def __repr__(self) -> str:
        if self.reachable.ndim:
            return f"<Inverse of {self.reachable.size} targets: {int(self.reachable.sum())} reachable>"
        if not self.reachable:
            return f"<Inverse: {'beyond the limits' if self.exists else 'unreachable'}>"
        angles = ", ".join(f"{a:.3f}" for a in np.degrees(self.q))
        return f"<Inverse: {self.names[int(self.chosen)]}, [{angles}] deg>"


# Numbers too large to square are out of reach like any other, and no reason to warn.
@np.errstate(over="ignore", invalid="ignore")
def inverse_kinematics(limb: Limb, target: ArrayLike, rotation: ArrayLike | None = None) -> Inverse:
    """All joint angles that bring the tip of `limb` to `target` (..., 3), metres, limb frame.

    Args:
        limb: the limb.
        target: positions.
        rotation: attitudes (..., 3, 3); for limbs of six joints level where not given, for shorter
            limbs refused, as they cannot choose one.

    Raises:
        UsageError: wrong shapes, or an attitude for a limb that cannot choose it.
    """
    target = np.asarray(target, float)
    if target.ndim == 0 or target.shape[-1] != 3:
        raise UsageError(f"a target is three numbers x y z, got an array of shape {target.shape}")
    posed = len(limb.joints) >= 6
    if rotation is not None and not posed:
        raise UsageError(f"limb {limb.name} has {len(limb.joints)} joints: it cannot choose its attitude")
    R = np.eye(3) if rotation is None else np.asarray(rotation, float)
    if R.shape[-2:] != (3, 3) or not np.abs(R @ np.swapaxes(R, -1, -2) - np.eye(3)).max(initial=0.0) < 1e-6:
        raise UsageError("an attitude is a rotation matrix of shape (3, 3)")
    lead = np.broadcast_shapes(target.shape[:-1], R.shape[:-2] if posed else ())
    target = np.broadcast_to(target, (*lead, 3)).reshape(-1, 3)
    attitudes = np.broadcast_to(R, (*lead, 3, 3)).reshape(-1, 3, 3) if posed else None

    form = limb.closed_form
    names = form.names if form else tuple(f"solution {i + 1}" for i in range(STARTS))
    count, width = len(target), len(limb.joints)
    solutions = np.empty((count, len(names), width))
    exists = np.empty(count, dtype=bool)
    q = np.full((count, width), np.nan)
    within = np.zeros((count, len(names)), dtype=bool)
    chosen = np.empty(count, dtype=int)
    for rows in blocks(count):
        R_rows = None if attitudes is None else attitudes[rows]
        if form is None:
            found, exists[rows] = _iterate(limb, target[rows], R_rows)
        elif form.needs_pose:
            assert R_rows is not None
            found, exists[rows] = form.solve(homogeneous(R_rows, target[rows]))
        else:
            found, exists[rows] = form.solve(target[rows])
        within[rows] = fit_limits(limb, found)
        solutions[rows] = found
        first = np.argmax(within[rows], axis=-1)
        any_fits = within[rows].any(axis=-1)
        chosen[rows] = np.where(any_fits, first, -1)
        q[rows][any_fits] = found[any_fits, first[any_fits]]
    return Inverse(
        q.reshape(*lead, width), (chosen >= 0).reshape(lead), exists.reshape(lead),
        solutions.reshape(*lead, *solutions.shape[1:]), within.reshape(*lead, len(names)),
        chosen.reshape(lead), names,
    )  # fmt: skip


def fit_limits(limb: Limb, q: Array) -> Array:
    """Turn angles (..., n) by whole turns into the limits where that fits (in place); whether they fit (...)."""
    lower, upper = limb.limits
    below, above = q < lower - LIMIT_SLACK, q > upper + LIMIT_SLACK
    if below.any() or above.any():
        q += 2 * np.pi * (below & (q + 2 * np.pi <= upper + LIMIT_SLACK))
        q -= 2 * np.pi * (above & (q - 2 * np.pi >= lower - LIMIT_SLACK))
    with np.errstate(invalid="ignore"):
        return np.asarray(((q >= lower - LIMIT_SLACK) & (q <= upper + LIMIT_SLACK)).all(axis=-1))


def _iterate(limb: Limb, target: Array, rotation: Array | None) -> tuple[Array, Array]:
    """Solutions of a chain that has no closed form: Levenberg-Marquardt from many starts, the distinct ones kept."""
    from kinlab.kinematics import numeric

    rng = np.random.default_rng(0)
    lower, upper = limb.limits
    n = len(lower)
    samples = np.vstack([rng.uniform(lower, upper, (SAMPLES, n)), rng.uniform(-np.pi, np.pi, (SAMPLES, n))])
    tips = limb.fk(samples)[:, :3, 3]
    solutions = np.full((len(target), STARTS, n), np.nan)
    for i in np.flatnonzero(np.isfinite(target).all(axis=-1)):
        kept: list[Array] = []
        R = None if rotation is None else rotation[i]
        for start in _apart(samples[np.argsort(np.linalg.norm(tips - target[i], axis=1))]):
            found = numeric.solve(
                limb.axes, limb.links, target[i], start,
                method="lm", rotation=R, tolerance_m=POLISHED_M, max_iterations=100,
            )  # fmt: skip
            near = [np.abs(wrap(found.q - other)).max() < SAME for other in kept]
            if found.residual_m < EXACT_M and not any(near):
                kept.append(found.q)
        solutions[i, : len(kept)] = kept or np.nan
    return solutions, np.isfinite(solutions[:, 0, 0])


def _apart(samples: Array) -> Iterator[Array]:
    """Up to STARTS of the `samples`, the first ones first, each unlike those before it."""
    for _ in range(STARTS):
        if not len(samples):
            return
        first = samples[0]
        yield first
        samples = samples[np.abs(wrap(samples - first)).max(axis=1) > APART]


def nearest(limb: Limb, target: ArrayLike) -> Array:
    """The point (3,), metres, limb frame, nearest to `target` (3,) that the tip reaches within the limits.

    Raises:
        UsageError: a target that is not finite.
    """
    return np.asarray(chain.fk(limb.axes, limb.links, nearest_pose(limb, target))[:3, 3])


def nearest_pose(limb: Limb, target: ArrayLike) -> Array:
    """The angles (n,), rad, within the limits, that bring the tip nearest to `target` (3,), metres, limb frame.

    The attitude is left free. Damped Newton steps on the squared distance with the exact second
    derivatives, joints held at a limit that they press against, from the best of many starts.

    Raises:
        UsageError: a target that is not finite.
    """
    target = np.asarray(target, float)
    finite(target, "a target")
    # Further out only the direction counts, to the last digit.
    far = FAR * float(np.linalg.norm(limb.links, axis=1).sum())
    target = target * (far / max(far, float(np.abs(target).max())))
    lower, upper = limb.limits
    n = len(lower)
    rng = np.random.default_rng(0)
    q = np.vstack([(lower + upper) / 2, rng.uniform(lower, upper, (4096, n))])
    # Extremes of the reach lie at limits and at stretched or folded joints.
    special = np.clip(np.array([0.0, -np.pi, np.pi]), lower[:, None], upper[:, None])
    picks = np.concatenate([special, lower[:, None], upper[:, None]], axis=1)
    mask = rng.random(q.shape) < 0.3
    choice = rng.integers(0, picks.shape[1], q.shape)
    q = np.where(mask, picks[np.arange(n), choice], q)
    distance = np.linalg.norm(chain.fk(limb.axes, limb.links, q)[:, :3, 3] - target, axis=1)
    best = min((_descend(limb, target, q[i]) for i in np.argsort(distance)[:8]), key=lambda found: found[0])
    return np.asarray(best[1])


def _descend(limb: Limb, target: Array, q: Array) -> tuple[float, Array]:
    lower, upper = limb.limits
    damping = 1e-4
    tip = chain.fk(limb.axes, limb.links, q)[:3, 3]
    for _ in range(100):
        gap = target - tip
        J = chain.jacobian(limb.axes, limb.links, q)[:3]
        gradient = -J.T @ gap
        H = J.T @ J - np.einsum("i,ijk->jk", gap, chain.position_hessian(limb.axes, limb.links, q))
        free = ~(((q <= lower) & (gradient > 0)) | ((q >= upper) & (gradient < 0)))
        if not free.any() or np.abs(gradient[free]).max() < 1e-15:
            break
        values, vectors = np.linalg.eigh(H[np.ix_(free, free)])
        scale = max(float(np.abs(values).max()), 1e-12)
        step = np.zeros_like(q)
        along = vectors.T @ gradient[free]
        step[free] = -vectors @ (along / (np.abs(values) + damping * scale))
        new = np.clip(q + step, lower, upper)
        new_tip = chain.fk(limb.axes, limb.links, new)[:3, 3]
        # The difference of the squared distances, without the digits that far targets would cost it.
        if (new_tip - tip) @ (new_tip + tip - 2 * target) < 0:
            done = np.abs(new - q).max() < 1e-14
            q, tip, damping = new, new_tip, max(damping / 10, 1e-14)
            if done:
                break
        else:
            damping *= 10
            if damping > 1e12:
                break
    return float(np.linalg.norm(target - tip)), q
