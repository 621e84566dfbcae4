"""Robots files: found, read, checked, and built into robots."""

import math
import os
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, get_args

import msgspec

from kinlab.errors import FileError
from kinlab.names import resolve, suggestion
from kinlab.robots import yaml_source
from kinlab.robots.build import SpecError, build_robot, build_servo_model
from kinlab.robots.model import Robot
from kinlab.robots.schema import (
    Axis,
    Group,
    JointSpec,
    Kind,
    Length,
    Mass,
    Member,
    Mounting,
    PaperAxes,
    Point,
    Protocol,
    Range,
    RobotSpec,
    ServoModelSpec,
)
from kinlab.robots.servo import ServoModel
from kinlab.shipped import shipped

VARIABLE = "KINLAB_ROBOTS"

# What a wrong value of a field should have been, in words.
_EXPECTED = {
    "mm": "a length in mm",
    "g": "a mass in g",
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
}
_TYPES = {
    "object": "a mapping", "array": "a list", "str": "a text", "float": "a number", "int": "a whole number",
    "bool": "yes or no", "null": "nothing",
}  # fmt: skip


def load_robot(name: str, file: str | os.PathLike[str] | None = None) -> Robot:
    """One robot, by its name or a unique beginning of it.

    Args:
        name: of the robot.
        file: a robots file that adds to those of KinLab; default `$KINLAB_ROBOTS`, if set.

    Raises:
        UsageError: no such robot.
        FileError: the file cannot be read, or says something that it must not.

    >>> load_robot("xl430-hexapod").limbs["R1"].joint_names
    ('coxa', 'femur', 'tibia')
    """
    source = _Source.of(file)
    return source.robot(resolve(name, source.names(), "robot"))


def load_robots(file: str | os.PathLike[str] | None = None) -> dict[str, Robot]:
    """All robots by name: KinLab's own, those of `file` (default `$KINLAB_ROBOTS`) added or in their place."""
    source = _Source.of(file)
    return {name: source.robot(name) for name in source.names()}


def robot_names(file: str | os.PathLike[str] | None = None) -> list[str]:
    """The names that `load_robot` takes, without building the robots."""
    return _Source.of(file).names()


class _Source:
    """The shipped robots file with a user's on top. A user's file is checked whole; ours robot by robot."""

    def __init__(self, files: list[yaml_source.Mapping], paths: list[str]) -> None:
        self.files, self.paths = files, paths
        self.where = {name: i for i, file in enumerate(files) for name in file.get("robots", {})}

    @classmethod
    def of(cls, file: str | os.PathLike[str] | None) -> "_Source":
        chosen = file or os.environ.get(VARIABLE)
        own = _shipped_file()
        if not chosen:
            return cls([own], ["robots.yaml"])
        tree = yaml_source.parse(yaml_source.read_text(Path(chosen)), str(chosen))
        _check_top(tree, str(chosen))
        source = cls([own, tree], ["robots.yaml", str(chosen)])
        for name in tree.get("robots", {}):
            source.robot(name)
        return source

    def names(self) -> list[str]:
        return list(self.where)

    def models(self) -> dict[str, ServoModel]:
        found: dict[str, ServoModel] = {}
        for tree, path in zip(self.files, self.paths, strict=True):
            for name, data in tree.get("servo_models", {}).items():
                at = ("servo_models", name)
                spec = _convert(data, ServoModelSpec, path, tree, at)
                found[name] = _guard(path, tree, at, build_servo_model, name, spec)
        return found

    def robot(self, name: str) -> Robot:
        index = self.where[name]
        tree, path = self.files[index], self.paths[index]
        data = tree["robots"][name]
        at = ("robots", name)
        spec = _convert(_with_groups(data, path, tree, at), RobotSpec, path, tree, at)
        return _guard(path, tree, at, build_robot, name, spec, self.models())  # type: ignore[no-any-return]


@cache
def _shipped_file() -> yaml_source.Mapping:
    path = shipped("robots.yaml")
    tree = yaml_source.parse(yaml_source.read_text(path), "robots.yaml")
    _check_top(tree, "robots.yaml")
    return tree


def _check_top(tree: yaml_source.Mapping, path: str) -> None:
    for key in tree:
        if key not in ("robots", "servo_models"):
            near = suggestion(key, ["robots", "servo_models"])
            raise FileError(f"{path}:{tree.lines[key]}: '{key}' has no place here{near}")
        if not isinstance(tree[key], dict):
            raise FileError(f"{path}:{tree.lines[key]}: {key}: expected a mapping of names")
    for place, value in _floats(tree, ()):
        if not math.isfinite(value):
            raise FileError(f"{_where(path, tree, place)}: expected a finite number, got {value}")


def _floats(value: Any, place: tuple[Any, ...]) -> Iterator[tuple[tuple[Any, ...], float]]:
    if isinstance(value, float):
        yield place, value
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from _floats(item, (*place, key))
    elif isinstance(value, list):
        for i, item in enumerate(value):
            yield from _floats(item, (*place, i))


def _with_groups(data: Any, path: str, tree: yaml_source.Mapping, at: tuple[Any, ...]) -> Any:
    """The robot with its free keys gathered: groups of limbs, and in each of them its lengths."""
    if not isinstance(data, dict):
        raise FileError(f"{_where(path, tree, at)}: expected a mapping, got {_quoted(data)}")
    fixed = {k: v for k, v in data.items() if k in RobotSpec.__struct_fields__ and k != "groups"}
    groups = {}
    for name, group in data.items():
        if name in fixed:
            continue
        if not isinstance(group, dict):
            near = suggestion(name, [f for f in RobotSpec.__struct_fields__ if f != "groups"])
            raise FileError(
                f"{_where(path, tree, (*at, name))}: expected a group of limbs, got {_quoted(group)}{near}"
            )
        known = {k: v for k, v in group.items() if k in Group.__struct_fields__ and k != "lengths"}
        lengths = {k: v for k, v in group.items() if k not in known}
        for key, value in lengths.items():
            if isinstance(value, dict) and not set(value) & set(Length.__struct_fields__):
                near = suggestion(key, [f for f in Group.__struct_fields__ if f != "lengths"])
                raise FileError(f"{_where(path, tree, (*at, name, key))}: no such field{near}")
        groups[name] = {**known, "lengths": lengths}
    return {**fixed, "groups": groups}


def _guard(path: str, tree: Any, at: tuple[Any, ...], build: Any, *args: Any) -> Any:
    try:
        return build(*args)
    except SpecError as error:
        raise FileError(f"{_where(path, tree, (*at, *error.place))}: {error}") from None


def _convert(data: Any, kind: Any, path: str, tree: Any, at: tuple[Any, ...]) -> Any:
    try:
        return msgspec.convert(data, kind)
    except msgspec.ValidationError as error:
        problem, _, trail = str(error).partition(" - at `$")
        place = tuple(_follow(data, kind, trail.rstrip("`"), str(error)))
        raise FileError(_message(path, tree, at, place, problem)) from None


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


def _message(path: str, tree: Any, at: tuple[Any, ...], place: tuple[Any, ...], problem: str) -> str:
    keys = tuple(k for k in place if k not in ("groups", "lengths"))
    value = _value_at(tree, (*at, *keys))
    if problem.startswith("Object contains unknown field"):
        field = problem.split("`")[1]
        return f"{_where(path, tree, (*at, *keys, field))}: no such field{suggestion(field, _fields(place))}"
    if problem.startswith("Object missing required field"):
        return f"{_where(path, tree, (*at, *keys))}: '{problem.split('`')[1]}' is missing"
    names = [k for k in place if isinstance(k, str)]
    if len(names) > 1 and names[-1] == "mm" and names[-2] in _EXPECTED and place[-1] == "mm":
        names.pop()
    last = names[-1] if names else ""
    if "lengths" in place[-2:] or (len(place) > 1 and place[0] == "body"):
        expected: str | None = "a length in mm"
    elif "limits" in names:
        expected = "two angles [lowest, highest] in deg"
    elif "paper_axes" in names[:-1]:
        expected = ", ".join(get_args(Axis))
    else:
        expected = _EXPECTED.get(last)
    if keys and keys[-1] == "mm":
        keys = keys[:-1]
    if expected is None and problem.startswith("Expected `"):
        wanted = problem.split("`")[1]
        expected = " or ".join(_TYPES.get(part.strip(), part.strip()) for part in wanted.split("|"))
    if expected is None:
        said = problem[0].lower() + problem[1:]
        return f"{_where(path, tree, (*at, *keys))}: {said.replace('`', '')}, got {_quoted(value)}"
    return f"{_where(path, tree, (*at, *keys))}: expected {expected}, got {_quoted(value)}"


def _fields(place: tuple[Any, ...]) -> tuple[str, ...]:
    """The fields of what stands at `place` of a robot; of a servo model where the place is empty."""
    kinds = {
        "at": Point, "body": Length, "joints": JointSpec, "lengths": Length, "limits": Range, "mass": Mass,
        "masses": Mass, "members": Member, "mountings": Mounting, "paper_axes": PaperAxes, "stance": Point,
    }  # fmt: skip
    kind: Any = next((kinds[k] for k in reversed(place) if k in kinds), ServoModelSpec)
    return kind.__struct_fields__  # type: ignore[no-any-return]


def _value_at(value: Any, place: tuple[Any, ...]) -> Any:
    for key in place:
        try:
            value = value[key]
        except (KeyError, IndexError, TypeError):
            return None
    return value


def _where(path: str, tree: Any, place: tuple[Any, ...]) -> str:
    """`robots.yaml:37: udiebot.legs.femur` for a place in a robots file."""
    line, value = 1, tree
    for key in place:
        lines = getattr(value, "lines", None)
        if lines is None or (isinstance(key, str) and key not in value):
            break
        line = lines[key]
        value = value[key]
    shown = [f"[{k}]" if isinstance(k, int) else str(k) for k in place if k not in ("groups", "lengths")]
    if shown and shown[0] == "robots":
        shown = shown[1:]
    return f"{path}:{line}: {'.'.join(shown).replace('.[', '[')}" if shown else f"{path}:{line}"


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
