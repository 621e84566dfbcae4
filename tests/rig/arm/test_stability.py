"""The stability map: what it calls settled, oscillating and run away, and the linear model's bounds in it."""

import numpy as np
import pytest

from kinlab.control import Environment, PositionGains, SecondOrder
from kinlab.errors import UsageError
from kinlab.rig.arm import Settings, Setup
from kinlab.rig.arm.stability import (
    OSCILLATES,
    RUNS_AWAY,
    SETTLES,
    reversals,
    scale,
    settings_for,
    sweep,
    with_gains,
)


def test_swings_are_counted_and_the_servos_resolution_is_not():
    t = np.linspace(0, 3, 600)
    assert reversals(np.radians(10) * np.sin(2 * np.pi * t)) == 6
    assert reversals(np.radians(0.5) * np.sin(2 * np.pi * t)) == 0
    assert reversals(np.radians(20) * (1 - np.exp(-3 * t))) == 0


def test_gentle_gains_settle_strong_ones_oscillate_and_stronger_ones_run_away(robot, limb):
    found = sweep(robot, limb, Settings(), Setup(), ("kp", [3.0, 30.0, 400.0]), ("kv", [1.0]))
    assert found.state.tolist() == [[SETTLES, OSCILLATES, RUNS_AWAY]]
    assert np.isnan(found.when[0, :2]).all()
    assert 0 < found.when[0, 2] < 3


def test_the_bounds_are_those_of_the_linear_model(robot, limb):
    calls = []
    found = sweep(
        robot,
        limb,
        Settings(),
        Setup(),
        ("kp", [4.0, 9.0]),
        ("kv", scale((0.5, 100), 2)),
        lambda: calls.append(1),
    )
    np.testing.assert_allclose(found.critical, [4.0, 6.0], rtol=0.02)
    assert SecondOrder.of_position(4.0, 4.0).zeta == 1
    # Sampled with a delay of one cycle, Kv alone is stable up to 1 / dt.
    np.testing.assert_allclose(found.sampled, 1 / 0.016, rtol=0.05)
    assert len(calls) == 4


def test_gains_of_the_environment_are_swept_under_compliance(robot, limb):
    base = settings_for(Settings(gains=PositionGains(20, 8)), "denv", "kenv")
    assert base.law == "compliance"
    found = sweep(robot, limb, base, Setup(slope=32), ("kenv", [1.0]), ("denv", [0.1, 10.0]))
    assert found.sampled is None
    np.testing.assert_allclose(found.critical, [2.0], rtol=0.02)
    assert with_gains(base, {"kenv": 3.0}).environment == Environment(0.3, 3.0, 5, 1)


@pytest.mark.parametrize(
    ("x", "y", "complaint"),
    [
        (("kp", [1.0]), ("kp", [1.0]), "two different gains"),
        (("kp", [1.0]), ("kw", [1.0]), "no gain of position control is named 'kw'"),
        (("kp", [-1.0]), ("kv", [1.0]), "finite and more than 0"),
    ],
)
def test_a_map_that_cannot_be_is_refused(robot, limb, x, y, complaint):
    with pytest.raises(UsageError, match=complaint):
        sweep(robot, limb, Settings(), Setup(), x, y)


@pytest.mark.parametrize(
    ("span", "count"), [((0, 1), 5), ((2, 1), 5), ((1, np.inf), 5), ((1, 2), 1), ((1, 2), 10**6)]
)
def test_a_range_that_cannot_be_is_refused(span, count):
    with pytest.raises(UsageError):
        scale(span, count)
