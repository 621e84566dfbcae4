"""A robots file being read: its data, the line of each figure, and errors that name both.

msgspec checks the data against `schema`; what it complains about is put here in a reader's words:
`robots.yaml:37: udiebot.legs.femur: expected a length in mm, got 'sixty'`.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar, get_args

import msgspec

from kinlab.errors import FileError
from kinlab.names import suggestion
from kinlab.robots import schema, yaml_source
from kinlab.robots.schema import Axis, Group, Kind, Protocol, RobotSpec

Place = tuple[Any, ...]
T = TypeVar("T")

# What a wrong value of a field should have been, in words.
_EXPECTED = {
    "mm": "a length in mm",
    "g": "a mass in g",
    "ma": "a current in mA",
    "standby": "a current in mA",
    "deg": "an angle in deg",
    "zero": "an angle in deg",
    "turn": "an angle in deg",
    "at": "a place [x, y, z] in mm",
    "stance": "a place [x, y, z] in mm",
    "ids": "a servo id",
    "positions": "two whole numbers [lowest, highest]",
    "sign": "1 or -1",
    "joints": "'leg' or a list of joints",
    "axis": f"{', '.join(get_args(Axis))} or three numbers",
    "kind": f"one of {', '.join(get_args(Kind))}",
    "protocol": f"one of {', '.join(get_args(Protocol))}",
    "sole": "a length and a width [x, y] in mm",
    "centre": "a place [x, y, z] in mm",
    "duty": "a fraction such as 5/6",
    "touchdown": "a phase of touch-down for each leg",
}
_TYPES = {
    "object": "a mapping", "array": "a list", "str": "a text", "float": "a number", "int": "a whole number",
    "bool": "yes or no", "null": "nothing",
}  # fmt: skip


@dataclass(frozen=True)
class Document:
    """A robots file.

    Attributes:
        name: of the file, for messages.
        tree: its data.
    """

    name: str
    tree: yaml_source.Mapping

    @classmethod
    def read(cls, path: Path, name: str) -> "Document":
        """The document at `path`, shown as `name`.

        Raises:
            FileError: it cannot be read, is no plain YAML, or holds other than robots, servo models and gaits.
        """
        document = cls(name, yaml_source.parse(yaml_source.read_text(path), name))
        for key, value in document.tree.items():
            if key not in SECTIONS:
                raise document.error((key,), f"this has no place here{suggestion(key, SECTIONS)}")
            if not isinstance(value, dict):
                raise document.error((key,), "expected a mapping of names")
        for place, number in _floats(document.tree, ()):
            if not math.isfinite(number):
                raise document.error(place, f"expected a finite number, got {number}")
        return document

    def error(self, place: Place, problem: str) -> FileError:
        """`FILE:LINE: robot.group.field: problem` for a place in the file."""
        line, value = 1, self.tree
        for key in place:
            lines = getattr(value, "lines", None)
            if lines is None or (isinstance(key, str) and key not in value):
                break
            line, value = lines[key], value[key]
        shown = [f"[{k}]" if isinstance(k, int) else str(k) for k in place if k not in GATHERED]
        field = ".".join(shown[1:] if shown[:1] == ["robots"] else shown).replace(".[", "[")
        return FileError(f"{self.name}:{line}: {field + ': ' if field else ''}{problem}")

    def convert(self, data: Any, kind: type[T], at: Place) -> T:
        """`data`, which stands at the place `at`, as a struct of the schema.

        Raises:
            FileError: it does not fit; the message names the line, the field, and what is allowed.
        """
        try:
            return msgspec.convert(data, kind)
        except msgspec.ValidationError as error:
            problem, _, trail = str(error).partition(" - at `$")
            place = tuple(_follow(data, kind, trail.rstrip("`"), str(error)))
            raise self._complaint(at, kind, place, problem) from None

    def robot(self, name: str) -> RobotSpec:
        """The robot of that name, checked; its free keys gathered into groups of limbs, and theirs into lengths."""
        at = ("robots", name)
        data = self.tree["robots"][name]
        if not isinstance(data, dict):
            raise self.error(at, f"expected a mapping, got {_quoted(data)}")
        fields = [f for f in RobotSpec.__struct_fields__ if f != "groups"]
        groups = {}
        for key, group in data.items():
            if key in fields:
                continue
            if not isinstance(group, dict):
                near = suggestion(key, fields)
                raise self.error((*at, key), f"expected a group of limbs, got {_quoted(group)}{near}")
            known = {k: v for k, v in group.items() if k in Group.__struct_fields__ and k != "lengths"}
            lengths = {k: v for k, v in group.items() if k not in known}
            for field, value in lengths.items():
                if isinstance(value, dict) and not set(value) & set(schema.Length.__struct_fields__):
                    near = suggestion(field, [f for f in Group.__struct_fields__ if f != "lengths"])
                    raise self.error((*at, key, field), f"no such field{near}")
            groups[key] = {**known, "lengths": lengths}
        fixed = {k: v for k, v in data.items() if k in fields}
        return self.convert({**fixed, "groups": groups}, RobotSpec, at)

    def _complaint(self, at: Place, kind: type[Any], place: Place, problem: str) -> FileError:
        keys = tuple(k for k in place if k not in GATHERED)
        if problem.startswith("Object contains unknown field"):
            field = problem.split("`")[1]
            return self.error((*at, *keys, field), f"no such field{suggestion(field, _fields(kind, place))}")
        if problem.startswith("Object missing required field"):
            return self.error((*at, *keys), f"'{problem.split('`')[1]}' is missing")
        value = _value_at(self.tree, (*at, *keys))
        expected = _expected(place, problem)
        if keys and keys[-1] == "mm":
            keys = keys[:-1]
        return self.error((*at, *keys), f"expected {expected}, got {_quoted(value)}")


SECTIONS = ("robots", "servo_models", "gaits")
# Levels that the schema has and the file has not.
GATHERED = ("groups", "lengths")


def _expected(place: Place, problem: str) -> str:
    """What should have stood at `place`, in words."""
    names = [k for k in place if isinstance(k, str)]
    if place[-1:] == ("mm",) and len(names) > 1 and names[-2] in _EXPECTED:
        names.pop()
    if "lengths" in place[-2:] or (len(place) > 1 and place[0] == "body"):
        return "a length in mm"
    if "limits" in names:
        return "two angles [lowest, highest] in deg"
    if "touchdown" in names[:-1]:
        return "a fraction of the cycle such as 1/6"
    if "paper_axes" in names[:-1]:
        return ", ".join(get_args(Axis))
    if names and names[-1] in _EXPECTED:
        return _EXPECTED[names[-1]]
    kinds = problem.split("`")[1].split("|") if "`" in problem else []
    return " or ".join(_TYPES.get(kind.strip(), kind.strip()) for kind in kinds) or "something else"


def _floats(value: Any, place: tuple[Any, ...]) -> Iterator[tuple[tuple[Any, ...], float]]:
    if isinstance(value, float):
        yield place, value
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from _floats(item, (*place, key))
    elif isinstance(value, list):
        for i, item in enumerate(value):
            yield from _floats(item, (*place, i))


def _follow(data: Any, kind: Any, trail: str, message: str) -> Iterator[Any]:
    """The keys along msgspec's trail, `.legs[...].mm[0]`, in which `[...]` stands for some key of a mapping."""
    path: list[Any] = []
    current = data
    for name, index in re.findall(r"\.([^.[]+)|\[(\d+|\.\.\.)\]", trail):
        if name:
            key: Any = name
        elif index.isdigit():
            key = int(index)
        else:
            # The key whose value alone brings the same complaint.
            key = next(k for k in current if _fails(_only(data, path, k), kind, message))
        yield key
        path.append(key)
        current = current[key]


def _only(data: Any, path: list[Any], key: str) -> Any:
    """`data` with the mapping at `path` reduced to `key`."""
    if not path:
        return {key: data[key]}
    if isinstance(data, list):
        return [_only(v, path[1:], key) if i == path[0] else v for i, v in enumerate(data)]
    return {k: _only(v, path[1:], key) if k == path[0] else v for k, v in data.items()}


def _fails(data: Any, kind: Any, message: str) -> bool:
    try:
        msgspec.convert(data, kind)
    except msgspec.ValidationError as error:
        return str(error) == message
    return False


# What stands under a key of a robot.
_STRUCTS = {
    "at": schema.Point, "body": schema.Length, "centre": schema.Point, "joints": schema.JointSpec,
    "lengths": schema.Length, "limits": schema.Range, "mass": schema.Mass, "masses": schema.Mass,
    "members": schema.Member, "mountings": schema.Mounting, "paper_axes": schema.PaperAxes, "sole": schema.Area,
    "stance": schema.Point, "standby": schema.Current,
}  # fmt: skip


def _fields(top: type[Any], place: Place) -> tuple[str, ...]:
    """The fields of what stands at `place`, below a struct of the kind `top`."""
    kind: Any = next((_STRUCTS[k] for k in reversed(place) if k in _STRUCTS), top)
    return tuple(kind.__struct_fields__)


def _value_at(value: Any, place: tuple[Any, ...]) -> Any:
    for key in place:
        try:
            value = value[key]
        except (KeyError, IndexError, TypeError):
            return None
    return value


def _quoted(value: Any) -> str:
    if isinstance(value, str):
        return f"'{value[:60]}'"
    if isinstance(value, dict):
        return "a mapping"
    if isinstance(value, list):
        return str(list(value)) if len(str(list(value))) < 60 else f"a list of {len(value)}"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "nothing" if value is None else str(value)
