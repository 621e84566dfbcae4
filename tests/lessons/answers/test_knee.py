"""The other knee: the same foot, a mirrored leg."""

import pytest

from kinlab.lessons.answers import knee
from kinlab.lessons.answers.leg import foot

ROBOT = "xl430-hexapod"


@pytest.mark.parametrize(("x", "z"), [(75, -60), (100, -40), (90, -20)])
def test_both_knees_bring_the_foot_to_one_place(x: float, z: float) -> None:
    up = knee.knee_up(ROBOT, x, 0, z)
    assert foot(ROBOT, 0, up["beta"], up["gamma"]) == pytest.approx([x, 0, z])
    assert foot(ROBOT, 0, *knee.knee_down(ROBOT, x, 0, z)) == pytest.approx([x, 0, z])


def test_the_mirror_is_the_line_to_the_foot() -> None:
    up = knee.knee_up(ROBOT, 75, 10, -60)
    beta, gamma = knee.knee_down(ROBOT, 75, 10, -60)
    assert [beta, gamma] == pytest.approx([2 * knee.line(ROBOT, 75, 10, -60) - up["beta"], -up["gamma"]])


def test_of_four_ways_one_is_within_the_limits_and_near_full_stretch_two() -> None:
    assert (knee.ways(ROBOT, 75, 10, -60), knee.ways_within_limits(ROBOT, 75, 10, -60)) == (4, 1)
    assert knee.ways_within_limits(ROBOT, 140, 0, -30) == 2


def test_a_mirrored_servo_has_its_limits_the_other_way_round() -> None:
    # (240 - 145) and (240 + 30) deg, and (60 - 30) and (60 + 145) deg, by 300/1024 deg.
    assert knee.limit_ticks("krsri-hexapod", "R1", "tibia", -145, 30) == [324, 922]
    assert knee.limit_ticks("krsri-hexapod", "L1", "tibia", -145, 30) == [102, 700]
