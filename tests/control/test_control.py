"""Control laws against the closed forms that they discretise, observers against the force that was applied."""

import numpy as np
import pytest

from kinlab.control import (
    AT_REST,
    Environment,
    PositionGains,
    SecondOrder,
    compliance_control,
    low_pass,
    observe,
    position_control,
    sampled_radius,
    yield_to,
)
from kinlab.errors import UsageError

TABLE_4_1 = Environment(0.3, 12, 5, 1)
CONCLUSION = Environment(0.2, 9, 5, 9)
TEXT = PositionGains(3.8, 0.2)


@pytest.mark.parametrize("model", [SecondOrder(2.0, 0.05), SecondOrder(5.0, 0.4), SecondOrder(3.0, 0.7)])
def test_peak_overshoot_and_settling_are_those_of_the_step_response(model):
    """(2.16) to (2.18), with the minus that (2.17) leaves out."""
    t = np.linspace(0, 1.2 * model.settling_time, 200_001)
    y = model.step(t)
    assert t[np.argmax(y)] == pytest.approx(model.peak_time, rel=1e-3)
    assert y.max() - 1 == pytest.approx(model.overshoot, rel=1e-5)
    assert np.abs(y[t > model.settling_time] - 1).max() < 0.03
    # (2.19) is a rule of thumb for the time from 10 to 90 per cent.
    rise = t[np.argmax(y > 0.9)] - t[np.argmax(y > 0.1)]
    assert rise == pytest.approx(model.rise_time, rel=0.5)


def test_without_overshoot_there_is_no_peak():
    slow = SecondOrder(2.0, 1.0)
    assert (slow.peak_time, slow.overshoot) == (np.inf, 0.0)
    t = np.linspace(0, 5, 50)
    np.testing.assert_allclose(slow.step(t), 1 - np.exp(-2 * t) * (1 + 2 * t), atol=1e-6)


def test_the_printed_gains_promise_what_chapter_two_says_of_them():
    """Kp 3.8 with Kv 0.2: 1.95 rad/s, damped by a twentieth, 85 % of overshoot after 1.6 s."""
    model = SecondOrder.of_position(3.8, 0.2)
    assert (model.omega, model.zeta) == (pytest.approx(1.949, abs=1e-3), pytest.approx(0.0513, abs=1e-4))
    assert (model.overshoot, model.peak_time) == (
        pytest.approx(0.851, abs=1e-3),
        pytest.approx(1.614, abs=1e-3),
    )


@pytest.mark.parametrize("environment", [TABLE_4_1, CONCLUSION])
def test_the_environment_yields_as_its_second_order_model(environment):
    model = SecondOrder.of_environment(*environment[1:])
    state, dt = AT_REST, 0.001
    angles = []
    for _ in range(4000):
        state = yield_to(environment, state, 2.0, dt)
        angles.append(float(state.angle))
    expected = 2.0 * environment.kf / environment.kenv * model.step(dt * np.arange(1, 4001))
    # The torque sets in within the first sample.
    np.testing.assert_allclose(angles, expected, atol=2e-3 * expected.max())


@pytest.mark.parametrize("dt", [0.016, 1.0, 100.0])
def test_no_sample_time_makes_the_environment_run_away(dt):
    state = AT_REST
    for _ in range(2000):
        state = yield_to(TABLE_4_1, state, np.array([1.0, -2.0]), dt)
    assert np.abs(state.angle).max() < 0.2


def test_sampled_position_control_in_small_steps_is_the_model_with_its_zero():
    """(2.3): the response to a ramp-free step is the step response plus Kv / Kp times its derivative."""
    gains, dt = PositionGains(4.0, 1.2), 1e-4
    theta = rate = 0.0
    found = []
    for _ in range(40_000):
        rate += dt * float(position_control(gains, 1.0, 0.0, theta, rate))
        theta += dt * rate
        found.append(theta)
    model = SecondOrder.of_position(*gains)
    np.testing.assert_allclose(found, model.step(dt * np.arange(1, 40_001)), atol=1e-3)


def test_compliance_control_without_yielding_is_position_control():
    args = (0.3, 0.1, 0.2, -0.1)
    assert compliance_control(TEXT, TABLE_4_1, *args, AT_REST) == position_control(TEXT, *args)


def test_compliance_control_weighs_the_yielding_as_printed():
    given = yield_to(TABLE_4_1, AT_REST, 1.0, 0.016)
    expected = -3.8 * 12 * given.angle - 0.2 * 5 * given.rate - 1 * given.acceleration
    assert compliance_control(TEXT, TABLE_4_1, 0.0, 0.0, 0.0, 0.0, given) == pytest.approx(float(expected))


def test_the_filter_takes_a_step_in_by_its_share():
    y, found = 0.0, []
    for _ in range(100):
        y = float(low_pass(y, 1.0, 0.05))
        found.append(y)
    np.testing.assert_allclose(found, 1 - 0.95 ** np.arange(1, 101))


@pytest.mark.parametrize("cutoff", [10.0, 30.0])
def test_the_disturbance_observer_finds_the_force_applied(cutoff):
    """A motor with a known torque on an inertia, pushed: the estimate follows within its own lag."""
    inertia, dt = 0.02, 0.001
    rate, state, estimates, applied = 0.0, None, [], []
    for k in range(3000):
        push = 0.4 if 500 <= k < 1500 else -0.1
        torque = 0.1 * np.sin(0.01 * k)
        rate += dt / inertia * (torque - push)
        state = observe(state, torque, rate, inertia, cutoff, dt)
        estimates.append(float(state.estimate))
        applied.append(push)
    lag = round(5 / cutoff / dt)
    np.testing.assert_allclose(estimates[500 + lag : 1500], applied[500 + lag : 1500], atol=0.01)
    np.testing.assert_allclose(estimates[1500 + lag :], applied[1500 + lag :], atol=0.01)


def test_the_reaction_observer_leaves_out_what_is_known():
    inertia, dt, weight = 0.02, 0.001, 0.5
    rate, state = 0.0, None
    for _ in range(2000):
        torque, push = 0.8, 0.2
        rate += dt / inertia * (torque - push - weight)
        state = observe(state, torque, rate, inertia, 20.0, dt, known=weight)
    assert float(state.estimate) == pytest.approx(0.2, abs=0.003)


def test_a_sampled_loop_is_stable_below_the_bound_and_runs_away_above_it():
    dt = 0.016
    for kv in (2.0, 10.0, 20.0):
        low, high = 1e-3, 2e4
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if sampled_radius(middle, kv, dt) <= 1 else (low, middle)
        for kp, grows in ((0.9 * low, False), (1.1 * low, True)):
            past, rate, reference = [1.0, 1.0], 0.0, 1.0  # what was reached two cycles ago, and one
            size = []
            for _ in range(4000):
                before, real = past
                rate += dt * (-kp * real - kv * (real - before) / dt)
                past = [real, reference]
                reference += dt * rate
                size.append(abs(reference))
                if abs(reference) > 1e6:
                    break
            assert (max(size[-200:]) > max(size[:200])) == grows


@pytest.mark.parametrize("wrong", [(0.3, 12, 5, 0), (0.3, -1, 5, 1), (np.nan, 12, 5, 1)])
def test_an_environment_that_cannot_be_is_refused(wrong):
    with pytest.raises(UsageError, match="Menv more than 0"):
        Environment(*wrong).check()
