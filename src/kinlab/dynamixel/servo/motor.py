"""The plant behind a servo: what turns when the firmware drives it."""

import math
from typing import Protocol

from kinlab.dynamixel.tables import ControlTable

RPM = math.tau / 60


class Plant(Protocol):
    """Anything a servo's firmware can drive: a motor with its gear and load, or a simulator's joint.

    Attributes:
        angle: of the horn, rad, not wrapped, counter-clockwise positive; 0 where the servo reads tick 0.
        velocity: of the horn, rad/s.
        torque: that the motor gives to the horn, N m.
        current: that the motor draws, A.
    """

    angle: float
    velocity: float
    torque: float
    current: float

    def step(self, drive: float, volts: float, dt: float) -> None:
        """Go on by `dt` seconds with the winding at `drive` (-1 to 1) times `volts`."""


class GearMotor:
    """A DC motor with its gear: inertia, friction, back-EMF; held against, turned or loaded from outside.

    The model's stall torque, no-load speed and gear ratio come from its data sheet; the rotor's inertia
    and the share of dry friction are assumed (no maker prints them). While the drive is constant the
    motion is that of a first-order lag, so a step of any length is exact.

    Attributes:
        external: torque that the outside exerts on the horn, N m.
        load_inertia: of what hangs on the horn, kg m2.
        held: the horn cannot turn at all (a stuck servo).
    """

    ROTOR_INERTIA = 7e-8
    DRY_FRICTION = 0.02

    def __init__(self, table: ControlTable, angle: float = 0.0) -> None:
        self.angle = angle
        self.velocity = 0.0
        self.torque = 0.0
        self.current = 0.0
        self.external = 0.0
        self.load_inertia = 0.0
        self.held = False
        self._torque_per_volt = table.stall_nm / table.rated_v
        self._amps_per_torque = table.stall_a / table.stall_nm
        self._friction = self.DRY_FRICTION * table.stall_nm
        self._drag = (table.stall_nm - self._friction) / (table.no_load_rpm * RPM)
        self._rotor = self.ROTOR_INERTIA * table.gear_ratio**2

    def step(self, drive: float, volts: float, dt: float) -> None:
        """Go on by `dt` seconds with the winding at `drive` (-1 to 1) times `volts`."""
        push = drive * volts * self._torque_per_volt
        if self.held:
            self.velocity = 0.0
        else:
            self._move(push + self.external, dt)
        self.torque = push - self._drag * self.velocity
        self.current = abs(self.torque) * self._amps_per_torque

    def _move(self, push: float, dt: float) -> None:
        velocity = self.velocity
        if velocity == 0.0 and -self._friction <= push <= self._friction:
            return
        forward = velocity > 0.0 if velocity else push > 0.0
        end = (push - self._friction if forward else push + self._friction) / self._drag
        lag = (self._rotor + self.load_inertia) / self._drag
        later = end + (velocity - end) * math.exp(-dt / lag)
        if velocity and (later > 0.0) != forward:
            # Dry friction changes its sign here: stop, then see whether the push is enough to go on.
            rest = lag * math.log((velocity - end) / -end)
            self.angle += end * rest + velocity * lag
            self.velocity = 0.0
            self._move(push, dt - rest)
            return
        self.angle += end * dt + (velocity - later) * lag
        self.velocity = later
