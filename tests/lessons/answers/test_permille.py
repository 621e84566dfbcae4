"""The case of the missing 0.1 percent, against the digits that the paper prints."""

import pytest

from kinlab.lessons.answers import permille

ROBOT = "udiebot"
# Udiebot (2018), Table 4: x in cm, theta2, theta3.
TABLE_4 = [
    (30, 0, -0.072), (28, 21.031, -42.134), (26, 29.914, -59.901), (24, 36.855, -73.782), (22, 42.816, -85.704),
    (20, 48.17, -96.413), (18, 53.108, -106.289), (16, 57.745, -115.564), (14, 62.156, -124.386),
    (12, 66.395, -132.862),
]  # fmt: skip


@pytest.mark.parametrize(("x", "theta2", "theta3"), TABLE_4)
def test_the_row_is_as_it_is_printed(x: float, theta2: float, theta3: float) -> None:
    row = permille.printed(ROBOT, x)
    assert (row["theta2"], row["theta3"]) == (theta2, theta3)
    # Cut, not rounded: towards zero.
    assert 0 <= theta3 - permille.knee(ROBOT, x) < 0.001


@pytest.mark.parametrize("x", [row[0] for row in TABLE_4[1:]])
def test_every_row_leads_to_the_same_pi(x: float) -> None:
    assert permille.leg_of_table(ROBOT, x) == "bare"
    assert permille.their_pi(ROBOT, x) == pytest.approx(22 / 7, abs=1e-4)
    assert permille.fraction(ROBOT, x) == "twenty-two"


def test_one_row_of_table_6_makes_the_average_that_is_printed() -> None:
    assert round(permille.average(), 3) == 0.029
    assert round(permille.share(26), 2) == 0.11
    assert permille.average_without_outlier() == pytest.approx(0.053 / 9)
