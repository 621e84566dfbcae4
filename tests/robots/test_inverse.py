"""Inverse kinematics of every limb of the five robots: exact, complete, within the limits or refused."""

import numpy as np
import pytest

import kinlab
from kinlab.errors import UsageError
from kinlab.kinematics.transforms import rpy_to_rotation
from kinlab.robots.inverse import nearest
from kinlab.robots.model import LIMIT_SLACK

ROBOTS = kinlab.load_robots()
LIMBS = {f"{robot.name} {limb.name}": limb for robot in ROBOTS.values() for limb in robot.limbs.values()}
TIGHT = 1e-12  # m, which is 1e-9 mm

every_limb = pytest.mark.parametrize("limb", LIMBS.values(), ids=LIMBS)
a_few = pytest.mark.parametrize(
    "limb",
    [
        LIMBS[n]
        for n in (
            "xl430-hexapod R1",
            "udiebot LF",
            "eros right_leg",
            "eros left_arm",
            "receptionist-arm left_arm",
        )
    ],
    ids=repr,
)


def count(limb, many):
    """Iterated limbs cost milliseconds a target."""
    return many if limb.closed_form else 15


def answer(limb, T):
    return limb.ik(T[..., :3, 3], T[..., :3, :3] if len(limb.joints) >= 6 else None)


def missed(limb, q, T):
    return np.linalg.norm(limb.fk(q)[..., :3, 3] - T[..., :3, 3], axis=-1)


def special_angles(limb, rng, size):
    """Joints at their limits and at multiples of 90 deg where the limits allow, some a hair beside."""
    lower, upper = limb.limits
    quarters = np.clip(np.arange(-2, 3) * np.pi / 2, lower[:, None], upper[:, None])
    picks = np.concatenate([quarters, lower[:, None], upper[:, None]], axis=1)
    q = picks[np.arange(len(lower)), rng.integers(0, picks.shape[1], (size, len(lower)))]
    beside = rng.choice([0, 0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5], q.shape) * rng.choice([-1, 1], q.shape)
    return np.clip(q + beside, lower, upper)


@every_limb
def test_fk_after_ik_is_the_identity_over_the_whole_workspace(limb):
    lower, upper = limb.limits
    T = limb.fk(np.random.default_rng(1).uniform(lower, upper, (count(limb, 20_000), len(lower))))
    found = answer(limb, T)
    assert found.reachable.all()
    assert found.exists.all()
    assert missed(limb, found.q, T).max() < TIGHT


@every_limb
def test_fk_after_ik_is_the_identity_at_limits_and_singular_poses(limb):
    T = limb.fk(special_angles(limb, np.random.default_rng(2), count(limb, 5000)))
    found = answer(limb, T)
    assert found.reachable.all()
    assert missed(limb, found.q, T).max() < TIGHT
    if len(limb.joints) >= 6:
        np.testing.assert_allclose(limb.fk(found.q)[:, :3, :3], T[:, :3, :3], atol=1e-12)


@every_limb
def test_every_solution_is_a_solution_and_the_one_it_came_from_is_among_them(limb):
    lower, upper = limb.limits
    q = np.random.default_rng(3).uniform(lower, upper, (count(limb, 5000), len(lower)))
    T = limb.fk(q)
    found = answer(limb, T)
    assert found.solutions.shape == (len(q), len(found.names), len(lower))
    assert np.nanmax(missed(limb, found.solutions, T[:, None])) < TIGHT
    away = np.abs(np.angle(np.exp(1j * (found.solutions - q[:, None])))).max(axis=-1)
    assert np.nanmin(away, axis=1).max() < 1e-6


@every_limb
def test_the_chosen_solution_is_the_first_within_the_limits(limb):
    lower, upper = limb.limits
    q = np.random.default_rng(4).uniform(lower, upper, (count(limb, 2000), len(lower)))
    found = answer(limb, limb.fk(q))
    assert (found.q >= lower - LIMIT_SLACK).all()
    assert (found.q <= upper + LIMIT_SLACK).all()
    rows = np.arange(len(q))
    np.testing.assert_array_equal(found.q, found.solutions[rows, found.chosen])
    np.testing.assert_array_equal(found.chosen, np.argmax(found.within_limits, axis=1))
    inside = (found.solutions >= lower - LIMIT_SLACK) & (found.solutions <= upper + LIMIT_SLACK)
    np.testing.assert_array_equal(found.within_limits, inside.all(axis=-1))


@a_few
def test_a_target_that_only_forbidden_poses_reach_is_refused_and_its_solutions_still_listed(limb):
    """Nothing is clipped: a pose at its limit would be somewhere else."""
    rng = np.random.default_rng(5)
    T = limb.fk(rng.uniform(-np.pi, np.pi, (count(limb, 2000), len(limb.joints))))
    found = answer(limb, T)
    refused = found.exists & ~found.reachable
    assert refused.any()
    assert np.isnan(found.q[refused]).all()
    assert (found.chosen[refused] == -1).all()
    assert not found.within_limits[refused].any()
    assert np.isfinite(found.solutions[refused]).any(axis=(-1, -2)).all()
    assert np.nanmax(missed(limb, found.solutions, T[:, None])) < TIGHT


def test_a_leg_has_two_solutions_forwards_and_up_to_two_backwards():
    leg = LIMBS["xl430-hexapod R1"]
    assert leg.ik([0.075, 0.010, -0.046]).names == leg.closed_form.names
    assert np.isfinite(leg.ik([0.110, 0.0, -0.046]).solutions[:, 0]).tolist() == [True, True, False, False]
    assert np.isfinite(leg.ik([0.040, 0.0, -0.046]).solutions[:, 0]).tolist() == [True] * 4


def test_angles_are_turned_by_a_whole_turn_where_that_brings_them_within_the_limits():
    arm = LIMBS["eros right_arm"]
    found = arm.ik(arm.fk([np.pi, 0.3, -1.0])[:3, 3])
    assert found.reachable
    assert (np.abs(found.q) <= np.pi + LIMIT_SLACK).all()


@a_few
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e300])
def test_what_is_no_number_or_no_place_is_unreachable_without_a_warning(limb, bad):
    for axis in range(3):
        target = np.array([0.05, 0.01, -0.1])
        target[axis] = bad
        found = limb.ik(target)
        assert not found.reachable
        assert not found.exists
        assert np.isnan(found.q).all()
        assert np.isnan(found.solutions).all()


@a_few
def test_leading_dimensions_broadcast_and_lists_and_float32_are_taken(limb):
    target = np.array([0.05, 0.01, -0.1])
    one = limb.ik(target)
    n, k = len(limb.joints), len(one.names)
    many = limb.ik(np.broadcast_to(target, (2, 3, 3)))
    assert one.q.shape == (n,)
    assert many.q.shape == (2, 3, n)
    assert many.solutions.shape == (2, 3, k, n)
    assert many.within_limits.shape == (2, 3, k)
    assert many.reachable.shape == many.exists.shape == many.chosen.shape == (2, 3)
    np.testing.assert_array_equal(many.q[1, 2], one.q)
    np.testing.assert_array_equal(limb.ik(target.tolist()).q, one.q)
    assert limb.ik(target.astype(np.float32)).q.dtype == np.float64
    empty = limb.ik(np.empty((0, 3)))
    assert empty.q.shape == (0, n)
    assert empty.solutions.shape == (0, k, n)


def test_attitudes_broadcast_against_targets():
    leg = LIMBS["eros right_leg"]
    R = rpy_to_rotation([[0, 0, 0.1], [0, 0.1, 0], [0.1, 0, 0]])
    found = leg.ik([0.01, 0, -0.22], R)
    assert found.q.shape == (3, 6)
    np.testing.assert_allclose(leg.fk(found.q)[:, :3, :3], R, atol=1e-12)


def test_six_joints_stand_level_where_no_attitude_is_given():
    leg = LIMBS["eros left_leg"]
    np.testing.assert_allclose(leg.fk(leg.ik([0.01, 0.02, -0.22]).q)[:3, :3], np.eye(3), atol=1e-12)


@pytest.mark.parametrize("target", [0.1, [0.1, 0.2], [[0.1, 0.2, 0.3, 0.4]], None])
def test_a_target_is_three_numbers(target):
    with pytest.raises(UsageError, match="three numbers"):
        LIMBS["xl430-hexapod R1"].ik(target)


def test_a_limb_of_three_joints_cannot_be_given_an_attitude():
    with pytest.raises(UsageError, match="cannot choose its attitude"):
        LIMBS["xl430-hexapod R1"].ik([0.1, 0, 0], np.eye(3))


@a_few
@pytest.mark.parametrize(
    "target", [[1, 0, 0], [0.3, 0.1, 0.2], [0, 0, 0], [0, 0, -5], [0.001, 0, 0.001], [-0.2, 0.1, 0]]
)
def test_the_nearest_point_is_reachable_and_nearer_than_all_of_a_dense_sample(limb, target):
    point = nearest(limb, target)
    lower, upper = limb.limits
    q = np.random.default_rng(6).uniform(lower, upper, (100_000, len(lower)))
    sampled = np.linalg.norm(limb.fk(q)[:, :3, 3] - target, axis=1).min()
    assert np.linalg.norm(point - target) <= sampled + 1e-12
    if len(lower) < 6:
        assert np.linalg.norm(nearest(limb, point) - point) < 1e-9


@a_few
def test_the_nearest_point_of_a_far_target_depends_on_its_direction_alone(limb):
    far, further = nearest(limb, [1e12, 0, -1e12]), nearest(limb, [1e300, 0, -1e300])
    np.testing.assert_allclose(far, further, atol=1e-9)


def test_the_nearest_point_beyond_the_stretched_leg_lies_on_the_line_to_it():
    np.testing.assert_allclose(nearest(LIMBS["xl430-hexapod R1"], [1, 0, 0]), [0.145, 0, 0], atol=1e-12)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_no_point_is_nearest_to_what_is_no_number(bad):
    with pytest.raises(UsageError, match="finite"):
        nearest(LIMBS["xl430-hexapod R1"], [bad, 0, 0])


def test_an_inverse_says_in_a_notebook_what_it_found():
    leg = LIMBS["xl430-hexapod R1"]
    assert repr(leg.ik([0.075, 0.010, -0.046])) == "<Inverse: knee-up, [7.595, 28.275, -112.841] deg>"
    assert repr(leg.ik([1, 0, 0])) == "<Inverse: unreachable>"
    assert repr(leg.ik([[0.08, 0, 0], [1, 0, 0]])) == "<Inverse of 2 targets: 1 reachable>"
