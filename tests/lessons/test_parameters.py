"""Each student's numbers: the same everywhere, others for a neighbour."""

import hashlib
import subprocess
import sys

import pytest

from kinlab.lessons import Course, LessonError, Task
from kinlab.lessons.lesson import Call, Drawn, Parameter, Place
from kinlab.lessons.parameters import _draw, index, shuffled

PLACE = Place("here/en.md", 7)


def test_the_hash_is_the_one_that_is_written_down() -> None:
    text = b"kinlab-params-1\0leg\x001\0foot\0ani\x000\0x"
    assert (
        index(["leg", 1, "foot", "ani", 0, "x"], 1000)
        == int(hashlib.sha256(text).hexdigest()[:16], 16) % 1000
    )


def test_draws_do_not_change_from_one_release_to_the_next(samples: Course) -> None:
    lesson = samples.lesson("every-kind")
    drawn = [Task.of(lesson, "bytes", seed).values for seed in ("ani", "budi", "13519001")]
    assert [(v["x"], v["y"], v["servo"], v["goal"]) for v in drawn] == GOLDEN


GOLDEN = [(86, 12, 11, 471), (86, 9, 1, 433), (70, 9, 18, 512)]


def test_another_python_draws_the_same() -> None:
    code = "from kinlab.lessons.parameters import index; print([index(['a', i], 97) for i in range(20)])"
    other = subprocess.run(
        [sys.executable, "-R", "-c", code], capture_output=True, text=True, check=True
    ).stdout
    assert other.strip() == str([index(["a", i], 97) for i in range(20)])


def test_neighbours_have_different_numbers(samples: Course) -> None:
    lesson = samples.lesson("every-kind")
    goals = {Task.of(lesson, "bytes", f"student-{i}").values["goal"] for i in range(30)}
    assert len(goals) > 20


def test_every_choice_is_drawn_about_equally_often() -> None:
    counts = [0] * 7
    for i in range(7000):
        counts[index(["lesson", 1, "exercise", f"student-{i}", 0, "x"], 7)] += 1
    assert min(counts) > 850
    assert max(counts) < 1150


def test_a_draw_goes_on_until_the_requirement_is_met() -> None:
    drawn = Drawn((Parameter("x", (-1, 0, 1)),), Call("sample.positive", {}, PLACE))
    for i in range(30):
        assert _draw(drawn, {}, lambda attempt, i=i: ["l", 1, "e", i, attempt])["x"] == 1


def test_a_requirement_that_nothing_meets_is_said_with_its_line() -> None:
    drawn = Drawn((Parameter("x", (-2, -1)),), Call("sample.positive", {}, PLACE))
    with pytest.raises(LessonError, match=r"here/en\.md:7: none of 200 draws .* sample\.positive"):
        _draw(drawn, {}, lambda attempt: ["l", attempt])


def test_shuffling_keeps_everything_and_differs_between_students() -> None:
    orders = {tuple(shuffled("abcde", ["l", 1, "e", i])) for i in range(60)}
    assert all(sorted(order) == list("abcde") for order in orders)
    assert len(orders) > 30
