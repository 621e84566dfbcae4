"""What is said to right and wrong replies, kind by kind."""

import time
from dataclasses import replace

import pytest

from kinlab.errors import UsageError
from kinlab.lessons import Course, Task, Verdict
from kinlab.lessons.kinds import judge, kind_of
from kinlab.lessons.kinds.state import Workbench


def said(course: Course, name: str, reply: str, language: str = "en") -> Verdict:
    return judge(Task.of(course.lesson("every-kind"), name, "ani", language), reply)


# The student ani has x = 86 and y = 12.
@pytest.mark.parametrize(
    ("name", "reply", "code", "part"),
    [
        ("number", "172", "right", "Right: 172.0 mm"),
        ("number", "17,2 cm", "right", "172.0 mm"),
        ("number", "172.5", "right", ""),
        ("number", "172.51", "near", "not within 0.5 mm"),
        ("number", "17.2", "unit", "17.2 is right in cm, not in mm"),
        ("number", "0.172", "unit", "right in m, not in mm"),
        ("number", "0.172 mm", "unit", "right in m, not in mm"),
        ("number", "172 cm", "unit", "right in mm, not in cm"),
        ("number", "-172", "sign", "There is no minus in 86."),
        ("number", "7396", "slip", "That is its square."),
        ("number", "3", "wrong", "far off"),
        ("number", "172 s", "unit-other", "asked for in mm"),
        ("number", "**172 mm**", "right", ""),
        ("number", "≈ 172", "right", ""),
        ("number", "1e150", "no-number", "1e150"),
        ("share", "173.7", "right", ""),
        ("share", "174", "near", "1 %"),
        ("share", "172 mm", "unit-none", "a bare number"),
        ("vector", "86 -12 98", "right", "86.0, -12.0, 98.0 mm"),
        ("vector", "8,6 -1,2 9,8", "unit", "right in cm"),
        ("vector", "86 12 98", "sign", "the sign of v"),
        ("vector", "-12 86 98", "swapped", "u and v"),
        ("vector", "86 -12 90", "partly", "Right so far: u, v. The rest puts it 8 mm off."),
        ("vector", "83 -15 101", "near", "Close: it is 5.2 mm off."),
        ("vector", "1 2 3", "wrong", "mm off"),
        ("vector", "86.7 -12.7 98.7", "near", "Close: it is 1.21 mm off."),
        ("joints", "7.94 26 -102", "right", "your foot lands"),
        ("joints", "0.1386 0.454 -1.781", "unit", "in radians"),
        ("joints", "7.94 26 102", "sign", "the sign of gamma"),
        ("joints", "7.94 26 -99", "near", "your foot would land 3.7 mm off"),
        ("joints", "60 60 60", "wrong", "your foot would land"),
        ("bytes", "FF FF 0B 05 03 1E D7 01 F6", "right", "all 9 bytes"),
        ("bytes", "0xff,0xff,0x0b,5,3,0x1e,0xd7,1,0xf6", "right", ""),
        (
            "bytes",
            "FF FF 0B 04 03 1E D7 01 F6",
            "byte",
            "Byte 4 is the first wrong one: 04 stands where the length",
        ),
        ("bytes", "FF FF 0B 05 03 1E D7 01 F7", "byte", "every bit turned over"),
        ("bytes", "FF FF 0B 05", "short", "next comes the instruction"),
        ("bytes", "FF FF 0B 05 03 1E D7 01 F6 00", "long", "1 more"),
        ("bytes", "FF FF 0B 05 03 1E 01 D7 F6", "slip", "The low byte goes first."),
        ("bytes", "FF GG", "no-bytes", "GG"),
        ("bytes-2", "FF FF FD 00 0F 09 00 03 74 00 82 01 00 00 E1 1E", "byte", "its low byte goes first"),
        ("gait", "L2 L1 R2 R1", "right", ""),
        ("gait", "r2->r1->l2->l1", "right", ""),
        ("gait", "L1 L2 R1 R2", "reversed", "backwards"),
        ("gait", "L1 L2 R2 R1", "wrong", "After L1 something else comes than L2."),
        ("gait", "L1 L1 R2 R1", "items", "Missing: L2"),
        ("gait", "L1 X2", "no-item", "'X2' is none of the items"),
        ("path", "target, angles, ticks", "right", ""),
        ("path", "angles, ticks, target", "first", ""),
        ("choice", "b", "right", "86 is more than 12."),
        ("choice", "A)", "wrong", "12 is less than 86."),
        ("choice", "q", "no-option", "a, b"),
        ("mistake", "2", "right", "A factor of 2 is missing."),
        ("mistake", "(1)", "wrong", "Pythagoras"),
        ("mistake", "٢", "right", ""),
        ("mistake", "7", "no-line", "from 1 to 2"),
        ("mistake", "line 2", "right", ""),
        ("mistake", "R2", "no-line", "from 1 to 2"),
        ("state", "write 1 goal_position 425; wait 2", "right", ""),
        ("state", "write 1 goal_position 425", "right", ""),
        ("state", "write 1 goal_position 500", "wrong", "present_position of servo 1"),
        ("state", "nonsense 1", "line", "Line 1 (nonsense 1)"),
        ("hidden", "write 1 goal_position 675", "wrong", "goal_position of servo 1 is 512."),
        ("arm", "wait 1", "wrong", "mm from the target; 2 mm are allowed"),
    ],
)
def test_a_reply_gets_the_answer_that_it_deserves(
    samples: Course, name: str, reply: str, code: str, part: str
) -> None:
    verdict = said(samples, name, reply)
    assert verdict.code == code
    assert part in verdict.message


UNREADABLE = ("", "\x00", "x" * 100_000)


@pytest.mark.parametrize("reply", UNREADABLE)
def test_what_cannot_be_read_is_no_try_in_any_kind(samples: Course, reply: str) -> None:
    lesson = samples.lesson("every-kind")
    for exercise in lesson.exercises:
        for language in ("en", "id"):
            verdict = judge(Task.of(lesson, exercise.id, "ani", language), reply)
            assert not verdict.ok
            assert not verdict.counts
            assert verdict.message


def test_noise_of_every_kind_ends_in_a_verdict(samples: Course) -> None:
    pieces = [
        "FF",
        "a",
        "1",
        ",5",
        "-",
        "mm",
        "R1",
        "+",
        ";",
        "\n",
        "ping 1",
        "write 1",
        "\x1b[",
        "½",
        "٣",
        "[",
        "=",
    ]
    lesson = samples.lesson("every-kind")
    for exercise in lesson.exercises:
        task = Task.of(lesson, exercise.id, "ani")
        for i in range(40 if exercise.kind == "state" else 200):
            reply = " ".join(pieces[(i * 31 + j * 17 + i * j) % len(pieces)] for j in range(i % 12))
            verdict = judge(task, reply)
            assert verdict.message
            assert verdict.counts or not verdict.ok


def test_every_pose_that_gets_there_passes_unless_a_joint_cannot_turn_so_far(samples: Course) -> None:
    verdict = said(samples, "joints", "7.94347 -99.30793 102.04416")
    assert verdict.code == "limit"
    assert "gamma turns from -160 to 45 degrees only, and not to 102.044" in verdict.message
    assert said(samples, "joints", "7.94347 26.01406 257.95584").code == "limit"


def test_angles_are_right_a_whole_turn_further(samples: Course) -> None:
    task = Task.of(samples.lesson("elbow"), "mirror", "ani")
    first, second = task.answer
    assert judge(task, f"{first:.2f} {second:.2f}").ok
    assert judge(task, f"{first + 360:.2f}° {second - 360:.2f}°").ok
    assert judge(task, f"{first:.2f} {second + 180:.2f}").code == "partly"


def test_a_share_of_one_is_told_from_per_cent(samples: Course) -> None:
    task = Task.of(samples.lesson("control-tables"), "load", "student-1")
    verdict = judge(task, f"{task.answer / 100}")
    assert verdict.code == "unit"
    assert "is right in fractions of 1, not in %" in verdict.message
    assert judge(task, f"{task.answer} persen").ok


def test_what_has_to_be_exact_says_so(samples: Course) -> None:
    task = Task.of(samples.lesson("control-tables"), "address", "student-1")
    assert kind_of(task).shape(task) == "A number (no unit), exactly."
    assert judge(task, f"{task.answer}").ok
    big = Task(task.lesson, task.exercise, task.seed, "id", task.shared)
    big.__dict__["answer"] = 50
    assert judge(big, "51").message == "Sudah dekat, tetapi di sini harus tepat. Hitung sekali lagi."


def test_the_lesson_speaks_the_students_language(samples: Course) -> None:
    assert said(samples, "number", "-172", "id").message == "(id) There is no minus in 86."
    assert "mm dari sasaran" in said(samples, "joints", "60 60 60", "id").message


@pytest.mark.parametrize(
    "line",
    [
        "set 1 goal_position 425",
        "fault 1 off",
        "chain AX-12A:1",
        "load /etc/passwd",
        "save x",
        "push 1 9",
        "wait 61",
    ],
)
def test_a_state_is_reached_by_packets_and_by_nothing_else(samples: Course, line: str) -> None:
    bench = Workbench(Task.of(samples.lesson("every-kind"), "state", "ani"))
    with pytest.raises(UsageError):
        bench.execute(line)
    assert bench.lines == []


def test_a_goal_takes_verbs_away_and_hides_what_a_real_bus_hides(samples: Course) -> None:
    task = Task.of(samples.lesson("every-kind"), "state", "ani")
    open_bench = Workbench(task)
    assert open_bench.execute("servo 1").ok
    task.__dict__["answer"] = replace(task.answer, forbidden=("scan",), as_real=True)
    bench = Workbench(task)
    with pytest.raises(UsageError, match="'scan' is not for this exercise"):
        bench.execute("scan")
    with pytest.raises(UsageError, match="real bus"):
        bench.execute("servo 1")
    assert bench.execute("read 1 led").ok


def test_too_long_a_wait_is_refused_and_shorter_ones_still_work(samples: Course) -> None:
    bench = Workbench(Task.of(samples.lesson("every-kind"), "state", "ani"))
    for line in ("wait 100", "wait nan"):
        with pytest.raises(UsageError, match="60 s"):
            bench.execute(line)
    bench.execute("wait 60")
    assert bench.lines == ["wait 60"]


def test_a_workbench_goes_line_by_line_to_the_goal(samples: Course) -> None:
    task = Task.of(samples.lesson("every-kind"), "hidden", "ani")
    bench = Workbench(task)
    assert not bench.execute("ping 1").ok
    for line in task.answer.lines:
        assert not bench.reached()
        bench.execute(line)
    assert bench.reached()
    assert judge(task, "\n".join(bench.lines)).ok


def test_checking_takes_little_beside_the_cores_own_computation(samples: Course) -> None:
    tasks = [
        Task.of(samples.lesson("every-kind"), name, "ani")
        for name in ("number", "vector", "bytes", "gait", "choice", "mistake")
    ]
    replies = [kind_of(task).right(task) for task in tasks]
    start = time.perf_counter()
    for _ in range(100):
        for task, reply in zip(tasks, replies, strict=True):
            assert judge(task, reply).ok
    each = (time.perf_counter() - start) / 600
    start = time.perf_counter()
    sum(i * i for i in range(1_000_000))
    yardstick = time.perf_counter() - start
    # 50 ms are allowed; the yardstick takes about as long on any machine, and a check a hundredth of it.
    assert each < yardstick
