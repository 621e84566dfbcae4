"""A body over standing feet, against `kinlab body` and against a robot that is pushed."""

import pytest

from kinlab.lessons.answers import stance
from kinlab.robots import load_robot
from kinlab.robots.body import stand

ROBOT = "krsri-hexapod"


@pytest.mark.parametrize("limb", ["R1", "L2", "R3"])
def test_the_foot_is_where_the_body_command_shows_it(limb: str) -> None:
    shown = stand(load_robot(ROBOT), (20, -5, 10), (0, 0, 12)).to_json()["legs"][limb]["foot_mm"]
    assert stance.foot(ROBOT, limb, tx=20, ty=-5, tz=10, yaw=12) == pytest.approx(shown, abs=1e-6)


def test_the_floor_sinks_when_the_body_rises_and_the_left_feet_when_it_rolls() -> None:
    assert stance.height(ROBOT, "R1", 20) == pytest.approx(-110)
    assert stance.height_rolled(ROBOT, "L2", 10) < -90 < stance.height_rolled(ROBOT, "R2", 10)


def test_one_leg_stops_a_roll_of_25_degrees() -> None:
    found = stance.impossible(ROBOT, 25)
    assert (found["leg"], found["joint"], found["limit"]) == ("R2", "femur", pytest.approx(100))
    assert found["needs"] == pytest.approx(107.21, abs=0.01)


def test_the_printed_line_pushes_the_body_backwards() -> None:
    assert stance.misprint(ROBOT, 30, 0) == "backwards"
