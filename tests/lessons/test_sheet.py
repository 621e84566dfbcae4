"""Answers in a file: the sheet that is handed out, and what is read from one that was filled in."""

import pytest

from kinlab.lessons import Course, Sitting
from kinlab.lessons.kinds import kind_of
from kinlab.lessons.sheet import blank, read_sheet


@pytest.mark.parametrize(
    ("text", "replies"),
    [
        ("", {}),
        ("# number = 3\n\nnumber =\n", {}),
        ("number = 12,5 mm", {"number": "12,5 mm"}),
        ("  number=12  ", {"number": "12"}),
        ("number = 1\nnumber = 2", {"number": "2"}),
        ("a note\nnumber = 1", {"number": "1"}),
        ("[state]\nping 1\n# why\n  write 1 led 1", {"state": "ping 1\nwrite 1 led 1"}),
        ("[state]\nping 1\nnumber = 3", {"state": "ping 1", "number": "3"}),
        ("[vector]\nx = 1\ny = 2\nz = 3", {"vector": "x = 1\ny = 2\nz = 3"}),
        ("[state]\n[number]\n7", {"number": "7"}),
    ],
)
def test_replies_stand_behind_their_names_or_below_them(text: str, replies: dict[str, str]) -> None:
    assert read_sheet(text) == replies


@pytest.mark.parametrize("language", ["en", "id"])
def test_a_blank_sheet_has_a_place_for_each_answer(samples: Course, language: str) -> None:
    sitting = Sitting.alone(samples.lesson("every-kind"), "ani", language)
    sheet = blank(sitting)
    assert read_sheet(sheet) == {}
    for name, task in sitting.tasks.items():
        assert task.ask in sheet
        right = kind_of(task).right(task)
        for place in (f"\n{name} =", f"\n[{name}]"):
            sheet = sheet.replace(
                f"{place}\n", f"{place} {right}\n" if "=" in place else f"{place}\n{right}\n"
            )
    for name, reply in read_sheet(sheet).items():
        assert sitting.check(name, reply).ok
    assert sitting.open == []
