"""The format of a lesson's file: which fields there are, and what each of them holds."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from kinlab.names import suggestion

ID = r"[a-z0-9]+(-[a-z0-9]+)*"
# Of a number in a lesson.
LARGEST = 1e100


class Field(NamedTuple):
    """What a field holds: text, texts, number, margin, whole, yes, table, tables or call."""

    holds: str
    needed: bool = False
    translated: bool = False


WORDS = {
    "text": "a text in quotes",
    "texts": "a list of texts",
    "number": "a number",
    "margin": "a number from 0",
    "whole": "a whole number from 1",
    "yes": "true or false",
    "table": "a table",
    "tables": "a list of tables",
    "call": "the name of a function of the core, as in 'leg.foot'",
}

FRONT = {
    "title": Field("text", needed=True, translated=True),
    "goals": Field("texts", needed=True, translated=True),
    "version": Field("whole", needed=True),
    "minutes": Field("whole", needed=True),
    "order": Field("number"),
    "prerequisites": Field("texts"),
    "robot": Field("text"),
    "instrument": Field("text"),
    "explains": Field("texts"),
    "params": Field("table"),
    "require": Field("call"),
    "values": Field("table"),
}

# What a lesson's robot is shown by beside its text.
INSTRUMENTS = ("leg", "gait")

FIGURE = {
    "id": Field("text", needed=True, translated=True),
    "draw": Field("call", needed=True),
    "with": Field("table"),
    "alt": Field("text", needed=True, translated=True),
}

EXERCISE = {
    "id": Field("text", needed=True, translated=True),
    "kind": Field("text", needed=True),
    "ask": Field("text", needed=True, translated=True),
    "hints": Field("texts", needed=True, translated=True),
    "solution": Field("text", needed=True, translated=True),
    "feedback": Field("table", translated=True),
    "params": Field("table"),
    "require": Field("call"),
    "values": Field("table"),
    "answer": Field("call", needed=True),
    "with": Field("table"),
    "slips": Field("tables", translated=True),
}

# What each kind of exercise has besides.
KINDS: Mapping[str, Mapping[str, Field]] = {
    "number": {"unit": Field("text"), "tolerance": Field("margin"), "relative": Field("margin")},
    "vector": {
        "names": Field("texts", needed=True),
        "unit": Field("text"),
        "tolerance": Field("margin", needed=True),
    },
    "joints": {"names": Field("texts", needed=True), "tolerance": Field("margin", needed=True)},
    "bytes": {},
    "order": {"rotation": Field("yes"), "items": Field("table", translated=True)},
    "choice": {"options": Field("table", needed=True, translated=True)},
    "mistake": {"lines": Field("texts", needed=True), "why": Field("texts", needed=True, translated=True)},
    "state": {},
}

# The verdicts of each kind, whose words a lesson may replace by its `feedback`.
CODES: Mapping[str, tuple[str, ...]] = {
    "number": ("right", "unit", "sign", "near", "wrong"),
    "vector": ("right", "unit", "sign", "swapped", "partly", "near", "wrong"),
    "joints": ("right", "unit", "sign", "limit", "near", "wrong"),
    "bytes": ("right", "byte", "short", "long"),
    "order": ("right", "first", "reversed", "wrong"),
    "choice": ("right", "wrong"),
    "mistake": ("right", "wrong"),
    "state": ("right", "wrong"),
}

OPTION = {
    "text": Field("text", needed=True, translated=True),
    "why": Field("text", needed=True, translated=True),
}
SLIP = {
    "compute": Field("call", needed=True),
    "with": Field("table"),
    "say": Field("text", needed=True, translated=True),
}
VALUE = {"compute": Field("call", needed=True), "with": Field("table")}
CALL = {"compute": Field("call", needed=True), "with": Field("table")}


class FormatError(Exception):
    """A field that is unknown, missing or wrong.

    Attributes:
        key: which; None where it is one that is missing.
    """

    def __init__(self, message: str, key: str | None = None) -> None:
        super().__init__(message)
        self.key = key


def check(data: Mapping[str, Any], fields: Mapping[str, Field], *, translation: bool = False) -> None:
    """Refuse what a table must not say.

    Args:
        data: the table.
        fields: that there are.
        translation: only texts may stand here, and any of them may be missing.

    Raises:
        FormatError: names the field.
    """
    allowed = {name: f for name, f in fields.items() if f.translated or not translation}
    for key, value in data.items():
        if key not in allowed:
            if key in fields:
                raise FormatError(f"'{key}' stands in en.md alone; a translation holds texts only", key)
            raise FormatError(f"there is no field '{key}'{suggestion(key, allowed)}", key)
        if not holds(value, allowed[key].holds):
            raise FormatError(f"'{key}' is {WORDS[allowed[key].holds]}, not {value!r:.60}", key)
        if allowed[key].needed and value in ("", []):
            raise FormatError(f"'{key}' is empty", key)
    if not translation:
        for key, known in fields.items():
            if known.needed and key not in data:
                raise FormatError(f"the field '{key}' is missing: {WORDS[known.holds]}")


def holds(value: Any, what: str) -> bool:
    """Whether a value is what a field holds."""
    # Compared, as `math.isfinite` fails at whole numbers that no float can hold.
    number = isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST
    return {
        "text": isinstance(value, str),
        "texts": isinstance(value, list) and all(isinstance(v, str) for v in value),
        "number": number,
        "margin": number and value >= 0,
        "whole": number and isinstance(value, int) and value >= 1,
        "yes": isinstance(value, bool),
        "table": isinstance(value, dict),
        "tables": isinstance(value, list) and all(isinstance(v, dict) for v in value),
        "call": isinstance(value, str | dict),
    }[what]
