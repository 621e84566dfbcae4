"""Values as people write them, 512, 0x200 or 90deg, and as a register holds them."""

import math
import re

from kinlab.dynamixel.tables import Register
from kinlab.errors import UsageError
from kinlab.names import resolve

# How much of the register's own unit one of the named unit is.
UNITS = {
    "deg": {"deg": 1.0, "rad": 180 / math.pi, "rev": 360.0},
    "rpm": {"rpm": 1.0, "deg/s": 1 / 6, "rad/s": 30 / math.pi},
    "rev/min2": {"rev/min2": 1.0},
    "%": {"%": 1.0},
    "V": {"V": 1.0, "mV": 1e-3},
    "degC": {"degC": 1.0, "C": 1.0},
    "us": {"us": 1.0, "ms": 1e3, "s": 1e6},
    "ms": {"ms": 1.0, "s": 1e3},
}
_NUMBER = re.compile(r"([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?)\s*([A-Za-z%/0-9]*)")


def to_ticks(value: int | float | str, register: Register, unit: str | None = None) -> int:
    """A value for `register` as the number that it holds.

    Args:
        value: ticks, or (with `unit`, or as "90deg", "1.2rad", "60rpm", "50%") a physical amount.

    Raises:
        UsageError: not a number, or a unit that the register does not have.
    """
    if isinstance(value, str):
        text = value.strip()
        try:
            return int(text, 0)
        except ValueError:
            pass
        match = _NUMBER.fullmatch(text)
        if match is None:
            raise UsageError(f"'{value}' is no number; give ticks (512, 0x200) or an amount (90deg)")
        value, unit = float(match[1].replace(",", ".")), match[2] or unit
    if not math.isfinite(value):
        raise UsageError(f"{register.name} takes a finite number, got {value}")
    if unit is None:
        if value != int(value):
            raise UsageError(f"{register.name} takes a whole number, or an amount with its unit; got {value}")
        return int(value)
    return register.ticks(value * _factor(register, unit))


def from_ticks(ticks: int, register: Register, unit: str | None = None) -> int | float:
    """What `register` holds, in `unit`; None: as it stands, in ticks."""
    return ticks if unit is None else register.physical(ticks) / _factor(register, unit)


def _factor(register: Register, unit: str) -> float:
    if not register.unit:
        raise UsageError(f"{register.name} has no unit; give the bare number")
    units = UNITS[register.unit]
    return units[resolve(unit, units, f"unit of {register.name}")]
