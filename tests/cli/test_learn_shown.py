"""What lessons tell a student to type: each command line in them is one that works."""

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

from kinlab.lessons import load_course
from kinlab.lessons.filling import fill
from kinlab.lessons.lesson import Lesson, Prose
from kinlab.lessons.parameters import lesson_values

# They need a servo on a wire, or the time of a dozen walks.
ELSEWHERE = ("--port", "--compare")
# A target out of reach and a pose that no body takes are shown on purpose.
MEANT_TO_FAIL = ("ik xl430-hexapod 150 0 -60", "body krsri-hexapod --rpy 25 0 0")


def shown(lesson: Lesson, language: str) -> list[str]:
    """The command lines in a lesson's text, as one student reads them."""
    values = lesson_values(lesson, "ani")
    prose = "\n".join(fill(part.text, values) for part in lesson.parts[language] if isinstance(part, Prose))
    lines = re.findall(r"(?m)^ {4}kinlab (.+)$", prose)
    return [line for line in lines if not any(word in line for word in ELSEWHERE)]


LINES = [
    pytest.param(lesson, line, id=f"{lesson.id}: {line}")
    for lesson in load_course().lessons.values()
    for line in dict.fromkeys(shown(lesson, "en"))
]


@pytest.mark.parametrize(("lesson", "line"), LINES)
def test_a_command_that_a_lesson_shows_works(
    lesson: Lesson, line: str, kinlab: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = (lesson.folder / "en.md").read_text(encoding="utf-8")
    for name in re.findall(r"file `([\w.]+)`", text):
        block = text.split(f"file `{name}`")[1].split("\n\n")[1]
        (tmp_path / name).write_text(dedent(block), encoding="utf-8")
    run = kinlab(*shlex.split(line))
    assert run.code == (1 if line in MEANT_TO_FAIL else 0), run.err


@pytest.mark.parametrize("lesson", load_course().lessons.values(), ids=lambda lesson: lesson.id)
def test_both_languages_show_the_same_commands(lesson: Lesson) -> None:
    assert shown(lesson, "id") == shown(lesson, "en")
