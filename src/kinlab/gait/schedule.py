"""Gaits as schedules: which leg stands when. Instants are exact fractions of the cycle.

One convention of phase, that of the literature: a leg's phase is the lag of its touch-down behind the
beginning of the cycle. It stands for the duty factor, then swings for the rest.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.robots.provenance import UNSOURCED, Provenance


@dataclass(frozen=True)
class Event:
    """An instant, as a fraction of the cycle, at which legs lift or land."""

    at: Fraction
    lifts: tuple[str, ...]
    lands: tuple[str, ...]


@dataclass(frozen=True)
class Phase:
    """What lies between two events: the same legs swing, the same legs stand.

    Attributes:
        number: from 1.
        start, end: fractions of the cycle; the last phase of a cycle may end beyond 1.
        swing, stance: the legs.
    """

    number: int
    start: Fraction
    end: Fraction
    swing: tuple[str, ...]
    stance: tuple[str, ...]


@dataclass(frozen=True)
class Gait:
    """A gait.

    Attributes:
        name: as typed on the command line.
        kind: of the robots that it fits.
        duty: the duty factor, the share of the cycle that each leg stands.
        touchdown: by leg, the fraction of the cycle at which it lands.
        source: where it comes from.
    """

    name: str
    kind: str
    duty: Fraction
    touchdown: Mapping[str, Fraction]
    source: Provenance = field(default=UNSOURCED)

    @property
    def legs(self) -> tuple[str, ...]:
        """The legs that it moves."""
        return tuple(self.touchdown)

    def liftoff(self, leg: str) -> Fraction:
        """The fraction of the cycle at which `leg` lifts."""
        return (self.touchdown[leg] + self.duty) % 1

    def swings(self, leg: str, at: Fraction) -> bool:
        """Whether `leg` is in the air right after the instant `at`."""
        return (at - self.touchdown[leg]) % 1 >= self.duty

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """The instants of one cycle at which something lifts or lands, in order."""
        instants = {self.touchdown[leg] for leg in self.legs} | {self.liftoff(leg) for leg in self.legs}
        return tuple(
            Event(
                at,
                tuple(leg for leg in self.legs if self.liftoff(leg) == at),
                tuple(leg for leg in self.legs if self.touchdown[leg] == at),
            )
            for at in sorted(instants)
        )

    @cached_property
    def phases(self) -> tuple[Phase, ...]:
        """What lies between the events, in order, numbered from 1."""
        starts = [event.at for event in self.events]
        ends = [*starts[1:], starts[0] + 1]
        return tuple(
            Phase(
                number,
                start,
                end,
                tuple(leg for leg in self.legs if self.swings(leg, start)),
                tuple(leg for leg in self.legs if not self.swings(leg, start)),
            )
            for number, (start, end) in enumerate(zip(starts, ends, strict=True), 1)
        )

    def lags(self, legs: Iterable[str]) -> Array:
        """The touch-down phases of `legs`, in their order, (L,)."""
        return np.array([float(self.touchdown[leg]) for leg in legs])


def wave_gait(pairs: int, duty: Fraction) -> tuple[Fraction, ...]:
    """Touch-down phases of the wave gait, left and right leg of each pair, front to rear.

    Phases of neighbours on a side differ by the duty factor, those of a pair by half a cycle (Song and
    Waldron, Machines That Walk, 1989). Among the regular symmetric gaits none has a larger
    longitudinal stability margin.

    Args:
        pairs: of legs, at least 2.
        duty: at least 3 / (2 pairs), below which no wave gait stands on three legs all the time.

    >>> [str(phase) for phase in wave_gait(2, Fraction(3, 4))]
    ['0', '1/2', '3/4', '1/4']
    """
    left = [m * duty % 1 for m in range(pairs)]
    return tuple(phase for side in left for phase in (side, (side + Fraction(1, 2)) % 1))


def wave_margin(pairs: int, duty: float, pitch: float, stroke: float) -> float:
    """The least longitudinal margin of a wave gait straight ahead, in the unit of `pitch` and `stroke`.

    S = (n / 2 - 1) P + (1 - 3 / (4 beta)) R, for strokes up to the pitch (Song and Waldron, 1989).

    Args:
        pairs: of legs, n.
        duty: the duty factor beta.
        pitch: between neighbouring legs of a side, P.
        stroke: of a foot in the body frame during its stance, R.
    """
    return (pairs / 2 - 1) * pitch + (1 - 3 / (4 * duty)) * stroke
