"""EROS's optimisations: what they change at touch-down, and only there."""

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.gait import CURVES, assess, find_gait, plan
from kinlab.gait.landing import EXPERIMENTS, decelerated, find_experiment, landing, landings
from kinlab.robots import load_robot


def eros(**options):
    robot = load_robot("eros")
    return plan(robot, find_gait(robot), **options)


def test_deceleration_slows_the_touch_down():
    plain, slow = landing(eros()), landing(eros(decelerate=True))
    assert plain.down == pytest.approx(np.pi * eros().lift / eros().swing_time)
    assert slow.down < plain.down / 2
    found = landings(eros(decelerate=True, heel_strike=True))
    assert found["plain"] == plain
    assert found["deceleration"] == slow


def test_deceleration_follows_its_law():
    curve = decelerated(CURVES["quarter-circle"], areas=4, last_rate=0.5)
    s = np.linspace(0, 1, 200_001)
    along = curve.along.value(s)
    # Areas of equal length (48); in each the angle grows at 1 - C log(n) of its first rate.
    angle = np.arccos(1 - 2 * along)
    rate = np.gradient(angle, s)
    first = rate[np.searchsorted(along, 0.25)]
    for n in range(1, 5):
        middle = np.searchsorted(along, 0.5 + (n - 0.5) / 8)
        assert rate[middle] / first == pytest.approx(1 - 0.5 * np.log(n) / np.log(4), abs=1e-4)


def test_the_decelerated_path_is_the_same_path():
    plain, slow = CURVES["quarter-circle"], decelerated(CURVES["quarter-circle"])
    s = np.linspace(0, 1, 300)
    x, z = slow.along.value(s), slow.height.value(s)
    assert z == pytest.approx(plain.height.value(np.arccos(1 - 2 * x) / np.pi), abs=1e-9)
    assert (np.diff(x) > 0).all()


def test_a_slowed_landing_still_does_not_slip_and_is_continuous():
    walk = eros(decelerate=True, heel_strike=True).over(0.1)
    motion = walk.at(np.linspace(0, walk.duration, 1000))
    assert motion.slip() < 1e-9
    assert np.abs(np.diff(motion.feet, axis=0)).max() < 0.01


def test_heel_strike_points_the_toe_down_first_and_up_before_touch_down():
    walk = eros(heel_strike=True)
    # The left leg swings from 1/10 to 1/2 of the cycle; its sole's x axis points ahead.
    shares = np.array([0.1, 0.2, 0.3, 0.4, 0.5])
    rises = walk.at(shares * walk.period).soles[:, 1, 2, 0]
    assert rises[[0, 2, 4]] == pytest.approx(np.zeros(3), abs=1e-9)
    assert rises[1] < 0 < rises[3]
    found = landing(walk)
    assert found.toe_up == pytest.approx(found.toe_down, rel=1e-3)
    assert found.toe_up > 0
    assert landing(eros()).toe_up == 0
    ankle = walk.robot.legs[1].joint_names.index("ankle_pitch")
    bend = walk.at(0.4 * walk.period).q[1, ankle] - eros().at(0.4 * walk.period).q[1, ankle]
    assert bend < 0


@pytest.mark.parametrize(
    ("name", "step", "sway", "lift"), [("8", 8, 45, 100), ("16", 16, 35, 95), ("24", 24, 25, 90)]
)
def test_the_experiments_are_those_of_the_paper_and_the_legs_can_do_them(name, step, sway, lift):
    walk = eros(experiment=find_experiment(name))
    assert [walk.stride / 2 * 1000, walk.sway * 1000, walk.lift * 1000] == pytest.approx([step, sway, lift])
    assess(walk)


def test_there_are_three_experiments():
    assert len(EXPERIMENTS) == 3
    with pytest.raises(UsageError, match="there are: 8, 16, 24"):
        find_experiment("12")
