"""Which servos a chain has: a robot's, or those that a user names."""

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from kinlab.dynamixel.chain import Chain
from kinlab.dynamixel.tables import load_table, models
from kinlab.errors import UsageError

if TYPE_CHECKING:
    from kinlab.robots import Robot

Modules = list[tuple[str, list[int]]]


def parse_servo(text: str) -> tuple[str, list[int]]:
    """A module as users write it: "AX-12A:1", "2XL430-W250:1,2", or "AX-12A:1-18" for many at once.

    Raises:
        UsageError: an unknown model, or ids that cannot be.
    """
    model, _, numbers = text.rpartition(":")
    if not model:
        raise UsageError(
            f"'{text}' is no servo; write MODEL:ID, as in AX-12A:1 (models: {', '.join(models())})"
        )
    return load_table(model).model, parse_ids(numbers)


def parse_ids(text: str) -> list[int]:
    """Ids as users write them: "1", "1,2,5-7".

    Raises:
        UsageError: not a number, or not an id (0 to 253).
    """
    ids: list[int] = []
    for part in text.split(","):
        span = re.fullmatch(r"\s*(\d{1,3})(?:-(\d{1,3}))?\s*", part, re.ASCII)
        if span is None:
            raise UsageError(f"'{part}' is no id; ids are numbers from 0 to 253")
        first, last = int(span[1]), int(span[2] or span[1])
        if last < first:
            raise UsageError(f"'{part.strip()}' runs backwards; write {last}-{first}")
        ids += range(first, last + 1)
    wrong = [i for i in ids if i > 253]
    if wrong:
        raise UsageError(f"{wrong[0]} is no id; ids are numbers from 0 to 253")
    return ids


def modules_of(servos: list[tuple[str, list[int]]]) -> Modules:
    """Ids shared out to modules: two for each 2XL430, one for each of the others."""
    modules: Modules = []
    for model, ids in servos:
        axes = load_table(model).axes
        if len(ids) % axes:
            raise UsageError(f"each {model} takes {axes} ids, got {', '.join(map(str, ids))}")
        modules += [(model, ids[at : at + axes]) for at in range(0, len(ids), axes)]
    return modules


def robot_modules(robot: str, file: Path | None = None) -> Modules:
    """The modules of a robot's chain, in the order of their ids.

    Args:
        file: a user's own robots, besides those that ship.

    Raises:
        UsageError: no such robot, or its servos are not of Dynamixel models.
    """
    from kinlab.robots import load_robot

    return worn_by(load_robot(robot, file))


def worn_by(machine: "Robot") -> Modules:
    """The modules that a robot's servos make up, in the order of their ids.

    Raises:
        UsageError: it has none, or they are not of Dynamixel models.
    """
    by_model: list[tuple[str, list[int]]] = []
    if not machine.servos:
        raise UsageError(f"{machine.name} names no servos")
    for servo in machine.servos:
        if servo.model.protocol == "pwm":
            raise UsageError(
                f"{machine.name} has {servo.model.name} servos, which are not on a bus but on PWM"
            )
        table = load_table(servo.model.name)
        # The two axes of one case follow each other; single servos stand for themselves.
        if by_model and by_model[-1][0] == table.model and len(by_model[-1][1]) < table.axes:
            by_model[-1][1].append(servo.id)
        else:
            by_model.append((table.model, [servo.id]))
    return modules_of(by_model)


@cache
def known_chains() -> list[tuple[str, str]]:
    """What `chain_of` takes, each with what it is: robots that are on a bus, and a single servo of each model."""
    from kinlab.robots import load_robot, robot_names

    found = []
    for name in robot_names():
        robot = load_robot(name)
        try:
            modules = worn_by(robot)
        except UsageError:
            continue
        ids = sum(len(ids) for _, ids in modules)
        found.append((name, f"{ids} servos: {', '.join(dict.fromkeys(model for model, _ in modules))}"))
    for model in models():
        axes = load_table(model).axes
        found.append((f"{model}:{','.join(map(str, range(1, axes + 1)))}", f"a single {model}"))
    return found


def chain_of(text: str, baud: int) -> Chain:
    """The chain of a robot ("krsri-hexapod"), or of servos ("AX-12A:1,RX-24F:2")."""
    if ":" not in text:
        return Chain.of(robot_modules(text), baud)
    servos: list[tuple[str, list[int]]] = []
    for part in text.split(","):
        if ":" in part or not servos:
            servos.append(parse_servo(part))
        else:
            servos[-1][1].extend(parse_ids(part))
    return Chain.of(modules_of(servos), baud)
