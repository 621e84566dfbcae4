"""Robots files: found, read, and built into robots."""

import os
from functools import cache, cached_property
from pathlib import Path

from kinlab.names import resolve
from kinlab.robots.build import SpecError, build_robot, build_servo_model
from kinlab.robots.document import Document
from kinlab.robots.model import Robot
from kinlab.robots.schema import ServoModelSpec
from kinlab.robots.servo import ServoModel
from kinlab.shipped import shipped

VARIABLE = "KINLAB_ROBOTS"


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
    source = _Shelf.of(file)
    return source.robot(resolve(name, source.names(), "robot"))


def load_robots(file: str | os.PathLike[str] | None = None) -> dict[str, Robot]:
    """All robots by name: KinLab's own, those of `file` (default `$KINLAB_ROBOTS`) added or in their place."""
    source = _Shelf.of(file)
    return {name: source.robot(name) for name in source.names()}


def shipped_robots() -> dict[str, Robot]:
    """KinLab's own robots by name, whatever `$KINLAB_ROBOTS` says."""
    shelf = _own_shelf()
    return {name: shelf.robot(name) for name in shelf.names()}


def shipped_robot(name: str) -> Robot | None:
    """KinLab's own robot of exactly that name, whatever `$KINLAB_ROBOTS` says; None if it has none."""
    shelf = _own_shelf()
    return shelf.robot(name) if name in shelf.names() else None


def robot_names(file: str | os.PathLike[str] | None = None) -> list[str]:
    """The names that `load_robot` takes, without building the robots."""
    return _Shelf.of(file).names()


def documents(file: str | os.PathLike[str] | None = None) -> tuple[Document, ...]:
    """The robots files in force, the last one winning: KinLab's own, and `file` (default `$KINLAB_ROBOTS`).

    Raises:
        FileError: a file cannot be read, or says something that it must not.
    """
    chosen = file or os.environ.get(VARIABLE)
    own = shipped_document()
    return (own, Document.read(Path(chosen), str(chosen))) if chosen else (own,)


class _Shelf:
    """The shipped robots file with a user's on top. A user's file is checked whole; ours robot by robot."""

    def __init__(self, *documents: Document) -> None:
        self.documents = documents
        self.holder = {name: doc for doc in documents for name in doc.tree.get("robots", {})}
        self._built: dict[str, Robot] = {}

    @classmethod
    def of(cls, file: str | os.PathLike[str] | None) -> "_Shelf":
        ours, *users = documents(file)
        if not users:
            return _own_shelf()
        shelf = cls(ours, *users)
        _ = shelf.servo_models  # Those that no robot wears are checked too.
        for document in users:
            for name in document.tree.get("robots", {}):
                shelf.robot(name)
        return shelf

    def names(self) -> list[str]:
        return list(self.holder)

    def robot(self, name: str) -> Robot:
        if name not in self._built:
            self._built[name] = self._build(name)
        return self._built[name]

    def _build(self, name: str) -> Robot:
        document = self.holder[name]
        spec = document.robot(name)
        try:
            return build_robot(name, spec, self.servo_models)
        except SpecError as error:
            raise document.error(("robots", name, *error.place), str(error)) from None

    @cached_property
    def servo_models(self) -> dict[str, ServoModel]:
        found: dict[str, ServoModel] = {}
        for document in self.documents:
            for name, data in document.tree.get("servo_models", {}).items():
                at = ("servo_models", name)
                try:
                    found[name] = build_servo_model(name, document.convert(data, ServoModelSpec, at))
                except SpecError as error:
                    raise document.error((*at, *error.place), str(error)) from None
        return found


@cache
def _own_shelf() -> _Shelf:
    """KinLab's own robots: each is built once, as nothing can change it."""
    return _Shelf(shipped_document())


@cache
def shipped_document() -> Document:
    """KinLab's own robots file."""
    return Document.read(shipped("robots.yaml"), "robots.yaml")
