"""What is possible: the joint at its limit, the fastest speed, the foot that cannot follow."""

import re
from dataclasses import replace

import numpy as np
import pytest

from kinlab.errors import KinlabError
from kinlab.gait import assess, find_gait, plan
from kinlab.gait.limits import joint_rates
from kinlab.robots import load_robot


def krsri(**options):
    robot = load_robot("krsri-hexapod")
    return plan(robot, find_gait(robot, options.pop("gait", None)), **options)


def test_joint_speeds_are_the_rates_of_the_joint_angles():
    walk = krsri(gait="wave", turn=0.05)
    t = np.linspace(0, walk.period, 20001)
    rates = np.abs(np.diff(walk.at(t).q, axis=0) / np.diff(t)[:, None, None]).max(axis=0)
    assert assess(walk).speeds == pytest.approx(rates, rel=2e-3)


def test_at_the_fastest_speed_the_tightest_joint_is_at_its_servos_limit():
    limits = assess(krsri(gait="wave"))
    _, joint = limits.tightest
    assert limits.model == "AX-12A"
    at_limit = assess(krsri(gait="wave", forward=limits.fastest * 0.9999))
    assert at_limit.used == pytest.approx(1, abs=1e-3)
    assert at_limit.tightest[1] == joint
    with pytest.raises(KinlabError, match=f"the {joint} of .* AX-12A does 354 deg/s without load"):
        assess(krsri(gait="wave", forward=limits.fastest * 1.001))


def test_the_fastest_speed_that_an_error_names_is_possible_and_no_faster_one_is():
    for options, keep in (
        ({"forward": 0.5}, False),
        ({"forward": 1.0, "period": 1.0}, True),
        ({"stride": 0.5}, True),
    ):
        walk = krsri(**options)
        with pytest.raises(KinlabError) as refused:
            assess(walk, keep_period=keep)
        fastest = (
            float(re.search(r"fastest possible speed .* is ([\d.]+) mm/s", str(refused.value))[1]) / 1000
        )
        period = {"period": walk.period} if keep else {"stride": walk.stride}
        assess(krsri(forward=fastest * 0.999, **period), keep_period=keep)
        with pytest.raises(KinlabError):
            assess(krsri(forward=fastest * 1.002, **period), keep_period=keep)


def test_a_foot_out_of_reach_names_its_leg_phase_and_time():
    with pytest.raises(
        KinlabError,
        match=r"[LR]\d cannot follow at phase 0\.\d+ \(\d+\.\d+ s, (stance|swing)\): out of reach",
    ):
        assess(krsri(stride=0.5))


def test_too_high_a_body_is_possible_at_no_speed():
    with pytest.raises(KinlabError, match="no speed is possible"):
        assess(krsri(height=0.5))


def test_a_turn_beyond_the_servos_names_the_fastest_turn():
    with pytest.raises(KinlabError, match=r"fastest possible turn with this stride is [\d.]+ deg/s"):
        assess(krsri(forward=0.0, turn=3.0))


def test_steps_on_the_spot_beyond_the_servos_name_the_shortest_period():
    with pytest.raises(KinlabError, match="shortest possible period") as refused:
        assess(krsri(gait="wave", forward=0.0))
    shortest = float(re.search(r"period is ([\d.]+) s", str(refused.value))[1])
    assert assess(krsri(gait="wave", forward=0.0, period=shortest)).used == pytest.approx(1, abs=0.02)


def test_a_robot_whose_servos_nobody_names_is_limited_by_its_legs_alone():
    robot = load_robot("eros")
    limits = assess(plan(robot, find_gait(robot)))
    assert limits.fastest is None
    assert limits.model is None


def test_twice_the_speed_at_the_same_stride_is_twice_the_joint_speed():
    slow = krsri()
    fast = replace(slow, velocity=(0.04, 0.0), period=slow.period / 2)
    assert assess(fast).used == pytest.approx(2 * assess(slow).used)


def test_joint_rates_are_those_of_a_line_through_neighbouring_instants():
    walk = krsri(gait="wave")
    t = np.array([0.11, 0.37]) * walk.period
    h = 1e-4
    slope = (walk.at(t + h).q - walk.at(t - h).q) / (2 * h)
    np.testing.assert_allclose(joint_rates(walk, t), slope, atol=1e-4)
