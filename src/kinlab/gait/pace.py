"""How far a walk has come: travel in seconds at full command, over time."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array


@dataclass(frozen=True)
class Pace:
    """From standing to full speed, on, and back to standing; the speed changes without a jump of acceleration.

    Attributes:
        begin: when the first cycle begins, s.
        ramp: how long it takes to reach full speed, and to stop, s.
        way: the whole travel, in s at full speed.
    """

    begin: float
    ramp: float
    way: float

    @property
    def peak(self) -> float:
        """The share of full speed that is reached: less than 1 on a way too short for it."""
        return min(1.0, self.way / self.ramp)

    @property
    def end(self) -> float:
        """When the body stands again, s."""
        return self.begin + self.ramp + (self.way / self.peak if self.way else self.ramp)

    def _ramps(self, t: ArrayLike) -> tuple[Array, Array]:
        t = np.asarray(t, float)
        up = np.clip((t - self.begin) / self.ramp, 0.0, 1.0)
        down = np.clip((t - self.end + self.ramp) / self.ramp, 0.0, 1.0)
        return up, down

    def travel(self, t: ArrayLike) -> Array:
        """The travel at times `t` (...), s."""
        up, down = self._ramps(t)
        on = np.clip(
            np.asarray(t, float) - self.begin - self.ramp, 0.0, self.end - self.begin - 2 * self.ramp
        )
        reached = self.ramp * (_slope(up) + down - _slope(down)) + on
        return np.asarray(self.peak * reached)


def fade(t: ArrayLike, length: float, total: float) -> Array:
    """1 within a time of `total` seconds, from 0 and to 0 over `length` seconds at its ends."""
    t = np.asarray(t, float)
    return np.asarray(_step(np.clip(t / length, 0, 1)) * _step(np.clip((total - t) / length, 0, 1)))


def _step(u: Array) -> Array:
    return np.asarray(u * u * (3 - 2 * u))


def _slope(u: Array) -> Array:
    """The integral of `_step`."""
    return np.asarray(u**3 * (1 - u / 2))
