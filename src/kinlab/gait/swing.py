"""How a foot goes through the air: interchangeable curves, and what each does to it at both ends.

A curve gives, over the progress s of the swing from 0 to 1, how much of the way is done (0 to 1) and
how high the foot is (0 to 1 to 0), with first and second derivatives in s. The way is drawn either in
the frame of the body, from lift-off to touch-down as the body sees them, or over the ground. Over the
ground a curve that starts and ends at rest meets the ground at rest: that is what "velocity-matched"
curves do, whatever the body's own motion.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.polynomial import Polynomial

from kinlab.kinematics.transforms import Array
from kinlab.names import resolve

Function = Callable[[Array], Array]


class Profile(NamedTuple):
    """A function of the progress s (...), with its first and second derivative."""

    value: Function
    rate: Function
    bend: Function


class Sample(NamedTuple):
    """One number and its derivatives in s, each (...)."""

    value: Array
    rate: Array
    bend: Array


@dataclass(frozen=True)
class Curve:
    """A foot's way through the air.

    Attributes:
        name: as typed on the command line.
        along: the share of the way that is done.
        height: in units of the lift.
        over: whether the way is drawn in the frame of the body or over the ground.
        source: paper and equations, or literature.
        base: the curve that this one is a variant of.
    """

    name: str
    along: Profile
    height: Profile
    over: Literal["body", "ground"]
    source: str
    base: "Curve | None" = None

    def __repr__(self) -> str:
        return f"<Curve {self.name}>"


class Jumps(NamedTuple):
    """What a foot's motion over the ground does in no time, at lift-off and at touch-down.

    Velocities in strokes (along) and lifts (height) per swing time, accelerations per swing time squared.
    Each is a pair (lift-off, touch-down) of the foot's value in the air; on the ground it is zero.
    """

    velocity_along: tuple[float, float]
    velocity_height: tuple[float, float]
    acceleration_along: tuple[float, float]
    acceleration_height: tuple[float, float]


def jumps(curve: Curve, duty: float) -> Jumps:
    """The jumps of `curve` on a straight walk at a duty factor: the stroke is 1, the lift 1, the swing time 1."""
    ends = np.array([0.0, 1.0])
    body = (1 - duty) / duty  # the body's way during the swing, in strokes
    if curve.over == "ground":
        velocity = (1 + body) * curve.along.rate(ends)
        acceleration = (1 + body) * curve.along.bend(ends)
    else:
        velocity = curve.along.rate(ends) + body
        acceleration = curve.along.bend(ends)
    return Jumps(
        _pair(velocity), _pair(curve.height.rate(ends)), _pair(acceleration), _pair(curve.height.bend(ends))
    )


def _pair(values: Array) -> tuple[float, float]:
    # What is left of a sine of pi is nothing.
    first, last = (round(float(v), 12) + 0.0 for v in values)
    return first, last


def _polynomial(p: Polynomial) -> Profile:
    return Profile(p, p.deriv(), p.deriv(2))


def _bezier(points: tuple[float, ...]) -> Profile:
    n = len(points) - 1
    s, rest = Polynomial([0, 1]), Polynomial([1, -1])
    binomials = [1]
    for i in range(n):
        binomials.append(binomials[-1] * (n - i) // (i + 1))
    total = Polynomial([0.0])
    for i, (c, weight) in enumerate(zip(points, binomials, strict=True)):
        total = total + c * weight * s**i * rest ** (n - i)
    return _polynomial(total)


PI = np.pi
LINE = Profile(lambda s: s, np.ones_like, np.zeros_like)
SINE = Profile(lambda s: np.sin(PI * s), lambda s: PI * np.cos(PI * s), lambda s: -(PI**2) * np.sin(PI * s))
QUARTERS = Profile(
    lambda s: (1 - np.cos(PI * s)) / 2,
    lambda s: PI / 2 * np.sin(PI * s),
    lambda s: PI**2 / 2 * np.cos(PI * s),
)
CYCLOID = Profile(
    lambda s: s - np.sin(2 * PI * s) / (2 * PI),
    lambda s: 1 - np.cos(2 * PI * s),
    lambda s: 2 * PI * np.sin(2 * PI * s),
)
HUMP = Profile(
    lambda s: (1 - np.cos(2 * PI * s)) / 2,
    lambda s: PI * np.sin(2 * PI * s),
    lambda s: 2 * PI**2 * np.cos(2 * PI * s),
)
_S = Polynomial([0, 1])
QUINTIC = _polynomial(10 * _S**3 - 15 * _S**4 + 6 * _S**5)
SEXTIC = _polynomial(64 * _S**3 * (1 - _S) ** 3)
# Hyun, Seok, Lee and Kim, IJRR 2014: twelve points, the way from -1 to 1 brought to 0 to 1.
_ALONG = tuple((x + 1) / 2 for x in (-1, -1.4, -1.5, -1.5, -1.5, 0, 0, 0, 1.5, 1.5, 1.4, 1))
_HEIGHT = (0, 0, 0.9, 0.9, 0.9, 0.9, 0.9, 1.1, 1.1, 1.1, 0, 0)

CURVES = {
    curve.name: curve
    for curve in (
        Curve("line-sine", LINE, SINE, "body", "krsri-hexapod, equations (24) to (27), (26) corrected"),
        Curve("quarter-circle", QUARTERS, SINE, "body", "eros-humanoid, equations (36) to (43), corrected"),
        Curve("cycloid", CYCLOID, HUMP, "body", "the cycloid at rest in the body frame at both ends"),
        Curve("matched-cycloid", CYCLOID, HUMP, "ground", "the cycloid at rest over the ground at both ends"),
        Curve(
            "matched-quintic", QUINTIC, SEXTIC, "ground", "velocity and acceleration matched to the ground"
        ),
        Curve("bezier", _bezier(_ALONG), _bezier(_HEIGHT), "body", "Hyun et al., IJRR 2014: twelve points"),
    )
}
# Where a robot's paper prints none: no jump of velocity or acceleration anywhere.
DEFAULT = "matched-quintic"


def find_curve(name: str) -> Curve:
    """The curve that `name` means.

    Raises:
        UsageError: no such curve.
    """
    return CURVES[resolve(name, CURVES, "foot trajectory")]
