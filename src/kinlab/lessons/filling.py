"""Filling a lesson's placeholders: `{reach}`, `{reach:.1f}`, `{leg.coxa:g}`.

A substitution of our own: a lesson may come from anybody, and `str.format` would hand it the inside of
every object. What matches no placeholder stays as it stands, so that braces of other meanings do no harm.
"""

import re
from collections.abc import Mapping, Sequence
from numbers import Integral, Real
from typing import Any

PLACEHOLDER = re.compile(r"\{([A-Za-z_]\w*(?:\.[\w-]+)*)(?::([^{}\s]{1,6}))?\}")
_FORMAT = re.compile(r"\+?(?:0\d)?(?:\.\d)?[defgX]")
_NOTHING = re.compile(r"-(0(?:\.0+)?)")
LONGEST = 10_000


class UnknownNameError(LookupError):
    """A placeholder that no value has the name of.

    Attributes:
        name: of the placeholder.
    """

    def __init__(self, name: str, message: str) -> None:
        super().__init__(message)
        self.name = name


def names(text: str) -> list[str]:
    """The placeholders of a text, whole (`leg.coxa`), in their order."""
    return [found[1] for found in PLACEHOLDER.finditer(text)]


def fill(text: str, values: Mapping[str, Any]) -> str:
    """The text with each placeholder's value.

    Raises:
        UnknownNameError: there is no such value, or it cannot be written in the format asked for.

    >>> fill("{x:.1f} mm and {y}", {"x": 12.345, "y": (1, 2.5)})
    '12.3 mm and 1, 2.5'
    """

    def one(found: re.Match[str]) -> str:
        return show(_look_up(found[1], values), found[2] or "", found[0])

    return PLACEHOLDER.sub(one, text)


def _look_up(path: str, values: Mapping[str, Any]) -> Any:
    value: Any = values
    for key in path.split("."):
        if not isinstance(value, Mapping) or key not in value:
            known = ", ".join(map(str, value)) if isinstance(value, Mapping) else ""
            raise UnknownNameError(path, f"no value is named '{path}'; there are: {known or 'none'}")
        value = value[key]
    return value


def show(value: Any, style: str = "", where: str = "") -> str:
    """A value as text: numbers in the style asked for, lists with commas, bytes in hexadecimal.

    Raises:
        UnknownNameError: the style does not fit the value.
    """
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool | str):
        shown = str(value)
    elif isinstance(value, bytes | bytearray):
        shown = bytes(value).hex(" ").upper()
    elif isinstance(value, Real):
        shown = _number(value, style, where)
    elif isinstance(value, Sequence):
        shown = ", ".join(show(v, style, where) for v in value)
    else:
        raise UnknownNameError(where, f"{where}: the value is no number, text or list")
    return shown[:LONGEST]


def _number(value: Any, style: str, where: str) -> str:
    if style and not _FORMAT.fullmatch(style):
        raise UnknownNameError(where, f"{where}: '{style}' is no format; write .1f, d, +.2f, g or 02X")
    whole = style[-1:] in ("d", "X") or (not style and isinstance(value, Integral))
    try:
        number = int(value) if whole else float(value)
    except (OverflowError, ValueError):
        raise UnknownNameError(where, f"{where}: {value!r:.40} is no number to be written") from None
    written = format(number, style or ("d" if whole else ".6g"))
    nothing = _NOTHING.fullmatch(written)
    return nothing[1] if nothing else written
