"""What is wrong with lessons, found without a student: references, translations, terms, and every exercise tried."""

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from kinlab.errors import KinlabError
from kinlab.language import LANGUAGES
from kinlab.lessons import lint_texts
from kinlab.lessons.course import Course
from kinlab.lessons.filling import names
from kinlab.lessons.kinds import judge, kind_of, rehearse
from kinlab.lessons.lesson import Call, Exercise, Lesson, LessonError, Place
from kinlab.lessons.parameters import exercise_values, lesson_values
from kinlab.lessons.registry import evaluate, find, takes
from kinlab.lessons.sitting import WIDTH, Sitting
from kinlab.lessons.task import Task
from kinlab.names import suggestion

# Seeds over which parameters are drawn and answers computed, and those over which replies are judged.
SEEDS = 1000
JUDGED = 20
# Talking to an emulated chain takes longer.
JUDGED_STATES = 3
DRAWN_FIGURES = 3
FEWEST_VARIANTS = 8


@dataclass(frozen=True)
class Finding:
    """Something wrong: where, and what."""

    place: Place
    message: str

    def __str__(self) -> str:
        return f"{self.place.file}:{self.place.line}: {self.message}"

    def to_json(self) -> dict[str, Any]:
        """File, line and message."""
        return {"file": self.place.file, "line": self.place.line, "message": self.message}


def lint(
    course: Course, lessons: list[str] | None = None, tell: Callable[[str], None] = lambda lesson: None
) -> list[Finding]:
    """Everything that is wrong with the course.

    Args:
        course: what was read of it.
        lessons: only these; None: all.
        tell: is told the lesson that is looked at next.
    """
    wanted = [each for each in course.lessons.values() if lessons is None or each.id in lessons]
    found: list[Finding] = [] if lessons else [_of_error(problem) for problem in course.problems]
    for lesson in wanted:
        tell(lesson.id)
        found += _prerequisites(course, lesson)
        for place, message in (
            *lint_texts.translations(lesson),
            *lint_texts.terms(course, lesson),
            *lint_texts.markdown(lesson),
        ):
            found.append(Finding(place, message))
        dead = list(_references(lesson))
        # Where a function is missing, trying its exercises would only say so again.
        found += dead or [*_idle(lesson), *_tried(lesson)]
    return list(dict.fromkeys(found))


def _of_error(error: LessonError) -> Finding:
    file, line, message = str(error).split(":", 2)
    return Finding(Place(file, int(line)), message.strip())


def _prerequisites(course: Course, lesson: Lesson) -> Iterator[Finding]:
    place = Place(f"{lesson.id}/en.md", 1)
    for name in lesson.prerequisites:
        before = course.lessons.get(name)
        if before is None:
            yield Finding(place, f"prerequisite '{name}' is no lesson{suggestion(name, course.lessons)}")
        elif lesson.id in _all_before(course, name) or name == lesson.id:
            yield Finding(place, f"prerequisite '{name}' itself comes after this lesson")
        elif before.order >= lesson.order:
            yield Finding(place, f"prerequisite '{name}' stands later in the course (order {before.order:g})")
    if lesson.robot:
        from kinlab.lessons.robots import find_gait, load_robot
        from kinlab.robots import robot_names

        if lesson.robot not in robot_names():
            yield Finding(
                place, f"no robot is named '{lesson.robot}'{suggestion(lesson.robot, robot_names())}"
            )
        elif lesson.instrument == "gait":
            try:
                find_gait(load_robot(lesson.robot))
            except KinlabError as error:
                yield Finding(place, f"the instrument is a gait: {error}")


def _all_before(course: Course, name: str) -> set[str]:
    found: set[str] = set()
    waiting = [name]
    while waiting:
        lesson = course.lessons.get(waiting.pop())
        new = set(lesson.prerequisites if lesson else ()) - found
        found |= new
        waiting += new
    return found


def _references(lesson: Lesson) -> Iterator[Finding]:
    for room, call in lesson.calls():
        try:
            find(call, room)
        except LessonError as error:
            yield _of_error(error)


def _idle(lesson: Lesson) -> Iterator[Finding]:
    """Parameters that a question names and its answer does not depend on: another was meant."""
    for exercise in lesson.exercises:
        values = {**lesson.drawn.values, **exercise.drawn.values}
        drawn = {p.name for p in (*lesson.drawn.parameters, *exercise.drawn.parameters)}
        asked = {name.partition(".")[0] for name in names(exercise.wording["en"].ask)}
        for name in sorted((asked & drawn) - _needed(exercise.answer, values)):
            yield Finding(
                exercise.answer.place,
                f"exercise '{exercise.id}': the question names '{name}', and {exercise.answer.name} is not given it",
            )


def _needed(call: Call, values: Mapping[str, Call]) -> set[str]:
    """The parameters and values that a call takes, also those that its values take."""
    found = set()
    for name in takes(find(call, "answers")):
        if name in call.given:
            found |= {inner.partition(".")[0] for inner in names(str(call.given[name]))}
        else:
            found.add(name)
    # Without those that were gone through: a lesson may have one lean on itself.
    rest = {name: value for name, value in values.items() if name not in found}
    return found.union(*(_needed(values[name], rest) for name in found if name in values))


def _tried(lesson: Lesson) -> list[Finding]:
    """What comes of drawing parameters, computing answers and judging replies."""
    try:
        shared = [lesson_values(lesson, f"seed-{i}") for i in range(SEEDS)]
    except LessonError as error:
        return [_of_error(error)]
    found: list[Finding] = []
    for exercise in lesson.exercises:
        try:
            found += _exercise(lesson, exercise, shared)
        except LessonError as error:
            found.append(_of_error(error))
        except KinlabError as error:
            found.append(Finding(exercise.place, f"exercise '{exercise.id}': {error}"))
    try:
        for code in LANGUAGES:
            for i in range(DRAWN_FIGURES):
                found += _shown(lesson, f"seed-{i}", code)
    except LessonError as error:
        found.append(_of_error(error))
    return found


def _exercise(lesson: Lesson, exercise: Exercise, shared: list[dict[str, Any]]) -> Iterator[Finding]:
    def wrong(message: str) -> Finding:
        return Finding(exercise.place, f"exercise '{exercise.id}': {message}")

    variants = set()
    for i, values in enumerate(shared):
        own = exercise_values(lesson, exercise, f"seed-{i}", values)
        variant = repr(own)
        if variant not in variants:
            variants.add(variant)
            evaluate(exercise.answer, "answers", own)
    if exercise.drawn.parameters and len(variants) < FEWEST_VARIANTS:
        yield wrong(
            f"its parameters make {len(variants)} variants only; neighbours would have the same numbers"
        )
    slips: Counter[int] = Counter()
    judged = JUDGED_STATES if exercise.kind == "state" else JUDGED
    for i in range(judged):
        seed = f"seed-{i}"
        for code in lesson.languages:
            rehearse(Task(lesson, exercise, seed, code, shared[i]))
        task = Task(lesson, exercise, seed, lesson.languages[i % len(lesson.languages)], shared[i])
        complaint = _judged(task, slips)
        if complaint:
            yield wrong(f"{complaint} (seed {seed})")
            return
    for number in range(len(exercise.slips)):
        if not slips[number]:
            yield wrong(f"slip {number + 1} ({exercise.slips[number].name}) is never recognised")


def _judged(task: Task, slips: Counter[int]) -> str:
    """What is wrong with how replies are judged, "" for nothing; counts the slips that are recognised."""
    kind = kind_of(task)
    right = kind.right(task)
    verdict = judge(task, right)
    if not verdict.ok:
        return f"its own answer '{right:.60}' fails: {verdict.message}"
    perturbed = kind.wrong(task)
    if not perturbed:
        return "there is no wrong answer: every reply would pass"
    for reply in perturbed:
        if judge(task, reply).ok:
            return f"a wrong answer '{reply:.60}' passes"
    for number, slip in enumerate(task.slips):
        said = judge(task, kind.right(_with_answer(task, slip)))
        slips[number] += said.code == "slip" and said.message == task.slip(number).message
    return ""


def _with_answer(task: Task, answer: Any) -> Task:
    """The task as if `answer` were the right one, so that its kind writes it as a reply."""
    other = Task(task.lesson, task.exercise, task.seed, task.language, task.shared)
    other.__dict__["answer"] = answer
    return other


def _shown(lesson: Lesson, seed: str, language: str) -> Iterator[Finding]:
    """What is wrong with the prose and the figures of one student."""
    sitting = Sitting.alone(lesson, seed, language)
    sitting.parts()
    for figure in lesson.figures:
        for plain in (False, True):
            picture = sitting.picture(figure, WIDTH, ascii_only=plain)
            wide = max((sum(len(text) for text, _ in row) for row in picture.rows), default=0)
            if not picture.text.strip():
                yield Finding(figure.place, f"figure '{figure.id}' is empty")
            elif wide > WIDTH:
                yield Finding(
                    figure.place, f"figure '{figure.id}' is {wide} characters wide; {WIDTH} are there"
                )
            elif plain and re.search(r"[\u2800-\u28ff]", picture.text):
                yield Finding(figure.place, f"figure '{figure.id}' draws braille where only ASCII is wanted")
