"""What was measured along a path, as arrays."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.rig.follow import Sample
from kinlab.rig.wiring import Wiring


@dataclass(frozen=True, eq=False, repr=False)
class Record:
    """F ticks of J joints, at least one; NaN where a servo did not answer.

    Attributes:
        wiring: of the joints.
        samples: tick by tick.
    """

    wiring: Wiring
    samples: Sequence[Sample]

    @cached_property
    def t(self) -> Array:
        """Times (F,), s."""
        return np.array([s.t for s in self.samples])

    @cached_property
    def way(self) -> Array:
        """How far the path had come (F,), s."""
        return np.array([s.way for s in self.samples])

    @cached_property
    def planned(self) -> Array:
        """Where the joints should have been (F, J), rad."""
        return np.array([s.planned for s in self.samples])

    @cached_property
    def q(self) -> Array:
        """Where the joints were (F, J), rad."""
        return np.array([s.reading.q for s in self.samples])

    @cached_property
    def velocity(self) -> Array:
        """Of the joints (F, J), rad/s."""
        return np.array([s.reading.velocity for s in self.samples])

    @cached_property
    def load(self) -> Array:
        """Share of the stall torque (F, J)."""
        return np.array([s.reading.load for s in self.samples])

    @cached_property
    def volts(self) -> Array:
        """At the servos (F, J)."""
        return np.array([s.reading.volts for s in self.samples])

    @cached_property
    def amps(self) -> Array:
        """From the supply, estimated (F, J), see `Rig.read`."""
        return np.array([s.reading.amps for s in self.samples])

    @cached_property
    def watts(self) -> Array:
        """Of each servo (F, J)."""
        return np.array([s.watts for s in self.samples])

    @cached_property
    def joules(self) -> Array:
        """Since the first tick (F,)."""
        return np.array([s.joules for s in self.samples])

    @cached_property
    def idle_joules(self) -> float:
        """The part of the energy that the servos would have taken without torque."""
        return self._joules(self.wiring.standby_amps)

    @cached_property
    def motor_joules(self) -> float:
        """The energy if the supply gave all of the motors' current, as it does to a motor without a bridge."""
        return self._joules(self.wiring.standby_amps + np.abs(self.load) * self.wiring.stall_amps)

    def _joules(self, amps: Array) -> float:
        watts = np.nan_to_num(self.volts * amps).sum(axis=1)
        return float(watts[1:] @ np.diff(self.t))

    @cached_property
    def errors(self) -> Array:
        """How far each limb's tip was from where it should have been (F, L), m."""
        off, first = [], 0
        for limb in self.wiring.limbs:
            own = slice(first, first := first + len(limb.joints))
            real, wanted = (limb.fk(angles[:, own])[..., :3, 3] for angles in (self.q, self.planned))
            off.append(np.linalg.norm(real - wanted, axis=-1))
        return np.stack(off, axis=-1)

    @cached_property
    def missing(self) -> Array:
        """Which servos did not answer (F, J)."""
        return np.isnan(self.q)

    @cached_property
    def lost(self) -> dict[int, int]:
        """By servo, how often it did not answer; absent if never."""
        counts = self.missing.sum(axis=0).tolist()
        return {number: count for number, count in zip(self.wiring.ids, counts, strict=True) if count}

    @cached_property
    def alarms(self) -> dict[int, list[str]]:
        """By servo, all that it reported about its state."""
        found: dict[int, list[str]] = {}
        for sample in self.samples:
            for number, names in sample.alarms.items():
                found[number] = list(dict.fromkeys([*found.get(number, []), *names]))
        return found
