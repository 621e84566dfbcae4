"""Profiles of time, and following a path by the inverse of the Jacobian."""

import numpy as np
import pytest

import kinlab
from kinlab.kinematics import chain
from kinlab.kinematics.profile import PROFILES, RAMP
from kinlab.kinematics.resolved_motion import follow, inverse_step, straight_line

ARM = kinlab.load_robot("receptionist-arm").limb()
START = np.radians([45.0, 0.0, 147.5])
LINE = np.array([0.2, 0, 0])
every_profile = pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)


@every_profile
def test_a_profile_goes_from_nothing_to_all_and_stays_there(profile):
    s, rate, _ = profile(np.array([-1.0, 0.0, 1.0, 2.0, 5.0]), 2.0)
    np.testing.assert_allclose(s, [0, 0, 0.5, 1, 1])
    assert rate[0] == rate[-1] == 0
    assert (np.diff(profile(np.linspace(0, 2, 500), 2.0)[0]) > 0).all()


@every_profile
def test_rate_and_change_of_rate_are_the_derivatives(profile):
    t = np.linspace(0.05, 1.95, 401)
    t = t[(np.abs(t - 2 * RAMP) > 1e-3) & (np.abs(t - 2 + 2 * RAMP) > 1e-3)]
    h = 1e-6
    before, now, after = (profile(t + d, 2.0) for d in (-h, 0, h))
    np.testing.assert_allclose((after[0] - before[0]) / (2 * h), now[1], atol=1e-8)
    np.testing.assert_allclose((after[1] - before[1]) / (2 * h), now[2], atol=1e-8)


def test_trapezoid_and_quintic_start_and_end_at_rest_where_steps_do_not():
    nearly = np.array([1e-9, 2 - 1e-9])
    assert np.abs(PROFILES["trapezoid"](nearly, 2.0)[1]).max() < 1e-8
    assert np.abs(PROFILES["quintic"](nearly, 2.0)[1:]).max() < 1e-7
    np.testing.assert_allclose(PROFILES["steps"](nearly, 2.0)[1], 0.5)


@pytest.mark.parametrize("name", PROFILES)
def test_a_line_is_followed_within_the_curvature_of_one_step(name):
    tip = ARM.fk(START)[:3, 3]
    t, points = straight_line(tip, tip + LINE, PROFILES[name], 1.28, 0.016)
    track = follow(ARM.axes, ARM.links, START, points, 0.016)
    assert len(t) == 81
    np.testing.assert_allclose(points[[0, -1]], [tip, tip + LINE], atol=1e-15)
    assert track.off.max() < 1e-4
    np.testing.assert_allclose(track.q[:, 1], 0, atol=1e-12)


def test_away_from_singularities_the_step_is_the_inverse_of_the_jacobian():
    q, dX = np.array([0.3, 0.4, 1.2]), np.array([1e-3, -2e-3, 5e-4])
    step = inverse_step(ARM.axes, ARM.links, q, dX)
    assert (step.damping, step.lost) == (0.0, None)
    np.testing.assert_allclose(ARM.jacobian(q)[:3] @ step.dq, dX, atol=1e-15)


def test_the_papers_path_runs_through_a_singularity_of_the_shoulders_roll():
    """Where cos(theta2) = -L1 / L2 the hand is on the roll's own axis, and no roll moves it."""
    q = np.array([0.5, 0.0, np.arccos(-0.185 / 0.250)])
    assert np.abs(chain.jacobian(ARM.axes, ARM.links, q)[:3, 1]).max() < 1e-15
    step = inverse_step(ARM.axes, ARM.links, q, [0, 1e-3, 0])
    assert ARM.joint_names[step.lost] == "shoulder_roll"
    assert step.damping > 0
    assert np.abs(step.dq).max() < 1e-9, "a step that cannot be made is not made"


def test_a_stretched_arm_loses_the_elbow_or_the_shoulder_and_does_not_run_away():
    step = inverse_step(ARM.axes, ARM.links, np.array([0.2, 0.1, 0.0]), [0, 0, 0.01])
    assert step.damping > 0
    assert np.abs(step.dq).max() < 1.0
