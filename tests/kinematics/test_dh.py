"""Denavit-Hartenberg parameters: whatever the chain, they give its forward kinematics back."""

import numpy as np
import pytest

import kinlab
from kinlab.kinematics import chain, dh
from kinlab.kinematics.transforms import homogeneous, rotation

LIMBS = {f"{r.name} {limb.name}": limb for r in kinlab.load_robots().values() for limb in r.limbs.values()}


def rebuilt(parameters, q):
    T = parameters.base
    for angle, theta, d, a, alpha in zip(q, *parameters[:4], strict=True):
        T = T @ homogeneous(rotation((0, 0, 1), angle + theta), [0, 0, d])
        T = T @ homogeneous(rotation((1, 0, 0), alpha), [a, 0, 0])
    return T @ parameters.tool


def test_chains_of_chance_have_the_same_forward_kinematics():
    rng = np.random.default_rng(1)
    for count in (1, 2, 3, 6):
        for _ in range(50):
            axes = rng.normal(size=(count, 3))
            axes /= np.linalg.norm(axes, axis=1, keepdims=True)
            links = rng.uniform(-0.2, 0.2, (count, 3)) * (rng.random((count, 3)) < 0.7)
            q = rng.uniform(-3, 3, count)
            wanted = chain.fk(axes, links, q)
            np.testing.assert_allclose(rebuilt(dh.from_chain(axes, links), q), wanted, atol=1e-12)


@pytest.mark.parametrize("limb", LIMBS.values(), ids=LIMBS)
def test_every_limb_has_the_same_forward_kinematics(limb):
    parameters = dh.from_chain(limb.axes, limb.links)
    for q in np.random.default_rng(2).uniform(-3, 3, (10, len(limb.joints))):
        np.testing.assert_allclose(rebuilt(parameters, q), limb.fk(q), atol=1e-12)


def test_a_leg_has_the_textbooks_parameters():
    leg = LIMBS["xl430-hexapod R1"]
    parameters = dh.from_chain(leg.axes, leg.links)
    np.testing.assert_allclose(parameters.a, [0.025, 0.050, 0.070], atol=1e-15)
    np.testing.assert_allclose(parameters.d, 0, atol=1e-15)
    np.testing.assert_allclose(np.abs(parameters.alpha), [np.pi / 2, 0, 0], atol=1e-15)
