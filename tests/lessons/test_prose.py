"""A lesson's Markdown as lines for a terminal."""

import pytest

from kinlab.lessons import Sitting, Text, load_course
from kinlab.lessons.prose import prose


def plain(markdown: str, columns: int = 40) -> list[str]:
    return ["".join(text for _, text in line) for line in prose(markdown, columns)]


def test_blocks_are_set_apart_and_wrapped() -> None:
    markdown = (
        "# Head\n\nOne two three four five six seven eight nine\nten.\n\n"
        "- an item that is longer than the line is wide\n- two"
    )
    assert plain(markdown, 30) == [
        "Head",
        "",
        "One two three four five six",
        "seven eight nine ten.",
        "",
        "- an item that is longer than",
        "  the line is wide",
        "- two",
    ]


def test_code_and_tables_stand_as_they_are() -> None:
    assert plain("    x = a * b_c   +  1") == ["    x = a * b_c   +  1"]
    assert plain("```\na   b\n\nc\n```") == ["    a   b", "    ", "    c"]
    assert plain("| a | long |\n|---|---|\n| `1` | 2 |") == ["  a  long", "  1  2"]


def test_the_last_column_of_a_wide_table_is_folded() -> None:
    assert plain("| a | b |\n|---|---|\n| one | two three four five six seven |", 28) == [
        "  a    b",
        "  one  two three four five",
        "       six seven",
    ]


def test_marks_become_styles_and_stray_ones_stay() -> None:
    [line] = prose("**bold** *soft* `code` a * b * c [text](link) x_y_z", 80)
    assert ("verb", "bold") in line
    assert ("id", "code") in line
    assert "".join(text for _, text in line) == "bold soft code a * b * c text (link) x_y_z"


def test_hard_breaks_begin_a_line() -> None:
    assert plain("a) one  \nb) two") == ["a) one", "b) two"]


@pytest.mark.parametrize("columns", [12, 29, 30, 31, 47, 60])
def test_a_full_stop_stays_with_the_word_before_it(columns: int) -> None:
    lines = prose("In the paper of `xl430-hexapod`. You know a **limb frame**, don't you?", columns)
    text = ["".join(part for _, part in line) for line in lines]
    assert " ".join(text) == "In the paper of xl430-hexapod. You know a limb frame, don't you?"
    assert all(len(line) <= columns or " " not in line for line in text)


@pytest.mark.parametrize("language", ["en", "id"])
def test_the_course_fits_eighty_columns(language: str) -> None:
    for lesson in load_course().lessons.values():
        sitting = Sitting.alone(lesson, "ani", language)
        texts = [part.markdown for part in sitting.parts() if isinstance(part, Text)]
        texts += [sitting.question(name) for name in sitting.tasks]
        wide = [
            line
            for text in texts
            for line in plain(text, 80)
            if len(line) > 80 and not line.startswith("    ")
        ]
        assert wide == [], lesson.id
