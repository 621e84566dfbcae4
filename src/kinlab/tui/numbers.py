"""Numbers as people type them into a field: decimal comma or point, with or without a unit."""

import math
import re

# What of each shown unit another one is worth.
UNITS: dict[str, dict[str, float]] = {
    "mm": {"mm": 1.0, "cm": 10.0, "m": 1000.0},
    "deg": {"deg": 1.0, "°": 1.0, "rad": 180 / math.pi},
    "mm/s": {"mm/s": 1.0, "cm/s": 10.0, "m/s": 1000.0},
    "deg/s": {"deg/s": 1.0, "°/s": 1.0, "rad/s": 180 / math.pi},
    "N": {"N": 1.0, "kN": 1000.0},
    "s": {"s": 1.0, "ms": 1e-3},
    "%": {"%": 1.0},
}
_NUMBER = re.compile(r"\s*([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(\D*?)\s*")


class NotANumberError(ValueError):
    """What was typed is no number; `key` names the sentence that says why, `values` fill it in."""

    def __init__(self, key: str, **values: object) -> None:
        super().__init__(key)
        self.key, self.values = key, values


def read(text: str, unit: str = "") -> float:
    """The number in `text`, in `unit`.

    Raises:
        NotANumberError: it is none, or its unit is another quantity's.
    """
    match = _NUMBER.fullmatch(text.replace("\N{MINUS SIGN}", "-"))
    if match is None:
        raise NotANumberError("field.empty" if not text.strip() else "field.no_number", text=text.strip())
    value = float(match[1].replace(",", "."))
    units = UNITS.get(unit, {unit: 1.0})
    typed = match[2]
    if typed and typed not in units:
        raise NotANumberError("field.no_unit", text=typed, units=", ".join(filter(None, units)) or "-")
    value *= units[typed] if typed else 1.0
    if not math.isfinite(value):
        raise NotANumberError("field.no_number", text=text.strip())
    return value


def shown(value: float, digits: int = 3) -> str:
    """A number with at most `digits` decimals."""
    text = f"{value:.{digits}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text in ("-0", "") else text
