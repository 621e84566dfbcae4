"""The exported URDF: MuJoCo, which shares no code with KinLab, must find every tip where KinLab does."""

from xml.etree import ElementTree as ET

import mujoco
import numpy as np
import pytest

import kinlab
from kinlab.robots.urdf import to_urdf

ROBOTS = kinlab.load_robots()
every_robot = pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)


def judge(robot):
    """MuJoCo's model of the URDF, with every link a body of its own."""
    root = ET.fromstring(to_urdf(robot))
    # MuJoCo fuses links that do not move into their parents, unless it is told not to.
    ET.SubElement(ET.SubElement(root, "mujoco"), "compiler", fusestatic="false", discardvisual="true")
    return mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))


@every_robot
def test_mujoco_finds_tips_and_joints_where_kinlab_does(robot):
    model = judge(robot)
    data = mujoco.MjData(model)
    rng = np.random.default_rng(1)
    for _ in range(20):
        angles = {limb.name: rng.uniform(*limb.limits) for limb in robot.limbs.values()}
        for limb in robot.limbs.values():
            for joint, angle in zip(limb.joints, angles[limb.name], strict=True):
                data.joint(f"{limb.name}_{joint.name}").qpos = angle
        mujoco.mj_kinematics(model, data)
        for limb in robot.limbs.values():
            q = angles[limb.name]
            tip = data.body(f"{limb.name}_tip")
            T = limb.fk(q, frame="body")
            np.testing.assert_allclose(tip.xpos, T[:3, 3], atol=1e-12)
            np.testing.assert_allclose(tip.xmat.reshape(3, 3), T[:3, :3], atol=1e-12)
            frames = limb.mount @ limb.frames(q)
            for i, joint in enumerate(limb.joints):
                found = data.joint(f"{limb.name}_{joint.name}")
                np.testing.assert_allclose(found.xanchor, frames[i, :3, 3], atol=1e-12)
                np.testing.assert_allclose(found.xaxis, frames[i, :3, :3] @ joint.axis, atol=1e-12)


@every_robot
def test_mujocos_jacobian_of_each_tip_is_kinlabs(robot):
    model = judge(robot)
    data = mujoco.MjData(model)
    rng = np.random.default_rng(2)
    data.qpos[:] = rng.uniform(-1, 1, model.nq)
    mujoco.mj_forward(model, data)
    for limb in robot.limbs.values():
        columns = [int(model.joint(f"{limb.name}_{j.name}").dofadr[0]) for j in limb.joints]
        q = np.array([data.joint(f"{limb.name}_{j.name}").qpos[0] for j in limb.joints])
        linear, angular = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        mujoco.mj_jacBody(model, data, linear, angular, model.body(f"{limb.name}_tip").id)
        J, R = limb.jacobian(q), limb.mount[:3, :3]
        np.testing.assert_allclose(linear[:, columns], R @ J[:3], atol=1e-12)
        np.testing.assert_allclose(angular[:, columns], R @ J[3:], atol=1e-12)


@every_robot
def test_the_limits_are_those_of_the_robots_file_and_the_servos(robot):
    model = judge(robot)
    for limb in robot.limbs.values():
        for joint, (lower, upper) in zip(limb.joints, limb.limits.T, strict=True):
            np.testing.assert_allclose(model.joint(f"{limb.name}_{joint.name}").range, [lower, upper])


@every_robot
def test_the_names_are_those_of_the_contract(robot):
    root = ET.fromstring(to_urdf(robot))
    links = {link.get("name") for link in root.iter("link")}
    joints = {joint.get("name") for joint in root.iter("joint")}
    assert root.get("name") == robot.name
    assert "body" in links
    for limb in robot.limbs.values():
        assert f"{limb.name}_tip" in links
        assert {f"{limb.name}_{joint.name}" for joint in limb.joints} <= joints


@every_robot
def test_every_moving_link_has_a_mass_and_an_inertia_that_a_body_can_have(robot):
    model = judge(robot)
    for limb in robot.limbs.values():
        for joint in limb.joints:
            body = int(model.joint(f"{limb.name}_{joint.name}").bodyid[0])
            assert model.body_mass[body] > 0
            small, middle, large = sorted(model.body_inertia[body])
            assert small > 0
            assert large <= small + middle + 1e-15


def test_a_name_from_a_users_file_cannot_break_the_xml(tmp_path):
    path = tmp_path / "mine.yaml"
    path.write_text(
        "robots:\n  'a<b&\"c':\n    legs:\n"
        "      {coxa: 1, femur: 2, tibia: 3, joints: leg, members: {'L\"<': {at: [0, 0, 0]}}}\n"
    )
    robot = kinlab.load_robot('a<b&"c', path)
    assert ET.fromstring(to_urdf(robot)).get("name") == 'a<b&"c'
