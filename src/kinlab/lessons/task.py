"""An exercise as one student has it: own numbers, one language, the right answer computed by the core."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from kinlab.language import words_of
from kinlab.lessons.filling import UnknownNameError, fill
from kinlab.lessons.lesson import Call, Exercise, Lesson, Wording
from kinlab.lessons.parameters import exercise_values, lesson_values
from kinlab.lessons.registry import evaluate
from kinlab.lessons.results import GIVES, Goal, Reach
from kinlab.names import nearest


@dataclass(frozen=True)
class Verdict:
    """What is said to a reply.

    Attributes:
        ok: whether it is right.
        code: why, in a word: "right", "unit", "sign", "near", "wrong", ...
        message: a sentence for the student.
        counts: whether it was a try; what cannot be read is none.
        faults: which parts of a reply that has several are wrong, from 0; none where it is wrong as a whole.
    """

    ok: bool
    code: str
    message: str
    counts: bool = True
    faults: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class Task:
    """An exercise of one student.

    Attributes:
        lesson, exercise: which.
        seed: of the student.
        language: in which it speaks.
        shared: values of the lesson.
    """

    lesson: Lesson
    exercise: Exercise
    seed: str
    language: str
    shared: Mapping[str, Any]

    @classmethod
    def of(cls, lesson: Lesson, name: str, seed: str, language: str = "en") -> "Task":
        """The exercise `name` of a lesson for the student with that seed."""
        return cls(lesson, lesson.exercise(name), seed, language, lesson_values(lesson, seed))

    @cached_property
    def values(self) -> dict[str, Any]:
        """Drawn and computed, for the exercise and its texts."""
        return exercise_values(self.lesson, self.exercise, self.seed, self.shared)

    @cached_property
    def answer(self) -> Any:
        """What the core computes.

        Raises:
            LessonError: it cannot, or it gives what is no answer to this kind of exercise.
        """
        return self._computed(self.exercise.answer)

    @cached_property
    def slips(self) -> list[Any]:
        """The known wrong answers."""
        return [self._computed(slip) for slip in self.exercise.slips]

    def _computed(self, call: Call) -> Any:
        found = evaluate(call, "answers", self.values)
        wanted, fits = GIVES[self.exercise.kind]
        if not fits(found):
            raise call.place.error(
                f"{call.name} gives {found!r:.40}, and an exercise of the kind"
                f" '{self.exercise.kind}' needs {wanted}"
            )
        return found

    @property
    def wording(self) -> Wording:
        """In the student's language where there is one, else in English."""
        found = self.exercise.wording
        return found.get(self.language, found["en"])

    @property
    def fallback(self) -> bool:
        """Whether it stands in English because there is no translation."""
        return self.language not in self.exercise.wording

    @property
    def field(self) -> Mapping[str, Any]:
        """The fields that only this kind has."""
        return self.exercise.fields

    def text(self, text: str, **more: Any) -> str:
        """A text of the lesson with the student's numbers.

        Raises:
            LessonError: a placeholder has no value.
        """
        try:
            return fill(text, {**self.values, **more})
        except UnknownNameError as error:
            raise self.exercise.place.error(f"exercise '{self.exercise.id}': {error}") from None

    def say(self, key: str, **values: object) -> str:
        """The engine's own words."""
        return words_of("kinlab.lessons").say(self.language, key, **values)

    def verdict(
        self, ok: bool, code: str, *, own: str | None = None, faults: Sequence[int] = (), **values: object
    ) -> Verdict:
        """A verdict whose words are the lesson's (`own`, else its feedback), else the engine's."""
        if own is None and code in self.wording.feedback:
            own = self.text(self.wording.feedback[code])
        said = own if own is not None else self.say(f"{self.exercise.kind}.{code}", **values)
        return Verdict(ok, code, said, faults=tuple(faults))

    def slip(self, number: int) -> Verdict:
        """The verdict on a known wrong answer, from 0."""
        return Verdict(False, "slip", self.text(self.wording.slips[number]))

    @property
    def ask(self) -> str:
        """The question."""
        return self.text(self.wording.ask)

    @property
    def hints(self) -> list[str]:
        """From the idea to the formula."""
        return [self.text(hint) for hint in self.wording.hints]

    @property
    def solution(self) -> str:
        """The way to the answer, with the answer."""
        return self.text(self.wording.solution, answer=shown(self.answer))


def did_you_mean(language: str, name: str, names: Iterable[str]) -> str:
    """The end of a sentence about a name that there is not: the nearest ones, "" where none is near."""
    near = nearest(name, names)
    words = words_of("kinlab.lessons")
    return " " + words.say(language, "talk.near", names=", ".join(near)) if near else ""


def shown(answer: Any) -> Any:
    """An answer as a placeholder can show it."""
    if isinstance(answer, Reach):
        return answer.solution_deg
    if isinstance(answer, Goal):
        return "; ".join(answer.lines)
    return answer


def parts_of(task: Task) -> Sequence[str | int]:
    """What a student's own order of options is drawn from."""
    return [task.lesson.id, task.lesson.version, task.exercise.id, task.seed, 0]
