"""Servo steps: what they are worth at the foot."""

import numpy as np
import pytest

from kinlab.lessons.answers import ticks
from kinlab.lessons.answers.leg import foot

ROBOT = "krsri-hexapod"


def test_the_middle_of_an_ax_12_is_tick_512_and_a_mirrored_femur_goes_the_other_way() -> None:
    assert ticks.tick(ROBOT, "R1", "femur", 0) == ticks.tick(ROBOT, "L1", "femur", 0) == 512
    assert ticks.tick(ROBOT, "R1", "femur", 30) - 512 == 512 - ticks.tick(ROBOT, "L1", "femur", 30) == 102


def test_dividing_by_1023_is_one_off_where_it_is_asked_about() -> None:
    angles = [a for a in range(-60, 61) if ticks.differs_by_1023(ROBOT, "R1", "femur", a)]
    assert angles
    assert all(
        abs(ticks.tick(ROBOT, "R1", "femur", a) - ticks.tick_by_1023(ROBOT, "R1", "femur", a)) == 1
        for a in angles
    )


def test_a_step_of_the_femur_moves_the_foot_as_far_as_two_poses_lie_apart() -> None:
    # The stance of krsri-hexapod, kinlab ik krsri-hexapod 130 0 -90.
    alpha, beta, gamma = 0.0, 34.92636, -114.33816
    step = 300 / 1024
    apart = np.subtract(
        foot(ROBOT, alpha, beta + step / 2, gamma), foot(ROBOT, alpha, beta - step / 2, gamma)
    )
    assert ticks.steps(ROBOT)["femur"] == pytest.approx(np.linalg.norm(apart), rel=1e-4)


def test_rounding_moves_the_foot_by_no_more_than_half_a_step_of_every_joint() -> None:
    assert 0 < ticks.rounded(ROBOT, 0.0, 34.92636, -114.33816) <= ticks.worst(ROBOT)


def test_the_ruler_found_far_more_than_rounding_explains() -> None:
    # xl430-hexapod, Table 4: nine errors on x add up to 14 mm.
    assert ticks.measured()["x"] == pytest.approx(14 / 9)
    assert ticks.larger("xl430-hexapod") == "mechanics"
