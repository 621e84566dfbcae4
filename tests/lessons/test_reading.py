"""Lessons' files: what is wrong is said with file and line, and what is right still works."""

import os
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from kinlab.errors import FileError, UsageError
from kinlab.lessons import Course, LessonError, Progress, Sitting, Task, Text, load_course
from kinlab.lessons.lint import lint
from kinlab.lessons.reading import read_lesson
from kinlab.lessons.template import ENGLISH, INDONESIAN, new_lesson


@pytest.fixture
def lesson(tmp_path: Path) -> Callable[..., Path]:
    """Writes the template as a lesson, with texts replaced in English, and in Bahasa Indonesia (`other`)."""

    def write(*replaced: tuple[str, str], other: tuple[tuple[str, str], ...] | None = ()) -> Path:
        folder = new_lesson("mine", tmp_path / "lessons")[0].parent
        for code, text, changes in (("en", ENGLISH, replaced), ("id", INDONESIAN, other or ())):
            for old, new in changes:
                assert old in text
                text = text.replace(old, new, 1)
            (folder / f"{code}.md").write_text(text, encoding="utf-8")
        if other is None:
            (folder / "id.md").unlink()
        return folder

    return write


WRONG = [
    (("+++\ntitle", "title"), "mine/en.md:1: begins with no front matter"),
    (("minutes = 10\n", 'minutes = "ten"\n'), "mine/en.md:5: 'minutes' is a whole number from 1, not 'ten'"),
    (("minutes = 10\n", "minuts = 10\n"), "mine/en.md:5: there is no field 'minuts'; did you mean minutes"),
    (("version = 1\n", ""), "mine/en.md:1: the field 'version' is missing"),
    (("version = 1\n", "version = \n"), "mine/en.md:4: no valid TOML"),
    (("beta = {", "beta = { step = 2, "), "mine/en.md:11: no valid TOML"),
    (("step = 5 }", "step = 0 }"), "mine/en.md:11: parameter 'beta' goes up"),
    (("from = 10, to = 45, step = 5", "from = 10, to = 4500000, step = 1"), "more than 1000 values"),
    (('kind = "number"', 'kind = "nummer"'), "no kind of exercise 'nummer'; did you mean number"),
    (("tolerance = 0.5\n", ""), "a number has a 'tolerance' in its unit, or a 'relative' one"),
    (
        ("tolerance = 0.5\n", 'tolerance = "much"\n'),
        "mine/en.md:30: 'tolerance' is a number from 0, not 'much'",
    ),
    (('id = "height"', 'id = "leg"'), "mine/en.md:27: two blocks have the id 'leg'"),
    (('id = "height"', 'id = "../x"'), "mine/en.md:27: exercise: 'id' is a name in small letters"),
    (("with = { alpha = 0 }\n```", "with = { alpha = 0 }"), "the block has no end"),
    (("Say what", "Say\x1b[31m what"), "mine/en.md:17: holds the control character U+001B"),
    (("Say what", "Say\u202e what"), "control character U+202E"),
    (('answer = "leg.height"', 'answer = { compute = "leg.height", code = "x" }'), "no field 'code'"),
    (("The idea:", "\\u001b[31mThe idea:"), "mine/en.md:33: holds the control character U+001B"),
    (("order = 1000", f"order = {'9' * 5000}"), "mine/en.md:2: no valid TOML: Exceeds the limit"),
    (("order = 1000", f"order{'.a' * 5000} = 1"), "no valid TOML: maximum recursion depth"),
    (("order = 1000", "order = nan"), "mine/en.md:6: 'order' is a number, not nan"),
    (("{ from = 10, to = 45, step = 5 }", "{ pick = [inf] }"), "mine/en.md:11: parameter 'beta' picks"),
    (("step = 5 }", "step = 1e-300 }"), "more than 1000 values"),
    (('kind = "number"\n', ""), "mine/en.md:26: the field 'kind' is missing"),
    (
        ("version = 1\n", f"version = {'9' * 400}\n"),
        "mine/en.md:4: 'version' is a whole number from 1, not 999",
    ),
    (
        ("{ from = 10, to = 45, step = 5 }", f"{{ pick = [{'9' * 400}] }}"),
        "mine/en.md:11: parameter 'beta' picks",
    ),
    (("tolerance = 0.5\n", "tolerance = -1\n"), "mine/en.md:30: 'tolerance' is a number from 0, not -1"),
    (
        ('robot = "xl', 'instrument = "leq"\nrobot = "xl'),
        "mine/en.md:7: there is no instrument 'leq'; did you mean leg",
    ),
    (('robot = "xl430-hexapod"', 'instrument = "gait"'), "an instrument shows a 'robot', and none is named"),
    (("sign = ", "sing = "), "mine/en.md:41: 'number' has no verdict 'sing'; did you mean sign"),
    (('title = "A title that asks or promises something"', 'title = ""'), "mine/en.md:2: 'title' is empty"),
]


@pytest.mark.parametrize(
    "make", [Path.mkdir, lambda path: os.mkfifo(path), lambda path: path.symlink_to("/dev/zero")]
)
def test_what_is_no_file_is_not_read(lesson: Callable[..., Path], make: Callable[[Path], None]) -> None:
    folder = lesson(other=None)
    make(folder / "id.md")
    with pytest.raises(LessonError, match=r"mine/id\.md:1: is no file"):
        read_lesson(folder)


def test_a_glossary_that_cannot_be_read_is_named_with_its_line(lesson: Callable[..., Path]) -> None:
    root = lesson().parent
    for text, problem in (
        ('[a]\nen = "x\\u001b[31m"', r"glossary\.toml:2: holds the control character U\+001B"),
        ("[a]\nen = ", r"glossary\.toml:2: no valid TOML"),
        ("a = " + "[" * 9999, r"glossary\.toml:1: no valid TOML"),
        ("a = 3", r"glossary\.toml:1: 'a' is a table"),
    ):
        (root / "glossary.toml").write_text(text)
        course = load_course(root)
        assert re.match(problem, str(course.problems[0]))
        assert "mine" in course.lessons


def test_a_figure_is_as_wide_as_the_face_wants(lesson: Callable[..., Path]) -> None:
    folder = lesson(("with = { alpha = 0 }", "with = { alpha = 0, columns = 100000000 }"))
    [finding] = lint(load_course(folder.parent), ["mine"])
    assert str(finding).startswith("mine/en.md:21: 'columns' is not a lesson's to give")


@pytest.mark.parametrize(("change", "message"), WRONG)
def test_an_error_names_file_line_and_field(
    lesson: Callable[..., Path], change: tuple[str, str], message: str
) -> None:
    folder = lesson(change)
    with pytest.raises(LessonError) as refused:
        read_lesson(folder)
    assert message in str(refused.value)


def test_a_lesson_in_one_language_alone_is_not_passed_over(lesson: Callable[..., Path]) -> None:
    folder = lesson()
    (folder / "en.md").unlink()
    [problem] = load_course(folder.parent).problems
    assert str(problem) == "mine/en.md:1: cannot be read: No such file or directory"
    (folder / "en.md").symlink_to("/nowhere")
    assert [str(each) for each in load_course(folder.parent).problems] == [str(problem)]


def test_a_translation_that_says_more_than_texts_is_refused(lesson: Callable[..., Path]) -> None:
    folder = lesson(other=(('id = "height"', 'id = "height"\nkind = "number"'),))
    with pytest.raises(LessonError, match=r"mine/id\.md:\d+: 'kind' stands in en\.md alone"):
        read_lesson(folder)
    folder.joinpath("id.md").write_text(INDONESIAN.replace('id = "height"', 'id = "hight"'))
    with pytest.raises(LessonError, match=r"no block 'hight'; did you mean height"):
        read_lesson(folder)


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        ('kind = "vector"\nnames = ["a"]\ntolerance = 1', "the kind 'vector' needs a list of numbers"),
        ('kind = "joints"\nnames = ["a"]\ntolerance = 1', "the kind 'joints' needs a Reach"),
        ('kind = "bytes"', "the kind 'bytes' needs bytes"),
        ('kind = "order"', "the kind 'order' needs a list of keys"),
        ('kind = "mistake"\nlines = ["a"]\nwhy = ["b"]', "the kind 'mistake' needs the number of a line"),
        ('kind = "state"', "the kind 'state' needs a Goal"),
    ],
)
def test_an_answer_of_another_kind_is_the_lessons_fault(
    lesson: Callable[..., Path], kind: str, message: str
) -> None:
    old = 'kind = "number"\nunit = "mm"\ntolerance = 0.5'
    feedback = '\n[feedback]\nsign = "The foot hangs below the coxa: its height is negative."'
    folder = lesson((old, kind), (feedback, ""))
    sitting = Sitting.alone(read_lesson(folder), "ani", "en")
    with pytest.raises(LessonError, match=rf"mine/en\.md:\d+: leg\.height gives -\d+\.\d+, and .*{message}"):
        sitting.check("height", "1")


def test_as_many_names_as_numbers(lesson: Callable[..., Path]) -> None:
    folder = lesson(
        ('kind = "number"', 'kind = "vector"\nnames = ["a", "b"]'),
        ('answer = "leg.height"', 'answer = "leg.foot"\nwith = { alpha = 0 }'),
        ('\n[feedback]\nsign = "The foot hangs below the coxa: its height is negative."', ""),
    )
    with pytest.raises(LessonError, match="'names' are 2, and there are 3 numbers"):
        Sitting.alone(read_lesson(folder), "ani", "en").check("height", "1 2")


def test_the_other_lessons_still_work_beside_a_broken_one(lesson: Callable[..., Path]) -> None:
    folder = lesson(("version = 1\n", "version = \n"))
    course = load_course(folder.parent)
    assert [str(problem).split(":")[:2] for problem in course.problems] == [["mine/en.md", "4"]]
    assert "leg-geometry" in course.lessons
    assert "mine" not in course.lessons
    with pytest.raises(LessonError, match=r"mine/en\.md:4"):
        course.lesson("mine")


def test_bytes_that_are_no_text_are_located(lesson: Callable[..., Path]) -> None:
    folder = lesson()
    raw = (folder / "en.md").read_bytes()
    (folder / "en.md").write_bytes(raw.replace(b"Say what", b"Say \xff what"))
    with pytest.raises(LessonError, match=r"mine/en\.md:17: is not UTF-8"):
        read_lesson(folder)


def test_windows_line_ends_and_a_byte_order_mark_are_read_as_well(lesson: Callable[..., Path]) -> None:
    folder = lesson()
    raw = (folder / "en.md").read_bytes()
    (folder / "en.md").write_bytes(b"\xef\xbb\xbf" + raw.replace(b"\n", b"\r\n"))
    assert read_lesson(folder).exercises[0].id == "height"


def test_the_template_is_whole(lesson: Callable[..., Path]) -> None:
    course = load_course(lesson().parent)
    assert [str(finding) for finding in lint(course, ["mine"])] == []


def test_a_new_lesson_overwrites_nothing(tmp_path: Path) -> None:
    new_lesson("mine", tmp_path)
    with pytest.raises(FileError, match="is there already"):
        new_lesson("mine", tmp_path)
    with pytest.raises(UsageError, match="no name for a lesson"):
        new_lesson("../mine", tmp_path)


def test_a_full_disk_leaves_no_half_of_a_new_lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, content: str) -> None:
        if path.name == "id.md":
            raise FileError(f"{path}: cannot be written: No space left on device")
        path.write_text(content)

    monkeypatch.setattr("kinlab.lessons.template.write_whole", full)
    with pytest.raises(FileError, match="No space left"):
        new_lesson("mine", tmp_path)
    assert not (tmp_path / "mine").exists()


def test_what_is_not_translated_stands_in_english_and_is_marked(lesson: Callable[..., Path]) -> None:
    start, end = INDONESIAN.index("```exercise"), INDONESIAN.index("Akhiri")
    folder = lesson(other=((INDONESIAN[start:end], ""),))
    sitting = Sitting.alone(read_lesson(folder), "ani", "id")
    parts = sitting.parts()
    texts = [part for part in parts if isinstance(part, Text)]
    assert [text.fallback for text in texts] == [False, False]
    assert [type(part).__name__ for part in parts] == ["Text", "Figure", "Task", "Text"]
    assert sitting.tasks["height"].ask.startswith("The femur stands")
    assert sitting.tasks["height"].fallback
    untranslated = Sitting.alone(read_lesson(lesson_without_translation(folder)), "ani", "id")
    assert untranslated.fallback
    assert all(part.fallback for part in untranslated.parts() if isinstance(part, Text | Task))


def lesson_without_translation(folder: Path) -> Path:
    (folder / "id.md").unlink()
    return folder


def test_a_lesson_of_ones_own_takes_the_place_of_ours(tmp_path: Path) -> None:
    folder = new_lesson("leg-geometry", tmp_path)[0].parent
    assert load_course(tmp_path).lesson("leg-geometry").folder == folder


def test_lessons_are_found_by_name_beginning_and_number(samples: Course) -> None:
    assert samples.lesson("every").id == "every-kind"
    assert samples.lesson(str(len(samples.lessons))).id == "every-kind"
    with pytest.raises(UsageError, match="did you mean every-kind"):
        samples.lesson("evry-kind")


FINDINGS = [
    ((('answer = "leg.height"', 'answer = "leg.hight"'),), (), "has no 'hight' (of 'leg.hight'); did you mean height"),
    ((('answer = "leg.height"', 'answer = "os.system"'),), (), "answers have no topic 'os'"),
    ((('draw = "leg.side"', 'draw = "leg.sid"'),), (), "has no 'sid'"),
    ((('answer = "leg.height"', 'answer = "leg.height"\nwith = { beta = 20 }'),), (), "leg.height is not given it"),
    ((("with = { alpha = 0 }", ""),), (), "leg.side needs 'alpha'"),
    ((("with = { alpha = 0 }", "with = { alpa = 0 }"),), (), "takes no 'alpa'; did you mean alpha"),
    ((("with = { alpha = 0 }", 'with = { alpha = "much" }'),), (), "failed: "),
    ((('["leg-geometry"]', '["leg-geometri"]'),), (), "is no lesson; did you mean leg-geometry"),
    ((('["leg-geometry"]', '["mine"]'),), (), "itself comes after this lesson"),
    ((("order = 1000", "order = 1"),), (), "stands later in the course"),
    ((('prerequisites = ["leg-geometry"]', ""),), (), "uses the term 'femur'"),
    ((('robot = "xl430-hexapod"', 'robot = "xl430"'),), (), "no robot is named 'xl430'; did you mean xl430-hexapod"),
    ((('robot = "xl430-hexapod"', 'robot = "receptionist-arm"\ninstrument = "gait"'),), (), "has no legs to walk on"),
    ((("[params]\nbeta", '[values.robot]\ncompute = "leg.height"\n[params]\nbeta'),), (), "leg.height(robot="),
    ((("minutes = 10\n", 'minutes = 10\nexplains = ["gayt"]\n'),), (), "explains 'gayt', which"),
    ((("{beta} degrees", "{bta} degrees"),), (), "no value is named 'bta'"),
    ((('solution = "h = {answer:.1f} mm"', 'solution = "h = {answer:.9999f} mm"'),), (), "no format"),
    ((("Say what the student", "There are 18 servos: say what the student"),), (), "the text: other numbers"),
    ((), (("{beta}°", "beta"),), "'height', ask: other placeholders than in en.md: lacks {beta}"),
    ((), (('goals = ["apa yang bisa dilakukan mahasiswa sesudahnya"]\n', ""),), "mine/id.md:1: 'goals' is missing"),
    ((), (('solution = "h = {answer:.1f} mm"\n', ""),), "'height': 'solution' is missing"),
    ((("End with something", "<b>End</b> with something"),), (), "raw HTML <b>"),
    (
        (('answer = "leg.height"', 'answer = "leg.height"\n[[slips]]\ncompute = "leg.height"\nsay = "The same."'),),
        (("tingginya negatif.\"", 'tingginya negatif."\n[[slips]]\nsay = "Sama saja."'),),
        "slip 1 (leg.height) is never recognised",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("english", "other", "message"), FINDINGS)
def test_lint_finds_it(
    lesson: Callable[..., Path],
    monkeypatch: pytest.MonkeyPatch,
    english: tuple[tuple[str, str], ...],
    other: tuple[tuple[str, str], ...],
    message: str,
) -> None:
    monkeypatch.setattr("kinlab.lessons.lint.SEEDS", 60)
    course = load_course(lesson(*english, other=other).parent)
    assert any(message in str(finding) for finding in lint(course, ["mine"]))


def test_lint_finds_a_missing_translation(lesson: Callable[..., Path]) -> None:
    [finding] = lint(load_course(lesson(other=None).parent), ["mine"])
    assert str(finding) == "mine/en.md:1: there is no id.md: the lesson is not there in Bahasa Indonesia"


def test_lint_finds_parameters_that_only_sometimes_fail(lesson: Callable[..., Path]) -> None:
    """One value in forty is out of reach: a few seeds would miss it."""
    changes = (
        ('answer = "leg.height"', 'answer = "leg.reach"\n[params]\nx = { from = 61, to = 139, step = 2 }'),
        (
            'kind = "number"\nunit = "mm"\ntolerance = 0.5',
            'kind = "joints"\nnames = ["a", "b", "c"]\ntolerance = 2',
        ),
        ("[params]\nbeta", "[params]\ny = { pick = [0] }\nz = { pick = [-50] }\nbeta"),
        ("{answer:.1f} mm", "{answer:.1f}"),
        ('\n[feedback]\nsign = "The foot hangs below the coxa: its height is negative."', ""),
    )
    folder = lesson(
        *changes,
        other=(
            ("{answer:.1f} mm", "{answer:.1f}"),
            ('\n[feedback]\nsign = "Ujung kaki menggantung di bawah coxa: tingginya negatif."', ""),
        ),
    )
    *_, finding = lint(load_course(folder.parent), ["mine"])
    assert re.search(r"mine/en\.md:\d+: leg\.reach\(.*x=\d+.*\) failed: .* does not reach", str(finding))


def test_a_lesson_can_only_name_what_is_there_for_lessons(lesson: Callable[..., Path]) -> None:
    for name in ("leg.load_robot", "leg._leg", "leg.np", "leg.foot.__globals__", "..leg.foot", "leg"):
        folder = lesson(('answer = "leg.height"', f'answer = "{name}"'))
        with pytest.raises(LessonError):
            _ = Task.of(read_lesson(folder), "height", "ani").answer
        for path in folder.iterdir():
            path.unlink()
        folder.rmdir()


@pytest.mark.parametrize(
    "asked",
    [
        'answer = "yielding.cycles"\nwith = { alpha = 0.2, share = 100 }',
        'answer = "yielding.cycles"\nwith = { alpha = 1e-9, share = 50 }',
        'answer = "gaits.orders"\nwith = { legs = 1000000000 }',
    ],
)
def test_no_lesson_asks_for_endless_work(lesson: Callable[..., Path], asked: str) -> None:
    folder = lesson(('answer = "leg.height"', asked))
    with pytest.raises(LessonError, match=r"mine/en\.md:\d+: .* failed: ValueError"):
        _ = Task.of(read_lesson(folder), "height", "ani").answer


def test_a_setup_reads_no_files(samples: Course, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from dataclasses import replace

    from kinlab.lessons.kinds.state import Workbench

    task = Task.of(samples.lesson("every-kind"), "state", "ani")
    goal = replace(task.answer, setup=(f"load {tmp_path}/x",))
    task.__dict__["answer"] = goal
    with pytest.raises(LessonError, match="reads and writes no files"):
        Workbench(task)


def test_progress_is_shared_by_every_face(samples: Course, tmp_path: Path) -> None:
    one = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "en")
    other = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "id")
    one.check("number", "172")
    other.check("share", "172")
    assert {"number", "share"}.isdisjoint(other.open)
