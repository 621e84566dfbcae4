"""A student at a lesson: what every face shows and asks, and what is kept of it.

sitting = Sitting(course.lesson("leg-geometry"), Progress("ani"), "en")
for part in sitting.parts():
    ...                                   # Text, Figure or Task, in the order to show them
sitting.check("foot", "75.3 -63.2 -28.5")  # a Verdict, kept in the progress
sitting.hint("foot")                       # the next one
sitting.solution("foot")                   # None until three tries were made
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kinlab.errors import UsageError
from kinlab.language import words_of
from kinlab.lessons.drawing import Picture, draw
from kinlab.lessons.filling import UnknownNameError, fill
from kinlab.lessons.kinds import judge, kind_of
from kinlab.lessons.lesson import Exercise, Figure, Lesson, Place, Prose
from kinlab.lessons.parameters import lesson_values
from kinlab.lessons.progress import Event, Progress, Standing, Unkept
from kinlab.lessons.replies import LONGEST_SCRIPT
from kinlab.lessons.task import Task, Verdict

if TYPE_CHECKING:
    from kinlab.lessons.kinds.state import Workbench

WIDTH = 48


@dataclass(frozen=True)
class Text:
    """Markdown to show.

    Attributes:
        markdown: placeholders filled in.
        fallback: whether it stands in English because there is no translation.
    """

    markdown: str
    fallback: bool = False


@dataclass(frozen=True)
class Hint:
    """One of the hints.

    Attributes:
        number: from 1.
        count: how many there are.
        text: Markdown.
    """

    number: int
    count: int
    text: str


@dataclass(frozen=True)
class Step:
    """A piece of a lesson to take at once.

    Attributes:
        parts: what there is to read and to see first.
        task: the exercise that follows; None at the end of the lesson.
    """

    parts: tuple[Text | Figure, ...]
    task: Task | None


class Sitting:
    """A student at a lesson.

    Attributes:
        lesson: which.
        progress: of the student.
        language: in which the lesson speaks, "en" or "id".
        tasks: the exercises with the student's numbers, by id.
    """

    def __init__(self, lesson: Lesson, progress: Progress, language: str) -> None:
        progress.begin()
        self.lesson = lesson
        self.progress = progress
        self.language = language
        self.shared = lesson_values(lesson, progress.seed)
        self.tasks = {
            exercise.id: Task(lesson, exercise, progress.seed, language, self.shared)
            for exercise in lesson.exercises
        }

    @classmethod
    def alone(cls, lesson: Lesson, seed: str, language: str) -> "Sitting":
        """A sitting of which nothing is kept, for the student with that seed."""
        return cls(lesson, Unkept(seed), language)

    @property
    def fallback(self) -> bool:
        """Whether the lesson is not there in the student's language at all."""
        return self.language not in self.lesson.languages

    def parts(self) -> list[Text | Figure | Task]:
        """The lesson in the order in which a student meets it; a first heading that repeats its title is left out.

        Raises:
            LessonError: a placeholder has no value.
        """
        found: list[Text | Figure | Task] = []
        for part in self.lesson.parts.get(self.language, self.lesson.parts["en"]):
            if isinstance(part, Prose):
                text = part.text if found else _without_title(part.text, self.lesson.title(part.language))
                found.append(Text(self._fill(text, part.place), part.language != self.language))
            elif isinstance(part, Exercise):
                found.append(self.tasks[part.id])
            else:
                found.append(part)
        return found

    def steps(self) -> list[Step]:
        """The lesson cut behind its exercises; the last step has none.

        Raises:
            LessonError: a placeholder has no value.
        """
        found: list[Step] = []
        before: list[Text | Figure] = []
        for part in self.parts():
            if isinstance(part, Task):
                found.append(Step(tuple(before), part))
                before = []
            else:
                before.append(part)
        return [*found, Step(tuple(before), None)]

    def _fill(self, text: str, place: Place) -> str:
        try:
            return fill(text, self.shared)
        except UnknownNameError as error:
            raise place.error(str(error)) from None

    def picture(self, figure: Figure, columns: int = WIDTH, *, ascii_only: bool = False) -> Picture:
        """A figure, drawn now, at most `columns` wide.

        Raises:
            LessonError: it cannot be drawn.
        """
        alt = self._fill(figure.alt.get(self.language, figure.alt["en"]), figure.place)
        return draw(figure, self.shared, alt, columns, ascii_only)

    def question(self, name: str) -> str:
        """Markdown: the question, and below it what a reply looks like."""
        task = self._task(name)
        return f"{task.ask}\n\n{self.shape(name)}"

    def shape(self, name: str) -> str:
        """What a reply looks like: the options, the items, the unit and how exact is exact enough."""
        task = self._task(name)
        return kind_of(task).shape(task)

    def check(self, name: str, reply: str) -> Verdict:
        """What is said to a reply; kept where it counts.

        Raises:
            LessonError: the lesson's answer cannot be computed.
            FileError: the progress cannot be written.
        """
        task = self._task(name)
        # Bytes that were no text come as halves of characters, which no file can hold.
        reply = reply.encode(errors="replace").decode()
        verdict = judge(task, reply)
        if verdict.counts:
            self._keep("try", task, reply=reply[:LONGEST_SCRIPT], ok=verdict.ok, code=verdict.code)
        return verdict

    def workbench(self, name: str) -> "Workbench":
        """The emulated chain of an exercise of the kind "state", set up anew: it executes lines.

        Raises:
            UsageError: no such exercise.
            LessonError: it is of another kind.
        """
        from kinlab.lessons.kinds.state import Workbench

        return Workbench(self._task(name))

    def reached(self, name: str, lines: Sequence[str]) -> bool:
        """Whether lines on a fresh workbench lead to the goal, moments later; nothing is kept of it."""
        return judge(self._task(name), "\n".join(lines)).ok

    def answered(self, name: str) -> str:
        """The latest right reply, "" where there is none."""
        exercise = self._task(name).exercise.id
        for event in reversed(self.progress.events):
            if event.ok and (event.lesson, event.exercise) == (self.lesson.id, exercise):
                return event.reply
        return ""

    def hints(self, name: str) -> list[Hint]:
        """Those that were looked at, in their order."""
        task = self._task(name)
        seen = min(self.standing(name).hints, len(task.hints))
        return [Hint(i + 1, len(task.hints), text) for i, text in enumerate(task.hints[:seen])]

    def hint(self, name: str) -> Hint | None:
        """The next hint; None where all were looked at."""
        task = self._task(name)
        seen = self.standing(name).hints
        if seen >= len(task.hints):
            return None
        self._keep("hint", task)
        return Hint(seen + 1, len(task.hints), task.hints[seen])

    def solution(self, name: str) -> str | None:
        """The solution, and a note that it was looked at; None while too little was tried."""
        task = self._task(name)
        now = self.standing(name)
        if not now.may_see_solution:
            return None
        text = task.solution
        if not now.done:
            self._keep("shown", task)
        return text

    def standing(self, name: str) -> Standing:
        """How the student stands with an exercise."""
        return self.progress.standing(self.lesson.id, self.lesson.version, self._task(name).exercise.id)

    def say(self, key: str, **values: object) -> str:
        """A sentence of the engine, in the student's language."""
        return words_of("kinlab.lessons").say(self.language, key, **values)

    @property
    def open(self) -> list[str]:
        """The exercises that are still to be done."""
        return [name for name in self.tasks if not self.standing(name).done]

    def reset(self) -> None:
        """Begin the lesson anew; what was done stays in the file."""
        self.progress.add(Event.now("reset", self.lesson.id, self.lesson.version))

    def _task(self, name: str) -> Task:
        if name not in self.tasks:
            raise UsageError(f"{self.lesson.id} has no exercise '{name}'; there are: {', '.join(self.tasks)}")
        return self.tasks[name]

    def _keep(self, event: str, task: Task, **more: object) -> None:
        self.progress.add(Event.now(event, self.lesson.id, self.lesson.version, task.exercise.id, **more))


def _without_title(text: str, title: str) -> str:
    """Prose without the heading that repeats the title, which every face shows by itself."""
    first, _, rest = text.partition("\n")
    return rest.lstrip("\n") if first.strip("# ") == title and rest.strip() else text
