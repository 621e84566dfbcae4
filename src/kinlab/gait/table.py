"""The gaits of the robots files, checked; and those that fit a robot."""

import os
import re
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from types import MappingProxyType

from kinlab.errors import UsageError
from kinlab.gait.schedule import Gait
from kinlab.names import resolve
from kinlab.robots import Robot
from kinlab.robots.build import SpecError, provenance
from kinlab.robots.document import Document
from kinlab.robots.load import documents, shipped_document
from kinlab.robots.schema import GaitSpec

_FRACTION = re.compile(r"\d{1,6}(/\d{1,6}|\.\d{1,12})?")


def load_gaits(file: str | os.PathLike[str] | None = None) -> dict[str, Gait]:
    """All gaits by name: KinLab's own, those of `file` (default `$KINLAB_ROBOTS`) added or in their place.

    Raises:
        FileError: naming file, line and field of what is wrong.
    """
    found = dict(shipped_gaits())
    for document in documents(file)[1:]:
        found |= _gaits_of(document)
    return found


@cache
def shipped_gaits() -> Mapping[str, Gait]:
    """KinLab's own gaits by name, whatever `$KINLAB_ROBOTS` says; built once, as nothing can change them."""
    return MappingProxyType(_gaits_of(shipped_document()))


def _gaits_of(document: Document) -> dict[str, Gait]:
    found = {}
    for name, data in document.tree.get("gaits", {}).items():
        place = ("gaits", name)
        spec = document.convert(data, GaitSpec, place)
        try:
            found[name] = build_gait(name, spec)
        except SpecError as error:
            raise document.error((*place, *error.place), str(error)) from None
    return found


def build_gait(name: str, spec: GaitSpec) -> Gait:
    """The gait of a file's `gaits`.

    Raises:
        SpecError: fractions out of range, or an instant at which no leg is on the ground.
    """
    duty = _fraction(spec.duty, ("duty",))
    if not 0 < duty < 1:
        raise SpecError(("duty",), f"expected a duty factor between 0 and 1, got {duty}")
    if not spec.touchdown:
        raise SpecError(("touchdown",), "a gait needs at least one leg")
    touchdown = {}
    for leg, value in spec.touchdown.items():
        touchdown[leg] = _fraction(value, ("touchdown", leg))
        if not 0 <= touchdown[leg] < 1:
            raise SpecError(
                ("touchdown", leg), f"expected a phase from 0 up to, not including, 1, got {touchdown[leg]}"
            )
    gait = Gait(name, spec.kind, duty, MappingProxyType(touchdown), provenance(spec, ()))
    for phase in gait.phases:
        if not phase.stance:
            raise SpecError(
                ("duty",),
                f"a duty factor of {duty} leaves no leg on the ground at {phase.start} of the cycle",
            )
    return gait


def gaits_for(robot: Robot, file: str | os.PathLike[str] | None = None) -> dict[str, Gait]:
    """The gaits that fit `robot`, by name: those of its kind."""
    return {name: gait for name, gait in load_gaits(file).items() if gait.kind == robot.kind}


def find_gait(robot: Robot, name: str | None = None, file: str | os.PathLike[str] | None = None) -> Gait:
    """The gait that `name` means for `robot`; the first of its kind where it is None.

    Raises:
        UsageError: no such gait, one for another kind of robot, or one for legs that the robot has not.
    """
    if not robot.legs:
        raise UsageError(f"{robot.name} has no legs to walk on")
    gaits = load_gaits(file)
    fitting = {key: gait for key, gait in gaits.items() if gait.kind == robot.kind}
    there = f"for {robot.name}, a {robot.kind}, there are: {', '.join(fitting) or 'none'}"
    if name is None:
        if not fitting:
            raise UsageError(f"no gait fits a {robot.kind}; a robots file may define one under gaits")
        gait = next(iter(fitting.values()))
    else:
        try:
            gait = fitting[resolve(name, fitting, "gait")]
        except UsageError:
            other = gaits.get(name)
            if other is None:
                raise
            raise UsageError(f"{name} is a gait for a {other.kind}; {there}") from None
    _check_legs(robot, gait)
    return gait


def _check_legs(robot: Robot, gait: Gait) -> None:
    names = [leg.name for leg in robot.legs]
    for leg in gait.legs:
        if leg not in names:
            raise UsageError(
                f"gait {gait.name} moves a leg {leg}, which {robot.name} has not: its legs are {', '.join(names)}"
            )
    for leg in names:
        if leg not in gait.legs:
            raise UsageError(f"gait {gait.name} says nothing of leg {leg} of {robot.name}")


def _fraction(value: float | str, place: tuple[str, ...]) -> Fraction:
    """An exact fraction of what a person wrote: 0.1 is a tenth, not the nearest binary number."""
    text = f"{value:g}" if isinstance(value, float) and value == round(value) else str(value)
    if not _FRACTION.fullmatch(text.removeprefix("-")):
        raise SpecError(place, f"expected a fraction such as 5/6, got '{text[:40]}'")
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise SpecError(place, f"'{text}' divides by zero") from None
