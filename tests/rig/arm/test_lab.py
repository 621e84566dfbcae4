"""An arm that goes on for ever while gains, law and a hand on it change."""

from dataclasses import replace

import numpy as np
import pytest

from kinlab.control import Environment, PositionGains
from kinlab.errors import UsageError
from kinlab.rig.arm import ArmServos, Lab, Push, RunawayError, Settings, run
from kinlab.rig.arm.drawing import VIEWS, draw_arm, pull

FIRM = Settings("position", PositionGains(20, 8), Environment(0.1, 12, 8, 1))


@pytest.fixture
def lab(robot, limb, stay):
    with Lab(robot, limb, stay, FIRM) as lab:
        yield lab


def farthest(lab, cycles):
    return max(
        float(np.degrees(np.abs(lab.cycle().angles["real"] - lab.track.q[0])).max()) for _ in range(cycles)
    )


def test_cycle_by_cycle_it_is_the_run_of_the_experiments(robot, limb, line):
    push = Push(0.4, 0.3, "hand", (-2.0, 0.0, 0.0))
    with ArmServos.emulated(robot, limb, line.q[0].tolist(), [push]) as servos:
        servos.hold()
        record = run(servos, line, FIRM)
    with Lab(robot, limb, line, FIRM) as lab:
        for k in range(len(line.q)):
            # A hand of the lab acts from the next step of the world on, which is no later than the next cycle.
            lab.lean(push.force if push.acts(k * FIRM.dt) else None)
            lab.cycle()
    real = np.array([moment.angles["real"] for moment in lab.moments])
    np.testing.assert_allclose(real, record.angles["real"], atol=np.radians(1.0))
    np.testing.assert_array_equal(real[:25], record.angles["real"][:25])


def test_it_goes_round_its_track_for_ever(lab):
    count = len(lab.track.q)
    moments = [lab.cycle() for _ in range(count + 3)]
    np.testing.assert_array_equal(moments[count + 1].angles["command"], moments[1].angles["command"])
    assert [m.t for m in moments] == pytest.approx([k * FIRM.dt for k in range(count + 3)])


def test_a_hand_pushes_for_as_long_as_it_leans(lab):
    free = farthest(lab, 40)
    lab.lean((0.0, 0.0, -3.0))
    assert farthest(lab, 40) > free + 3
    assert np.abs(lab.moments[-1].torques["pushed"]).max() > 0.3
    lab.lean(None)
    farthest(lab, 80)
    assert np.abs(lab.moments[-1].torques["pushed"]).max() == 0
    assert farthest(lab, 20) < free + 2


def test_compliance_yields_more_to_the_same_hand_and_can_be_switched_while_it_runs(lab):
    way = {}
    for law in ("position", "compliance"):
        lab.settings = replace(FIRM, law=law)
        lab.lean((0.0, 0.0, -3.0))
        way[law] = farthest(lab, 50)
        lab.lean(None)
        farthest(lab, 120)
    assert way["compliance"] > 1.5 * way["position"]
    assert np.abs(lab.moments[-1].angles["given_way"]).max() > 0
    lab.settings = FIRM
    assert not lab.cycle().angles["given_way"].any()


def test_gains_that_are_too_high_run_away_and_say_so(lab):
    farthest(lab, 10)
    lab.settings = replace(FIRM, gains=PositionGains(4000, 0))
    with pytest.raises(RunawayError, match=r"ran away at .* s: the reference of"):
        farthest(lab, 125)


def test_the_cycle_time_stays(lab):
    with pytest.raises(UsageError, match="cycle time"):
        lab.settings = replace(FIRM, dt=0.02)


def test_the_torque_is_off_afterwards(robot, limb, stay):
    with Lab(robot, limb, stay, FIRM) as lab:
        lab.cycle()
        servos = lab._servos
    assert servos.unconfirmed == ()
    assert [servos.bus.read(i, "torque_enable") for i in servos.ids] == [0, 0, 0]


@pytest.mark.parametrize("view", VIEWS)
def test_the_arm_and_its_line_are_in_sight(limb, line, view):
    for q in line.q[[0, -1]]:
        canvas = draw_arm(limb, q, line, view=view, reference=q + 0.1, force=(-5.0, 2.0, 0.0))
        text = canvas.text()
        assert "▼" in text
        assert "●" in text
        assert "bad" in {role for row in canvas.spans() for _, role in row}
    assert draw_arm(limb, q, line, view=view, ascii_only=True).text().isascii()


@pytest.mark.parametrize("view", VIEWS)
def test_a_hand_on_the_drawing_pulls_to_where_it_is(limb, line, view):
    tip = VIEWS[view] @ limb.fk(line.q[0])[:3, 3] * 1000
    force = np.array(pull(limb, line.q[0], view, (tip[0] + 40, tip[1] - 60)))
    np.testing.assert_allclose(VIEWS[view] @ force, [2, -3], atol=1e-9)
    assert np.linalg.norm(pull(limb, line.q[0], view, (1e6, 1e6))) == pytest.approx(10)
    assert pull(limb, line.q[0], view, tuple(tip)) == pytest.approx((0, 0, 0), abs=1e-9)


def test_what_is_kept_is_there_to_be_plotted(lab):
    assert lab.off == 0
    for _ in range(30):
        lab.cycle()
    assert lab.column("real").shape == (30, 3)
    assert lab.column("load", 0.16).shape == (10, 3)
    np.testing.assert_array_equal(lab.column("real")[-1], lab.moments[-1].angles["real"])
    np.testing.assert_allclose(lab.trail(0.016)[0], lab.limb.fk(lab.moments[-1].angles["real"])[:3, 3])
    assert 0 < lab.off < 0.05
    assert len(lab.times) == 30
