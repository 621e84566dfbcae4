"""A student's progress: whole at every moment, whatever happens to the program or to the file."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kinlab.errors import FileError, UsageError
from kinlab.lessons import Course, Progress, Sitting
from kinlab.lessons.progress import Event, profiles, standing

WRITER = """
import sys
from pathlib import Path
from kinlab.lessons.progress import Event, Progress

progress = Progress("ani", Path(sys.argv[1]))
for i in range(int(sys.argv[2]), int(sys.argv[3])):
    progress.add(Event.now("try", "lesson", 1, "exercise", reply=str(i)))
    print(i, flush=True)
"""


def writer(folder: Path, first: int, last: int) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", WRITER, str(folder), str(first), str(last)], stdout=subprocess.PIPE, text=True
    )


def test_a_kill_at_any_moment_loses_nothing_that_was_said_to_be_kept(tmp_path: Path) -> None:
    kept: list[int] = []
    for round_ in range(40):
        with writer(tmp_path, 1000 * round_, 1000 * round_ + 1000) as process:
            assert process.stdout
            said = [process.stdout.readline()]
            time.sleep(0.013 * (round_ % 5) + 0.001 * round_)
            os.kill(process.pid, signal.SIGKILL)
            said += process.stdout.readlines()
        kept += [int(line) for line in said if line.endswith("\n")]
        progress = Progress("ani", tmp_path)
        assert progress.set_aside is None
        replies = [int(event.reply) for event in progress.events]
        assert replies == sorted(replies)
        # One more may be on the disk than was said: it was killed between the two.
        assert set(kept) <= set(replies)
        assert len(replies) <= len(kept) + round_ + 1
    assert list(tmp_path.glob("*.damaged*")) == []
    Progress("ani", tmp_path).add(Event.now("hint", "lesson", 1, "exercise"))
    assert list(tmp_path.glob(".*")) == []


def test_two_windows_at_once_keep_both(tmp_path: Path) -> None:
    both = [writer(tmp_path, 0, 40), writer(tmp_path, 100, 140)]
    for process in both:
        with process:
            assert process.wait(60) == 0
    replies = {int(event.reply) for event in Progress("ani", tmp_path).events}
    assert replies == {*range(40), *range(100, 140)}


@pytest.mark.parametrize(
    "damage",
    [
        lambda raw: raw[: len(raw) // 2],
        lambda raw: raw[:-1],
        lambda raw: raw.replace(b'"ok": false', b'"ok": maybe', 1),
        lambda raw: b"\x00" * 50 + raw[50:],
        lambda raw: raw + b"\xff\xfe garbage\n",
        lambda raw: b"",
        lambda raw: raw.split(b"\n", 1)[1],
        lambda raw: raw.replace(b'"version": 3', b'"version": "three"', 1),
        lambda raw: raw + b"[" * 100_000 + b"\n",
        lambda raw: raw.replace(b'"reply": "3"', b'"reply": "\\ud800"'),
        lambda raw: raw.replace(b'"seed": "ani"', b'"seed": "\\ud800"'),
    ],
)
def test_a_damaged_file_is_set_aside_whole_and_what_can_be_read_goes_on(
    samples: Course, tmp_path: Path, damage: object
) -> None:
    sitting = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "en")
    sitting.check("number", "3")
    sitting.check("number", "172")
    path = sitting.progress.path
    spoilt = damage(path.read_bytes())  # type: ignore[operator]
    path.write_bytes(spoilt)
    again = Progress("ani", tmp_path)
    assert again.set_aside is not None
    assert again.set_aside.read_bytes() == spoilt
    assert again.seed == "ani"
    assert len(again.events) <= 2
    later = Progress("ani", tmp_path)
    assert later.set_aside is None
    assert later.events == again.events


def test_a_damaged_first_line_keeps_the_numbers_where_the_seed_can_be_read(tmp_path: Path) -> None:
    first = Progress(folder=tmp_path)
    first.begin()
    first.path.write_bytes(first.path.read_bytes().replace(b'{"format"', b'\x00format"', 1))
    again = Progress(folder=tmp_path)
    assert again.set_aside is not None
    assert again.seed == first.seed
    assert Progress(folder=tmp_path).set_aside is None


def test_a_full_disk_leaves_a_damaged_file_as_it_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "ani.jsonl"
    path.write_bytes(b"garbage")

    def full(handle: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(FileError, match=r"ani\.jsonl.*No space left"):
        Progress("ani", tmp_path)
    assert {each.name for each in tmp_path.iterdir()} == {"ani.jsonl", "ani.jsonl.lock"}
    assert path.read_bytes() == b"garbage"


def test_a_file_of_a_newer_kinlab_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "ani.jsonl"
    path.write_text('{"format": 2, "profile": "ani", "seed": "ani"}\n')
    with pytest.raises(FileError, match="newer KinLab"):
        Progress("ani", tmp_path)
    assert path.read_text().startswith('{"format": 2')


@pytest.mark.parametrize(
    "name", ["", "../ani", "a/b", ".hidden", "x" * 65, "a b", "a\n", "𠀀" * 64, "ΐ" * 64]
)
def test_a_profile_has_a_name_that_is_no_path(name: str, tmp_path: Path) -> None:
    with pytest.raises(UsageError):
        Progress(name, tmp_path)


def test_profiles_are_apart_and_the_nameless_one_is_like_no_other(tmp_path: Path) -> None:
    seeds = []
    for folder in ("one", "two"):
        progress = Progress(folder=tmp_path / folder)
        progress.begin()
        seeds.append(progress.seed)
        assert Progress(folder=tmp_path / folder).seed == progress.seed
    assert seeds[0] != seeds[1]
    named = Progress("Ani", tmp_path / "one")
    named.begin()
    assert named.seed == "ani"
    assert Progress("ANI", tmp_path / "one").path == named.path
    assert profiles(tmp_path / "one") == ["ani", "student"]


def test_the_home_comes_from_the_environment(home: Path) -> None:
    assert Progress("ani").path == home / "progress" / "ani.jsonl"


def test_looking_keeps_nothing(home: Path) -> None:
    Progress("ani")
    assert not home.exists()


def test_standing_follows_the_events(samples: Course, tmp_path: Path) -> None:
    sitting = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "en")
    assert sitting.solution("number") is None
    assert sitting.hint("number").text == "Add it to itself."
    assert sitting.hint("number") is None
    sitting.check("number", "")
    for _ in range(3):
        sitting.check("number", "3")
    now = sitting.standing("number")
    assert (now.tries, now.hints, now.status, now.may_see_solution) == (3, 1, "open", True)
    assert sitting.solution("number") == "172.0"
    sitting.check("number", "172")
    assert sitting.standing("number").status == "shown"
    sitting.check("share", "172")
    assert sitting.solution("share") is not None
    assert sitting.standing("share").status == "solved"
    assert "share" not in sitting.open
    sitting.reset()
    assert sitting.standing("number").status == "open"
    lines = [json.loads(line) for line in sitting.progress.path.read_text().splitlines()]
    assert [line.get("event") for line in lines] == [
        None, "hint", "try", "try", "try", "shown", "try", "try", "reset",
    ]  # fmt: skip


def test_what_comes_after_the_right_reply_changes_nothing() -> None:
    def event(kind: str, ok: bool = False) -> Event:
        return Event.now(kind, "lesson", 1, "exercise", ok=ok)

    solved = [event("try"), event("try", ok=True)]
    assert standing(solved, "lesson", 1, "exercise").tries == 2
    assert standing([*solved, event("try"), event("shown")], "lesson", 1, "exercise") == standing(
        solved, "lesson", 1, "exercise"
    )
    assert standing([event("shown"), *solved], "lesson", 1, "exercise").status == "shown"


def test_a_new_version_of_a_lesson_begins_anew(samples: Course, tmp_path: Path) -> None:
    progress = Progress("ani", tmp_path)
    progress.add(Event.now("try", "every-kind", 2, "number", reply="1", ok=True, code="right"))
    assert progress.standing("every-kind", 3, "number").status == "open"
    assert progress.standing("every-kind", 2, "number").status == "solved"


def test_a_closed_folder_is_said_to_be_closed(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError, match=r"below: cannot be made.*KINLAB_HOME can name another folder"):
        Progress("ani", tmp_path / "file" / "below").begin()


def test_bytes_that_are_no_text_are_kept_as_marks(samples: Course, tmp_path: Path) -> None:
    sitting = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "en")
    sitting.check("gait", "L2 L1 R2 R1\udcff")
    sitting.check("number", "3")
    assert Progress("ani", tmp_path).events == sitting.progress.events


def test_a_second_window_sees_what_the_first_one_kept(tmp_path: Path) -> None:
    one, other = Progress("ani", tmp_path), Progress("ani", tmp_path)
    one.add(Event.now("try", "lesson", 1, "exercise", ok=True))
    assert not other.standing("lesson", 1, "exercise").solved
    other.refresh()
    assert other.standing("lesson", 1, "exercise").solved


def test_a_kill_while_a_damaged_file_is_set_aside_loses_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Progress("ani", tmp_path).add(Event.now("try", "lesson", 1, "exercise", ok=True))
    path = tmp_path / "ani.jsonl"
    path.write_bytes(path.read_bytes() + b"{ half")
    monkeypatch.setattr(Progress, "_write", lambda self, text: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        Progress("ani", tmp_path)
    monkeypatch.undo()
    again = Progress("ani", tmp_path)
    assert again.standing("lesson", 1, "exercise").solved
    assert len(list(tmp_path.glob("*.damaged-*"))) == 2
