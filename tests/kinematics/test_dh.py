"""Denavit-Hartenberg parameters, derived from the chain."""

import numpy as np
import pytest

from kinlab.kinematics import chain, dh
from kinlab.robots import load_robots

LIMBS = [(r.name, limb) for r in load_robots().values() for limb in r.limbs.values()]


@pytest.mark.parametrize(("robot", "limb"), LIMBS, ids=lambda v: getattr(v, "name", v))
def test_the_parameters_give_the_same_tip_as_the_chain(robot, limb):
    q = np.random.default_rng(3).uniform(-np.pi, np.pi, (200, len(limb.joints)))
    parameters = dh.from_chain(limb.axes, limb.links)
    assert np.abs(dh.fk(parameters, q) - limb.fk(q)).max() < 1e-12


def test_any_chain_has_parameters():
    rng = np.random.default_rng(5)
    for _ in range(100):
        axes = rng.normal(size=(5, 3))
        axes /= np.linalg.norm(axes, axis=1, keepdims=True)
        links = rng.uniform(-0.2, 0.2, (5, 3))
        q = rng.uniform(-3, 3, (20, 5))
        parameters = dh.from_chain(axes, links)
        assert np.abs(dh.fk(parameters, q) - chain.fk(axes, links, q)).max() < 1e-9


def test_a_leg_has_the_textbook_parameters():
    parameters = dh.from_chain(
        [(0, 0, 1), (0, -1, 0), (0, -1, 0)], [(0.06, 0, 0), (0.15, 0, 0), (0.15, 0, 0)]
    )
    assert np.degrees(parameters.alpha) == pytest.approx([90, 0, 0])
    assert parameters.a == pytest.approx([0.06, 0.15, 0.15])
    assert parameters.d == pytest.approx([0, 0, 0])
