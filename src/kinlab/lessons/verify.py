"""A lecturer's recomputation: every reply of every student judged again, by the student's own numbers.

The file says which replies were right; that is not believed. Who gives wrong replies and writes that they
were right is found, and so is who hands in a neighbour's replies: they are answers to other numbers, unless
the seed was taken too, and then two files have the same seed.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from kinlab.errors import KinlabError
from kinlab.lessons.course import Course
from kinlab.lessons.export import Handed
from kinlab.lessons.kinds import judge
from kinlab.lessons.progress import PROFILE, Event, Standing, standing
from kinlab.lessons.replies import quote
from kinlab.lessons.task import Task

LONGEST_PATH = 120


@dataclass(frozen=True)
class LessonResult:
    """How a student did in a lesson: exercises solved, solved with the solution's help, and all; replies."""

    solved: int
    shown: int
    exercises: int
    tries: int


@dataclass(frozen=True)
class Result:
    """What came of one student's work.

    Attributes:
        file, profile, seed: whose.
        lessons: by id, those that were begun.
        forged: what the file claims and the recomputation denies, a sentence each.
        notes: what could not be recomputed.
    """

    file: str
    profile: str
    seed: str
    lessons: dict[str, LessonResult]
    forged: tuple[str, ...]
    notes: tuple[str, ...]

    @property
    def solved(self) -> int:
        """Exercises solved without the solution."""
        return sum(lesson.solved for lesson in self.lessons.values())

    def share(self, course: Course) -> float:
        """Of all exercises of the course, those solved without the solution."""
        every = sum(len(lesson.exercises) for lesson in course.lessons.values())
        return self.solved / every if every else 0.0

    def to_json(self, course: Course) -> dict[str, Any]:
        """For programs."""
        return {
            "file": self.file,
            "profile": self.profile,
            "seed": self.seed,
            "ok": not self.forged,
            "solved": self.solved,
            "share": self.share(course),
            "lessons": {
                name: {"solved": r.solved, "shown": r.shown, "exercises": r.exercises, "tries": r.tries}
                for name, r in self.lessons.items()
            },
            "forged": list(self.forged),
            "notes": list(self.notes),
        }


def verify(
    handed: Iterable[Handed], course: Course, tell: Callable[[str], None] = lambda profile: None
) -> list[Result]:
    """Recompute what students handed in.

    Args:
        handed: their files.
        course: whose lessons they took.
        tell: is told whose turn it is.
    """
    every = list(handed)
    seeds = Counter(each.seed for each in every)
    results = []
    for each in every:
        tell(each.profile)
        results.append(
            _recomputed(each, course, [o for o in every if o is not each] if seeds[each.seed] > 1 else [])
        )
    return results


def _recomputed(handed: Handed, course: Course, others: list[Handed]) -> Result:
    notes: list[str] = list(handed.problems)
    forged: list[str] = []
    if handed.seed != handed.profile.casefold() and handed.profile != PROFILE:
        forged.append(f"the seed '{quote(handed.seed)}' is not that of the profile '{quote(handed.profile)}'")
    for other in (each for each in others if each.seed == handed.seed):
        where = quote(other.file, LONGEST_PATH)
        if _same_work(handed, other):
            notes.append(f"is handed in once more in {where}")
        else:
            forged.append(f"has the same seed as {quote(other.profile)} in {where}")
    tasks: dict[tuple[str, str], Task] = {}
    events: list[Event] = []
    accused: set[tuple[str, str]] = set()
    for event in handed.events:
        if event.event != "try":
            events.append(event)
            continue
        found = _judged_again(event, handed.seed, course, tasks)
        if isinstance(found, str):
            notes.append(found)
            continue
        events.append(replace(event, ok=found))
        what = f"{quote(event.lesson)} {quote(event.exercise)}: the reply '{quote(event.reply)}'"
        if event.ok and not found:
            forged.append(f"{what} is said to be right and is wrong")
            accused.add((event.lesson, event.exercise))
        elif found and not event.ok:
            notes.append(f"{what} is right after all")
    forged += _claims(handed, course, events, accused)
    return Result(
        handed.file, handed.profile, handed.seed, _lessons(course, events), _once(forged), _once(notes)
    )


def _claims(
    handed: Handed, course: Course, events: list[Event], accused: set[tuple[str, str]]
) -> Iterator[str]:
    """What a file's summary says otherwise than its events, judged again; those of `accused` were said to be wrong."""
    for (name, version, exercise), claim in handed.claimed.items():
        # Of another version nothing can be said, and nothing counts; the replies' notes say so.
        lesson = course.lessons.get(name)
        if lesson is None or version not in ("", str(lesson.version)):
            continue
        now = standing(events, name, lesson.version, exercise)
        if claim.get("status") == "solved" != now.status:
            yield f"{name} {quote(exercise)}: said to be solved, and is {now.status}"
        elif (name, exercise) not in accused and not handed.problems:
            yield from _taken_away(
                name, exercise, claim, standing(handed.events, name, lesson.version, exercise)
            )


def _same_work(one: Handed, other: Handed) -> bool:
    """Whether two files are of one student by name, and the longer one goes on where the other ends."""
    named = one.profile == other.profile != PROFILE
    return named and all(a == b for a, b in zip(one.events, other.events, strict=False))


def _taken_away(lesson: str, exercise: str, claim: dict[str, Any], listed: Standing) -> Iterator[str]:
    """What a file's summary says otherwise than its own events: some were taken away, or changed."""
    for key, made in {"status": listed.status, "tries": listed.tries, "hints": listed.hints}.items():
        if key in claim and claim[key] != made:
            yield (
                f"{lesson} {quote(exercise)}: the summary says {key} {quote(str(claim[key]))},"
                f" and the events make it {made}"
            )


def _once(sentences: list[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(sentences))


def _judged_again(event: Event, seed: str, course: Course, tasks: dict[tuple[str, str], Task]) -> bool | str:
    """Whether a reply is right; in words why that cannot be said."""
    lesson = course.lessons.get(event.lesson)
    if lesson is None:
        return f"there is no lesson {quote(event.lesson)}"
    if event.version != lesson.version:
        return f"{lesson.id}: was taken in version {quote(str(event.version))}, and the course has {lesson.version}"
    key = event.lesson, event.exercise
    try:
        if key not in tasks:
            tasks[key] = Task.of(lesson, event.exercise, seed)
        return judge(tasks[key], event.reply).ok
    except KinlabError as error:
        return f"{lesson.id} {quote(event.exercise)}: {quote(str(error), 200)}"


def _lessons(course: Course, events: list[Event]) -> dict[str, LessonResult]:
    found = {}
    for lesson in course.lessons.values():
        each = [standing(events, lesson.id, lesson.version, exercise.id) for exercise in lesson.exercises]
        if any(now.tries or now.done for now in each):
            found[lesson.id] = LessonResult(
                sum(now.status == "solved" for now in each),
                sum(now.status == "shown" for now in each),
                len(each),
                sum(now.tries for now in each),
            )
    return found
