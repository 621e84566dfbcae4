"""Placeholders: filled by a substitution of our own, which reaches nothing but the values."""

import pytest

from kinlab.lessons.filling import UnknownNameError, fill, names, show


@pytest.mark.parametrize(
    ("text", "filled"),
    [
        ("{x} mm", "12.5 mm"),
        ("{x:.2f}", "12.50"),
        ("{x:+.0f}", "+12"),
        ("{n:02X}", "0C"),
        ("{n}", "12"),
        ("{leg.coxa:g} mm", "25 mm"),
        ("{places:.1f}", "1.0, -2.5"),
        ("{raw}", "FF 0A"),
        ("{nothing:.1f}", "0.0"),
        ("{name}", "R1"),
        ("sets {1, 2} and {} stay, \\frac{1}{2} too", "sets {1, 2} and {} stay, \\frac{1}{2} too"),
    ],
)
def test_values_are_written_in_the_style_asked_for(text: str, filled: str) -> None:
    values = {
        "x": 12.5,
        "n": 12,
        "leg": {"coxa": 25.0},
        "places": (1.0, -2.5),
        "raw": b"\xff\x0a",
        "nothing": -0.001,
        "name": "R1",
    }
    assert fill(text, values) == filled


@pytest.mark.parametrize(
    "text", ["{y}", "{x.real}", "{x.__class__}", "{leg.femur}", "{leg}", "{x:.99f}", "{x:>9}", "{far:d}"]
)
def test_what_is_no_value_is_refused_and_never_reached_into(text: str) -> None:
    with pytest.raises(UnknownNameError):
        fill(text, {"x": 1.5, "far": float("inf"), "leg": {"coxa": 25.0}})


def test_a_value_is_not_filled_again() -> None:
    assert fill("{a}", {"a": "{b}", "b": "secret"}) == "{b}"


def test_long_values_are_cut_and_names_are_listed() -> None:
    assert len(show("x" * 1_000_000)) == 10_000
    assert names("{a} {b.c:.1f} {not one}") == ["a", "b.c"]
