"""A robot that walks on the spot while somebody looks."""

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.gait import find_gait, plan
from kinlab.rig import Treadmill, WalkResult
from kinlab.robots import load_robot


@pytest.fixture
def treadmill(krsri):
    with Treadmill(plan(krsri, find_gait(krsri, "tripod"), forward=0.1)) as treadmill:
        yield treadmill


def test_a_cycle_costs_what_the_steady_part_of_a_walk_costs(treadmill, errand, walked, krsri):
    job = errand(speed=100, distance=500)
    record = walked(job)
    steady = WalkResult(job, record, "memory", True)
    treadmill.tread(3 * treadmill.walk.period)
    assert treadmill.cycle_power == pytest.approx(steady.steady.power, rel=0.01)
    assert treadmill.per_metre == pytest.approx(steady.per_metre, rel=0.01)


def test_the_second_cycle_is_like_the_first_but_for_its_start(treadmill):
    period = treadmill.walk.period
    treadmill.tread(2 * period)
    first, second = treadmill.at(0.9 * period), treadmill.at(1.9 * period)
    np.testing.assert_allclose(first.planned, second.planned, atol=0.03)
    np.testing.assert_allclose(first.reading.q, second.reading.q, atol=0.04)
    assert second.joules > first.joules


def test_it_walks_no_further_than_it_is_asked(treadmill):
    assert treadmill.at(0.0) is None
    assert treadmill.cycle_power is None
    assert not treadmill.tread(1.0, most=5)
    assert len(treadmill.samples) == 5
    assert treadmill.tread(0.2)
    assert treadmill.samples[-1].t == pytest.approx(0.2)
    assert treadmill.at(0.101).t == pytest.approx(0.1)
    assert treadmill.at(5.0) is None


def test_what_is_long_past_is_not_kept(treadmill):
    period = treadmill.walk.period
    treadmill.tread(3 * period)
    assert treadmill.at(0.1) is None
    assert treadmill.at(1.5 * period).t == pytest.approx(1.5 * period, abs=0.02)


def test_the_torque_is_off_afterwards(krsri):
    with Treadmill(plan(krsri, find_gait(krsri))) as treadmill:
        rig = treadmill._rig
        treadmill.tread(0.1)
        assert rig.bus.read(1, "torque_enable") == 1
    assert rig.unconfirmed == ()
    assert [rig.bus.read(i, "torque_enable") for i in rig.wiring.ids] == [0] * 18


@pytest.mark.parametrize("name", ["udiebot", "eros"])
def test_robots_without_servos_on_a_bus_say_so(name):
    robot = load_robot(name)
    with pytest.raises(UsageError, match=robot.name):
        Treadmill(plan(robot, find_gait(robot)))
