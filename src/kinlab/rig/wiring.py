"""Which servo moves which joint: joint angles and what goes over the bus, for all joints at once."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamixel.outfit import worn_by
from kinlab.dynamixel.tables import ControlTable, load_table
from kinlab.errors import KinlabError, UsageError
from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb, Robot
from kinlab.robots.servo import Servo

# The same quantity has another name on other series.
NAMES = {
    "position": ("present_position",),
    "velocity": ("present_speed", "present_velocity"),
    "load": ("present_load",),
    "volts": ("present_voltage", "present_input_voltage"),
}


@dataclass(frozen=True, eq=False)
class Wiring:
    """The J joints of some limbs, limb after limb, each with its servo.

    Attributes:
        robot: whose.
        limbs: of it, in this order.
        servos: one for each joint.
        tables: the control table of each.
    """

    robot: Robot
    limbs: tuple[Limb, ...]
    servos: tuple[Servo, ...]
    tables: tuple[ControlTable, ...]

    @classmethod
    def of(cls, robot: Robot, limbs: Sequence[Limb]) -> "Wiring":
        """The wiring of `limbs`.

        Raises:
            UsageError: a joint has no servo, or the servos are not on a bus.
        """
        worn_by(robot)
        servos = []
        for limb in limbs:
            for joint in limb.joints:
                if joint.servo is None:
                    raise UsageError(f"the {joint.name} of {limb.name} has no servo")
                servos.append(joint.servo)
        return cls(robot, tuple(limbs), tuple(servos), tuple(load_table(s.model.name) for s in servos))

    @cached_property
    def ids(self) -> tuple[int, ...]:
        """The servos' ids (J,)."""
        return tuple(servo.id for servo in self.servos)

    @cached_property
    def joints(self) -> tuple[tuple[str, str], ...]:
        """Limb and joint of each servo (J,)."""
        return tuple((limb.name, joint) for limb in self.limbs for joint in limb.joint_names)

    @cached_property
    def stall_amps(self) -> Array:
        """What each servo draws when it is held fast at full drive (J,), A: the maker's figure."""
        return np.array([table.stall_a for table in self.tables])

    @cached_property
    def standby_amps(self) -> Array:
        """What each servo draws without torque (J,), A; 0 where nobody gives it."""
        return np.array([servo.model.standby or 0.0 for servo in self.servos])

    @cached_property
    def stall_torque(self) -> Array:
        """The torque at full load (J,), N m."""
        return np.array([table.stall_nm for table in self.tables])

    @cached_property
    def fastest(self) -> Array:
        """The speed of each joint without load (J,), rad/s: the maker's figure."""
        return np.array([table.no_load_rpm for table in self.tables]) * np.pi / 30

    @cached_property
    def registers(self) -> tuple[tuple[str, ...], ...]:
        """Of each servo, the names of the registers of position, velocity, load and voltage (J, 4)."""
        return tuple(
            tuple(next(n for n in names if n in table.by_name) for names in NAMES.values())
            for table in self.tables
        )

    @cached_property
    def sign(self) -> Array:
        """+1 or -1 (J,): whether servo and joint turn the same way."""
        return np.array([float(servo.sign) for servo in self.servos])

    @cached_property
    def _scales(self) -> Array:
        """What one tick of these registers is worth (J, 4): rad and rad/s of the joint, share of stall torque, V."""
        found = []
        for servo, table, names in zip(self.servos, self.tables, self.registers, strict=True):
            _, velocity, load, volts = (table.by_name[name].scale for name in names)
            turn = servo.sign * np.pi / 180
            found.append(
                (turn * servo.model.deg_per_step, turn * 6 * velocity, servo.sign * load / 100, volts)
            )
        return np.array(found)

    @cached_property
    def _zeros(self) -> Array:
        """The joint angles at tick 0 (J,), rad."""
        return np.array([float(servo.joint(0)) for servo in self.servos])

    def by_limb(self, values: Array) -> dict[str, Array]:
        """Values of the joints (..., J), each limb's own (..., n) by its name."""
        ends = np.cumsum([len(limb.joints) for limb in self.limbs])[:-1]
        parts = np.split(values, ends, axis=-1)
        return {limb.name: part for limb, part in zip(self.limbs, parts, strict=True)}

    def ticks(self, q: ArrayLike) -> Array:
        """Position commands (..., J) for joint angles (..., J) in rad.

        Raises:
            KinlabError: a servo cannot turn that far.
        """
        q = np.asarray(q, float)
        found = np.stack([servo.command(q[..., j]) for j, servo in enumerate(self.servos)], axis=-1)
        if np.isnan(found).any():
            where = tuple(np.argwhere(np.isnan(found))[0])
            (limb, joint), servo = self.joints[where[-1]], self.servos[where[-1]]
            low, high = servo.model.range_deg
            raise KinlabError(
                f"the {joint} of {limb} would have to stand at {float(servo.degrees(q[where])):.1f} deg of its "
                f"{servo.model.name}, which turns from {low:.0f} to {high:.0f} deg"
            )
        return found

    def measured(self, ticks: ArrayLike) -> Array:
        """The four registers (..., J, 4) as rad and rad/s of the joint, share of stall torque, V."""
        found = np.asarray(ticks, float) * self._scales
        found[..., 0] += self._zeros
        return found
