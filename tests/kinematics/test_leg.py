"""The three-joint leg: its signs, its reach, and all four ways to a foot."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.kinematics.blocks import BLOCK
from kinlab.kinematics.leg import leg_fk, leg_ik

# Coxa, femur, tibia in metres: ordinary, without coxa, equal links, tibia the shorter, coxa longest.
LEGS = [
    (0.025, 0.050, 0.070),
    (0.0, 0.150, 0.150),
    (0.060, 0.150, 0.150),
    (0.030, 0.080, 0.020),
    (0.300, 0.050, 0.070),
]
WAYS = [(knee, back) for knee in (True, False) for back in (True, False)]
TIGHT = 1e-12  # m, which is 1e-9 mm

turns = st.floats(-np.pi, np.pi)
quarters = st.sampled_from([k * np.pi / 2 for k in range(-2, 3)])
# Poses anywhere, and poses at or a little off the singular ones.
angle = (
    turns | quarters | st.builds(lambda q, e: q + e, quarters, st.sampled_from([1e-15, 1e-9, -1e-7, 1e-5]))
)
legs = st.sampled_from(LEGS)


def errors_of_all_ways(foot, leg):
    """The distance by which each way misses `foot`, NaN for those that do not exist."""
    found = [leg_ik(foot, *leg, knee_up=knee, backwards=back) for knee, back in WAYS]
    return np.stack([np.linalg.norm(leg_fk(q, *leg) - foot, axis=-1) for q, _ in found], axis=-1)


@pytest.mark.parametrize("leg", LEGS)
def test_a_foot_anywhere_in_the_workspace_is_reached_to_a_billionth_of_a_millimetre(leg):
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (50_000, 3))
    errors = errors_of_all_ways(leg_fk(q, *leg), leg)
    assert np.isfinite(np.nanmin(errors, axis=1)).all()
    assert np.nanmax(errors) < TIGHT


@given(legs, st.tuples(angle, angle, angle))
def test_every_way_that_is_found_reaches_the_foot_at_singular_poses_too(leg, q):
    foot = leg_fk(q, *leg)
    errors = errors_of_all_ways(foot, leg)
    assert np.isfinite(errors).any(), "a pose of the leg must be reachable"
    assert np.nanmax(errors) < TIGHT


@given(legs, turns, turns, st.floats(-3, 3))
def test_the_pose_that_a_foot_came_from_is_among_the_ways(leg, alpha, beta, gamma):
    q = np.array([alpha, beta, gamma])
    found = np.stack([leg_ik(leg_fk(q, *leg), *leg, knee_up=k, backwards=b).q for k, b in WAYS])
    away = np.abs(np.angle(np.exp(1j * (found - q)))).max(axis=1)
    r = leg[0] + leg[1] * np.cos(beta) + leg[2] * np.cos(beta + gamma)
    if abs(r) > 1e-6 and abs(np.sin(gamma)) > 1e-6:
        assert np.nanmin(away) < 1e-6


@pytest.mark.parametrize(
    ("q", "foot"),
    [
        ([0, 0, 0], (0.145, 0, 0)),
        ([np.pi / 2, 0, 0], (0, 0.145, 0)),
        ([0, np.pi / 2, 0], (0.025, 0, 0.120)),
        ([0, 0, np.pi / 2], (0.075, 0, 0.070)),
        ([0, 0, -np.pi / 2], (0.075, 0, -0.070)),
    ],
    ids=["zero pose", "coxa to the left", "femur up", "tibia up", "tibia down"],
)
def test_each_joint_counts_counter_clockwise(q, foot):
    np.testing.assert_allclose(leg_fk(q, *LEGS[0]), foot, atol=1e-16)


def test_the_papers_target_has_the_papers_angles():
    q, reachable = leg_ik([0.075, 0.010, -0.046], *LEGS[0])
    assert reachable
    np.testing.assert_allclose(np.degrees(q), [7.595, 28.275, -112.843], atol=0.005)


@pytest.mark.parametrize("leg", LEGS)
def test_knee_up_bends_the_tibia_down_and_knee_down_up(leg):
    foot = leg_fk(np.random.default_rng(2).uniform(-2, 2, (1000, 3)), *leg)
    for back in (True, False):
        assert not (leg_ik(foot, *leg, knee_up=True, backwards=back).q[:, 2] > 0).any()
        assert not (leg_ik(foot, *leg, knee_up=False, backwards=back).q[:, 2] < 0).any()


@pytest.mark.parametrize("leg", LEGS)
def test_backwards_turns_the_coxa_away_from_the_foot(leg):
    foot = leg_fk(np.random.default_rng(3).uniform(-2, 2, (1000, 3)), *leg)
    for back, towards in ((False, 1.0), (True, -1.0)):
        alpha = leg_ik(foot, *leg, backwards=back).q[:, 0]
        along = np.cos(alpha) * foot[:, 0] + np.sin(alpha) * foot[:, 1]
        known = np.isfinite(alpha)
        np.testing.assert_allclose(along[known], towards * np.hypot(*foot[known, :2].T), atol=1e-15)


@pytest.mark.parametrize("leg", LEGS)
@pytest.mark.parametrize("back", [False, True])
def test_the_reach_is_the_ring_between_femur_less_tibia_and_femur_plus_tibia(leg, back):
    coxa, femur, tibia = leg
    foot = np.random.default_rng(4).uniform(-0.4, 0.4, (20_000, 3))
    r = (-1 if back else 1) * np.hypot(foot[:, 0], foot[:, 1]) - coxa
    d = np.hypot(r, foot[:, 2])
    inside = (d <= femur + tibia) & (d >= abs(femur - tibia))
    q, reachable = leg_ik(foot, *leg, backwards=back)
    np.testing.assert_array_equal(reachable, inside)
    np.testing.assert_array_equal(np.isnan(q), np.repeat(~inside[:, None], 3, axis=1))


@pytest.mark.parametrize("leg", LEGS)
@pytest.mark.parametrize(("outside", "counts"), [(0.0, True), (5e-13, True), (1e-11, False), (1e-6, False)])
def test_the_boundary_belongs_to_the_reach_within_a_billionth_of_a_millimetre(leg, outside, counts):
    coxa, femur, tibia = leg
    beta = np.random.default_rng(5).uniform(-np.pi / 2, np.pi / 2, 200)
    reach = femur + tibia + outside
    foot = np.stack([coxa + reach * np.cos(beta), 0 * beta, reach * np.sin(beta)], axis=-1)
    q, reachable = leg_ik(foot, *leg)
    assert (reachable == counts).all()
    if counts:
        assert np.linalg.norm(leg_fk(q, *leg) - foot, axis=1).max() < TIGHT


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.filterwarnings("ignore:invalid value")
def test_what_is_no_number_is_unreachable(bad, place):
    foot = np.array([0.075, 0.010, -0.046])
    foot[place] = bad
    q, reachable = leg_ik(foot, *LEGS[0])
    assert not reachable
    assert np.isnan(q).all()


def test_leading_dimensions_broadcast_and_empty_batches_stay_empty():
    foot = np.full((4, 5, 3), 0.05)
    q, reachable = leg_ik(foot, *LEGS[0])
    assert q.shape == leg_fk(q, *LEGS[0]).shape == (4, 5, 3)
    assert reachable.shape == (4, 5)
    q, reachable = leg_ik(np.empty((0, 3)), *LEGS[0])
    assert q.shape == (0, 3)
    assert reachable.shape == (0,)
    assert leg_fk(np.empty((0, 3)), *LEGS[0]).shape == (0, 3)
    q, reachable = leg_ik([0.075, 0.010, -0.046], *LEGS[0])
    assert q.shape == (3,)
    assert reachable.shape == ()


def test_lists_float32_and_strided_arrays_are_taken_and_left_alone():
    foot = np.random.default_rng(6).uniform(0.03, 0.07, (10, 3))
    wanted = leg_ik(foot, *LEGS[0]).q
    np.testing.assert_array_equal(leg_ik(foot.tolist(), *LEGS[0]).q, wanted)
    np.testing.assert_array_equal(leg_ik(np.asfortranarray(foot), *LEGS[0]).q, wanted)
    np.testing.assert_array_equal(leg_ik(np.repeat(foot, 2, axis=1)[:, ::2], *LEGS[0]).q, wanted)
    single = foot.astype(np.float32)
    kept = single.copy()
    assert leg_ik(single, *LEGS[0]).q.dtype == np.float64
    np.testing.assert_array_equal(single, kept)
    np.testing.assert_array_equal(leg_fk(wanted, *LEGS[0]), leg_fk(wanted.tolist(), *LEGS[0]))


def test_a_batch_longer_than_a_block_is_no_different_from_its_rows():
    foot = np.random.default_rng(7).uniform(-0.1, 0.1, (2 * BLOCK + 3, 3))
    q, reachable = leg_ik(foot, *LEGS[0])
    for i in (0, BLOCK - 1, BLOCK, 2 * BLOCK + 2):
        one = leg_ik(foot[i], *LEGS[0])
        assert one.reachable == reachable[i]
        np.testing.assert_allclose(one.q, q[i], atol=1e-15)
