"""Voltage, temperature and load of a servo, and when they become alarms.

The makers do not publish heat capacities or how long an overload may last, so these figures are assumed.
"""

import math

from kinlab.dynamixel.tables import ControlTable

AMBIENT = 25.0  # degC
WARMING = 8.0  # K per W
WARMING_TIME = 300.0  # s
OVERLOAD_SHARE = 0.8  # of the stall torque
OVERLOAD_TIME = 2.0  # s


class Health:
    """What wears on a servo.

    Attributes:
        temperature: degC.
        strained: how long the load has been above what the servo bears, s.
    """

    def __init__(self, table: ControlTable) -> None:
        self.temperature = AMBIENT
        self.strained = 0.0
        self._bearable = OVERLOAD_SHARE * table.stall_nm
        self._ohms = table.rated_v / table.stall_a

    @property
    def overloaded(self) -> bool:
        return self.strained >= OVERLOAD_TIME

    def go_on(self, torque: float, current: float, dt: float) -> None:
        """Let `dt` seconds pass under that torque (N m) and current (A)."""
        if torque >= self._bearable or torque <= -self._bearable:
            self.strained += dt
        elif self.strained and not self.overloaded:
            self.strained = 0.0
        final = AMBIENT + current * current * self._ohms * WARMING
        self.temperature -= (final - self.temperature) * math.expm1(-dt / WARMING_TIME)
