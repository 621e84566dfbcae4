"""EROS's optimisations of the landing: deceleration (48) and heel strike (44) to (47), and its three experiments.

What the paper leaves open is filled by an assumption that each function states.
"""

from dataclasses import dataclass, replace

import numpy as np

from kinlab.errors import UsageError
from kinlab.gait.swing import Curve, Function, Profile
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array

AREAS = 8
LAST_RATE = 0.25
# C of (46), (47), in mm per deg.
HEEL_GAIN = 5.0

DECELERATION = (
    "(48) divides the landing into n areas of equal length; how many, the gain, and the law itself (figures 16 "
    f"and 17) are not in the text. Assumed: n = {AREAS}, T(n) = T(n-1) - C log(n / (n-1)), with C such that the last "
    f"area has {LAST_RATE:g} of the first one's step, and the whole swing as long as without it."
)
HEEL_STRIKE = (
    "(46) and (47) add the height between the soles, divided by a gain, to the angle of the ankle; the gain is not "
    "printed, and with the knee's angle as printed no sole would be level. Assumed: the sole's pitch is the height "
    f"divided by {HEEL_GAIN:g} mm a deg, times the cosine of the swing, so that toe down passes into toe up."
)


@dataclass(frozen=True)
class Experiment:
    """What one of eros's experiments put into its walk: figures 24, 26 and 28, metres.

    Only X is named, the length of a step. Y is read as the sway of the body towards the standing foot,
    of the size of half the hips' width, and Z as the lift, on grass that is 50 mm high.
    """

    name: str
    step: float
    sway: float
    lift: float


# What is shown beside a walk with the values of an experiment.
EXPERIMENT_NOTE = (
    "the experiments print X, Y and Z and name only X, the step: Y is read as the sway of the body, Z as the lift; "
    "their speed is not printed"
)
EXPERIMENTS = (
    Experiment("8", 0.008, 0.045, 0.100),
    Experiment("16", 0.016, 0.035, 0.095),
    Experiment("24", 0.024, 0.025, 0.090),
)


def find_experiment(step_mm: str) -> Experiment:
    """The experiment of that length of a step in mm.

    Raises:
        UsageError: no such experiment.
    """
    for experiment in EXPERIMENTS:
        if experiment.name == step_mm.removesuffix("mm"):
            return experiment
    names = ", ".join(e.name for e in EXPERIMENTS)
    raise UsageError(f"no experiment of eros has a step of {step_mm} mm; there are: {names}")


def decelerated(curve: Curve, areas: int = AREAS, last_rate: float = LAST_RATE) -> Curve:
    """`curve` with its landing slowed down area by area: eros-humanoid, (48) and figures 16, 17.

    Args:
        curve: whose second half is the landing.
        areas: n of (48), of equal length along the landing's quarter circle.
        last_rate: the last area's step in angle, as a share of the first one's.
    """
    number = np.arange(1, areas + 1)
    rates = 1 - (1 - last_rate) * np.log(number) / np.log(areas)
    ends = np.concatenate([[0.0, 0.5], 0.5 + np.arcsin(number / areas) / np.pi])
    times = np.concatenate([[0.0], np.cumsum(np.diff(ends) / np.concatenate([[1.0], rates]))])
    whole = times[-1]
    knots, slopes = times / whole, np.concatenate([[1.0], rates]) * whole

    def progress(s: Array) -> Array:
        return np.asarray(np.interp(s, knots, ends))

    def rate(s: Array) -> Array:
        return np.asarray(slopes[np.clip(np.searchsorted(knots, s, side="left") - 1, 0, areas)])

    return replace(
        curve,
        name=f"{curve.name}, decelerated",
        along=_warped(curve.along, progress, rate),
        height=_warped(curve.height, progress, rate),
        base=curve,
    )


def _warped(profile: Profile, progress: Function, rate: Function) -> Profile:
    return Profile(
        lambda s: profile.value(progress(s)),
        lambda s: profile.rate(progress(s)) * rate(s),
        lambda s: profile.bend(progress(s)) * rate(s) ** 2,
    )


def heel_pitch_per_metre(gain_mm_per_deg: float = HEEL_GAIN) -> float:
    """The pitch of a swinging sole per height above the ground, rad/m: see `Walk.heel`."""
    return float(np.radians(1.0) / (gain_mm_per_deg / 1000))


@dataclass(frozen=True)
class Landing:
    """How a foot comes down.

    Attributes:
        down: its speed towards the ground at touch-down, m/s.
        along: its speed over the ground there, m/s, on a straight walk.
        toe_down, toe_up: the largest pitch of the sole after lift-off and before touch-down, rad.
    """

    down: float
    along: float
    toe_down: float
    toe_up: float


def landings(walk: Walk) -> dict[str, Landing]:
    """How they come down without and with each of eros's optimisations, by name."""
    plain = replace(walk, curve=walk.curve.base or walk.curve, heel=0.0)
    found = {"plain": plain, "deceleration": replace(plain, curve=decelerated(plain.curve))}
    if walk.robot.kind == "humanoid":
        found["heel strike"] = replace(plain, heel=heel_pitch_per_metre())
    return {name: landing(variant) for name, variant in found.items()}


def landing(walk: Walk) -> Landing:
    """How the feet of `walk` come down."""
    one = np.array([1.0])
    down = -walk.lift * float(walk.curve.height.rate(one)[0]) / walk.swing_time
    share = float(walk.curve.along.rate(one)[0])
    if walk.curve.over == "ground":
        along = walk.stride * share / walk.swing_time
    else:
        along = walk.stroke * share / walk.swing_time + walk.speed
    s = np.linspace(0.0, 1.0, 1001)
    pitch = walk.heel * walk.lift * walk.curve.height.value(s) * np.cos(np.pi * s)
    return Landing(down, abs(along), max(0.0, float(pitch.max())), max(0.0, -float(pitch.min())))
