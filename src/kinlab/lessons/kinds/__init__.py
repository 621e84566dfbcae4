"""The kinds of exercise: what a reply looks like, which one is right, and what to say to the others."""

from collections.abc import Sequence
from importlib import import_module
from typing import Protocol, cast

from kinlab.lessons.replies import UnreadableError
from kinlab.lessons.task import Task, Verdict


class Kind(Protocol):
    """What the module of a kind offers."""

    def shape(self, task: Task) -> str:
        """What a reply looks like, in a sentence or a list, to stand below the question."""

    def right(self, task: Task) -> str:
        """A right reply."""

    def wrong(self, task: Task) -> Sequence[str]:
        """Replies that must not pass."""

    def judge(self, task: Task, reply: str) -> Verdict:
        """What is said to a reply.

        Raises:
            UnreadableError: it is none.
        """


def kind_of(task: Task) -> Kind:
    """The module that knows the task's kind."""
    return cast(Kind, import_module(f"kinlab.lessons.kinds.{task.exercise.kind}"))


def offers(task: Task) -> dict[str, str]:
    """What there is to choose from or to put in order: texts by what is typed for each; nothing in other kinds."""
    offered: dict[str, str] = getattr(kind_of(task), "offers", lambda _: {})(task)
    return offered


def judge(task: Task, reply: str) -> Verdict:
    """What is said to a reply; one that cannot be read is no try."""
    try:
        return kind_of(task).judge(task, reply)
    except UnreadableError as error:
        return Verdict(False, error.code, task.say(f"unreadable.{error.code}", **error.values), counts=False)


def rehearse(task: Task) -> None:
    """Compute and fill in everything of an exercise once, so that nothing of it fails later.

    Raises:
        LessonError: the lesson is at fault.
    """
    _ = task.ask, task.hints, task.solution, task.slips
    kind_of(task).shape(task)
    kind_of(task).right(task)
    for texts in (task.wording.feedback.values(), task.wording.slips, task.wording.why.values()):
        for text in texts:
            task.text(text)
