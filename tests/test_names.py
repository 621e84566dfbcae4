"""Names as people type them."""

import pytest

from kinlab.errors import UsageError
from kinlab.names import resolve, suggestion

ROBOTS = ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros"]


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("udiebot", "udiebot"), ("UdieBot", "udiebot"), ("xl", "xl430-hexapod"), ("E", "eros")],
)
def test_exact_then_any_case_then_unique_beginning(typed, meant):
    assert resolve(typed, ROBOTS, "robot") == meant


def test_an_exact_name_wins_over_longer_ones_that_begin_with_it():
    assert resolve("lm", ["lm", "lma"], "method") == "lm"


@pytest.mark.parametrize(
    ("typed", "says"),
    [
        ("udibot", "no robot is named 'udibot'; did you mean udiebot?"),
        ("", "no robot is named ''; there are: xl430-hexapod, krsri-hexapod, udiebot, eros"),
        ("zzz", "there are: xl430-hexapod"),
    ],
)
def test_a_wrong_name_is_answered_with_valid_ones(typed, says):
    with pytest.raises(UsageError, match=says.replace("?", r"\?")):
        resolve(typed, ROBOTS, "robot")


def test_an_ambiguous_beginning_is_answered_with_its_meanings():
    with pytest.raises(UsageError, match="limb 'R' is ambiguous: R1, R2"):
        resolve("R", ["R1", "R2", "L1"], "limb")


def test_no_suggestion_where_there_is_nothing_to_suggest():
    assert suggestion("x", []) == ""
