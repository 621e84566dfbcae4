"""What students type, read generously: decimal comma or point, units attached, labels, stray characters."""

import math
import re
import unicodedata
from dataclasses import dataclass

LONGEST = 500
LONGEST_SCRIPT = 20_000
# Beyond it, changing the unit or squaring would leave the numbers that there are.
LARGEST = 1e100

# How many of the first unit of its kind one is; kinds in the order length, angle, time, ...
UNITS: dict[str, tuple[str, float]] = {
    "mm": ("length", 1e-3), "cm": ("length", 1e-2), "m": ("length", 1.0), "km": ("length", 1e3),
    "deg": ("angle", math.pi / 180), "rad": ("angle", 1.0), "turn": ("angle", math.tau),
    "us": ("time", 1e-6), "ms": ("time", 1e-3), "s": ("time", 1.0), "min": ("time", 60.0),
    "Hz": ("frequency", 1.0), "kHz": ("frequency", 1e3),
    "mm/s": ("speed", 1e-3), "cm/s": ("speed", 1e-2), "m/s": ("speed", 1.0),
    "deg/s": ("rate", math.pi / 180), "rad/s": ("rate", 1.0), "rpm": ("rate", math.pi / 30),
    "g": ("mass", 1e-3), "kg": ("mass", 1.0),
    "mN": ("force", 1e-3), "N": ("force", 1.0), "kN": ("force", 1e3),
    "mNm": ("torque", 1e-3), "Nmm": ("torque", 1e-3), "Ncm": ("torque", 1e-2), "Nm": ("torque", 1.0),
    "kgfcm": ("torque", 0.0980665),
    "mJ": ("energy", 1e-3), "J": ("energy", 1.0), "kJ": ("energy", 1e3), "Wh": ("energy", 3600.0),
    "mW": ("power", 1e-3), "W": ("power", 1.0),
    "mA": ("current", 1e-3), "A": ("current", 1.0),
    "mV": ("voltage", 1e-3), "V": ("voltage", 1.0),
    "bps": ("data rate", 1.0), "kbps": ("data rate", 1e3), "Mbps": ("data rate", 1e6),
    "%": ("share", 0.01), "1": ("share", 1.0),
}  # fmt: skip
_OTHER_NAMES = {
    "°": "deg", "degree": "deg", "derajat": "deg",
    "radian": "rad", "putaran": "turn", "rev": "turn",
    "millimetre": "mm", "millimeter": "mm", "milimeter": "mm", "centimetre": "cm", "centimeter": "cm",
    "sentimeter": "cm", "meter": "m", "metre": "m", "kilometre": "km", "kilometer": "km",
    "sec": "s", "second": "s", "detik": "s", "minute": "min", "menit": "min",
    "millisecond": "ms", "milidetik": "ms", "microsecond": "us", "mikrodetik": "us", "µs": "us", "μs": "us",
    "hertz": "Hz", "gram": "g", "kilogram": "kg", "newton": "N", "newtonmetre": "Nm", "newtonmeter": "Nm",
    "joule": "J", "watthour": "Wh", "watt": "W", "ampere": "A", "amp": "A", "volt": "V",
    "kgcm": "kgfcm", "baud": "bps", "bit/s": "bps", "kbit/s": "kbps", "mbit/s": "Mbps",
    "percent": "%", "persen": "%",
}  # fmt: skip
# Of no kind but their own.
_COUNTED = {name: name for name in ("tick", "byte", "bit", "step")}
_BY_FOLD = {name.casefold(): name for name in UNITS}

# Keys such as arrows, which a terminal types as several characters.
_ESCAPE = re.compile(r"\x1b(\[[0-9;?]*[ -/]*[@-~]|O.|.)")
_SIGNS = str.maketrans({"−": "-", "–": "-", "—": "-", "º": "°", "˚": "°", "＋": "+"})
_UNIT = r"[A-Za-zµμ°%]+(?:[./*·][A-Za-zµμ°]+)*"
_DIGITS = r"\d+(?:[.,]\d+)?|[.,]\d+|\d+[.,]"
_PLAIN_DIGITS = r"\d+(?:\.\d*)?|\.\d+"
_EXPONENT = r"(?:[eE][+-]?\d+)?"
# Separators, brackets, a word for "about", and the marks of Markdown.
_BESIDE = ' \n\t,;()[]{}|~≈`*$"“”'
_LABEL = re.compile(r"[^\W\d]\w{0,15}\s*[=:]")
_FRACTION = re.compile(r"([+-]?\d{1,6})\s*/\s*(\d{1,6})")
_HEXADECIMAL = re.compile(r"(?<![\w.,])0[xX]([0-9a-fA-F]{1,8})\b")
_THOUSANDS = re.compile(r"(?<![\d.,])\d{1,3}(?:([.,])\d{3})+(?!\1)[.,]\d+(?![\d.,])")


class UnreadableError(Exception):
    """A reply that is none: no try is counted.

    Attributes:
        code: which of the engine's words say why.
        values: for them.
    """

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code = code
        self.values = values


@dataclass(frozen=True)
class Quantity:
    """A number as typed, and the unit beside it ("" where there is none)."""

    value: float
    unit: str = ""


def clean(reply: str, longest: int = LONGEST) -> str:
    """The reply without what nobody meant to type.

    Raises:
        UnreadableError: nothing is left, or far too much.
    """
    if len(reply) > longest:
        raise UnreadableError("too-long", count=len(reply), longest=longest)
    plain = _ESCAPE.sub("", reply).translate(_SIGNS)
    kept = "".join(c if c == "\n" or unicodedata.category(c)[0] != "C" else " " for c in plain)
    text = "\n".join(line.strip() for line in kept.splitlines()).strip()
    if not text:
        raise UnreadableError("empty")
    return text


def quote(text: str, longest: int = 40) -> str:
    """A piece of a reply to show in a message: short, on one line, with nothing that a terminal obeys."""
    shown = " ".join("".join(c if unicodedata.category(c)[0] != "C" else " " for c in text).split())
    return shown if len(shown) <= longest else f"{shown[: longest - 1]}…"


def numbers(reply: str, count: int) -> list[Quantity]:
    """`count` numbers with their units, separated by spaces, semicolons, or commas where these are no decimal marks.

    Raises:
        UnreadableError: they are not there.
    """
    text = _LABEL.sub(" ", clean(reply))
    text = _THOUSANDS.sub(_without_thousands, text)
    text = _HEXADECIMAL.sub(lambda found: str(int(found[1], 16)), text)
    if count == 1:
        text = _FRACTION.sub(lambda f: repr(int(f[1]) / int(f[2])) if int(f[2]) else f[0], text, count=1)
    found: list[Quantity] = []
    counts = []
    for digits in (_DIGITS, _PLAIN_DIGITS):
        found, rest = _scan(text, digits)
        if rest:
            raise UnreadableError("no-number", text=quote(rest))
        counts.append(len(found))
        if len(found) == count:
            break
    else:
        raise UnreadableError("count", wanted=count, got=counts[0])
    units = {quantity.unit for quantity in found if quantity.unit}
    # One unit behind the last number stands for all of them.
    if len(units) == 1:
        found = [Quantity(quantity.value, *units) for quantity in found]
    return found


def _scan(text: str, digits: str) -> tuple[list[Quantity], str]:
    """The numbers of a text, and the first thing in it that is neither number nor separator."""
    pattern = re.compile(
        rf"(?<![\w.])([+-]?)\s?({digits})({_EXPONENT})\s?({_UNIT}(?:\s(?:m|mm|cm|met(?:er|re)s?)\b)?)?"
    )
    found: list[Quantity] = []
    end = 0
    for match in pattern.finditer(text):
        between = text[end : match.start()].strip(_BESIDE)
        if between:
            return found, between
        value = float(f"{match[1]}{match[2].replace(',', '.')}{match[3]}")
        if not abs(value) <= LARGEST:
            return found, match[0]
        found.append(Quantity(value, _unit(match[4] or "")))
        end = match.end()
    return found, text[end:].strip(f"{_BESIDE}.")


def _without_thousands(match: re.Match[str]) -> str:
    """1.234,5 and 1,234.5 as 1234.5."""
    whole, mark = match[0], max(match[0].rfind("."), match[0].rfind(","))
    return re.sub(r"[.,]", "", whole[:mark]) + "." + whole[mark + 1 :]


def _unit(text: str) -> str:
    """The unit's own name, "" for none.

    Raises:
        UnreadableError: there is no such unit.
    """
    plain = re.sub(r"[\s·*.]", "", text)
    if not plain or plain in UNITS:
        return plain
    folded = plain.casefold()
    # A rate may be written as a whole word or by its two parts: deg/s, derajat/detik.
    for parts in ([folded], folded.split("/")):
        name = "/".join(map(_own_name, parts))
        if name in UNITS or name in _COUNTED:
            return name
    raise UnreadableError("unit-unknown", text=quote(text))


def _own_name(folded: str) -> str:
    """The name used here of a unit that is written in small letters, "" where there is none."""
    for word in (folded, folded.removesuffix("s")):
        for known in (_OTHER_NAMES, _BY_FOLD, _COUNTED):
            if word in known:
                return known[word]
    return ""


def normal_unit(text: str) -> str:
    """A unit of a lesson's file by the name used here; one that is not known stands for itself."""
    try:
        return _unit(text)
    except UnreadableError:
        return re.sub(r"\s", "", text)


def factor(unit: str, to: str) -> float | None:
    """How many of `to` one `unit` is; None where they measure different things."""
    if unit == to:
        return 1.0
    kind, size = UNITS.get(unit, (unit, 1.0))
    other, whole = UNITS.get(to, (to, 1.0))
    return size / whole if kind == other else None


def cousins(unit: str) -> dict[str, float]:
    """Other units of the same kind, and how many of `unit` each is."""
    found = {other: factor(other, unit) for other in UNITS if other != unit}
    return {other: size for other, size in found.items() if size is not None}
