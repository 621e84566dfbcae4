"""Iterative inverse kinematics: it converges to the tolerance in metres, or says why it did not."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinlab.errors import UsageError
from kinlab.kinematics import chain
from kinlab.kinematics.leg import leg_ik
from kinlab.kinematics.numeric import METHODS, TOLERANCE_M, solve
from kinlab.kinematics.transforms import rpy_to_rotation

LENGTHS = (0.025, 0.050, 0.070)
LEG = ([[0, 0, 1], [0, -1, 0], [0, -1, 0]], [[length, 0, 0] for length in LENGTHS])
HEAD = ([[0, 0, 1], [0, 1, 0]], [[0, 0, 0.03], [0, 0, 0.08]])
HUMANOID = (
    [[0, 0, 1], [1, 0, 0], [0, 1, 0], [0, 1, 0], [0, 1, 0], [1, 0, 0]],
    [[0, 0, 0], [0, 0, 0], [0, 0, -0.1064], [0, 0, -0.1064], [0, 0, 0], [0, 0, -0.0383]],
)
TARGET = np.array([0.075, 0.010, -0.046])
# From here every one of the six finds the knee-up solution of TARGET.
NEAR = np.radians([5, 30, -105])
every_method = pytest.mark.parametrize("method", METHODS)


def distance(legs, q, target):
    return np.linalg.norm(chain.fk(*legs, q)[:3, 3] - target)


@every_method
def test_each_method_finds_the_closed_forms_solution(method):
    found = solve(*LEG, TARGET, NEAR, method=method)
    assert found.method == method
    assert found.converged, found.reason
    assert found.reason == "converged"
    assert distance(LEG, found.q, TARGET) <= TOLERANCE_M * 1.001
    np.testing.assert_allclose(found.q, leg_ik(TARGET, *LENGTHS).q, atol=1e-7)


@every_method
def test_the_tolerance_is_a_length_in_metres(method):
    """A tolerance of 1 mm stops as soon as the tip is within 1 mm, whatever the links' lengths."""
    for tolerance in (1e-3, 1e-6, 1e-11):
        found = solve(*LEG, TARGET, NEAR, method=method, tolerance_m=tolerance)
        assert found.converged
        assert found.residual_m <= tolerance
        assert all(step.residual_m > tolerance for step in found.trace[:-1])


@settings(max_examples=40)
@given(
    st.sampled_from(sorted(METHODS)),
    st.tuples(*[st.floats(-0.2, 0.2)] * 3),
    st.tuples(*[st.floats(-3, 3)] * 3),
)
def test_success_is_claimed_exactly_within_the_tolerance_and_failure_has_a_reason(method, target, start):
    found = solve(*LEG, target, start, method=method)
    missed = distance(LEG, found.q, target)
    assert found.residual_m == pytest.approx(missed, abs=1e-12)
    assert found.converged == (found.residual_m <= TOLERANCE_M)
    assert (found.reason == "converged") == found.converged
    assert found.reason
    assert (np.abs(found.q) <= np.pi).all()


@every_method
def test_the_trace_begins_at_the_start_ends_at_the_result_and_tells_each_residual(method):
    found = solve(*LEG, TARGET, NEAR, method=method)
    assert len(found.trace) == found.iterations + 1
    np.testing.assert_array_equal(found.trace[0].q, NEAR)
    np.testing.assert_allclose(np.exp(1j * found.trace[-1].q), np.exp(1j * found.q), atol=1e-15)
    for step in found.trace:
        assert step.residual_m == pytest.approx(distance(LEG, step.q, TARGET), abs=1e-15)
    assert found.residual_m == found.trace[-1].residual_m


@every_method
def test_a_start_at_the_target_takes_no_step(method):
    found = solve(*LEG, chain.fk(*LEG, NEAR)[:3, 3], NEAR, method=method)
    assert found.converged
    assert found.iterations == 0
    np.testing.assert_array_equal(found.q, NEAR)


@every_method
def test_a_target_out_of_reach_is_never_claimed(method):
    found = solve(*LEG, [0.3, 0, 0], NEAR, method=method)
    assert not found.converged
    assert found.residual_m >= 0.3 - sum(LENGTHS) - 1e-12
    assert found.reason not in ("", "converged")


@every_method
@pytest.mark.parametrize("target", [[np.nan, 0, 0], [np.inf, 0, 0], [1e300, 0, 0]])
def test_a_target_that_is_no_number_is_a_stated_failure(method, target):
    found = solve(*LEG, target, NEAR, method=method)
    assert not found.converged
    assert "not finite" in found.reason
    assert found.iterations == 0


def test_rate_control_cannot_leave_a_singular_pose_and_says_so():
    found = solve(*LEG, TARGET, [0, 0, 0], method="rmrc")
    assert not found.converged
    assert "singular" in found.reason


def test_rate_control_needs_as_many_joints_as_coordinates_and_says_so():
    found = solve(*HEAD, chain.fk(*HEAD, [0.5, 0.4])[:3, 3], [0.1, 0.1], method="rmrc")
    assert not found.converged
    assert "2 joints cannot follow 3 coordinates" in found.reason


def test_rate_control_halves_its_step_where_the_inverse_is_inaccurate():
    """Step 5 of the paper's algorithm, close to the stretched leg."""
    found = solve(*LEG, TARGET, [0.1, 0.2, 1e-11], method="rmrc", max_iterations=3)
    assert "halved" in found.trace[1].note


@pytest.mark.parametrize("method", ["dls", "lm", "ccd"])
def test_damped_steps_and_single_joints_leave_a_singular_pose(method):
    found = solve(*LEG, TARGET, [0, 0, 0], method=method)
    assert found.converged, found.reason


@pytest.mark.parametrize("method", ["dls", "gauss-newton", "lm", "ccd"])
def test_a_chain_of_two_joints_follows_targets_on_its_sphere(method):
    found = solve(*HEAD, chain.fk(*HEAD, [0.5, 0.4])[:3, 3], [0.1, 0.1], method=method)
    assert found.converged, found.reason
    np.testing.assert_allclose(found.q, [0.5, 0.4], atol=1e-6)


def test_damping_is_noted_only_near_singular_poses():
    found = solve(*LEG, TARGET, [0, 0, 0], method="dls")
    assert found.trace[1].note.startswith("damped")
    assert found.trace[-1].note == ""


def test_newton_is_quadratic_near_the_solution():
    found = solve(*LEG, TARGET, NEAR, method="newton", tolerance_m=1e-14)
    residuals = [step.residual_m for step in found.trace]
    assert found.converged
    assert residuals[-2] < 1e-5
    assert residuals[-1] < 1e3 * residuals[-2] ** 2 + 1e-16


@pytest.mark.parametrize("method", [m for m in METHODS if m != "ccd"])
def test_an_attitude_is_followed_to_the_same_tolerance_along_its_arc(method):
    q = np.radians([10, -15, -40, 70, -25, 12])
    T = chain.fk(*HUMANOID, q)
    found = solve(*HUMANOID, T[:3, 3], q + 0.05, method=method, rotation=T[:3, :3])
    assert found.converged, found.reason
    np.testing.assert_allclose(chain.fk(*HUMANOID, found.q), T, atol=1e-8)


def test_coordinate_descent_turns_every_joint_towards_the_attitude_too():
    q = np.radians([10, -15, -40, 70, -25, 12])
    T = chain.fk(*HUMANOID, q)
    found = solve(*HUMANOID, T[:3, 3], q + 0.05, method="ccd", rotation=T[:3, :3])
    residuals = [step.residual_m for step in found.trace]
    assert residuals[-1] < residuals[0] / 10
    assert all(after <= before * (1 + 1e-9) for before, after in pairwise(residuals))


def test_an_attitude_that_no_pose_has_is_not_claimed():
    T = chain.fk(*HUMANOID, np.zeros(6))
    found = solve(*HUMANOID, T[:3, 3], np.full(6, 0.1), rotation=rpy_to_rotation([0, 1.5, 0]))
    assert not found.converged


def test_a_method_is_found_by_its_beginning_and_an_unknown_one_refused():
    assert solve(*LEG, TARGET, NEAR, method="gauss").method == "gauss-newton"
    with pytest.raises(UsageError, match="no method is named 'lma'; did you mean lm"):
        solve(*LEG, TARGET, NEAR, method="lma")


def test_lists_and_float32_are_taken_and_the_start_is_left_alone():
    start = NEAR.astype(np.float32)
    found = solve(*LEG, TARGET.tolist(), start)
    assert found.converged
    assert found.q.dtype == np.float64
    np.testing.assert_array_equal(start, NEAR.astype(np.float32))


@every_method
def test_the_residual_is_that_of_the_angles_given_back_however_often_they_went_round(method):
    found = solve(*LEG, [0, 0, 0], [0, 0, 1e-9], method=method)
    assert found.residual_m == pytest.approx(distance(LEG, found.q, [0, 0, 0]), abs=1e-15)
