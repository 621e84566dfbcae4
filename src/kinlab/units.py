"""The one place where people's units (mm, degrees) meet the inside's (metres, radians)."""

import math
from typing import Any

import numpy as np

from kinlab.errors import UsageError
from kinlab.names import resolve

METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0}


def to_metres(values: Any, unit: str = "mm") -> Any:
    """Lengths in `unit` (mm, cm or m) as metres; scalars and arrays alike."""
    return np.asarray(values, dtype=float) * METRES[resolve(unit, METRES, "unit")]


def to_mm(values: Any) -> Any:
    """Metres as millimetres."""
    return np.asarray(values, dtype=float) * 1e3


def to_radians(degrees: float) -> float:
    """Degrees as radians."""
    return math.radians(degrees)


def shown_mm(metres: Any) -> list[float]:
    """A place (3,), in metres, as millimetres to show.

    A picometre is beyond what doubles hold of a leg; rounding there keeps 75.00000000000001 out of sight.
    """
    return [round(float(v), 9) + 0.0 for v in to_mm(metres)]


# A place further out than this (m) is a slip of the finger or of the unit.
FARTHEST = 1e6


def check_place(values: Any, what: str) -> None:
    """Refuse places (..., 3), in metres, that are not finite or beyond all reason.

    Raises:
        UsageError: naming `what` and the offending value.
    """
    finite(values, what)
    if np.abs(values).max(initial=0.0) > FARTHEST:
        raise UsageError(f"{what} must be within {FARTHEST / 1000:g} km; is the unit right?")


def finite(values: Any, what: str) -> None:
    """Refuse NaN and infinities.

    Raises:
        UsageError: naming `what` and the offending value.
    """
    for value in np.ravel(values):
        if not math.isfinite(value):
            raise UsageError(f"{what} must be finite numbers, got {value}")
