"""From what people ask of a walk to the walk: what they leave open is chosen here, and nowhere else."""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.gait.landing import Experiment, decelerated, heel_pitch_per_metre
from kinlab.gait.schedule import Gait
from kinlab.gait.stability import GRAVITY
from kinlab.gait.swing import CURVES, DEFAULT, Curve
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array
from kinlab.robots import Robot
from kinlab.units import finite

SPEED = 0.020
# Shares of a leg's length, assumed. The lift is that of xl430-hexapod, Table 1: 14 mm for a leg of 145 mm.
STROKE = {"humanoid": 0.08}
STROKE_OF_OTHERS = 0.2
LIFT = 0.1
# Of a robot that steps without going anywhere, s.
PERIOD_IN_PLACE = 1.0
# Beyond these (m, m/s, rad/s; s a cycle) a number is a slip of the finger or of the unit.
MOST, SLOWEST = 100.0, 1e6
PAPERS_CURVES = {"krsri-hexapod": "line-sine", "eros-humanoid": "quarter-circle"}


def plan(
    robot: Robot,
    gait: Gait,
    *,
    forward: float = SPEED,
    sideways: float = 0.0,
    turn: float = 0.0,
    stride: float | None = None,
    period: float | None = None,
    lift: float | None = None,
    curve: Curve | None = None,
    height: float = 0.0,
    rpy: ArrayLike = (0.0, 0.0, 0.0),
    sway: float | None = None,
    decelerate: bool = False,
    heel_strike: bool = False,
    experiment: Experiment | None = None,
) -> Walk:
    """A walk that goes on for ever; `Walk.over` makes it one from standing and back.

    Args:
        robot, gait: who walks, and how.
        forward, sideways: speed of the body, m/s; sideways is to the left.
        turn: to the left, rad/s.
        stride: the way per cycle, m, of the foot that goes farthest; of the body on a straight walk.
        period: of a cycle, s. Either this or the stride; default a stroke of a fifth of the leg's length.
        lift: of a foot, m; default a share of the leg's length.
        curve: of a foot through the air; default the paper's, where it prints one.
        height: of the body above its standing height, m.
        rpy: its attitude, rad.
        sway: of a robot of two legs, m; default as far as brings the zero moment point over the foot.
        decelerate, heel_strike: eros's optimisations, see `kinlab.gait.landing`.
        experiment: one of eros's, for step, sway and lift.

    Raises:
        UsageError: numbers that make no walk.
    """
    _check({"speed": forward, "speed sideways": sideways, "turn": turn, "height": height}, rpy)
    _check_positive({"stride": stride, "period": period, "lift": lift})
    two_legged = robot.kind == "humanoid"
    for name, asked in (("heel strike", heel_strike), ("an experiment of eros", experiment is not None)):
        if asked and not two_legged:
            raise UsageError(f"{name} is for robots that walk on soles; {robot.name} is a {robot.kind}")
    if experiment is not None:
        stride, lift, sway = 2 * experiment.step, experiment.lift, experiment.sway
    duty = float(gait.duty)
    length = float(np.mean([np.linalg.norm(leg.links, axis=1).sum() for leg in robot.legs]))
    if stride is None:
        stride = STROKE.get(robot.kind, STROKE_OF_OTHERS) * length / duty
    curve = curve or CURVES[PAPERS_CURVES.get(robot.paper or "", DEFAULT)]
    roll, pitch, yaw = np.asarray(rpy, float).tolist()
    walk = Walk(
        robot, gait, (float(forward), float(sideways)), float(turn), 1.0, LIFT * length if lift is None else lift,
        decelerated(curve) if decelerate else curve, height, (roll, pitch, yaw),
        heel=heel_pitch_per_metre() if heel_strike else 0.0,
    )  # fmt: skip
    fastest = float(np.hypot(*foot_velocities(walk).T).max())
    if period is None:
        period = stride / fastest if fastest else PERIOD_IN_PLACE
    if period > SLOWEST:
        raise UsageError(f"at this speed a cycle would take {period:.2g} s")
    walk = replace(walk, period=period)
    if not two_legged:
        return walk
    return replace(walk, sway=steady_sway(walk) if sway is None else sway)


def foot_velocities(walk: Walk) -> Array:
    """The command at the standing feet (L, 2), m/s: v + omega x r."""
    x, y = walk.neutral[:, 0], walk.neutral[:, 1]
    return np.stack([walk.velocity[0] - walk.turn * y, walk.velocity[1] + walk.turn * x], axis=-1)


def steady_sway(walk: Walk) -> float:
    """The sway, m, at which the zero moment point of a cart reaches the middle of the foot.

    A cart that swings by y = Y sin(w t) has it at y (1 + w^2 z / g).
    """
    from kinlab.gait.stability import centre_of_mass

    stands = walk.at(0.0)
    z = walk.height - walk.robot.standing_feet[:, 2].min() + float(centre_of_mass(walk.robot, stands.q)[2])
    omega = 2 * np.pi / walk.period
    return float(np.abs(walk.neutral[:, 1]).mean() / (1 + omega**2 * z / GRAVITY))


def _check(numbers: dict[str, float], rpy: ArrayLike) -> None:
    finite(rpy, "angles of the body")
    for name, value in numbers.items():
        finite(value, f"a walk's {name}")
        if abs(value) > MOST:
            raise UsageError(
                f"a walk's {name} must be within {MOST:g} in m, m/s or rad/s; is the unit right?"
            )


def _check_positive(numbers: dict[str, float | None]) -> None:
    for name, value in numbers.items():
        if value is not None and not 0 < value <= MOST:
            raise UsageError(f"a walk's {name} must be above 0 and at most {MOST:g} m or s, got {value:g}")
    if numbers["stride"] is not None and numbers["period"] is not None:
        raise UsageError("stride and period give each other at a given speed: name one of them")
