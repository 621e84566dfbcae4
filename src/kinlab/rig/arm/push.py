"""A hand that pushes: a force at a point of the limb, for a while."""

import math
from dataclasses import dataclass

from kinlab.dynamics import Contact
from kinlab.errors import UsageError
from kinlab.names import suggestion
from kinlab.robots.model import Limb

STRONGEST = 1000.0  # N; more is a slip of the finger


@dataclass(frozen=True)
class Push:
    """A constant force.

    Attributes:
        start, duration: s since the motion began.
        at: "hand", or the joint at whose link's end it acts.
        force: (3,), N, in the limb frame.
    """

    start: float
    duration: float
    at: str
    force: tuple[float, float, float]

    def acts(self, t: float) -> bool:
        """Whether it acts at time `t` (s)."""
        return self.start <= t < self.start + self.duration

    def contact(self, limb: Limb) -> Contact:
        """The point of the limb that it acts on.

        Raises:
            UsageError: the limb has no such point.
        """
        points = {"hand": len(limb.joints) - 1}
        for i, joint in enumerate(limb.joints):
            if any(joint.link):
                points[joint.name] = i
        if self.at not in points:
            raise UsageError(f"nobody can push at '{self.at}'{suggestion(self.at, points)}")
        return Contact(points[self.at])


def parse_push(text: str) -> Push:
    """A push as people write it: "t=0.5 dur=0.4 at=hand force=-5,0,0" (s, s, place, N).

    Raises:
        UsageError: a key that there is not, or something that is no number.
    """
    fields = {"t": "0", "dur": "inf", "at": "hand", "force": ""}
    for part in text.split():
        key, _, value = part.partition("=")
        if key not in fields:
            raise UsageError(f"a push has no '{key}'{suggestion(key, fields)}")
        fields[key] = value
    numbers = fields["force"].split(",")
    if len(numbers) != 3:
        raise UsageError(f"a push takes a force of three numbers in N, as in force=-5,0,0; got '{text}'")
    start, duration = _number("t", fields["t"]), _number("dur", fields["dur"])
    x, y, z = (_number("force", n) for n in numbers)
    if not (0 <= start < math.inf and duration > 0):
        raise UsageError(f"a push begins at t >= 0 and lasts for dur > 0; got '{text}'")
    if not max(map(abs, (x, y, z))) <= STRONGEST:
        raise UsageError(f"a push takes finite forces of up to {STRONGEST:g} N; got '{fields['force']}'")
    return Push(start, duration, fields["at"], (x, y, z))


def _number(key: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise UsageError(f"the {key} of a push must be a number, got '{text}'") from None
    if math.isnan(value):
        raise UsageError(f"the {key} of a push must be a number, got '{text}'")
    return value
