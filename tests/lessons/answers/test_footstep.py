"""A foot in the air, against differences and against the walk itself."""

import pytest

from kinlab.gait import find_curve, find_gait, jumps, plan
from kinlab.lessons.answers import footstep
from kinlab.robots import load_robot


def test_the_middle_of_the_flight_is_the_highest_point() -> None:
    assert footstep.point(50, 24, 0.5) == pytest.approx([25, 24])
    assert footstep.point(50, 24, 0.2)[1] == pytest.approx(footstep.point(50, 24, 0.8)[1])


def test_the_knock_is_how_fast_the_height_falls_at_the_end() -> None:
    before = footstep.point(50, 24, 1 - 1e-6)[1]
    assert footstep.knock(24, 0.4) == pytest.approx(before / (0.4 * 1e-6), rel=1e-5)


@pytest.mark.parametrize("gait", ["tripod", "wave", "ripple"])
def test_times_are_those_of_the_walk(gait: str) -> None:
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot, gait))
    usual = footstep.usual("krsri-hexapod", gait)
    assert footstep.swing_time(usual["stroke"], usual["speed"], usual["duty"]) == pytest.approx(
        walk.swing_time
    )
    assert footstep.period(usual["stroke"], usual["speed"], usual["duty"]) == pytest.approx(walk.period)


@pytest.mark.parametrize(
    ("curve", "key"), [("line-sine", "twice"), ("cycloid", "along"), ("matched-quintic", "rest")]
)
def test_the_slide_is_the_jump_of_the_curve_at_touch_down(curve: str, key: str) -> None:
    stroke, speed, duty = 50.0, 20.0, 0.5
    time = footstep.swing_time(stroke, speed, duty)
    jump = jumps(find_curve(curve), duty).velocity_along[1] * stroke / time
    assert footstep.slide(stroke, speed, duty, curve) == pytest.approx(jump, abs=1e-9)
    assert footstep.slide_key(stroke, speed, duty, curve) == key


def test_equation_26_hangs_the_foot_in_the_air() -> None:
    assert footstep.misprint(["24", "25", "26", "27"], 50, 25) == 3
