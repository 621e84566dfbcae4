"""What a lecturer finds: replies judged again by each student's own numbers."""

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest

from kinlab.errors import FileError
from kinlab.lessons import Course, Progress, Sitting
from kinlab.lessons.export import read_handed, to_csv, to_json
from kinlab.lessons.kinds import kind_of
from kinlab.lessons.verify import Result, verify


def taken(course: Course, folder: Path, profile: str = "ani") -> Sitting:
    """A student who solves all but the last exercise, the first one at the second try."""
    sitting = Sitting(course.lesson("every-kind"), Progress(profile, folder), "en")
    sitting.check("number", "3")
    for name, task in list(sitting.tasks.items())[:-1]:
        assert sitting.check(name, kind_of(task).right(task)).ok
    return sitting


def handed(course: Course, path: Path, document: Any) -> Result:
    path.write_text(document if isinstance(document, str) else json.dumps(document))
    [result] = verify(read_handed(path), course)
    return result


def test_an_honest_file_is_found_so(samples: Course, tmp_path: Path) -> None:
    sitting = taken(samples, tmp_path)
    result = handed(samples, tmp_path / "ani.json", to_json(sitting.progress, samples))
    assert result.forged == ()
    assert result.notes == ()
    done = result.lessons["every-kind"]
    assert (done.solved, done.shown, done.exercises, done.tries) == (12, 0, 13, 13)


def test_csv_tells_the_same_as_json(samples: Course, tmp_path: Path) -> None:
    sitting = taken(samples, tmp_path)
    one = handed(samples, tmp_path / "a.json", to_json(sitting.progress, samples))
    other = handed(samples, tmp_path / "a.csv", to_csv(sitting.progress))
    assert other.lessons == one.lessons
    assert other.forged == ()


def test_a_wrong_reply_said_to_be_right_is_found(samples: Course, tmp_path: Path) -> None:
    document = to_json(taken(samples, tmp_path).progress, samples)
    wrong = document["events"][0]
    assert wrong["reply"] == "3"
    wrong["ok"] = True
    result = handed(samples, tmp_path / "ani.json", document)
    assert result.forged == ("every-kind number: the reply '3' is said to be right and is wrong",)
    assert result.lessons["every-kind"].solved == 12


def test_an_invented_success_counts_for_nothing(samples: Course, tmp_path: Path) -> None:
    document = to_json(taken(samples, tmp_path).progress, samples)
    document["events"].append(document["events"][-1] | {"exercise": "arm", "reply": "wait 1", "ok": True})
    document["exercises"].append({"lesson": "every-kind", "exercise": "arm", "status": "solved"})
    result = handed(samples, tmp_path / "ani.json", document)
    assert len(result.forged) == 2
    assert result.lessons["every-kind"].solved == 12


def test_what_was_taken_away_is_missed_by_the_summary(samples: Course, tmp_path: Path) -> None:
    sitting = taken(samples, tmp_path)
    sitting.hint("number")
    document = to_json(sitting.progress, samples)
    whole = document["events"]
    document["events"] = [event for event in whole if event["ok"] or event["event"] != "try"]
    assert handed(samples, tmp_path / "ani.json", document).forged == (
        "every-kind number: the summary says tries 2, and the events make it 1",
    )
    document["events"] = [event for event in whole if event["event"] != "hint"]
    assert handed(samples, tmp_path / "ani.json", document).forged == (
        "every-kind number: the summary says hints 1, and the events make it 0",
    )


def test_a_solution_that_was_looked_at_is_not_hidden(samples: Course, tmp_path: Path) -> None:
    sitting = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "en")
    for reply in ("1", "2", "3"):
        sitting.check("number", reply)
    assert sitting.solution("number")
    assert sitting.check("number", "172").ok
    document = to_json(sitting.progress, samples)
    document["events"] = [event for event in document["events"] if event["event"] != "shown"]
    [sentence] = handed(samples, tmp_path / "ani.json", document).forged
    assert sentence == "every-kind number: the summary says status shown, and the events make it solved"


def test_a_file_that_powershell_wrote_is_read(samples: Course, tmp_path: Path) -> None:
    sitting = taken(samples, tmp_path)
    for text in (json.dumps(to_json(sitting.progress, samples)), to_csv(sitting.progress)):
        path = tmp_path / "ani.out"
        path.write_bytes(text.replace("\n", "\r\n").encode("utf-16"))
        [result] = verify(read_handed(path), samples)
        assert (result.solved, result.forged, result.notes) == (12, (), ())


def test_a_neighbours_replies_are_answers_to_other_numbers(samples: Course, tmp_path: Path) -> None:
    document = to_json(taken(samples, tmp_path).progress, samples)
    document |= {"profile": "budi", "seed": "budi"}
    result = handed(samples, tmp_path / "budi.json", document)
    assert any("bytes: the reply" in sentence for sentence in result.forged)
    assert result.lessons["every-kind"].solved < 12


def test_a_neighbours_seed_is_noticed(samples: Course, tmp_path: Path) -> None:
    document = to_json(taken(samples, tmp_path).progress, samples)
    (tmp_path / "ani.json").write_text(json.dumps(document))
    (tmp_path / "budi.json").write_text(json.dumps(document | {"profile": "budi"}))
    files = [each for name in ("ani", "budi") for each in read_handed(tmp_path / f"{name}.json")]
    ani, budi = verify(files, samples)
    assert any("same seed as ani" in sentence for sentence in budi.forged)
    assert any("not that of the profile" in sentence for sentence in budi.forged)
    assert any("same seed as budi" in sentence for sentence in ani.forged)


def test_work_that_is_handed_in_twice_is_a_note_and_no_accusation(samples: Course, tmp_path: Path) -> None:
    sitting = taken(samples, tmp_path)
    (tmp_path / "early.csv").write_text(to_csv(sitting.progress))
    sitting.check("number", "4")
    (tmp_path / "late.json").write_text(json.dumps(to_json(sitting.progress, samples)))
    early, late = verify(
        [each for name in ("early.csv", "late.json") for each in read_handed(tmp_path / name)], samples
    )
    assert early.forged == late.forged == ()
    assert early.notes == (f"is handed in once more in {tmp_path / 'late.json'}",)
    # Who names no profile may be anybody: the same file twice may be two people's.
    nameless = Sitting(samples.lesson("every-kind"), Progress(folder=tmp_path), "en")
    for name in ("one.json", "two.json"):
        (tmp_path / name).write_text(json.dumps(to_json(nameless.progress, samples)))
    one, two = verify(
        [each for name in ("one.json", "two.json") for each in read_handed(tmp_path / name)], samples
    )
    assert "same seed as student" in one.forged[0]
    assert "same seed as student" in two.forged[0]


def test_another_version_is_a_note_and_no_accusation(samples: Course, tmp_path: Path) -> None:
    document = to_json(taken(samples, tmp_path).progress, samples)
    for event in document["events"]:
        event["version"] = 2
    for claim in document["exercises"]:
        claim["version"] = 2
    result = handed(samples, tmp_path / "ani.json", document)
    assert result.forged == ()
    assert result.notes == ("every-kind: was taken in version 2, and the course has 3",)


def test_an_answer_in_the_students_words_is_right_in_every_language(samples: Course, tmp_path: Path) -> None:
    sitting = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "id")
    task = sitting.tasks["choice"]
    right = task.text(task.wording.options[task.answer])
    assert sitting.check("choice", f"({right})").ok
    assert right != task.text(task.exercise.wording["en"].options[task.answer])
    result = handed(samples, tmp_path / "ani.json", to_json(sitting.progress, samples))
    assert result.forged == ()
    assert result.solved == 1


def test_replies_are_no_formulas_for_a_spreadsheet(samples: Course, tmp_path: Path) -> None:
    sitting = Sitting(samples.lesson("every-kind"), Progress("ani", tmp_path), "en")
    sitting.check("state", "=cmd|' /C calc'!A0")
    sitting.check("number", "-3")
    rows = list(csv.DictReader(io.StringIO(to_csv(sitting.progress))))
    assert [row["reply"] for row in rows] == ["'-3"]
    path = tmp_path / "ani.csv"
    path.write_text(to_csv(sitting.progress))
    assert read_handed(path)[0].events[-1].reply == "-3"


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "{}",
        '{"format": 1}',
        '{"format": 1, "profile": "a", "seed": "a", "events": 3}',
        "a,b\n1,2\n",
        "[" * 9999,
        '{"format": 1, "profile": "student", "seed": "\\ud800", "events": []}',
    ],
)
def test_a_file_that_is_no_export_is_named(text: str, tmp_path: Path) -> None:
    path = tmp_path / "odd.json"
    path.write_text(text)
    with pytest.raises(FileError, match=r"odd\.json"):
        read_handed(path)


def test_a_row_that_is_no_event_is_noted(samples: Course, tmp_path: Path) -> None:
    text = to_csv(taken(samples, tmp_path).progress)
    odd = text.splitlines()[1].replace(",3,", f",{'9' * 5000},", 1)
    result = handed(samples, tmp_path / "ani.csv", f"{text}{odd}\n")
    assert result.notes == ("line 15 cannot be read",)
    assert result.solved == 12


def test_events_that_are_none_are_noted(samples: Course, tmp_path: Path) -> None:
    document = to_json(taken(samples, tmp_path).progress, samples)
    document["events"] += [3, {"event": "try"}, {"event": "dance", "at": "", "lesson": "", "version": 1}]
    result = handed(samples, tmp_path / "ani.json", document)
    assert result.notes == ("event 14 cannot be read", "event 15 cannot be read", "event 16 cannot be read")
