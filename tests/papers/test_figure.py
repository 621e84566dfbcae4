"""A printed number keeps its text, and knows what rounds to it and what is cut to it."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.papers.figure import Figure


def test_a_figure_keeps_its_zeros():
    assert Figure.read("3.980").decimals == 3
    assert Figure.read("3.98").decimals == 2
    assert Figure.read("3.980").value == Figure.read("3.98").value
    assert Figure.read("3.980").text == "3.980"


def test_a_figure_may_be_hexadecimal_or_damaged():
    assert Figure.read("0x18").value == 24
    assert Figure.read("0x18").decimals == 0
    assert Figure.read("7.2?") == Figure("7.2", damaged=True)


@pytest.mark.parametrize("text", ["", "?", "1,5", "1.", ".5", "1e3", "nan", "inf", "1 2", "--1", "12a"])
def test_nothing_else_is_a_figure(text):
    with pytest.raises(ValueError, match="no printed number"):
        Figure.read(text)


@pytest.mark.parametrize(
    ("text", "value", "rounds", "cuts"),
    [
        ("0.88", 8 / 9, False, True),
        ("0.89", 8 / 9, True, False),
        ("1.56", 14 / 9, True, False),
        ("63", 62.5, True, False),
        ("62", 62.5, True, True),  # equally near: either will do
        ("-0.017", -0.01759, False, True),
        ("-0.018", -0.01759, True, False),
        ("0", -0.4, True, True),
        ("-0.003", -0.003, True, True),
        ("2.3", 100 - 97.7, True, True),  # 2.2999999999999972 is 2.3
    ],
)
def test_rounding_and_cutting(text, value, rounds, cuts):
    figure = Figure.read(text)
    assert (figure.rounds(value), figure.cuts(value)) == (rounds, cuts)


def test_a_column_may_have_more_decimals_than_its_figure():
    """3.98 in a column of three decimals is 3.980."""
    figure = Figure.read("3.98")
    assert figure.rounds(3.9849)
    assert not figure.rounds(3.9849, 3)
    assert figure.cuts(3.9804, 3)
    assert not figure.cuts(3.9849, 3)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_gives_no_figure(value):
    assert not Figure("0").rounds(value)
    assert not Figure("0").cuts(value)


@given(st.floats(-1e6, 1e6), st.integers(0, 4))
def test_every_number_gives_what_python_prints_of_it(value, decimals):
    assert Figure.read(f"{value:.{decimals}f}").rounds(value)
