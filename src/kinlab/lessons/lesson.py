"""What a lesson is, read and checked: frozen data that needs no numpy and computes nothing."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kinlab.errors import FileError
from kinlab.names import resolve

Texts = Mapping[str, str]


class LessonError(FileError):
    """A lesson's file says something that it must not; the message starts with its name and line."""


@dataclass(frozen=True)
class Place:
    """Where something stands: a file as people name it, and a line from 1."""

    file: str
    line: int

    def error(self, message: str) -> LessonError:
        """An error that begins with this place."""
        return LessonError(f"{self.file}:{self.line}: {message}")


@dataclass(frozen=True)
class Call:
    """A named function of the core and what it is given: see `kinlab.lessons.registry`.

    Attributes:
        name: "TOPIC.FUNCTION".
        given: arguments by name; a text "{x}" stands for the value x.
        place: where the lesson says so.
    """

    name: str
    given: Mapping[str, Any]
    place: Place


@dataclass(frozen=True)
class Parameter:
    """A value that is drawn for each student: one of `choices`, all equally likely."""

    name: str
    choices: tuple[Any, ...]


@dataclass(frozen=True)
class Drawn:
    """What a lesson or an exercise has values of: drawn ones, then computed ones, in order.

    Attributes:
        parameters: drawn for each student.
        requires: what must be true of them, else others are drawn; None where all will do.
        values: computed from the parameters and from the values before, by name.
    """

    parameters: tuple[Parameter, ...] = ()
    requires: Call | None = None
    values: Mapping[str, Call] = field(default_factory=dict)


@dataclass(frozen=True)
class Wording:
    """The texts of an exercise in one language; placeholders are not filled in yet.

    Attributes:
        ask, solution: Markdown.
        hints: from the idea to the formula.
        feedback: by code of a verdict, in the place of the engine's own words.
        slips: what to say to each known wrong answer, in the order of the exercise's slips.
        options: of a choice, by key.
        why: what to say where an option is chosen (by key), or a line (by its number).
        items: of an order, by key.
    """

    ask: str
    hints: tuple[str, ...] = ()
    solution: str = ""
    feedback: Texts = field(default_factory=dict)
    slips: tuple[str, ...] = ()
    options: Texts = field(default_factory=dict)
    why: Texts = field(default_factory=dict)
    items: Texts = field(default_factory=dict)


@dataclass(frozen=True)
class Exercise:
    """An exercise.

    Attributes:
        id: within its lesson.
        kind: decides what a reply looks like and how it is judged.
        fields: those that only this kind has.
        drawn: its parameters and values, on top of the lesson's.
        answer: computes the right answer.
        slips: compute wrong answers that are worth a word of their own.
        wording: by language.
        place: where it begins.
    """

    id: str
    kind: str
    fields: Mapping[str, Any]
    drawn: Drawn
    answer: Call
    slips: tuple[Call, ...]
    wording: Mapping[str, Wording]
    place: Place


@dataclass(frozen=True)
class Figure:
    """A picture that the core draws; `alt` says by language what is to be seen, for who cannot see it."""

    id: str
    draw: Call
    alt: Texts
    place: Place


@dataclass(frozen=True)
class Prose:
    """Markdown; `language` is that in which it is written."""

    text: str
    language: str
    place: Place


Part = Prose | Figure | Exercise


@dataclass(frozen=True)
class Lesson:
    """A lesson.

    Attributes:
        id: the name of its folder.
        folder: where it lies.
        titles, goals: by language.
        prerequisites: ids of the lessons that come before.
        robot: that it is about, "" for none.
        instrument: "leg" or "gait", to be shown beside the text; "" where there is no robot.
        minutes: that a student needs.
        version: a higher one has other numbers.
        order: its place in the course, ascending.
        explains: terms of the glossary that it explains.
        drawn: parameters and values for its whole text.
        parts: by language, in the order in which a student meets them.
        languages: in which it is written.
    """

    id: str
    folder: Path
    titles: Texts
    goals: Mapping[str, tuple[str, ...]]
    prerequisites: tuple[str, ...]
    robot: str
    instrument: str
    minutes: int
    version: int
    order: float
    explains: tuple[str, ...]
    drawn: Drawn
    parts: Mapping[str, tuple[Part, ...]]
    languages: tuple[str, ...]

    @property
    def exercises(self) -> tuple[Exercise, ...]:
        """In their order."""
        return tuple(part for part in self.parts["en"] if isinstance(part, Exercise))

    @property
    def figures(self) -> tuple[Figure, ...]:
        """In their order."""
        return tuple(part for part in self.parts["en"] if isinstance(part, Figure))

    def exercise(self, name: str) -> Exercise:
        """The exercise that `name` means (exact or unique prefix).

        Raises:
            UsageError: no such exercise.
        """
        found = {exercise.id: exercise for exercise in self.exercises}
        return found[resolve(name, found, f"exercise of {self.id}")]

    def title(self, language: str) -> str:
        """In that language, else in English."""
        return self.titles.get(language, self.titles["en"])

    def calls(self) -> Iterator[tuple[str, Call]]:
        """Everything of the core that it names, each with the room that it is looked for in."""
        for drawn in (self.drawn, *(exercise.drawn for exercise in self.exercises)):
            yield from (("answers", call) for call in drawn.values.values())
            if drawn.requires:
                yield "answers", drawn.requires
        for exercise in self.exercises:
            yield from (("answers", call) for call in (exercise.answer, *exercise.slips))
        yield from (("figures", figure.draw) for figure in self.figures)
