"""The body over fixed feet: every leg's joints for its pose."""

import numpy as np
import pytest

import kinlab
from kinlab.errors import UsageError
from kinlab.kinematics.transforms import apply, homogeneous, rpy_to_rotation
from kinlab.robots.body import body_pose, legs_ik, resting

ROBOTS = {name: robot for name, robot in kinlab.load_robots().items() if robot.legs}
every_robot = pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)


def feet_on_the_ground(robot, pose, xyz, rpy):
    """Where forward kinematics puts the feet, in the frame of the body before it moved."""
    tips = [leg.fk(pose.q[..., i, :], frame="body")[..., :3, 3] for i, leg in enumerate(robot.legs)]
    moved = homogeneous(rpy_to_rotation(rpy), xyz)
    return apply(moved[..., None, :, :], np.stack(tips, axis=-2))


@every_robot
def test_the_feet_stay_where_they_are_while_the_body_moves_and_turns(robot):
    rng = np.random.default_rng(1)
    xyz, rpy = rng.uniform(-0.01, 0.01, (100, 3)), rng.uniform(-0.05, 0.05, (100, 3))
    pose = body_pose(robot, xyz, rpy)
    assert pose.reachable.mean() > 0.9
    feet = feet_on_the_ground(robot, pose, xyz, rpy)
    gone = np.linalg.norm(feet - robot.standing_feet, axis=-1)
    np.testing.assert_array_equal(np.isnan(gone), ~pose.reachable)
    assert np.nanmax(gone) < 1e-12


@every_robot
def test_no_pose_is_the_stance(robot):
    pose = body_pose(robot, [0, 0, 0], [0, 0, 0])
    assert pose.reachable.all()
    for i, leg in enumerate(robot.legs):
        np.testing.assert_allclose(leg.fk(pose.q[i])[:3, 3], leg.stance, atol=1e-14)


@every_robot
def test_a_batch_is_no_different_from_its_poses(robot):
    rng = np.random.default_rng(2)
    xyz, rpy = rng.uniform(-0.03, 0.03, (2, 5, 3)), rng.uniform(-0.2, 0.2, (2, 5, 3))
    many = body_pose(robot, xyz, rpy)
    assert many.q.shape == (2, 5, len(robot.legs), len(robot.legs[0].joints))
    for i, j in np.ndindex(2, 5):
        one = body_pose(robot, xyz[i, j], rpy[i, j])
        np.testing.assert_array_equal(one.reachable, many.reachable[i, j])
        np.testing.assert_allclose(one.q, many.q[i, j], atol=1e-12)


@every_robot
def test_raising_the_body_lowers_the_feet_in_its_frame(robot):
    pose = body_pose(robot, [0, 0, 0.005], [0, 0, 0])
    np.testing.assert_allclose(
        pose.feet - robot.standing_feet, [[0, 0, -0.005]] * len(robot.legs), atol=1e-15
    )


def test_turning_left_turns_the_feet_to_the_right_in_the_bodys_frame():
    robot = ROBOTS["xl430-hexapod"]
    pose = body_pose(robot, [0, 0, 0], [0, 0, 0.1])
    angle = np.arctan2(pose.feet[:, 1], pose.feet[:, 0]) - np.arctan2(*robot.standing_feet[:, 1::-1].T)
    np.testing.assert_allclose(np.angle(np.exp(1j * angle)), -0.1, atol=1e-12)


@every_robot
def test_each_leg_is_solved_as_on_its_own(robot):
    feet = robot.standing_feet + np.random.default_rng(3).uniform(-0.06, 0.06, (50, len(robot.legs), 3))
    many = legs_ik(robot, feet)
    for i, leg in enumerate(robot.legs):
        own = leg.ik(leg.to_limb(feet[:, i], "body"))
        np.testing.assert_array_equal(many.reachable[:, i], own.reachable)
        np.testing.assert_allclose(many.q[:, i], own.q, atol=1e-12)


def test_soles_stay_level_on_the_ground_while_the_body_leans():
    robot = ROBOTS["eros"]
    rpy = [0.05, -0.08, 0.1]
    pose = body_pose(robot, [0, 0, 0], rpy)
    for i, leg in enumerate(robot.legs):
        R = rpy_to_rotation(rpy) @ leg.fk(pose.q[i], frame="body")[:3, :3]
        np.testing.assert_allclose(R, np.eye(3), atol=1e-12)


def test_a_pose_out_of_reach_says_which_feet():
    pose = body_pose(ROBOTS["xl430-hexapod"], [0, 0, 0.2], [0, 0, 0])
    assert not pose.reachable.any()
    assert np.isnan(pose.q).all()


def test_a_robot_without_legs_has_nothing_to_stand_on():
    with pytest.raises(UsageError, match="receptionist-arm has no legs"):
        body_pose(kinlab.load_robot("receptionist-arm"), [0, 0, 0], [0, 0, 0])


@pytest.mark.parametrize("robot", kinlab.load_robots().values(), ids=kinlab.load_robots())
def test_at_rest_legs_stand_and_nothing_is_beyond_its_limits(robot):
    for name, q in resting(robot).items():
        limb = robot.limbs[name]
        lower, upper = limb.limits
        assert ((lower - 1e-6 <= q) & (q <= upper + 1e-6)).all()
        if limb.stance is None:
            assert not q[(lower <= 0) & (upper >= 0)].any()
        else:
            np.testing.assert_allclose(limb.fk(q)[:3, 3], limb.stance, atol=1e-12)
