"""A fault is marked where it was typed."""

import pytest

from kinlab.lessons import Course, Task, Verdict
from kinlab.lessons.kinds import judge, offers
from kinlab.lessons.marking import marked


def underlined(samples: Course, name: str, reply: str) -> list[str]:
    task = Task.of(samples.lesson("every-kind"), name, "ani")
    return [reply[a:b] for a, b in marked(task, reply, judge(task, reply))]


@pytest.mark.parametrize(
    ("name", "reply", "faults"),
    [
        ("number", " 171 mm ", ["171 mm"]),
        ("number", "172", []),
        ("vector", "86 -12 75", ["75"]),
        ("vector", "u=86; v=12 mm; w=98 mm", ["12 mm"]),
        ("bytes", "FF FF 0F 05 03 1E 74 02 55", ["0F"]),
        ("gait", "L1 L2 R2 R1", ["L1", "L2"]),
        ("gait", "L1, L2 -> R2 > R1", ["L1", "L2"]),
        ("choice", "a", ["a"]),
    ],
)
def test_the_part_at_fault_is_marked(samples: Course, name: str, reply: str, faults: list[str]) -> None:
    assert underlined(samples, name, reply) == faults


def test_a_reply_of_other_parts_than_asked_for_is_marked_as_a_whole(samples: Course) -> None:
    task = Task.of(samples.lesson("every-kind"), "vector", "ani")
    assert marked(task, "1 2", Verdict(False, "count", "", counts=False)) == [(0, 3)]
    assert marked(task, "  ", Verdict(False, "empty", "", counts=False)) == []


def test_what_can_be_chosen_has_a_label_to_type_and_a_text(samples: Course) -> None:
    lesson = samples.lesson("every-kind")

    def texts(name: str) -> dict[str, str]:
        return offers(Task.of(lesson, name, "ani"))

    assert texts("choice") == {"a": "12", "b": "86"}
    assert texts("mistake")["2"] == "sin(2 x) = sin(x) cos(x)"
    assert set(texts("path").values()) == {"a place", "joint angles", "servo ticks"}
    assert set(texts("gait")) == {"L1", "L2", "R1", "R2"}
    assert texts("number") == {}
