"""Several numbers that make up one place, speed or force: judged by how far off the whole is."""

import math
from collections.abc import Sequence
from typing import Any

from kinlab.lessons.kinds.number import (
    NEAR_SHARE,
    NEAR_TOLERANCES,
    SLACK,
    in_unit,
    nearest_turn,
    value_text,
)
from kinlab.lessons.replies import cousins, normal_unit, numbers
from kinlab.lessons.task import Task, Verdict


def shape(task: Task) -> str:
    """The names in their order, the unit, and how exact is exact enough."""
    names = " ".join(task.field["names"])
    unit = task.field.get("unit", "")
    margin = f"{task.field['tolerance']:g} {unit}".strip()
    return task.say("vector.shape", names=names, unit=unit or task.say("number.no-unit"), tolerance=margin)


def right(task: Task) -> str:
    """All numbers, all their digits."""
    return " ".join(f"{v:.12g}" for v in want(task))


def wrong(task: Task) -> Sequence[str]:
    """Each number in turn beyond the tolerance."""
    found = []
    for i in range(len(task.field["names"])):
        values = want(task)
        values[i] += 1.5 * task.field["tolerance"]
        found.append(" ".join(f"{v:.12g}" for v in values))
    return found


def want(task: Task, answer: Any = None) -> list[float]:
    """The right numbers, or those of another answer.

    Raises:
        LessonError: there are more of them than names, or fewer.
    """
    values = task.answer if answer is None else answer
    if len(values) != len(task.field["names"]):
        raise task.exercise.place.error(
            f"'names' are {len(task.field['names'])}, and there are {len(values)} numbers"
        )
    return [float(v) for v in values]


def judge(task: Task, reply: str) -> Verdict:
    """By the distance; units, signs and places that have changed are recognised."""
    names = task.field["names"]
    asked = normal_unit(task.field.get("unit", ""))
    right_one = want(task)
    given = numbers(reply, len(names))
    got = [nearest_turn(task, in_unit(each, asked), aim) for each, aim in zip(given, right_one, strict=True)]
    allowed = float(task.field["tolerance"])
    unit = f" {task.field['unit']}" if "unit" in task.field else ""
    off = math.dist(got, right_one)
    if off <= allowed * (1 + 1e-9):
        shown = ", ".join(value_text(v, allowed) for v in right_one)
        return task.verdict(True, "right", value=shown, unit=unit)
    length = math.hypot(*right_one)
    for other, size in cousins(asked).items():
        if length and math.dist([g.value * size for g in given], right_one) <= max(SLACK * length, 1e-12):
            return task.verdict(False, "unit", unit=other, want=task.field["unit"])
    for number, slip in enumerate(task.slips):
        if math.dist(got, want(task, slip)) <= allowed:
            return task.slip(number)
    changed = _changed(task, got, right_one)
    if changed:
        return changed
    rights = [
        name for name, a, b in zip(names, got, right_one, strict=True) if abs(a - b) <= allowed / len(names)
    ]
    distance = f"{off:.3g}{unit}"
    if rights:
        others = [i for i, name in enumerate(names) if name not in rights]
        return task.verdict(False, "partly", faults=others, distance=distance, names=", ".join(rights))
    if off <= max(NEAR_TOLERANCES * allowed, NEAR_SHARE * length):
        return task.verdict(False, "near", distance=distance)
    return task.verdict(False, "wrong", distance=distance)


def _changed(task: Task, got: list[float], right_one: list[float]) -> Verdict | None:
    """The verdict where all is right but for one sign, or two numbers in each other's place."""
    names, allowed = task.field["names"], float(task.field["tolerance"])
    for i, name in enumerate(names):
        turned = [*got[:i], -got[i], *got[i + 1 :]]
        if math.dist(turned, right_one) <= allowed:
            return task.verdict(False, "sign", faults=[i], name=name)
    for i in range(len(names)):
        for j in range(i):
            swapped = list(got)
            swapped[i], swapped[j] = got[j], got[i]
            if math.dist(swapped, right_one) <= allowed:
                return task.verdict(False, "swapped", faults=[j, i], first=names[j], second=names[i])
    return None
