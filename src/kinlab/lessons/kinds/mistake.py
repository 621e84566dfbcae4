"""Printed equations of which one is wrong: which?"""

import re
from collections.abc import Sequence

from kinlab.lessons.replies import UnreadableError, clean, quote
from kinlab.lessons.task import Task, Verdict


def offers(task: Task) -> dict[str, str]:
    """The lines by their numbers."""
    return {str(i): task.text(line) for i, line in enumerate(task.field["lines"], 1)}


def shape(task: Task) -> str:
    """The lines with their numbers, as a block of code: equations are full of stars and underscores."""
    lines = [f"    ({number})  {line}" for number, line in offers(task).items()]
    return "\n".join([*lines, "", task.say("mistake.shape", count=len(lines))])


def right(task: Task) -> str:
    """The number of the wrong line."""
    return str(_want(task))


def wrong(task: Task) -> Sequence[str]:
    """All others."""
    return [str(i) for i in range(1, len(task.field["lines"]) + 1) if i != _want(task)]


def _want(task: Task) -> int:
    want: int = task.answer
    if not 1 <= want <= len(task.field["lines"]):
        raise task.exercise.answer.place.error(
            f"{task.exercise.answer.name} gives line {want}, and there are {len(task.field['lines'])}"
        )
    return want


def judge(task: Task, reply: str) -> Verdict:
    """By the line, with what there is to say of it."""
    text = clean(reply)
    # "line 2" and "(2)" name a line, "R2" and "x2" something that stands in one.
    found = re.fullmatch(r"(?:\D{0,20}\W)?(\d{1,4})\D{0,3}", text)
    count = len(task.field["lines"])
    if found is None or not 1 <= int(found[1]) <= count:
        raise UnreadableError("no-line", text=quote(text), count=count)
    why = task.text(task.wording.why[str(int(found[1]))])
    if int(found[1]) == _want(task):
        return task.verdict(True, "right", why=why)
    return task.verdict(False, "wrong", why=why)
