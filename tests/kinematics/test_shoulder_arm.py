"""The three-joint arm with two crossed shoulder axes: all four ways to a place of the hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.kinematics import chain
from kinlab.kinematics.shoulder_arm import NAMES, shoulder_arm_ik

AXES = np.array([[0, 0, 1], [0, 1, 0], [0, 0, 1]], float)
# Upper arm and forearm in metres: the receptionist's, equal ones, forearm the shorter.
ARMS = [(0.185, 0.250), (0.185, 0.185), (0.250, 0.170)]
TIGHT = 1e-12

turns = st.floats(-np.pi, np.pi)
quarters = st.sampled_from([k * np.pi / 2 for k in range(-2, 3)])
angle = (
    turns | quarters | st.builds(lambda q, e: q + e, quarters, st.sampled_from([1e-15, 1e-9, -1e-7, 1e-5]))
)


def fk(q, arm):
    upper, fore = arm
    return chain.fk(AXES, [[0, 0, 0], [upper, 0, 0], [fore, 0, 0]], q)[..., :3, 3]


@pytest.mark.parametrize("arm", ARMS)
def test_every_way_reaches_a_hand_anywhere_in_the_workspace(arm):
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (50_000, 3))
    hand = fk(q, arm)
    found, reachable = shoulder_arm_ik(hand, *arm)
    assert reachable.all()
    assert np.linalg.norm(fk(found, arm) - hand[:, None], axis=-1).max() < TIGHT


@given(st.sampled_from(ARMS), st.tuples(angle, angle, angle))
def test_singular_poses_are_reached_as_exactly(arm, q):
    hand = fk(np.array(q), arm)
    found, reachable = shoulder_arm_ik(hand, *arm)
    assert reachable
    assert np.linalg.norm(fk(found, arm) - hand, axis=-1).max() < TIGHT


def test_the_pose_that_a_hand_came_from_is_among_the_four():
    q = np.random.default_rng(2).uniform(-np.pi, np.pi, (20_000, 3))
    found, _ = shoulder_arm_ik(fk(q, ARMS[0]), *ARMS[0])
    away = np.abs(np.angle(np.exp(1j * (found - q[:, None])))).max(axis=-1).min(axis=-1)
    assert np.quantile(away, 0.99) < 1e-9
    assert away.max() < 1e-6


def test_a_generic_hand_has_four_different_ways_in_the_order_of_their_names():
    q = np.radians([30, 20, 50])
    found, _ = shoulder_arm_ik(fk(q, ARMS[0]), *ARMS[0])
    assert len(NAMES) == len(found) == 4
    np.testing.assert_allclose(found[NAMES.index("elbow-in")], q, atol=1e-12)
    assert [way[2] > 0 for way in found] == [name.startswith("elbow-in") for name in NAMES]


@pytest.mark.parametrize("arm", ARMS)
def test_the_workspace_is_two_spheres_and_the_cone_that_the_second_axis_cannot_leave(arm):
    """Reachable exactly where a forward sweep over the elbow and the shoulder says so."""
    upper, fore = arm
    hand = np.random.default_rng(3).uniform(-0.5, 0.5, (20_000, 3))
    d2 = np.sum(hand**2, axis=1)
    spheres = (d2 <= (upper + fore) ** 2) & (d2 >= (upper - fore) ** 2)
    along = (d2 + upper**2 - fore**2) / (2 * upper)
    _, reachable = shoulder_arm_ik(hand, *arm)
    np.testing.assert_array_equal(reachable, spheres & (np.abs(hand[:, 2]) <= np.abs(along)))


@pytest.mark.parametrize(("gap", "counts"), [(5e-13, True), (1e-11, False), (0.01, False)])
def test_a_hand_beyond_the_stretched_arm_is_unreachable(gap, counts):
    q, reachable = shoulder_arm_ik([sum(ARMS[0]) + gap, 0, 0], *ARMS[0])
    assert reachable == counts
    assert np.isnan(q).all() == (not counts)


def test_a_hand_that_is_no_number_is_unreachable_and_shapes_broadcast():
    hand = np.full((2, 3, 3), 0.2)
    hand[1, 2, 0] = np.nan
    q, reachable = shoulder_arm_ik(hand, *ARMS[0])
    assert q.shape == (2, 3, 4, 3)
    assert reachable.shape == (2, 3)
    assert not reachable[1, 2]
    assert np.isnan(q[1, 2]).all()
    np.testing.assert_array_equal(shoulder_arm_ik(hand[0, 0].tolist(), *ARMS[0])[0], q[0, 0])
