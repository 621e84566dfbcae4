"""The case of the missing 0.1 percent, against the digits that the paper prints."""

import numpy as np
import pytest

from kinlab.lessons.answers import permille
from kinlab.papers.tables import printed_table

ROBOT = "udiebot"
TABLE_4 = printed_table("udiebot-quadruped", "4")
ROWS = [float(x) for x in TABLE_4.column("x")]


@pytest.mark.parametrize(("x", "theta3"), list(zip(ROWS, TABLE_4.column("theta3"), strict=True)))
def test_the_wrong_pi_predicts_the_knee_of_every_row(x: float, theta3: float) -> None:
    # Cut, not rounded: towards zero.
    assert 0 <= theta3 - permille.knee(ROBOT, x) < 0.001


@pytest.mark.parametrize("x", ROWS[1:])
def test_every_row_leads_to_the_same_pi(x: float) -> None:
    assert permille.leg_of_table(ROBOT, x) == "bare"
    assert permille.their_pi(ROBOT, x) == pytest.approx(22 / 7, abs=1e-4)
    assert permille.fraction(ROBOT, x) == "twenty-two"


def test_the_foot_comes_back_as_far_off_as_it_is_printed() -> None:
    # 26 cm: 25.993 and -0.016 cm, cut.
    row = permille.printed(ROBOT, 26)
    assert (26 - row["short_mm"] / 10, -row["low_mm"] / 10) == pytest.approx((25.993, -0.016), abs=1e-3)


def test_one_row_of_table_6_makes_the_average_that_is_printed() -> None:
    assert round(permille.average(), 3) == 0.029
    assert round(permille.share(26), 2) == 0.11
    assert permille.average_without_outlier() == pytest.approx(0.053 / 9)


def test_that_row_was_given_the_knee_of_the_row_before() -> None:
    found = permille.foot_with_knee(ROBOT, -1)
    # 25.764, 0.424, -3.961: cut, and y without its sign.
    assert (np.trunc(np.abs(found) * 1000) / 1000).tolist() == pytest.approx([25.764, 0.424, 3.961])
    assert permille.copied(ROBOT) == "before"
