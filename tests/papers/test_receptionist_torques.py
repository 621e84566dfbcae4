"""The arm paper's torque equations against the recursion that they stand for."""

import numpy as np
import pytest

import kinlab
from kinlab.dynamics import Mechanism, gravity_torque, inverse_dynamics
from kinlab.papers import receptionist_torques as paper

LENGTHS, MASSES = (0.185, 0.25), (0.176, 0.190)
ALL = frozenset(m.equation for m in paper.MISPRINTS)


@pytest.fixture(scope="module")
def rods():
    """The arm as the paper has it: slender rods, and a first shoulder joint that weighs nothing."""
    mass = np.array([0.0, *MASSES])
    lengths = np.array([0.0, *LENGTHS])
    return Mechanism(
        axes=paper.AXES,
        links=np.outer(lengths, [1, 0, 0]),
        mass=mass,
        centres=np.outer(lengths / 2, [1, 0, 0]),
        inertia=(mass * lengths**2 / 12)[:, None, None] * np.diag([0.0, 1, 1]),
        slides=(False,) * 3,
        gravity=np.array([9.80665, 0, 0]),
    )


def in_plane(seed):
    motion = np.random.default_rng(seed).normal(size=(3, 200, 3))
    motion[:, :, 1] = 0
    return motion


def test_corrected_the_equations_in_the_plane_are_the_newton_euler_recursion(rods):
    q, qd, qdd = in_plane(0)
    true = inverse_dynamics(rods, q, qd, qdd)
    found = paper.torques(q, qd, qdd, LENGTHS, MASSES)
    np.testing.assert_allclose(found[:, [0, 2]], true[:, [0, 2]], atol=1e-14)


@pytest.mark.parametrize(("equation", "spoilt"), [("3.28", [1]), ("3.31", [0]), ("3.36", [0, 2])])
def test_each_misprint_alone_spoils_its_own_torque(equation, spoilt):
    motion = np.random.default_rng(1).normal(size=(3, 200, 3))
    right = paper.torques(*motion, LENGTHS, MASSES)
    wrong = paper.torques(*motion, LENGTHS, MASSES, frozenset([equation]))
    assert [i for i in range(3) if np.abs(wrong - right)[:, i].max() > 1e-3] == spoilt


def test_as_printed_an_arm_at_rest_in_the_plane_keeps_the_shoulders_torque_but_for_the_elbows(rods):
    """Statics of (3.31): what it misses is exactly the torque of servo 3."""
    q, zero = in_plane(2)[0], np.zeros(3)
    held = gravity_torque(rods, q)
    printed = paper.torques(q, zero, zero, LENGTHS, MASSES, ALL)
    np.testing.assert_allclose(held[:, 0] - printed[:, 0], held[:, 2], atol=1e-14)
    # (3.36): in the plane z_B - z_C2 is 0, and with it all that gravity does to the elbow.
    np.testing.assert_allclose(printed[:, 2], 0, atol=1e-14)


def test_the_papers_rods_are_the_arm_of_the_robots_file_but_for_its_assumed_thickness(rods):
    arm = Mechanism.of(kinlab.load_robot("receptionist-arm").limb())
    motion = np.random.default_rng(3).normal(size=(3, 200, 3))
    # A massless shoulder there, 50 g in its centre here; rods of 6 mm radius here.
    difference = inverse_dynamics(arm, *motion) - inverse_dynamics(rods, *motion)
    assert np.abs(difference).max() < 1e-4


def test_what_they_miss_is_small_in_the_plane_once_corrected_and_large_as_printed():
    arm = Mechanism.of(kinlab.load_robot("receptionist-arm").limb())
    motion = in_plane(4)
    # The corrected ones miss the assumed thickness of the rods.
    assert np.abs(paper.missed(arm, *motion)[:, [0, 2]]).max() < 1e-4
    assert np.abs(paper.missed(arm, *motion, ALL)).max() > 0.1
