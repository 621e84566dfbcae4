"""One of several options, each with a reason why it is right or wrong."""

from collections.abc import Sequence

from kinlab.lessons.parameters import shuffled
from kinlab.lessons.replies import UnreadableError, clean, quote
from kinlab.lessons.task import Task, Verdict, parts_of

# What may stand around an answer.
_AROUND = "().[] "


def letters(task: Task) -> dict[str, str]:
    """Letters to options' keys, in an order of the student's own."""
    keys = shuffled(list(task.field["options"]), parts_of(task))
    return {chr(ord("a") + i): key for i, key in enumerate(keys)}


def offers(task: Task) -> dict[str, str]:
    """The options by their letters."""
    return {letter: task.text(task.wording.options[key]) for letter, key in letters(task).items()}


def shape(task: Task) -> str:
    """The options, and that a letter is enough."""
    options = [f"{letter}) {text}" for letter, text in offers(task).items()]
    return "  \n".join(options) + "\n\n" + task.say("choice.shape")


def right(task: Task) -> str:
    """The letter of the right one."""
    return next(letter for letter, key in letters(task).items() if key == _want(task))


def wrong(task: Task) -> Sequence[str]:
    """All others."""
    return [letter for letter, key in letters(task).items() if key != _want(task)]


def _want(task: Task) -> str:
    want: str = task.answer
    if want not in task.field["options"]:
        raise task.exercise.answer.place.error(
            f"{task.exercise.answer.name} gives '{want}', and there is no such option;"
            f" there are: {', '.join(task.field['options'])}"
        )
    return want


def judge(task: Task, reply: str) -> Verdict:
    """By the option, with its reason."""
    text = clean(reply).casefold().strip(_AROUND)
    by_letter = letters(task)
    # In every language: a lecturer's recomputation does not know in which one the student read.
    by_text = {
        task.text(wording.options[key]).casefold().strip(_AROUND): key
        for wording in task.exercise.wording.values()
        for key in by_letter.values()
    }
    chosen = by_letter.get(text) or by_text.get(text)
    if chosen is None:
        raise UnreadableError("no-option", text=quote(clean(reply)), options=", ".join(by_letter))
    why = task.text(task.wording.why[chosen])
    if chosen == _want(task):
        return task.verdict(True, "right", why=why)
    return task.verdict(False, "wrong", why=why)
