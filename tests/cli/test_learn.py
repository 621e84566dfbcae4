"""`kinlab learn`: the list, the lesson at the plain terminal, and a lecturer's commands."""

import subprocess
import sys
from collections.abc import Callable
from io import StringIO
from pathlib import Path
from typing import Any

import pytest

from kinlab.language import words_of
from kinlab.lessons import Lesson, Progress, Sitting, load_course
from kinlab.lessons.kinds import kind_of

LEG = "leg-geometry"


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("KINLAB_HOME", str(tmp_path / "home"))
    for name in ("KINLAB_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    return tmp_path / "home"


@pytest.fixture
def types(kinlab: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> Callable[..., Any]:
    """`types("a", "12", lesson="leg-geometry")`: a student who types these lines into the lesson."""

    def run(*lines: str, lesson: str = LEG, options: tuple[str, ...] = ()) -> Any:
        monkeypatch.setattr(sys, "stdin", StringIO("".join(f"{line}\n" for line in lines)))
        return kinlab("learn", lesson, "--profile", "ani", *options)

    return run


def right_lines(lesson: Lesson, language: str = "en") -> list[str]:
    """What a student types who knows everything."""
    sitting = Sitting.alone(lesson, "ani", language)
    return [line for task in sitting.tasks.values() for line in kind_of(task).right(task).split("\n")]


@pytest.mark.parametrize("language", ["en", "id"])
def test_a_scripted_student_goes_through_the_whole_course(types: Any, kinlab: Any, language: str) -> None:
    for lesson in load_course().lessons.values():
        run = types(*right_lines(lesson, language), lesson=lesson.id, options=("--lang", language))
        assert run.code == 0
        count = len(lesson.exercises)
        words = words_of("kinlab.lessons")
        end = words.say(language, "talk.finished", solved=count, count=count, shown=0)
        assert end in " ".join(run.out.split()), run.out[-2000:]
    listed = kinlab("learn", "list", "--profile", "ani", "--json").json
    assert listed["next"] is None
    assert {status for each in listed["lessons"] for status in each["exercises"].values()} == {"solved"}
    assert words.say(language, "talk.course-finished") in run.out


def test_a_student_errs_and_is_helped(types: Any) -> None:
    sitting = Sitting.alone(load_course().lesson(LEG), "ani", "en")
    first = next(iter(sitting.tasks.values()))
    wrong = kind_of(first).wrong(first)[0]
    run = types(
        wrong, "hint", "what coxa", "what nonsense", "question", "", wrong, "solution", wrong, "solution"
    )
    assert "Not yet." in run.out
    assert "'hint' gives a hint." in run.out
    assert f"Hint 1 of {len(first.hints)}: " in run.out
    assert "coxa: the first link of a leg" in run.out
    assert "'nonsense' is not in the glossary" in run.out
    assert "There is no answer yet." in run.out
    assert "The solution is shown after 3 tries; so far there were 2." in run.out
    assert "The solution: " in run.out
    assert "What you have done is kept. Go on with: kinlab learn leg-geometry" in run.out
    assert Progress("ani").standing(LEG, sitting.lesson.version, first.exercise.id).status == "shown"
    again = types("quit")
    assert "You have looked at the solution of this one" in again.out


def test_what_comes_next_is_the_next_open_lesson(types: Any) -> None:
    first, second, third, *_ = load_course().lessons.values()
    run = types(*right_lines(second), lesson=second.id)
    assert f"Next: kinlab learn {third.id} " in run.out
    last = list(load_course().lessons.values())[-1]
    assert f"Next: kinlab learn {first.id} " in types(*right_lines(last), lesson=last.id).out


def test_skipped_exercises_stay_open_and_are_named(types: Any) -> None:
    count = len(load_course().lesson(LEG).exercises)
    run = types(*["skip"] * count)
    assert "Still open: " in run.out
    assert f"0 of {count} exercise(s) solved" in run.out


def test_the_lesson_can_be_heard(types: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("KINLAB_ASCII", raising=False)
    run = types("quit", options=("--no-figures",))
    assert "The leg" in run.out
    assert not any(0x2800 <= ord(c) < 0x2900 for c in run.out)
    assert "\x1b" not in run.out
    assert max(len(line) for line in run.out.splitlines()) <= 88
    assert any(0x2800 <= ord(c) < 0x2900 for c in types("quit").out)
    by_option = types("quit", options=("--ascii",)).out
    assert not any(0x2800 <= ord(c) < 0x2900 for c in by_option)
    monkeypatch.setenv("KINLAB_ASCII", "1")
    assert types("quit").out == by_option


def test_without_any_input_the_lesson_is_shown_and_left(kinlab: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", None)
    run = kinlab("learn", LEG)
    assert run.code == 0
    assert "What you have done is kept." in run.out
    assert kinlab("learn", "reset", LEG).code == 2


def test_no_word_is_swallowed(types: Any) -> None:
    run = types("done", "again", "selesai", "quit")
    assert run.out.count("' is none of the options") == 3


def test_control_characters_are_not_obeyed(types: Any) -> None:
    run = types("\x1b]0;title\x07", "\x1b[2J12\x00", "x" * 5000, "quit")
    assert "\x1b" not in run.out
    assert "5000 characters" in run.out


def test_the_language_comes_from_the_environment(kinlab: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "The three-joint leg" in kinlab("learn").out
    monkeypatch.setenv("LANG", "id_ID.UTF-8")
    assert "Kaki tiga sendi" in kinlab("learn").out
    assert "The three-joint leg" in kinlab("learn", "--lang", "en").out


def test_listing_needs_no_numpy(home: Path) -> None:
    code = (
        "import sys\n"
        "from kinlab.cli import main\n"
        "try:\n    main(['learn'])\nexcept SystemExit as end:\n    assert not end.code\n"
        "heavy = {'numpy', 'textual', 'rich', 'pydantic', 'prompt_toolkit'} & set(sys.modules)\n"
        "assert not heavy, heavy\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_options_stand_before_or_behind_the_lesson(kinlab: Any) -> None:
    before = kinlab("learn", "--lang", "id", "-p", "ani", LEG, "--json").json
    assert before == kinlab("learn", LEG, "--lang", "id", "-p", "ani", "--json").json
    assert before["language"] == "id"


def test_one_answer_is_checked(kinlab: Any) -> None:
    sitting = Sitting.alone(load_course().lesson(LEG), "ani", "en")
    name = next(name for name, task in sitting.tasks.items() if task.exercise.kind == "vector")
    right = kind_of(sitting.tasks[name]).right(sitting.tasks[name])
    wrong = kinlab("learn", "check", LEG, name, "-1", "2", "-3,5", "-p", "ani", "--json")
    assert wrong.code == 1
    assert (wrong.json["ok"], wrong.json["tries"], wrong.json["status"]) == (False, 1, "open")
    unread = kinlab("learn", "check", LEG, name, "much", "-p", "ani", "--json")
    assert (unread.code, unread.json["counts"], unread.json["tries"]) == (1, False, 1)
    passed = kinlab("learn", "check", LEG, name, *right.split(), "-p", "ani", "--lang", "id")
    assert passed.code == 0
    assert passed.out.startswith("Benar: ")
    assert "did you mean" in kinlab("learn", "check", LEG, f"{name}x", "1").err


def test_hints_and_solutions_come_one_by_one(kinlab: Any) -> None:
    count = len(next(iter(Sitting.alone(load_course().lesson(LEG), "ani", "en").tasks.values())).hints)
    name = load_course().lesson(LEG).exercises[0].id
    for number in range(1, count + 1):
        assert f"Hint {number} of {count}" in kinlab("learn", "hint", LEG, name).out
    assert len(kinlab("learn", "hint", LEG, name, "--json").json["hints"]) == count
    refused = kinlab("learn", "solution", LEG, name)
    assert refused.code == 1
    assert "after 3 tries" in refused.err


def test_reset_asks_first(kinlab: Any, types: Any) -> None:
    types(*right_lines(load_course().lesson(LEG))[:1], "quit")
    refused = kinlab("learn", "reset", LEG, "-p", "ani")
    assert refused.code == 2
    assert "--yes" in refused.err
    done = kinlab("learn", "reset", LEG, "-p", "ani", "--yes", "--json")
    assert done.json == {"lesson": LEG, "open": [each.id for each in load_course().lesson(LEG).exercises]}
    assert (
        "solved"
        not in kinlab("learn", "list", "-p", "ani", "--json").json["lessons"][0]["exercises"].values()
    )


@pytest.mark.parametrize("csv", [False, True])
def test_work_is_exported_and_verified(types: Any, kinlab: Any, tmp_path: Path, csv: bool) -> None:
    types(*right_lines(load_course().lesson(LEG)))
    file = tmp_path / "ani.out"
    assert kinlab("learn", "export", "-p", "ani", *(["--csv"] if csv else []), "-o", file).code == 0
    honest = kinlab("learn", "verify", file, "--json")
    assert honest.code == 0
    count = len(load_course().lesson(LEG).exercises)
    assert honest.json["students"][0]["solved"] == count
    table = kinlab("learn", "verify", file)
    assert f"{LEG}" in table.out
    if not csv:
        file.write_text(file.read_text().replace('"reply": "', '"reply": "9'))
        found = kinlab("learn", "verify", file)
        assert found.code == 1
        assert "is said to be right and is wrong" in found.out


def test_a_file_that_cannot_be_read_does_not_stop_the_class(types: Any, kinlab: Any, tmp_path: Path) -> None:
    types("quit")
    whole, broken = tmp_path / "whole.json", tmp_path / "broken.json"
    kinlab("learn", "export", "-p", "ani", "-o", str(whole))
    broken.write_text("{")
    run = kinlab("learn", "verify", str(broken), str(whole), "--json")
    assert run.code == 1
    assert "broken.json: no valid JSON" in run.err
    assert not run.json["ok"]
    assert [student["file"] for student in run.json["students"]] == [str(whole)]
    assert kinlab("learn", "verify", str(broken)).code == 2


def test_students_of_the_same_name_are_told_apart_by_their_files(
    types: Any, kinlab: Any, tmp_path: Path
) -> None:
    types("quit")
    kinlab("learn", "export", "-p", "ani", "-o", tmp_path / "ani.json")
    for name in ("one", "two"):
        (tmp_path / f"{name}.json").write_text(
            f'{{"format": 1, "profile": "student", "seed": "{name}", "events": []}}'
        )
    out = kinlab("learn", "verify", *tmp_path.glob("*.json")).out
    assert "one.json)" in out
    assert "two.json)" in out
    assert "ani.json)" not in out


def test_exporting_nothing_says_so(kinlab: Any) -> None:
    run = kinlab("learn", "export", "-p", "nobody")
    assert run.code == 2
    assert "has not begun any lesson" in run.err


def test_a_damaged_file_is_named_when_it_is_set_aside(types: Any, kinlab: Any, home: Path) -> None:
    types("quit")
    path = home / "progress" / "ani.jsonl"
    path.write_text(path.read_text() + "{ half")
    run = kinlab("learn", "list", "-p", "ani")
    assert run.code == 0
    assert "was damaged. It is set aside as ani.jsonl.damaged-" in run.err
    assert "damaged" not in kinlab("learn", "list", "-p", "ani").err


def test_a_broken_lesson_is_named_and_the_others_work(
    kinlab: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kinlab.lessons.lint.SEEDS", 20)
    monkeypatch.setattr("kinlab.lessons.lint.JUDGED", 1)
    monkeypatch.setattr("kinlab.lessons.lint.JUDGED_STATES", 1)
    monkeypatch.setattr("kinlab.lessons.lint.DRAWN_FIGURES", 1)
    folder = tmp_path / "lessons"
    assert kinlab("learn", "new", "mine", "--lessons", folder).code == 0
    page = folder / "mine" / "en.md"
    page.write_text(page.read_text().replace("version = 1", "version = one"))
    run = kinlab("learn", "--lessons", folder)
    assert run.code == 0
    assert LEG in run.out
    assert "mine/en.md:4: no valid TOML" in run.out
    assert kinlab("learn", "mine", "--lessons", folder).code == 2
    linted = kinlab("learn", "lint", "--lessons", folder, "--json")
    assert linted.code == 1
    assert {"file": "mine/en.md", "line": 4}.items() <= linted.json["findings"][0].items()


def test_an_exercise_without_a_translation_is_said_to_be_none(
    types: Any, kinlab: Any, tmp_path: Path
) -> None:
    kinlab("learn", "new", "mine", "--lessons", tmp_path)
    page = tmp_path / "mine" / "id.md"
    text = page.read_text()
    page.write_text(text[: text.index("```exercise")] + text[text.index("Akhiri") :])
    out = types("skip", lesson="mine", options=("--lessons", str(tmp_path), "--lang", "id")).out
    assert out.count("(en) Bagian berikut belum diterjemahkan.") == 1
    assert out.index("(en) Bagian") < out.index("The femur stands")


def test_a_new_lesson_passes_its_lint(kinlab: Any, tmp_path: Path) -> None:
    kinlab("learn", "new", "mine", "--lessons", tmp_path)
    run = kinlab("learn", "lint", "mine", "--lessons", tmp_path)
    assert (run.code, run.out) == (0, "1 lesson(s), 1 exercise(s): no finding(s)\n")


def test_lessons_of_ones_own_may_be_named_once_for_all(
    kinlab: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KINLAB_LESSONS", str(tmp_path / "ours"))
    assert f"{tmp_path / 'ours'}: cannot be read" in kinlab("learn").err
    assert str(tmp_path / "ours" / "mine" / "en.md") in kinlab("learn", "new", "mine").out
    assert "  mine  " in kinlab("learn").out


def test_a_lesson_is_one_document(kinlab: Any) -> None:
    found = kinlab("learn", LEG, "-p", "ani", "--json").json
    assert found["seed"] == "ani"
    assert {part["part"] for part in found["parts"]} == {"text", "figure", "exercise"}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["leg-geometri"], "did you mean leg-geometry"),
        ([LEG, "--lang", "fr"], "no language is named 'fr'"),
        ([LEG, "--profile", "../x"], "no name for a profile"),
        ([LEG, "--profile", ""], "'' is no name for a profile"),
        ([LEG, "--lessons", "/nowhere"], "/nowhere: cannot be read"),
        ([LEG, "--json", "--watch", "x"], "give one of the two"),
        (["export", "--csv", "--json"], "give one"),
        (["--json", LEG], "--json goes behind the lesson"),
        (["verify", "/nowhere.json"], "/nowhere.json: cannot be read"),
        (["new", "../x"], "no name for a lesson"),
        (["new", "list"], "'list' is a command of kinlab learn"),
        (["reset", LEG, "--json"], "say --yes"),
    ],
)
def test_wrong_usage_is_said(kinlab: Any, arguments: list[str], message: str) -> None:
    run = kinlab("learn", *arguments)
    assert run.code == 2
    assert message in run.err


def test_a_watched_file_is_checked_when_it_is_saved(tmp_path: Path) -> None:
    sheet = tmp_path / "answers.txt"
    command = [
        sys.executable,
        "-u",
        "-m",
        "kinlab",
        "learn",
        LEG,
        "-p",
        "ani",
        "--lang",
        "en",
        "--watch",
        str(sheet),
    ]
    sitting = Sitting.alone(load_course().lesson(LEG), "ani", "en")
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        assert "is new" in process.stdout.readline()
        assert "Watching" in process.stdout.readline()
        blank = sheet.read_text()
        assert all(f"\n{name} =" in blank for name in sitting.tasks)
        name, task = next(iter(sitting.tasks.items()))
        sheet.write_text(blank.replace(f"{name} =", f"{name} = {kind_of(task).wrong(task)[0]}"))
        assert process.stdout.readline().startswith(f"{name}: ")
        more = sheet.read_text().replace("foot =", "foot = 1 2 3")
        sheet.write_text(more)
        assert any(line.startswith("foot: ") for line in process.stdout)
        filled = blank
        for name, task in sitting.tasks.items():
            filled = filled.replace(f"\n{name} =", f"\n{name} = {kind_of(task).right(task)}")
        sheet.write_text(filled)
        rest = process.stdout.read()
        assert process.wait(60) == 0
    count = len(sitting.tasks)
    assert f"{count} of {count} exercise(s) solved by yourself" in " ".join(rest.split())
    # Each answer was tried once, however often the file was saved.
    tried = [event.reply for event in Progress("ani").events]
    assert len(tried) == len(set(tried)) == count + 2
