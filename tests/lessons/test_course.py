"""The course itself: every exercise of every lesson, over many students, in both languages."""

from functools import cache

import pytest

from kinlab.language import LANGUAGES
from kinlab.lessons import Course, Task, load_course
from kinlab.lessons.kinds import judge, kind_of
from kinlab.lessons.lesson import Exercise, Lesson
from kinlab.lessons.lint import lint
from kinlab.lessons.parameters import lesson_values

STUDENTS = 50


@cache
def course() -> Course:
    return load_course()


EXERCISES = [
    pytest.param(lesson, exercise, id=f"{lesson.id}/{exercise.id}")
    for lesson in load_course().lessons.values()
    for exercise in lesson.exercises
]


def test_every_file_can_be_read() -> None:
    assert course().problems == ()


@pytest.mark.parametrize(("lesson", "exercise"), EXERCISES)
def test_the_computed_answer_passes_and_perturbed_ones_fail(lesson: Lesson, exercise: Exercise) -> None:
    for i in range(STUDENTS):
        seed, language = f"student-{i}", ("en", "id")[i % 2]
        task = Task(lesson, exercise, seed, language, lesson_values(lesson, seed))
        kind = kind_of(task)
        verdict = judge(task, kind.right(task))
        assert verdict.ok, (seed, kind.right(task), verdict.message)
        wrong = kind.wrong(task)
        assert wrong
        for reply in wrong if exercise.kind != "bytes" else wrong[i % len(wrong) :: 7]:
            assert not judge(task, reply).ok, (seed, reply)


@pytest.mark.parametrize(("lesson", "exercise"), EXERCISES)
def test_both_languages_have_the_same_numbers(lesson: Lesson, exercise: Exercise) -> None:
    for i in range(5):
        seed = f"student-{i}"
        english, other = (
            Task(lesson, exercise, seed, code, lesson_values(lesson, seed)) for code in LANGUAGES
        )
        assert english.values == other.values
        assert kind_of(english).right(english) == kind_of(other).right(other)
        assert len(english.hints) == len(other.hints)
        assert english.ask != other.ask


def test_every_lesson_is_whole_in_both_languages() -> None:
    for lesson in course().lessons.values():
        assert set(lesson.languages) == set(LANGUAGES)


def test_lint_is_clean(monkeypatch: pytest.MonkeyPatch) -> None:
    # A tenth of the seeds that `kinlab learn lint` tries: the replies are judged above.
    monkeypatch.setattr("kinlab.lessons.lint.SEEDS", 100)
    monkeypatch.setattr("kinlab.lessons.lint.JUDGED", 4)
    monkeypatch.setattr("kinlab.lessons.lint.JUDGED_STATES", 1)
    assert [str(finding) for finding in lint(course())] == []
