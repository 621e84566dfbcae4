"""The weight on standing legs: forces and moments balance, and torques do the work of the weight."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.gait import find_gait, plan
from kinlab.gait.stability import GRAVITY
from kinlab.rig.ground import Ground, shares, weight_torques
from kinlab.rig.rig import Rig

FEET = np.array([[0.1, -0.1], [0.0, -0.15], [-0.1, -0.1], [0.1, 0.1], [0.0, 0.15], [-0.1, 0.1]])


@given(
    st.floats(-0.03, 0.03), st.floats(-0.03, 0.03), st.sampled_from([0b010101, 0b101010, 0b111011, 0b111111])
)
def test_what_stands_balances(x, y, standing):
    down = np.array([bool(standing >> i & 1) for i in range(6)])
    found = shares(FEET, [x, y], down)
    assert found.sum() == pytest.approx(1)
    assert (found[~down] == 0).all()
    assert found @ FEET == pytest.approx([x, y], abs=1e-12)


def test_a_middle_leg_carries_half_of_a_tripod():
    down = [True, False, True, False, True, False]
    assert shares(FEET, [0.0, 0.0], down)[4] == pytest.approx(0.4)
    straight = FEET * [1, 0] + [0, 1] * np.sign(FEET) * 0.1
    assert shares(straight, [0.0, 0.0], down)[4] == pytest.approx(0.5)


def test_no_foot_pulls_at_the_ground():
    found = shares(FEET, [0.25, 0.0], np.ones(6, bool))
    assert found.min() >= 0
    assert found.sum() == pytest.approx(1)


def test_torques_do_the_work_of_the_weight(krsri):
    """Lower the body by a hair: what the weight does is what the joints take up."""
    walk = plan(krsri, find_gait(krsri, "wave"), rpy=(0.05, -0.03, 0.0))
    motion = walk.at(np.linspace(0, walk.period, 7)[:-1] + 0.01)
    torques = weight_torques(motion)
    h = 1e-6
    lower = plan(krsri, find_gait(krsri, "wave"), rpy=(0.05, -0.03, 0.0), height=-h).at(motion.t)
    turned = np.where(motion.swing[..., None], 0.0, lower.q - motion.q)
    assert (torques * turned).sum(axis=(1, 2)) == pytest.approx(krsri.mass * GRAVITY * h, rel=1e-3)
    assert (torques[motion.swing] == 0).all()


def test_the_ground_presses_on_the_horns(krsri):
    with Rig.open(krsri) as rig:
        ground = Ground(rig, rig.chain)
        ground.press(np.full(18, 0.3))
        signs = [servo.sign for servo in rig.wiring.servos]
        assert [rig.chain.servo(i).plant.external for i in rig.wiring.ids] == pytest.approx(
            0.3 * np.array(signs)
        )
        before = rig.read().q
        rig.clock.wait(0.1)
        assert (rig.read().q > before).all()
        ground.lift()
        assert {servo.plant.external for servo in rig.chain.servos} == {0.0}
