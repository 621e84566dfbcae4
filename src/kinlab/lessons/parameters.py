"""Each student's own numbers, drawn by a hash that any language can repeat.

The index of a choice among n is SHA-256 of the parts below, in UTF-8 and joined by zero bytes, its first
eight bytes as a big-endian number, modulo n:

    kinlab-params-1  LESSON  VERSION  EXERCISE  SEED  TRY  NAME

EXERCISE is empty for the parameters of a whole lesson. TRY counts from 0, and goes on while the
requirement of the lesson or exercise is not met.
"""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from kinlab.lessons.lesson import Drawn, Exercise, Lesson
from kinlab.lessons.registry import evaluate

SCHEME = "kinlab-params-1"
MOST_TRIES = 200
T = TypeVar("T")


def index(parts: Sequence[str | int], count: int) -> int:
    """Which of `count` choices is drawn for `parts`.

    >>> index(["leg", 1, "foot", "ani", 0, "x"], 10)
    7
    """
    text = "\0".join([SCHEME, *map(str, parts)])
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big") % count


def shuffled(items: Sequence[T], parts: Sequence[str | int]) -> list[T]:
    """The items in an order of the student's own (Fisher and Yates)."""
    mixed = list(items)
    for i in range(len(mixed) - 1, 0, -1):
        j = index([*parts, i, "shuffle"], i + 1)
        mixed[i], mixed[j] = mixed[j], mixed[i]
    return mixed


def lesson_values(lesson: Lesson, seed: str) -> dict[str, Any]:
    """The values that the lesson's text, figures and exercises share.

    Raises:
        LessonError: they cannot be computed.
    """
    beginning = {"robot": lesson.robot} if lesson.robot else {}
    return _draw(lesson.drawn, beginning, lambda attempt: [lesson.id, lesson.version, "", seed, attempt])


def exercise_values(
    lesson: Lesson, exercise: Exercise, seed: str, shared: Mapping[str, Any]
) -> dict[str, Any]:
    """The values of one exercise, on top of those that the lesson shares.

    Raises:
        LessonError: they cannot be computed.
    """
    return _draw(
        exercise.drawn, shared, lambda attempt: [lesson.id, lesson.version, exercise.id, seed, attempt]
    )


def _draw(
    drawn: Drawn, beginning: Mapping[str, Any], parts: Callable[[int], list[str | int]]
) -> dict[str, Any]:
    for attempt in range(MOST_TRIES):
        values = dict(beginning)
        for parameter in drawn.parameters:
            chosen = index([*parts(attempt), parameter.name], len(parameter.choices))
            values[parameter.name] = parameter.choices[chosen]
        if drawn.requires is None or evaluate(drawn.requires, "answers", values):
            break
    else:
        assert drawn.requires is not None
        raise drawn.requires.place.error(
            f"none of {MOST_TRIES} draws of the parameters fulfils {drawn.requires.name}"
        )
    for name, call in drawn.values.items():
        values[name] = evaluate(call, "answers", values)
    return values
