"""A robot that walks on the spot for as long as somebody looks, and is measured meanwhile."""

from bisect import bisect_right
from collections import deque
from operator import attrgetter

from kinlab.gait import Walk
from kinlab.rig.follow import SECONDS, Sample, follow
from kinlab.rig.path import path_of
from kinlab.rig.rig import Rig

RATE = 50.0  # commands and readings per second
KEPT = 2  # cycles whose ticks are kept


class Treadmill:
    """A walk without an end on an emulated rig, in simulated time, which goes on only when it is asked to.

    with Treadmill(walk) as treadmill:
        treadmill.tread(until=0.5)
        treadmill.at(0.5).power

    Attributes:
        walk: that is walked.
        wiring: of the servos.
        samples: the latest ticks, oldest first.
    """

    def __init__(self, walk: Walk) -> None:
        """Take up the first pose; the torque stays on until `close`.

        Raises:
            UsageError: the robot's servos are not on a bus.
            KinlabError: a servo cannot turn that far.
        """
        self.walk = walk
        self.samples: deque[Sample] = deque(maxlen=int(KEPT * walk.period * RATE) + 2)
        self._rig = Rig.open(walk.robot)
        self.wiring = self._rig.wiring
        try:
            path = path_of(walk, self.wiring, RATE)
            self._rig.hold()
            self._rig.approach(path.q[0])
        except BaseException:
            self.close()
            raise
        self._ticks = follow(self._rig, path, RATE)

    def __enter__(self) -> "Treadmill":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Switch the torque off."""
        self._rig.__exit__(None, None, None)

    def tread(self, until: float, most: int | None = None) -> bool:
        """Walk on to time `until`, s, in no more than `most` ticks; gives whether it has come there."""
        ticks = 0
        while not self.samples or self.samples[-1].t < until:
            if ticks == most:
                return False
            self.samples.append(next(self._ticks))
            ticks += 1
        return True

    def at(self, t: float) -> Sample | None:
        """The tick at time `t`, s, or the last before it; None where it is not walked yet, or no longer kept."""
        found = bisect_right(self.samples, t, key=attrgetter("t"))
        return self.samples[found - 1] if found and t <= self.samples[-1].t + 1 / RATE else None

    @property
    def cycle_power(self) -> float | None:
        """The mean power over the last whole cycle, W; None before there is one."""
        if not self.samples:
            return None
        last = self.samples[-1]
        first = self.at(last.t - self.walk.period)
        return (last.joules - first.joules) / (last.t - first.t) if first else None

    @property
    def per_metre(self) -> float | None:
        """What that cycle costs, Wh per metre of the way; None before there is one, or without a way."""
        power = self.cycle_power
        return power / self.walk.speed / SECONDS if power and self.walk.speed else None
