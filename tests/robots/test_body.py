"""The body over fixed feet."""

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.kinematics.transforms import homogeneous, inverse, rpy_to_rotation
from kinlab.robots import load_robot
from kinlab.robots.body import body_pose, legs_ik

WALKERS = ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros"]


@pytest.mark.parametrize("name", WALKERS)
def test_the_feet_stay_on_the_ground_for_any_pose_of_the_body(name):
    robot = load_robot(name)
    rng = np.random.default_rng(7)
    xyz, rpy = rng.uniform(-0.008, 0.008, (50, 3)), rng.uniform(-0.06, 0.06, (50, 3))
    found = body_pose(robot, xyz, rpy)
    body = homogeneous(rpy_to_rotation(rpy), xyz)
    for i, leg in enumerate(robot.legs):
        ok = found.reachable[:, i]
        assert ok.mean() > 0.9
        feet = (body @ leg.fk(found.q[:, i], frame="body"))[ok, :3, 3]
        assert np.abs(feet - robot.standing_feet[i]).max() < 1e-12


def test_soles_of_six_joint_legs_stay_level():
    robot = load_robot("eros")
    rpy = np.array([0.05, -0.04, 0.1])
    found = body_pose(robot, [0, 0, -0.005], rpy)
    for i, leg in enumerate(robot.legs):
        sole = rpy_to_rotation(rpy) @ leg.fk(found.q[i], frame="body")[:3, :3]
        assert np.abs(sole - np.eye(3)).max() < 1e-12


@pytest.mark.parametrize("name", WALKERS)
def test_one_call_for_all_legs_equals_each_leg_by_itself(name):
    robot = load_robot(name)
    found = body_pose(robot, [0.004, -0.003, 0.002], [0.02, 0.01, -0.03])
    for i, leg in enumerate(robot.legs):
        place = leg.to_limb(found.feet[i], "body")
        R = None
        if len(leg.joints) == 6:
            R = (inverse(leg.mount)[:3, :3] @ rpy_to_rotation([0.02, 0.01, -0.03]).T) @ leg.mount[:3, :3]
        assert np.abs(leg.ik(place, R).q - found.q[i]).max() < 1e-12


def test_a_foot_out_of_reach_is_said_and_has_no_angles():
    robot = load_robot("xl430-hexapod")
    feet = robot.standing_feet.copy()
    feet[2] += [0, -0.5, 0]
    found = legs_ik(robot, feet)
    assert found.reachable.tolist() == [True, True, False, True, True, True]
    assert np.isnan(found.q[2]).all()


def test_a_robot_without_legs_cannot_stand():
    with pytest.raises(UsageError, match="no legs"):
        body_pose(load_robot("receptionist-arm"), [0, 0, 0], [0, 0, 0])
