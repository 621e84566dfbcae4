"""A motion as its rig needs it: commands, angles and loads at even times."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import KinlabError
from kinlab.gait import Walk
from kinlab.kinematics.transforms import Array
from kinlab.rig.ground import weight_torques
from kinlab.rig.wiring import Wiring


@dataclass(frozen=True, eq=False, repr=False)
class Path:
    """Frames of J joints, `step` seconds apart; straight between them.

    Attributes:
        step: s.
        end: when it is over, s. A path without an end begins anew after its last frame, which is its first.
        q: joint angles (F, J), rad.
        ticks: commands (F, J).
        torques: of the weight on the joints (F, J), N m.
    """

    step: float
    end: float
    q: Array
    ticks: Array
    torques: Array

    def angles(self, t: ArrayLike) -> Array:
        """Where the joints should be (J,) at time `t`, s, or each at a time of its own (J,)."""
        return self._between(self.q, t)

    def commands(self, t: float) -> Array:
        """Position commands (J,) for time `t`, s."""
        return np.rint(self._between(self.ticks, t))

    def load(self, t: float) -> Array:
        """Torques of the weight (J,) at time `t`, s."""
        return self._between(self.torques, t)

    def _between(self, frames: Array, t: ArrayLike) -> Array:
        last = len(frames) - 1.0
        at = np.asarray(t) / self.step
        at = at % last if self.end == np.inf else np.clip(at, 0.0, last)
        before = np.minimum(at.astype(int), len(frames) - 2)
        joints = np.arange(frames.shape[1])
        first = frames[before, joints]
        return np.asarray(first + (at - before) * (frames[before + 1, joints] - first))


def path_of(walk: Walk, wiring: Wiring, rate: float) -> Path:
    """The frames of a walk, `rate` of them a second; of one that goes on for ever, at least as many, of one cycle.

    Raises:
        KinlabError: a foot is out of reach, or a servo cannot turn that far.
    """
    if walk.pace is None:
        count = int(np.ceil(walk.period * rate)) + 1
        step = walk.period / (count - 1)
    else:
        count, step = int(np.ceil(walk.duration * rate)) + 2, 1 / rate
    motion = walk.at(np.arange(count) * step)
    if not motion.reachable.all():
        frame, leg = np.argwhere(~motion.reachable)[0]
        raise KinlabError(f"{walk.robot.legs[leg].name} is out of reach at {frame * step:.3f} s")
    q = motion.q.reshape(count, -1)
    return Path(step, walk.duration, q, wiring.ticks(q), weight_torques(motion).reshape(count, -1))
