"""Serial chains: forward kinematics, Jacobian, second derivatives, manipulability."""

import numpy as np
import pytest

from kinlab.kinematics import chain
from kinlab.kinematics.blocks import BLOCK
from kinlab.kinematics.transforms import homogeneous, rotation, rotation_vector

SIGNED = [sign * axis for axis in np.eye(3) for sign in (1, -1)]


def random_chain(rng, joints):
    """Axes of all kinds: skew ones, and the body's own with both signs."""
    axes = rng.normal(size=(joints, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    own = rng.random(joints) < 0.5
    axes[own] = np.array(SIGNED)[rng.integers(0, 6, own.sum())]
    links = rng.uniform(-0.2, 0.2, (joints, 3)) * (rng.random((joints, 3)) < 0.7)
    return axes, links


def textbook_fk(axes, links, q):
    T = np.eye(4)
    for axis, link, angle in zip(axes, links, q, strict=True):
        T = T @ homogeneous(rotation(axis, angle), [0, 0, 0]) @ homogeneous(np.eye(3), link)
    return T


@pytest.fixture(params=[1, 2, 3, 6, 7])
def case(request):
    rng = np.random.default_rng(request.param)
    for _ in range(5):
        axes, links = random_chain(rng, request.param)
    return axes, links, rng.uniform(-4, 4, (40, request.param))


def test_fk_is_the_product_of_turns_and_links(case):
    axes, links, q = case
    for angles, T in zip(q, chain.fk(axes, links, q), strict=True):
        np.testing.assert_allclose(T, textbook_fk(axes, links, angles), atol=1e-14)


@pytest.mark.parametrize("axis", SIGNED)
@pytest.mark.parametrize("joint", [0, 1, 2])
def test_each_joint_turns_counter_clockwise_about_its_own_signed_axis(axis, joint):
    """Only one joint turns; what follows it must move as Rodrigues' formula says, sign included."""
    axes = np.array([[0, 0, 1.0], [0, 0, 1.0], [0, 0, 1.0]])
    axes[joint] = axis
    links = np.array([[0.1, 0.2, 0.3], [0.4, -0.5, 0.6], [0.7, 0.8, -0.9]])
    q = np.zeros(3)
    q[joint] = 0.3
    pivot, arm = links[:joint].sum(axis=0), links[joint:].sum(axis=0)
    turned = arm * np.cos(0.3) + np.cross(axis, arm) * np.sin(0.3) + axis * (axis @ arm) * (1 - np.cos(0.3))
    T = chain.fk(axes, links, q)
    np.testing.assert_allclose(T[:3, 3], pivot + turned, atol=1e-15)
    np.testing.assert_allclose(rotation_vector(T[:3, :3]), 0.3 * axis, atol=1e-15)
    np.testing.assert_allclose(chain.jacobian(axes, links, q)[3:, joint], axis, atol=1e-15)


def test_frames_begin_at_the_base_and_end_at_the_tip(case):
    axes, links, q = case
    T = chain.frames(axes, links, q)
    assert T.shape == (len(q), len(axes) + 1, 4, 4)
    np.testing.assert_array_equal(T[:, 0], np.broadcast_to(np.eye(4), (len(q), 4, 4)))
    np.testing.assert_allclose(T[:, -1], chain.fk(axes, links, q), atol=1e-14)


def test_every_frame_is_the_fk_of_the_chain_up_to_it(case):
    axes, links, q = case
    T = chain.frames(axes, links, q)
    for i in range(1, len(axes) + 1):
        np.testing.assert_allclose(T[:, i], chain.fk(axes[:i], links[:i], q[:, :i]), atol=1e-14)


def test_the_jacobian_is_the_derivative_of_position_and_attitude(case):
    axes, links, q = case
    J = chain.jacobian(axes, links, q)
    step = 1e-6
    for i in range(len(axes)):
        dq = step * np.eye(len(axes))[i]
        ahead, behind = chain.fk(axes, links, q + dq), chain.fk(axes, links, q - dq)
        linear = (ahead[:, :3, 3] - behind[:, :3, 3]) / (2 * step)
        turn = rotation_vector(ahead[:, :3, :3] @ np.swapaxes(behind[:, :3, :3], 1, 2)) / (2 * step)
        np.testing.assert_allclose(J[:, :3, i], linear, atol=1e-9)
        np.testing.assert_allclose(J[:, 3:, i], turn, atol=1e-9)


def test_the_position_hessian_is_the_derivative_of_the_jacobian(case):
    axes, links, q = case
    H = chain.position_hessian(axes, links, q)
    np.testing.assert_array_equal(H, np.swapaxes(H, -1, -2))
    step = 1e-6
    for j in range(len(axes)):
        dq = step * np.eye(len(axes))[j]
        ahead, behind = chain.jacobian(axes, links, q + dq), chain.jacobian(axes, links, q - dq)
        np.testing.assert_allclose(H[..., j], (ahead - behind)[:, :3] / (2 * step), atol=1e-9)


def test_leading_dimensions_broadcast():
    rng = np.random.default_rng(3)
    axes, links = random_chain(rng, 4)
    q = rng.uniform(-3, 3, (2, 5, 4))
    assert chain.fk(axes, links, q).shape == (2, 5, 4, 4)
    assert chain.frames(axes, links, q).shape == (2, 5, 5, 4, 4)
    assert chain.jacobian(axes, links, q).shape == (2, 5, 6, 4)
    assert chain.position_hessian(axes, links, q).shape == (2, 5, 3, 4, 4)
    assert chain.fk(axes, links, q[0, 0]).shape == (4, 4)
    assert chain.fk(axes, links, np.empty((0, 4))).shape == (0, 4, 4)
    np.testing.assert_allclose(chain.fk(axes, links, q)[1, 3], chain.fk(axes, links, q[1, 3]), atol=1e-15)


def test_a_batch_longer_than_a_block_is_no_different_from_its_rows():
    rng = np.random.default_rng(4)
    axes, links = random_chain(rng, 3)
    q = rng.uniform(-3, 3, (BLOCK + 17, 3))
    T = chain.fk(axes, links, q)
    for i in (0, BLOCK - 1, BLOCK, BLOCK + 16):
        np.testing.assert_allclose(T[i], chain.fk(axes, links, q[i]), atol=1e-15)


def test_lists_and_float32_are_taken_and_the_arithmetic_is_double():
    axes, links = [[0, 0, 1], [0, -1, 0]], [[1, 0, 0], [1, 0, 0]]
    q = [0.5, 0.25]
    assert chain.fk(axes, links, np.array(q, np.float32)).dtype == np.float64
    np.testing.assert_array_equal(chain.fk(axes, links, q), chain.fk(axes, links, np.array(q, np.float32)))


def test_a_chain_that_has_links_off_its_joints_axis_is_carried_whole():
    T = chain.fk([[0, 0, 1]], [[0.3, 0.4, 0.5]], [np.pi / 2])
    np.testing.assert_allclose(T[:3, 3], [-0.4, 0.3, 0.5], atol=1e-15)


def test_manipulability_is_the_area_of_a_planar_arms_jacobian():
    """For two links, det J = l1 l2 sin(q2): the textbook's example."""
    axes, links = [[0, 0, 1], [0, 0, 1]], [[0.3, 0, 0], [0.2, 0, 0]]
    q = np.random.default_rng(5).uniform(-3, 3, (100, 2))
    measure = chain.manipulability(chain.jacobian(axes, links, q)[:, :2])
    np.testing.assert_allclose(measure, 0.3 * 0.2 * np.abs(np.sin(q[:, 1])), atol=1e-15)


def test_manipulability_is_the_root_of_the_determinant_of_j_jt():
    J = np.random.default_rng(6).normal(size=(50, 3, 5))
    wanted = np.sqrt(np.linalg.det(J @ np.swapaxes(J, 1, 2)))
    np.testing.assert_allclose(chain.manipulability(J), wanted, rtol=1e-10)


@pytest.mark.parametrize("q", [[0.4, 0.7, 0.0], [0.4, 0.7, np.pi], [0.4, np.pi / 2, 0.0]])
def test_manipulability_of_a_stretched_or_folded_leg_is_zero(q):
    axes, links = [[0, 0, 1], [0, -1, 0], [0, -1, 0]], [[0.025, 0, 0], [0.05, 0, 0], [0.07, 0, 0]]
    assert chain.manipulability(chain.jacobian(axes, links, q)[:3]) == pytest.approx(0, abs=1e-18)


def test_manipulability_of_a_foot_on_the_coxas_axis_is_zero():
    axes, links = [[0, 0, 1], [0, -1, 0], [0, -1, 0]], [[0.05, 0, 0], [0.05, 0, 0], [0.07, 0, 0]]
    # The femur points back over the coxa, the tibia down along the coxa's axis.
    q = [0.2, np.pi, -np.pi / 2]
    np.testing.assert_allclose(chain.fk(axes, links, q)[:2, 3], 0, atol=1e-16)
    assert chain.manipulability(chain.jacobian(axes, links, q)[:3]) == pytest.approx(0, abs=1e-18)
