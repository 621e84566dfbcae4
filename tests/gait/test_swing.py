"""Foot trajectories: from the ground to the ground, and what they do to the foot at both ends."""

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.gait import CURVES, find_curve, find_gait, jumps, plan
from kinlab.gait.landing import decelerated
from kinlab.robots import load_robot

ALL = [*CURVES.values(), decelerated(CURVES["quarter-circle"])]
S = np.linspace(0.001, 0.999, 997)


@pytest.mark.parametrize("curve", ALL, ids=str)
def test_a_curve_goes_from_one_foothold_to_the_next_and_leaves_the_ground_between(curve):
    ends = np.array([0.0, 1.0])
    assert curve.along.value(ends) == pytest.approx([0, 1], abs=1e-12)
    assert curve.height.value(ends) == pytest.approx([0, 0], abs=1e-12)
    assert (curve.height.value(S) > 0).all()


@pytest.mark.parametrize("curve", CURVES.values(), ids=str)
@pytest.mark.parametrize("part", ["along", "height"])
def test_rates_are_the_derivatives_of_values(curve, part):
    profile, h = getattr(curve, part), 1e-6
    slope = (profile.value(S + h) - profile.value(S - h)) / (2 * h)
    bend = (profile.rate(S + h) - profile.rate(S - h)) / (2 * h)
    assert profile.rate(S) == pytest.approx(slope, abs=1e-6)
    assert profile.bend(S) == pytest.approx(bend, abs=1e-4)


# Measured independently: strokes and lifts per swing time, at duty factors of 1/2, 3/4, 5/6.
TABLE = {
    "quarter-circle": ((1, 1 / 3, 0.2), np.pi, 0.0),
    "line-sine": ((2, 4 / 3, 1.2), np.pi, 0.0),
    "cycloid": ((1, 1 / 3, 0.2), 0.0, 2 * np.pi**2),
    "matched-cycloid": ((0, 0, 0), 0.0, 2 * np.pi**2),
    "matched-quintic": ((0, 0, 0), 0.0, 0.0),
    "bezier": ((-1.2, -2.2 + 1 / 3, -2.0), 0.0, 99.0),
}


@pytest.mark.parametrize("name", CURVES)
def test_jumps_are_those_of_the_literature(name):
    along, up, acceleration = TABLE[name]
    for duty, expected in zip((1 / 2, 3 / 4, 5 / 6), along, strict=True):
        found = jumps(CURVES[name], duty)
        assert found.velocity_along == pytest.approx((expected, expected), abs=1e-9)
        assert found.velocity_height == pytest.approx((up, -up), abs=1e-9)
        assert found.acceleration_height[0] == pytest.approx(acceleration, abs=1e-9)


@pytest.mark.parametrize("curve", CURVES.values(), ids=str)
def test_a_walk_has_the_jumps_that_its_curve_reports(curve):
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot, "ripple"), curve=curve)
    h = 1e-6
    R1 = [leg.name for leg in robot.legs].index("R1")
    lift_off = float(walk.gait.liftoff("R1")) * walk.period
    motion = walk.at(np.array([lift_off + h, lift_off + 2 * h]))
    velocity = np.diff(motion.ground[:, R1], axis=0)[0] / h
    expected = jumps(curve, walk.duty)
    assert velocity[0] == pytest.approx(expected.velocity_along[0] * walk.stroke / walk.swing_time, abs=1e-4)
    assert velocity[2] == pytest.approx(expected.velocity_height[0] * walk.lift / walk.swing_time, abs=1e-4)


def test_a_mistyped_trajectory_is_answered_with_the_nearest():
    with pytest.raises(UsageError, match="no foot trajectory is named 'cyclid'; did you mean cycloid"):
        find_curve("cyclid")
