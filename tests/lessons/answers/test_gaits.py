"""Orders of steps, against the gaits of the robots file."""

import pytest

from kinlab.gait import find_gait, plan
from kinlab.lessons.answers import gaits
from kinlab.robots import load_robot

ROBOT = "krsri-hexapod"


@pytest.mark.parametrize(("beta", "name"), [("5/6", "metachronal"), ("2/3", "ripple")])
def test_the_order_is_that_of_the_wave_gaits_in_the_robots_file(beta: str, name: str) -> None:
    touchdown = find_gait(load_robot(ROBOT), name).touchdown
    assert gaits.order(beta) == sorted(touchdown, key=lambda leg: touchdown[leg])
    for leg, at in touchdown.items():
        assert gaits.landing(beta, leg) == pytest.approx(float(at))


def test_a_duty_factor_is_what_the_legs_in_the_air_leave() -> None:
    for name, beta in (("tripod", 1 / 2), ("ripple", 2 / 3), ("wave", 5 / 6)):
        assert gaits.duty_of(ROBOT, name) == pytest.approx(beta) == 1 - gaits.aloft(ROBOT, name) / 6


@pytest.mark.parametrize("name", ["tripod", "ripple", "wave"])
def test_the_speed_is_that_of_a_walk_with_this_swing(name: str) -> None:
    robot = load_robot(ROBOT)
    walk = plan(robot, find_gait(robot, name))
    assert gaits.speed(walk.stroke, walk.swing_time, walk.duty) == pytest.approx(walk.speed)


def test_the_fastest_wave_is_five_times_slower_than_the_fastest_tripod() -> None:
    assert gaits.fastest(ROBOT, "tripod") / gaits.fastest(ROBOT, "wave") == pytest.approx(5, rel=1e-3)
