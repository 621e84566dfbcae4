"""A number with a unit."""

import math
from collections.abc import Sequence

from kinlab.lessons.replies import Quantity, UnreadableError, cousins, factor, normal_unit, numbers
from kinlab.lessons.task import Task, Verdict

# A wrong number is near when it is off by less than this many tolerances, or this share of the right one.
NEAR_TOLERANCES = 5.0
NEAR_SHARE = 0.1
# A number that is right in another unit may have been rounded more roughly there, to this share.
SLACK = 0.01


def shape(task: Task) -> str:
    """The unit, and how exact is exact enough."""
    unit = task.field.get("unit", "") or task.say("number.no-unit")
    if not tolerance(task, 1.0):
        return task.say("number.shape-exact", unit=unit)
    return task.say("number.shape", unit=unit, tolerance=_margin(task))


def _margin(task: Task) -> str:
    """How far off is still right, as a person reads it."""
    if "tolerance" in task.field:
        return f"{task.field['tolerance']:g}{_shown_unit(task)}"
    return f"{100 * task.field['relative']:g} %"


def right(task: Task) -> str:
    """The number, all its digits."""
    return f"{float(task.answer):.12g} {task.field.get('unit', '')}".strip()


def wrong(task: Task) -> Sequence[str]:
    """Beyond the tolerance on both sides."""
    want = float(task.answer)
    off = 1.5 * tolerance(task, want) + 1e-9
    return [f"{want + off:.12g}", f"{want - off:.12g}"]


def tolerance(task: Task, want: float) -> float:
    """How far a number may be off, in the unit of the exercise."""
    return max(float(task.field.get("tolerance", 0.0)), float(task.field.get("relative", 0.0)) * abs(want))


def judge(task: Task, reply: str) -> Verdict:
    """By the tolerance; a unit, a sign or a known slip is recognised."""
    asked = normal_unit(task.field.get("unit", ""))
    [given] = numbers(reply, 1)
    want = float(task.answer)
    got = in_unit(given, asked)
    if fits(task, got, want):
        return task.verdict(
            True, "right", value=value_text(want, tolerance(task, want)), unit=_shown_unit(task)
        )
    other = _other_unit(given, asked, want)
    if other:
        return task.verdict(
            False,
            "unit",
            number=f"{given.value:g}",
            unit=task.say("number.fraction") if other == "1" else other,
            asked=given.unit or task.field["unit"],
            want=task.field["unit"],
        )
    for number, slip in enumerate(task.slips):
        if fits(task, got, float(slip)):
            return task.slip(number)
    if want and fits(task, got, -want):
        return task.verdict(False, "sign")
    allowed = tolerance(task, want)
    if abs(got - want) <= max(NEAR_TOLERANCES * allowed, NEAR_SHARE * abs(want)):
        exact = None if allowed or "near" in task.wording.feedback else task.say("number.near-exact")
        return task.verdict(False, "near", own=exact, tolerance=_margin(task))
    return task.verdict(False, "wrong")


def _shown_unit(task: Task) -> str:
    unit = task.field.get("unit", "")
    return f" {unit}" if unit else ""


def in_unit(given: Quantity, asked: str) -> float:
    """A quantity in the unit asked for.

    Raises:
        UnreadableError: its unit measures something else.
    """
    size = 1.0 if not given.unit else factor(given.unit, asked or "1")
    if size is None:
        if asked in ("", "1"):
            raise UnreadableError("unit-none", unit=given.unit)
        raise UnreadableError("unit-other", unit=given.unit, asked=asked)
    return given.value * size


def fits(task: Task, got: float, want: float) -> bool:
    """Whether a number is within the tolerance of another; angles up to half a turn also a turn away."""
    off = nearest_turn(task, got, want) - want
    # A number typed exactly at the edge of the tolerance is within it.
    return abs(off) <= tolerance(task, want) * (1 + 1e-9) + 1e-12 * abs(want)


def nearest_turn(task: Task, got: float, want: float) -> float:
    """A number; an angle by whole turns as near as can be to one that is wanted, if that is up to half a turn."""
    turn = factor("turn", normal_unit(task.field.get("unit", "")))
    if not turn or abs(want) > turn / 2:
        return got
    return want + (got - want + turn / 2) % turn - turn / 2


def _other_unit(given: Quantity, asked: str, want: float) -> str | None:
    """The unit in which the number would be right, whatever unit stands beside it."""
    for other, size in cousins(asked).items():
        if other != given.unit and want and abs(given.value * size - want) <= SLACK * abs(want):
            return other
    if given.unit and given.unit != asked and abs(given.value - want) <= SLACK * abs(want):
        return asked
    return None


def value_text(value: float, tolerance: float) -> str:
    """A number with a digit more than the tolerance has."""
    if tolerance <= 0:
        return f"{value:.6g}"
    return f"{value:.{min(max(0, math.floor(-math.log10(tolerance)) + 1), 9)}f}"
