"""The path in one sentence: where the tip gets, or why it does not get there."""

from kinlab.robots.reasons import breaches
from kinlab.tui.numbers import shown
from kinlab.tui.stations.robot.asking import Answer
from kinlab.tui.stations.robot.naming import Say, solution_name
from kinlab.tui.stations.robot.table import error_mm


def verdict(answer: Answer, say: Say) -> tuple[str, str]:
    """The kind of message, and the sentence."""
    path, asked = answer.path, answer.question
    report = path.answer
    if path.pose is not None:
        if path.arrival is None:
            return "good", say("told.reached", solution=solution_name(path.pose.name, say))
        if path.arrival_error_m is None:
            return "warn", say("told.off") if not asked.powered else say("told.silent")
        error = error_mm(path.arrival_error_m)
        return "good", say("told.stands", solution=solution_name(path.pose.name, say), error=error)
    values: dict[str, object] = {"reason": report.reason}
    if report.poses:
        broken = min((breaches(report.limb, pose.q) for pose in report.poses), key=len)
        first = broken[0]
        values |= {
            "joint": first.joint,
            "angle": shown(first.angle_deg, 1),
            "limit": shown(first.limit_deg, 1),
        }
        sentence = say("told.beyond", **values)
    else:
        sentence = say("told.unreachable", **values)
    if report.nearest is not None:
        place = ", ".join(shown(v, 1) for v in report.place_mm(report.nearest))
        sentence += " " + say("told.nearest", place=place, missed=shown(report.missed_mm, 1))
    return "bad", sentence
