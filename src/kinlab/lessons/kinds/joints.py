"""Joint angles, judged by where and how they bring the tip: every pose that gets there is right."""

import math
from collections.abc import Sequence

from kinlab.lessons.kinds.number import in_unit
from kinlab.lessons.replies import numbers
from kinlab.lessons.results import Reach
from kinlab.lessons.task import Task, Verdict

# How far the tip may be turned, where its attitude counts.
TILT_DEG = 2.0


def shape(task: Task) -> str:
    """The joints in their order, and how near is near enough."""
    asked = task.say(
        "joints.shape",
        tip=_tip(task),
        names=" ".join(task.field["names"]),
        tolerance=f"{task.field['tolerance']:g} mm",
    )
    return f"{asked} {task.say('joints.attitude', angle=f'{TILT_DEG:g}')}" if _reach(task).tilt_deg else asked


def right(task: Task) -> str:
    """One solution."""
    return " ".join(f"{v:.9g}" for v in _reach(task).solution_deg)


def wrong(task: Task) -> Sequence[str]:
    """Each joint in turn moved until the tip is too far off."""
    reach = _reach(task)
    found = []
    for i in range(len(reach.solution_deg)):
        angles = list(reach.solution_deg)
        for _ in range(90):
            angles[i] += 1.0
            if _off(reach, angles) > 1.5 * task.field["tolerance"]:
                found.append(" ".join(f"{v:.9g}" for v in angles))
                break
    return found


def angles_deg(task: Task, reply: str) -> list[float]:
    """The angles that a reply gives.

    Raises:
        UnreadableError: it gives none.
    """
    return [in_unit(each, "deg") for each in numbers(reply, len(task.field["names"]))]


def _reach(task: Task) -> Reach:
    reach = task.answer
    if not isinstance(reach, Reach) or len(reach.solution_deg) != len(task.field["names"]):
        raise task.exercise.answer.place.error(
            f"{task.exercise.answer.name} gives no Reach of {len(task.field['names'])} joints, as 'names' has them"
        )
    return reach


def _off(reach: Reach, angles: Sequence[float]) -> float:
    return math.dist(reach.tip_mm(angles), reach.target_mm)


def _tip(task: Task) -> str:
    return task.say(f"joints.tip.{_reach(task).tip}")


def judge(task: Task, reply: str) -> Verdict:
    """By forward kinematics, the joints' limits, and the attitude where it counts."""
    reach = _reach(task)
    names = task.field["names"]
    given = numbers(reply, len(names))
    angles = [in_unit(each, "deg") for each in given]
    allowed = float(task.field["tolerance"])
    off = _off(reach, angles)
    shown = f"{off:.1f}"
    if off <= allowed:
        limits = zip(names, angles, reach.lower_deg, reach.upper_deg, strict=False)
        for i, (name, angle, low, high) in enumerate(limits):
            if not low - 1e-3 <= angle <= high + 1e-3:
                turn = {"angle": f"{angle:g}", "low": f"{low:g}", "high": f"{high:g}"}
                return task.verdict(False, "limit", faults=[i], name=name, **turn)
        tilt = reach.tilt_deg(angles) if reach.tilt_deg else 0.0
        if tilt > TILT_DEG:
            return task.verdict(False, "tilt", angle=f"{tilt:.1f}")
        return task.verdict(True, "right", tip=_tip(task), distance=shown)
    if not any(each.unit for each in given) and _off(reach, [math.degrees(a) for a in angles]) <= allowed:
        return task.verdict(False, "unit", tip=_tip(task), distance=shown)
    for number, slip in enumerate(task.slips):
        expected = slip.solution_deg if isinstance(slip, Reach) else slip
        if math.dist(reach.tip_mm(angles), reach.tip_mm(expected)) <= allowed:
            return task.slip(number)
    for i, name in enumerate(names):
        if _off(reach, [*angles[:i], -angles[i], *angles[i + 1 :]]) <= allowed:
            return task.verdict(False, "sign", faults=[i], name=name, tip=_tip(task), distance=shown)
    place = ", ".join(f"{v:.1f}" for v in reach.tip_mm(angles))
    if off <= 10 * allowed:
        return task.verdict(False, "near", tip=_tip(task), distance=shown, place=place)
    return task.verdict(False, "wrong", tip=_tip(task), distance=shown, place=place)
