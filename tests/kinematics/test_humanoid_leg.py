"""The six-joint leg: all eight ways to a pose of the sole."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.kinematics import chain
from kinlab.kinematics.closed_form import recognise
from kinlab.kinematics.humanoid_leg import NAMES, humanoid_leg_ik

AXES = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0], [0, 1, 0], [0, 1, 0], [1, 0, 0]], float)
# Thigh, shank, foot in metres: equal, unequal, without a foot.
LEGS = [(0.1064, 0.1064, 0.0383), (0.15, 0.08, 0.03), (0.08, 0.15, 0.0)]
TIGHT = 1e-12

turns = st.floats(-np.pi, np.pi)
quarters = st.sampled_from([k * np.pi / 2 for k in range(-2, 3)])
angle = (
    turns | quarters | st.builds(lambda q, e: q + e, quarters, st.sampled_from([1e-15, 1e-9, -1e-7, 1e-5]))
)


def links(leg):
    thigh, shank, foot = leg
    return np.array([[0, 0, -length] for length in (0, 0, thigh, shank, 0, foot)])


def misses(pose, q, leg):
    """Position error in metres and attitude error, for every way (..., 8)."""
    gap = chain.fk(AXES, links(leg), q) - pose[..., None, :, :]
    return np.linalg.norm(gap[..., :3, 3], axis=-1), np.abs(gap[..., :3, :3]).max(axis=(-1, -2))


@pytest.mark.parametrize("leg", LEGS)
def test_all_eight_ways_give_any_pose_of_the_sole_back(leg):
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (20_000, 6))
    pose = chain.fk(AXES, links(leg), q)
    found, reachable = humanoid_leg_ik(pose, *leg)
    assert reachable.all()
    place, attitude = misses(pose, found, leg)
    assert place.max() < TIGHT
    assert attitude.max() < 1e-12


@given(st.sampled_from(LEGS), st.tuples(*[angle] * 6))
def test_singular_poses_are_given_back_as_exactly(leg, q):
    pose = chain.fk(AXES, links(leg), np.array(q))
    found, reachable = humanoid_leg_ik(pose, *leg)
    assert reachable
    place, attitude = misses(pose, found, leg)
    assert place.max() < TIGHT
    assert attitude.max() < 1e-12


def test_the_pose_that_a_sole_came_from_is_among_the_eight():
    q = np.random.default_rng(2).uniform(-np.pi, np.pi, (20_000, 6))
    found, _ = humanoid_leg_ik(chain.fk(AXES, links(LEGS[0]), q), *LEGS[0])
    away = np.abs(np.angle(np.exp(1j * (found - q[:, None])))).max(axis=-1).min(axis=-1)
    assert np.quantile(away, 0.99) < 1e-9
    assert away.max() < 1e-6


def test_a_generic_pose_has_eight_different_ways_in_the_order_of_their_names():
    q = np.radians([10, -15, -40, 70, -25, 12])
    found, _ = humanoid_leg_ik(chain.fk(AXES, links(LEGS[0]), q), *LEGS[0])
    assert len(NAMES) == len(found) == 8
    gaps = np.abs(np.angle(np.exp(1j * (found[:, None] - found[None])))).max(axis=-1)
    assert gaps[~np.eye(8, dtype=bool)].min() > 0.01
    np.testing.assert_allclose(found[NAMES.index("knee-forwards")], q, atol=1e-12)
    for name, way in zip(NAMES, found, strict=True):
        assert (way[3] > 0) == name.startswith("knee-forwards")


@pytest.mark.parametrize(("gap", "counts"), [(5e-13, True), (1e-11, False), (0.01, False)])
def test_a_sole_too_far_away_is_unreachable(gap, counts):
    thigh, shank, foot = LEGS[0]
    pose = np.eye(4)
    pose[2, 3] = -(thigh + shank + foot + gap)
    q, reachable = humanoid_leg_ik(pose, *LEGS[0])
    assert reachable == counts
    assert np.isnan(q).all() == (not counts)


def test_an_ankle_nearer_to_the_hip_than_unequal_links_allow_is_unreachable():
    pose = np.eye(4)
    pose[2, 3] = -0.03 - 0.069
    assert not humanoid_leg_ik(pose, *LEGS[1])[1]
    pose[2, 3] = -0.03 - 0.071
    assert humanoid_leg_ik(pose, *LEGS[1])[1]


def test_a_pose_that_is_no_number_is_unreachable():
    pose = np.full((2, 4, 4), np.nan)
    pose[1] = np.eye(4)
    pose[1, 2, 3] = -0.2
    q, reachable = humanoid_leg_ik(pose, *LEGS[0])
    assert reachable.tolist() == [False, True]
    assert np.isnan(q[0]).all()


def test_leading_dimensions_broadcast():
    pose = np.broadcast_to(np.eye(4), (3, 2, 4, 4)).copy()
    pose[..., 2, 3] = -0.2
    q, reachable = humanoid_leg_ik(pose, *LEGS[0])
    assert q.shape == (3, 2, 8, 6)
    assert reachable.shape == (3, 2)
    np.testing.assert_array_equal(humanoid_leg_ik(pose[0, 0].tolist(), *LEGS[0])[0], q[0, 0])


def test_the_chain_is_recognised_with_its_lengths():
    form = recognise(AXES, links(LEGS[1]))
    assert form.kind == "humanoid leg"
    assert form.lengths == LEGS[1]
    assert form.needs_pose
