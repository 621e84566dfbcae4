"""Servos as a robot wears them: joint angle to servo angle to what goes over the wire."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array
from kinlab.robots.provenance import UNSOURCED, Provenance


@dataclass(frozen=True)
class ServoModel:
    """What a model of servo takes as a position command.

    Attributes:
        name: the maker's name.
        protocol: "1.0" or "2.0" (Dynamixel), or "pwm".
        lowest, highest: the command range, in ticks (Dynamixel) or microseconds (PWM).
        deg_per_step: the angle of one tick or microsecond.
        torque: stall torque, in N m.
        speed: without load, in rad/s.
        source: where these figures come from.
        standby: the current without torque, in A; None where nobody gives one.
        standby_source: where it comes from.
    """

    name: str
    protocol: str
    lowest: int
    highest: int
    deg_per_step: float
    torque: float
    speed: float
    source: Provenance
    standby: float | None = None
    standby_source: Provenance = UNSOURCED

    @property
    def unit(self) -> str:
        """What one step of the command is called."""
        return "us" if self.protocol == "pwm" else "tick"

    @property
    def range_deg(self) -> tuple[float, float]:
        """The servo angles that a command can express; 0 deg is the lowest command."""
        return 0.0, (self.highest - self.lowest) * self.deg_per_step


@dataclass(frozen=True)
class Servo:
    """A servo on a joint: servo_deg = zero_deg + sign * joint_deg.

    Attributes:
        id: on the bus, or the output channel of a PWM servo.
        model: what it is.
        zero_deg: its angle where the joint is at zero.
        sign: +1 or -1.
        source: where zero and sign come from.
    """

    id: int
    model: ServoModel
    zero_deg: float
    sign: int
    source: Provenance

    def degrees(self, joint: ArrayLike) -> Array:
        """Servo angles, in degrees, for joint angles in rad, brought into the servo's turn where a turn fits."""
        angle = self.zero_deg + self.sign * np.degrees(np.asarray(joint, float))
        low, high = self.model.range_deg
        centre = (low + high) / 2
        # Angles repeat after a turn; the one nearest the middle of the range is the one to command.
        return np.asarray(angle - 360.0 * np.round((angle - centre) / 360.0))

    def command(self, joint: ArrayLike) -> Array:
        """The nearest position command (ticks or microseconds) for joint angles in rad.

        NaN where the servo cannot turn that far: a command is refused, never clipped.
        """
        low, high = self.model.range_deg
        degrees = self.degrees(joint)
        inside = (degrees >= low - 1e-9) & (degrees <= high + self.model.deg_per_step / 2)
        step = self.model.lowest + np.round(degrees / self.model.deg_per_step)
        return np.where(inside, np.clip(step, self.model.lowest, self.model.highest), np.nan)

    def joint(self, command: ArrayLike) -> Array:
        """The joint angle, in rad, at which a position command puts the joint."""
        degrees = (np.asarray(command, float) - self.model.lowest) * self.model.deg_per_step
        return np.asarray(np.radians(self.sign * (degrees - self.zero_deg)))
