"""Lessons as tables and as JSON documents."""

from collections import Counter
from typing import Any

import typer

from kinlab.cli.learn_prose import width
from kinlab.cli.printing import print_lines
from kinlab.language import words_of
from kinlab.lessons.course import Course
from kinlab.lessons.lesson import Lesson
from kinlab.lessons.progress import Progress, Standing
from kinlab.lessons.prose import wrapped

# Of one kind about one student, in the table for people.
MOST_SENTENCES = 5


def list_json(course: Course, progress: Progress, language: str) -> dict[str, Any]:
    """The document of `kinlab learn list --json`."""
    lessons = []
    for number, lesson in enumerate(course.lessons.values(), 1):
        each = _standings(lesson, progress)
        lessons.append(
            {
                "number": number,
                "id": lesson.id,
                "title": lesson.title(language),
                "goals": list(lesson.goals.get(language, lesson.goals["en"])),
                "prerequisites": list(lesson.prerequisites),
                "robot": lesson.robot or None,
                "minutes": lesson.minutes,
                "version": lesson.version,
                "languages": list(lesson.languages),
                "exercises": {name: now.status for name, now in each.items()},
            }
        )
    following = course.next_for(progress)
    return {
        "profile": progress.profile,
        "lessons": lessons,
        "next": following.id if following else None,
        "problems": [str(problem) for problem in course.problems],
    }


def _standings(lesson: Lesson, progress: Progress) -> dict[str, Standing]:
    return {
        exercise.id: progress.standing(lesson.id, lesson.version, exercise.id)
        for exercise in lesson.exercises
    }


def show_list(course: Course, progress: Progress, language: str) -> None:
    """Number, name, title, minutes, and what is solved; one line for each lesson, without a frame."""
    words = words_of("kinlab.lessons")
    rows = []
    total = solved = shown = 0
    for number, lesson in enumerate(course.lessons.values(), 1):
        each = _standings(lesson, progress)
        done = sum(now.done for now in each.values())
        total += len(each)
        solved += sum(now.status == "solved" for now in each.values())
        shown += sum(now.status == "shown" for now in each.values())
        rows.append((number, lesson, done, len(each)))
    wide = max((len(lesson.id) for lesson in course.lessons.values()), default=0)
    for number, lesson, done, count in rows:
        style = "good" if done == count else "odd" if done else ""
        minutes = words.say(language, "talk.minutes", minutes=lesson.minutes)
        head = f"{number:>3}  {lesson.id:<{wide}}  {minutes:>7}  {done:>2}/{count}  "
        row = wrapped(lesson.title(language), max(width(), len(head) + 20), head=head)
        print_lines([[(style, text) for _, text in line] for line in row])
    for problem in course.problems:
        print_lines([[("bad", words.say(language, "talk.broken", error=problem))]])
    typer.echo()
    typer.echo(
        words.say(language, "talk.list", profile=progress.profile, solved=solved, count=total, shown=shown)
    )
    following = course.next_for(progress)
    if following:
        typer.echo(words.say(language, "talk.legend", lesson=following.id))


def lesson_json(sitting: Any, *, ascii_only: bool) -> dict[str, Any]:
    """The document of `kinlab learn LESSON --json`: its parts with the student's numbers, without answers."""
    from kinlab.lessons.sitting import Sitting, Text
    from kinlab.lessons.task import Task

    assert isinstance(sitting, Sitting)
    parts: list[dict[str, Any]] = []
    for part in sitting.parts():
        if isinstance(part, Text):
            parts.append({"part": "text", "markdown": part.markdown, "fallback": part.fallback})
        elif isinstance(part, Task):
            now = sitting.standing(part.exercise.id)
            drawn = {parameter.name for parameter in part.exercise.drawn.parameters}
            parts.append(
                {
                    "part": "exercise",
                    "id": part.exercise.id,
                    "kind": part.exercise.kind,
                    "ask": part.ask,
                    "shape": sitting.shape(part.exercise.id),
                    "parameters": {name: part.values[name] for name in sorted(drawn)},
                    "status": now.status,
                    "tries": now.tries,
                    "hints": len(part.hints),
                    "fallback": part.fallback,
                }
            )
        else:
            picture = sitting.picture(part, ascii_only=ascii_only)
            parts.append({"part": "figure", "id": part.id, "text": picture.text, "alt": picture.alt})
    return {
        "lesson": sitting.lesson.id,
        "title": sitting.lesson.title(sitting.language),
        "language": sitting.language,
        "version": sitting.lesson.version,
        "profile": sitting.progress.profile,
        "seed": sitting.progress.seed,
        "parts": parts,
    }


def show_class(course: Course, results: list[Any]) -> None:
    """A row for each student, then one for each lesson; what is forged below."""
    from rich.text import Text

    from kinlab.cli.show import show, table
    from kinlab.lessons.replies import quote
    from kinlab.lessons.verify import LONGEST_PATH, Result

    students: list[Result] = results
    known = Counter(result.profile for result in students)
    # Who names no profile is "student": such are told apart by their files.
    names = {
        id(r): quote(r.profile)
        if known[r.profile] == 1
        else f"{quote(r.profile)} ({quote(r.file, LONGEST_PATH)})"
        for r in students
    }
    every = sum(len(lesson.exercises) for lesson in course.lessons.values())
    people = table("", "student", ("solved", f"of {every}"), ("share", "%"), "shown", "replies", "remarks")
    for result in students:
        remark = f"{len(result.forged)} forged" if result.forged else ""
        notes = f"{len(result.notes)} note(s)" if result.notes else ""
        people.add_row(
            Text(names[id(result)]),
            str(result.solved),
            f"{100 * result.share(course):.0f}",
            str(sum(lesson.shown for lesson in result.lessons.values())),
            str(sum(lesson.tries for lesson in result.lessons.values())),
            ", ".join(filter(None, (remark, notes))),
        )
    show(people)
    begun = [lesson for lesson in course.lessons.values() if any(lesson.id in r.lessons for r in students)]
    if begun:
        typer.echo()
        lessons = table("", "lesson", "begun by", ("solved", "mean"), ("of", ""), ("replies", "per exercise"))
        for lesson in begun:
            each = [r.lessons[lesson.id] for r in students if lesson.id in r.lessons]
            count = len(lesson.exercises)
            lessons.add_row(
                lesson.id,
                str(len(each)),
                f"{sum(r.solved for r in each) / len(each):.1f}",
                str(count),
                f"{sum(r.tries for r in each) / (len(each) * max(count, 1)):.1f}",
            )
        show(lessons)
    for result in students:
        for kind, sentences in (("forged", result.forged), ("note", result.notes)):
            for sentence in sentences[:MOST_SENTENCES]:
                file = quote(result.file, LONGEST_PATH)
                typer.echo(f"{quote(result.profile)} ({file}), {kind}: {sentence}")
            if len(sentences) > MOST_SENTENCES:
                typer.echo(f"    and {len(sentences) - MOST_SENTENCES} more; --json shows them all")
