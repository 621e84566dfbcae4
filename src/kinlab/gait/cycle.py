"""One cycle of a walk frame by frame, worked out before it is played: poses, margins, joint speeds."""

import math
from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from kinlab.gait.limits import Limits, assess, joint_rates
from kinlab.gait.schedule import Phase
from kinlab.gait.stability import Least, Stability, least_margins, stability
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array

# Frames of a second of walking, and how many a cycle has at least and at most.
RATE, FEWEST, MOST = 20.0, 48, 2400
# Frames lie in the middle of equal parts of the cycle; of so many, none lies on an event.
PARTS = 16


@dataclass(frozen=True, eq=False, repr=False)
class Cycle:
    """F frames of one cycle of a walk that goes on for ever.

    Attributes:
        walk: the walk.
        limits: how near it comes to its servos' limits.
        state: poses and margins of the frames (F,).
        rates: of the joints (F, L, n), rad/s.
    """

    walk: Walk
    limits: Limits
    state: Stability
    rates: Array

    def __len__(self) -> int:
        return len(self.state.static)

    @cached_property
    def used(self) -> Array:
        """The share of its servo's speed without load that each joint needs (F, L, n); 0 where no servo is known."""
        return np.asarray(np.abs(self.rates) / self.limits.allowed)

    @cached_property
    def least(self) -> tuple[Least, ...]:
        """The smallest margins of each phase, in the gait's order."""
        return least_margins(self.walk)

    @cached_property
    def _starts(self) -> list[int]:
        """The number of the first frame of each phase."""
        return [math.ceil(float(phase.start) * len(self) - 0.5) for phase in self.walk.gait.phases]

    def phase(self, frame: int) -> Phase:
        """The phase that a frame lies in."""
        # Before the first begins, the last of the cycle before still lasts.
        return self.walk.gait.phases[bisect_right(self._starts, frame) - 1]

    def frame_at(self, t: float) -> int:
        """The number of the frame that is shown at time `t`, s; the cycle goes on for ever."""
        return self._count(t) % len(self)

    def frames_on(self, t: float, frames: int) -> float:
        """The time, s, in the middle of the frame that is `frames` after the one at `t`; negative: before it."""
        return self._middle(self._count(t) + frames)

    def phases_on(self, t: float, phases: int) -> float:
        """The time, s, of the first frame of the phase that is `phases` after the one at `t`; negative: before it.

        From within a phase the first step back leads to where it began.
        """
        turns, frame = divmod(self._count(t), len(self))
        number = bisect_right(self._starts, frame) - 1
        if phases < 0 and frame != self._starts[number]:
            number += 1
        ahead, number = divmod(number + phases, len(self._starts))
        return self._middle((turns + ahead) * len(self) + self._starts[number])

    def _count(self, t: float) -> int:
        return math.floor(t / self.walk.period * len(self) + 1e-9)

    def _middle(self, count: int) -> float:
        return (count + 0.5) * self.walk.period / len(self)


def cycle_of(walk: Walk) -> Cycle:
    """The frames of a cycle of `walk`, which goes on for ever.

    Raises:
        KinlabError: beyond the legs or the servos, see `assess`.
    """
    limits = assess(walk)
    count = math.ceil(min(max(walk.period * RATE, FEWEST), MOST) / PARTS) * PARTS
    times = (np.arange(count) + 0.5) / count * walk.period
    return Cycle(walk, limits, stability(walk.at(times)), joint_rates(walk, times))
