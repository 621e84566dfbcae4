"""What the papers measured."""

import pytest

from kinlab.papers import measured
from kinlab.robots import load_robot


def test_a_target_of_the_table_has_its_own_row():
    """Test 3 of the xl430 paper: (60, 20, -55) was reached at (57, 19, -55), and test 7 at (60, 19, -55)."""
    robot = load_robot("xl430-hexapod")
    found = measured(robot, robot.limbs["R1"], [0.060, 0.020, -0.055])
    assert found.where == "Tables 2 and 3, test 3 and 7"
    assert found.axes_mm == pytest.approx((1.5, 1.0, 0.0))


def test_any_other_target_has_the_mean_of_all():
    """|x|: 1 1 3 2 3 1 0 2 1, |y|: 1 0 1 2 1 0 1 3 5, |z|: 0 1 0 2 1 0 0 1 1, from Tables 2 and 3."""
    robot = load_robot("xl430-hexapod")
    found = measured(robot, robot.limbs["R2"], [0.075, 0.0, -0.060])
    assert found.axes_mm == pytest.approx((14 / 9, 14 / 9, 6 / 9))


def test_left_legs_are_measured_in_the_papers_axes():
    robot = load_robot("xl430-hexapod")
    left = robot.limbs["L1"]
    found = measured(robot, left, left.to_limb([0.075, 0.010, -0.045], "paper"))
    assert found.axes_mm == pytest.approx((1, 1, 0))


@pytest.mark.parametrize("name", ["krsri-hexapod", "udiebot", "eros", "receptionist-arm"])
def test_papers_that_measured_no_foot_have_none(name):
    robot = load_robot(name)
    assert measured(robot, robot.limb(), [0.1, 0, -0.1]) is None
