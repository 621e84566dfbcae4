"""Rotations and homogeneous transforms."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.kinematics.transforms import (
    apply,
    homogeneous,
    inverse,
    quaternion,
    rotation,
    rotation_to_rpy,
    rotation_vector,
    rpy_to_rotation,
    wrap,
)

X, Y, Z = np.eye(3)
angles = st.floats(-7, 7)
components = st.floats(-1, 1)
axes = (
    st.tuples(components, components, components)
    .filter(lambda v: np.linalg.norm(v) > 0.1)
    .map(lambda v: np.array(v) / np.linalg.norm(v))
)


@pytest.mark.parametrize(("axis", "turned", "onto"), [(X, Y, Z), (Y, Z, X), (Z, X, Y)])
def test_a_quarter_turn_is_counter_clockwise_about_each_axis(axis, turned, onto):
    np.testing.assert_allclose(rotation(axis, np.pi / 2) @ turned, onto, atol=1e-15)
    np.testing.assert_allclose(rotation(-axis, np.pi / 2) @ turned, -onto, atol=1e-15)


@given(axes, angles)
def test_a_rotation_is_orthogonal_and_keeps_its_axis(axis, angle):
    R = rotation(axis, angle)
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(R) == pytest.approx(1, abs=1e-14)
    np.testing.assert_allclose(R @ axis, axis, atol=1e-14)


def test_rpy_turns_about_fixed_x_then_y_then_z():
    roll, pitch, yaw = 0.3, -0.4, 0.5
    wanted = rotation(Z, yaw) @ rotation(Y, pitch) @ rotation(X, roll)
    np.testing.assert_allclose(rpy_to_rotation([roll, pitch, yaw]), wanted, atol=1e-15)


@given(st.tuples(angles, angles, angles))
def test_rpy_gives_its_rotation_back(rpy):
    R = rpy_to_rotation(rpy)
    np.testing.assert_allclose(rpy_to_rotation(rotation_to_rpy(R)), R, atol=1e-12)


@pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2])
@pytest.mark.parametrize("distance", [0, 1e-16, 1e-13, 1e-12, 1e-10, 1e-8, 1e-5])
def test_rpy_gives_its_rotation_back_at_and_near_gimbal_lock(pitch, distance):
    rng = np.random.default_rng(1)
    lock = rng.uniform(-3, 3, (500, 3))
    lock[:, 1] = pitch + distance
    # A conjugate's roll and yaw have independent rounding errors, as those of a measured rotation have.
    R = rotation(Z, 0.3) @ (rotation(Z, -0.3) @ rpy_to_rotation(lock))
    np.testing.assert_allclose(rpy_to_rotation(rotation_to_rpy(R)), R, atol=2e-12)


def test_rpy_takes_the_roll_as_zero_at_gimbal_lock():
    roll, pitch, yaw = rotation_to_rpy(rpy_to_rotation([0.3, np.pi / 2, 0.5]))
    assert roll == pytest.approx(0, abs=1e-15)
    assert pitch == np.pi / 2
    assert yaw == pytest.approx(0.5 - 0.3)


@given(axes, st.floats(0, np.pi - 1e-9))
def test_rotation_vector_is_axis_times_angle(axis, angle):
    np.testing.assert_allclose(rotation_vector(rotation(axis, angle)), axis * angle, atol=1e-14)


@given(axes, st.sampled_from([0.0, 1e-300, 1e-16, 1e-10, 1e-8, 1e-6]))
def test_rotation_vector_keeps_all_digits_of_small_angles(axis, angle):
    error = np.abs(rotation_vector(rotation(axis, angle)) - axis * angle)
    assert (error <= 1e-9 * angle).all()


@given(axes, st.sampled_from([0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-3]))
def test_rotation_vector_gives_the_rotation_back_near_half_a_turn(axis, short):
    R = rotation(axis, np.pi - short)
    v = rotation_vector(R)
    angle = np.linalg.norm(v)
    np.testing.assert_allclose(rotation(v / angle, angle), R, atol=1e-14)


@pytest.mark.parametrize("axis", [*np.eye(3), *-np.eye(3)])
def test_rotation_vector_of_exactly_half_a_turn_about_each_axis(axis):
    half = 2 * np.outer(axis, axis) - np.eye(3)
    np.testing.assert_allclose(np.abs(rotation_vector(half)), np.pi * np.abs(axis), atol=1e-15)


@given(axes, angles, st.tuples(components, components, components))
def test_the_inverse_undoes_a_transform(axis, angle, place):
    T = homogeneous(rotation(axis, angle), place)
    np.testing.assert_allclose(inverse(T) @ T, np.eye(4), atol=1e-14)
    point = np.array([0.1, -0.2, 0.3])
    np.testing.assert_allclose(apply(inverse(T), apply(T, point)), point, atol=1e-14)


@given(st.floats(-1e4, 1e4))
def test_wrap_changes_an_angle_by_whole_turns_into_one_turn(angle):
    wrapped = wrap(angle)
    turns = (angle - wrapped) / (2 * np.pi)
    assert -np.pi < wrapped <= np.pi
    assert turns == pytest.approx(round(float(turns)), abs=1e-9)


def test_wrap_takes_half_a_turn_as_positive():
    assert wrap([np.pi, -np.pi, 3 * np.pi]).tolist() == [np.pi] * 3


def test_all_functions_broadcast_over_leading_dimensions():
    rng = np.random.default_rng(2)
    rpy = rng.uniform(-3, 3, (4, 5, 3))
    R = rpy_to_rotation(rpy)
    assert R.shape == (4, 5, 3, 3)
    assert rotation(Z, rpy[..., 0]).shape == (4, 5, 3, 3)
    assert rotation_to_rpy(R).shape == rotation_vector(R).shape == (4, 5, 3)
    T = homogeneous(R, [1, 2, 3])
    assert T.shape == inverse(T).shape == (4, 5, 4, 4)
    assert apply(T, rng.uniform(size=(5, 3))).shape == (4, 5, 3)
    np.testing.assert_allclose(rotation_vector(R)[2, 3], rotation_vector(R[2, 3]), atol=1e-15)
    np.testing.assert_allclose(rotation_to_rpy(R)[2, 3], rotation_to_rpy(R[2, 3]), atol=1e-15)


def test_empty_batches_come_back_empty():
    assert rotation_vector(np.empty((0, 3, 3))).shape == (0, 3)
    assert rotation_to_rpy(np.empty((0, 3, 3))).shape == (0, 3)


def test_quaternions_turn_vectors_as_their_rotations_do():
    rng = np.random.default_rng(4)
    vectors = np.concatenate([rng.uniform(-3, 3, (50, 3)), [[0, 0, 0], [1e-12, 0, 0], [0, np.pi, 0]]])
    xyz, w = np.split(quaternion(vectors), [3], axis=-1)
    v = rng.uniform(-1, 1, (len(vectors), 3))
    # v' = v + 2 w (q x v) + 2 q x (q x v)
    turned = v + 2 * w * np.cross(xyz, v) + 2 * np.cross(xyz, np.cross(xyz, v))
    for vector, before, after in zip(vectors, v, turned, strict=True):
        angle = np.linalg.norm(vector)
        axis = vector / angle if angle else np.array(Z, float)
        np.testing.assert_allclose(after, rotation(axis, angle) @ before, atol=1e-14)
