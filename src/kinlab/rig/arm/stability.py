"""For which gains the loop settles, oscillates, or runs away: a sweep over two of them on the emulated bus."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from kinlab.control import SecondOrder, sampled_radius
from kinlab.errors import UsageError
from kinlab.kinematics.resolved_motion import Track
from kinlab.kinematics.transforms import Array
from kinlab.names import resolve
from kinlab.rig.arm.loop import RunawayError, Settings, run
from kinlab.rig.arm.push import Push
from kinlab.rig.arm.servos import ArmServos, Setup
from kinlab.robots import Limb, Robot

SETTLES, OSCILLATES, RUNS_AWAY = range(3)
STATES = ("settles", "oscillates", "runs away")
POSITION, ENVIRONMENT = ("kp", "kv"), ("kf", "kenv", "denv", "menv")
# The task: a step of every joint from a bent pose, then a hand's push; what swings on later counts.
POSE, STEP = np.radians([30.0, 10.0, 60.0]), np.radians([10.0, 5.0, 10.0])
SECONDS, LATE = 3.0, 0.5
PUSH = Push(0.3, 0.3, "hand", (-3.0, 0.0, 0.0))
MOST = 200
# Swings of less than this are the servo's resolution and its dead band.
SWING = np.radians(1.5)


@dataclass(frozen=True)
class StabilityMap:
    """What became of the loop at every pair of gains.

    Attributes:
        law: that was swept.
        x, y: names of the gains.
        xs, ys: (X,), (Y,) their values.
        state: (Y, X) SETTLES, OSCILLATES or RUNS_AWAY.
        when: (Y, X) s after which it ran away, NaN where it did not.
        critical: (X,) the y at which the linear model's damping ratio is 1, by (2.12) or (2.14); NaN where there
            is none in sight, None where these two gains do not decide it.
        sampled: (X,) the y beyond which the linear model, sampled with one cycle of delay, runs away; None
            where these two gains do not decide it.
    """

    law: str
    x: str
    y: str
    xs: Array
    ys: Array
    state: Array
    when: Array
    critical: Array | None
    sampled: Array | None

    def bound_at(self, row: int, column: int) -> str:
        """What bound passes through a cell: "o" critical damping, "+" the sampled bound, "" none."""
        for mark, bound in (("o", self.critical), ("+", self.sampled)):
            at = np.nan if bound is None else bound[column]
            if np.isfinite(at) and int(np.argmin(np.abs(np.log(self.ys / at)))) == row:
                return mark
        return ""

    def counts(self) -> dict[str, float]:
        """The share of the map of each state."""
        return {name: float(np.mean(self.state == i)) for i, name in enumerate(STATES)}

    def to_json(self) -> dict[str, Any]:
        """As the command line prints it; rows of `states` go with `ys`."""

        def plain(values: Array | None) -> list[Any] | None:
            return None if values is None else [None if np.isnan(v) else round(float(v), 6) for v in values]

        return {
            "law": self.law,
            self.x: plain(self.xs),
            self.y: plain(self.ys),
            "states": [[STATES[s] for s in row] for row in self.state.tolist()],
            "ran_away_at_s": [plain(row) for row in self.when],
            "critical_damping": plain(self.critical),
            "sampled_bound": plain(self.sampled),
        }


def sweep(
    robot: Robot,
    limb: Limb,
    settings: Settings,
    setup: Setup,
    x: tuple[str, Array],
    y: tuple[str, Array],
    tell: Callable[[], None] = lambda: None,
) -> StabilityMap:
    """Run the loop at every pair of two gains, each given by name ("kp", ..., "menv") and values.

    Args:
        tell: called after each run.

    Raises:
        UsageError: no such gain, both the same, or a value that is not positive.
    """
    if settings.law == "none":
        raise UsageError("without a controller there are no gains to sweep")
    names = POSITION if settings.law == "position" else POSITION + ENVIRONMENT
    first, second = (resolve(name, names, f"gain of {settings.law} control") for name, _ in (x, y))
    if first == second:
        raise UsageError(f"a map takes two different gains, got {first} twice")
    xs, ys = (np.asarray(values, float) for _, values in (x, y))
    for values in (xs, ys):
        if not (np.isfinite(values).all() and (values > 0).all()):
            raise UsageError("a map takes gains that are finite and more than 0")
    state, when = np.zeros((len(ys), len(xs)), np.uint8), np.full((len(ys), len(xs)), np.nan)
    track = _task(limb, settings.dt)
    for row, up in enumerate(ys.tolist()):
        for column, along in enumerate(xs.tolist()):
            gains = with_gains(settings, {first: along, second: up})
            state[row, column], when[row, column] = _try(robot, limb, track, gains, setup)
            tell()
    critical, sampled = _bounds(settings, first, second, xs, ys)
    return StabilityMap(settings.law, first, second, xs, ys, state, when, critical, sampled)


def scale(span: tuple[float, float], count: int) -> Array:
    """Values (count,) from the lowest to the highest, each the same times the one before.

    Raises:
        UsageError: they do not rise, are not more than 0, or are fewer than two.
    """
    low, high = span
    if not 0 < low < high < np.inf:
        raise UsageError(f"a range of gains rises from more than 0, got {low:g} to {high:g}")
    if not 2 <= count <= MOST:
        raise UsageError(f"a map has 2 to {MOST} values on a side, got {count}")
    return np.geomspace(low, high, count)


def settings_for(settings: Settings, x: str, y: str) -> Settings:
    """`settings` with the law that these gains belong to: position control for kp and kv, else compliance."""
    every = POSITION + ENVIRONMENT
    names = {resolve(name, every, "gain") for name in (x, y)}
    return replace(settings, law="position" if names <= set(POSITION) else "compliance")


def with_gains(settings: Settings, gains: dict[str, float]) -> Settings:
    """Settings with some gains changed, by name."""
    position = {k: v for k, v in gains.items() if k in POSITION}
    environment = {k: v for k, v in gains.items() if k in ENVIRONMENT}
    return replace(
        settings,
        gains=settings.gains._replace(**position),
        environment=settings.environment._replace(**environment),
    )


def _task(limb: Limb, dt: float) -> Track:
    q = np.tile(POSE + STEP, (round(SECONDS / dt), 1))
    q[0] = POSE
    rest, points = np.zeros_like(q), limb.fk(q)[..., :3, 3]
    return Track(points, q, rest, rest, points, np.zeros(len(q)), np.full(len(q), -1))


def _try(robot: Robot, limb: Limb, track: Track, settings: Settings, setup: Setup) -> tuple[int, float]:
    with ArmServos.emulated(robot, limb, track.q[0].tolist(), [PUSH], setup) as servos:
        servos.hold()
        try:
            record = run(servos, track, settings)
        except RunawayError as away:
            return RUNS_AWAY, away.time
    late = record.angles["real"][round(LATE * len(track.q)) :]
    return (OSCILLATES if max(map(reversals, late.T)) >= 2 else SETTLES), np.nan


def reversals(angle: Array) -> int:
    """How often an angle (N,), rad, turns back by more than SWING."""
    count, direction, extreme = 0, 0, float(angle[0])
    for value in angle.tolist():
        if direction * (value - extreme) > 0 or (direction == 0 and abs(value - extreme) > SWING):
            direction, extreme = direction or (1 if value > extreme else -1), value
        elif abs(value - extreme) > SWING:
            count, direction, extreme = count + 1, -direction, value
    return count


def _bounds(settings: Settings, x: str, y: str, xs: Array, ys: Array) -> tuple[Array | None, Array | None]:
    fine = np.geomspace(ys.min(), ys.max(), 400)
    pair = {x, y}
    if pair == set(POSITION):

        def zeta(gains: Settings) -> float:
            return SecondOrder.of_position(*gains.gains).zeta

    elif pair <= {"kenv", "denv", "menv"}:

        def zeta(gains: Settings) -> float:
            return SecondOrder.of_environment(*gains.environment[1:]).zeta

    else:
        return None, None
    critical = np.array(
        [
            _crossing(fine, np.array([zeta(with_gains(settings, {x: a, y: b})) for b in fine]) - 1)
            for a in xs.tolist()
        ]
    )
    if pair != set(POSITION):
        return critical, None
    weight = (
        1 / settings.dt if settings.running_sum else 1.0
    )  # rates summed up without dt weigh that much more
    sampled = []
    for a in xs.tolist():
        kp, kv = (a, fine) if x == "kp" else (fine, a)
        radius = sampled_radius(weight * np.asarray(kp), weight * np.asarray(kv), settings.dt)
        sampled.append(_crossing(fine, radius - 1 - 1e-9, last=True))
    return critical, np.array(sampled)


def _crossing(at: Array, values: Array, last: bool = False) -> float:
    changes = np.flatnonzero(np.sign(values[1:]) != np.sign(values[:-1]))
    return float(at[changes[-1 if last else 0]]) if len(changes) else np.nan
