"""Inverse and forward dynamics against each other, against energy, virtual work and the textbook pendulum."""

import numpy as np
import pytest

from kinlab.dynamics import (
    GRAVITY,
    Contact,
    Mechanism,
    forward_dynamics,
    gravity_torque,
    inverse_dynamics,
    kinetic_energy,
    mass_matrix,
    potential_energy,
)
from kinlab.dynamics.mechanism import poses
from kinlab.errors import UsageError
from kinlab.kinematics import chain as kinematics
from kinlab.kinematics.blocks import BLOCK


def test_forward_dynamics_undoes_inverse_dynamics(chain, motion):
    q, qd, qdd = motion
    wrench = np.random.default_rng(1).normal(size=(30, 6))
    torque = inverse_dynamics(chain, q, qd, qdd, wrench)
    np.testing.assert_allclose(forward_dynamics(chain, q, qd, torque, wrench), qdd, atol=1e-8)


def test_the_mass_matrix_is_what_unit_accelerations_cost(chain, motion):
    q, _, _ = motion
    still = inverse_dynamics(chain, q, 0 * q, 0 * q)
    M = mass_matrix(chain, q)
    for j, unit in enumerate(np.eye(chain.count)):
        column = inverse_dynamics(chain, q, 0 * q, np.broadcast_to(unit, q.shape)) - still
        np.testing.assert_allclose(M[..., j], column, atol=1e-12)
    assert (np.linalg.eigvalsh(M) > 0).all()


def test_power_put_in_is_energy_gained(chain, motion):
    """d/dt (T + V) = qd . tau, with the derivative taken along the motion by central differences."""
    q, qd, qdd = motion
    torque = inverse_dynamics(chain, q, qd, qdd)
    h = 1e-5

    def energy(t):
        at, rate = q + t * qd + t * t / 2 * qdd, qd + t * qdd
        return kinetic_energy(chain, at, rate) + potential_energy(chain, at)

    np.testing.assert_allclose((energy(h) - energy(-h)) / (2 * h), np.sum(qd * torque, axis=-1), atol=1e-6)


def test_gravity_torque_is_the_gradient_of_potential_energy(chain, motion):
    q, _, _ = motion
    h = 1e-5
    gradient = np.stack(
        [
            (potential_energy(chain, q + h * e) - potential_energy(chain, q - h * e)) / (2 * h)
            for e in np.eye(chain.count)
        ],
        axis=-1,
    )
    np.testing.assert_allclose(gravity_torque(chain, q), gradient, atol=1e-8)


def test_kinetic_energy_is_that_of_the_moving_links(chain, motion):
    q, qd, _ = motion
    h = 1e-6
    (R0, o0), (R1, o1) = poses(chain, q - h * qd), poses(chain, q + h * qd)
    R, _ = poses(chain, q)
    c0, c1 = (o[..., :-1, :] + (r @ chain.centres[..., None])[..., 0] for r, o in ((R0, o0), (R1, o1)))
    v = (c1 - c0) / (2 * h)
    W = np.swapaxes(R, -1, -2) @ (R1 - R0) / (2 * h)
    w = np.stack([W[..., 2, 1], W[..., 0, 2], W[..., 1, 0]], axis=-1)
    energy = 0.5 * (v * v).sum(-1) @ chain.mass
    energy += 0.5 * np.einsum("...ni,nij,...nj->...", w, chain.inertia, w)
    np.testing.assert_allclose(kinetic_energy(chain, q, qd), energy, rtol=1e-7)


def test_a_swing_without_friction_keeps_its_energy(arm):
    """Two seconds of free fall from a stretched-out arm, by Runge and Kutta's method."""
    q, qd = np.array([1.2, 0.4, 0.8]), np.zeros(3)
    start = potential_energy(arm, q)

    def slope(state):
        return np.concatenate([state[3:], forward_dynamics(arm, state[:3], state[3:], np.zeros(3))])

    state, h = np.concatenate([q, qd]), 0.002
    fastest = 0.0
    for _ in range(1000):
        k1 = slope(state)
        k2 = slope(state + h / 2 * k1)
        k3 = slope(state + h / 2 * k2)
        k4 = slope(state + h * k3)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        fastest = max(fastest, float(kinetic_energy(arm, state[:3], state[3:])))
        total = kinetic_energy(arm, state[:3], state[3:]) + potential_energy(arm, state[:3])
        assert abs(total - start) < 1e-5
    assert fastest > 0.1, "it must have moved for this to say anything"


@pytest.mark.parametrize("link", [0, 1, 2])
@pytest.mark.parametrize("point", [None, (0.03, -0.02, 0.01)])
def test_a_wrench_costs_the_transposed_jacobian_of_its_point(arm, link, point):
    rng = np.random.default_rng(3)
    q, qd, qdd = rng.normal(size=(3, 20, 3))
    wrench = rng.normal(size=(20, 6))
    links = arm.links[: link + 1].copy()
    links[link] = links[link] if point is None else point
    J = np.zeros((20, 6, 3))
    J[..., : link + 1] = kinematics.jacobian(arm.axes[: link + 1], links, q[:, : link + 1])
    with_it = inverse_dynamics(arm, q, qd, qdd, wrench, Contact(link, point))
    without = inverse_dynamics(arm, q, qd, qdd)
    expected = without - (np.swapaxes(J, -1, -2) @ wrench[..., None])[..., 0]
    np.testing.assert_allclose(with_it, expected, atol=1e-14)


def test_a_pendulum_and_a_mass_on_a_rail_are_those_of_the_textbook():
    length, mass = 0.7, 2.0
    pendulum = Mechanism(
        axes=np.array([[0.0, -1, 0]]),
        links=np.array([[length, 0, 0]]),
        mass=np.array([mass]),
        centres=np.array([[length, 0, 0]]),
        inertia=np.zeros((1, 3, 3)),
        slides=(False,),
        gravity=np.array([0, 0, -GRAVITY]),
    )
    # About -y a positive angle lifts the mass; level, gravity costs m g l.
    np.testing.assert_allclose(gravity_torque(pendulum, [0.0]), [mass * GRAVITY * length])
    np.testing.assert_allclose(inverse_dynamics(pendulum, [np.pi / 2], [3.0], [5.0]), [mass * length**2 * 5])
    rail = Mechanism(
        axes=np.array([[0.0, 0, 1]]),
        links=np.zeros((1, 3)),
        mass=np.array([mass]),
        centres=np.zeros((1, 3)),
        inertia=np.zeros((1, 3, 3)),
        slides=(True,),
        gravity=np.array([0, 0, -GRAVITY]),
    )
    np.testing.assert_allclose(inverse_dynamics(rail, [0.3], [9.0], [1.0]), [mass * (GRAVITY + 1)])


def test_leading_dimensions_broadcast_and_blocks_leave_no_seam(arm):
    rng = np.random.default_rng(4)
    q, qdd = rng.normal(size=(BLOCK + 3, 3)), rng.normal(size=3)
    whole = inverse_dynamics(arm, q, np.zeros(3), qdd)
    assert whole.shape == (BLOCK + 3, 3)
    for row in (0, BLOCK - 1, BLOCK, BLOCK + 2):
        np.testing.assert_allclose(whole[row], inverse_dynamics(arm, q[row], np.zeros(3), qdd), atol=1e-15)
    assert inverse_dynamics(arm, q[:6].reshape(2, 3, 3), qdd, qdd).shape == (2, 3, 3)
    assert forward_dynamics(arm, q[:6].reshape(2, 3, 3), qdd, qdd).shape == (2, 3, 3)


def test_a_wrong_number_of_joints_is_refused(arm):
    with pytest.raises(UsageError, match="rates must have one number for each of 3 joints, got 2"):
        inverse_dynamics(arm, [0, 0, 0], [0, 0], [0, 0, 0])
    with pytest.raises(UsageError, match=r"positions .* got 1"):
        mass_matrix(arm, 0.0)
