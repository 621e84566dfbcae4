"""MuJoCo, which shares no code with KinLab, judges the dynamics: of every robot's URDF, and of sliding joints."""

from xml.etree import ElementTree as ET

import mujoco
import numpy as np
import pytest

import kinlab
from kinlab.dynamics import GRAVITY, Mechanism, forward_dynamics, inverse_dynamics, mass_matrix
from kinlab.robots.urdf import to_urdf

ROBOTS = kinlab.load_robots()


def of_urdf(robot):
    root = ET.fromstring(to_urdf(robot))
    # MuJoCo changes inertias that it finds too small, unless it is told not to.
    ET.SubElement(
        ET.SubElement(root, "mujoco"),
        "compiler",
        fusestatic="false",
        discardvisual="true",
        balanceinertia="false",
    )
    model = mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))
    model.opt.gravity[:] = [0, 0, -GRAVITY]
    return model


@pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)
def test_torques_and_inertias_of_every_limb_are_mujocos(robot):
    model = of_urdf(robot)
    data = mujoco.MjData(model)
    rng = np.random.default_rng(5)
    for limb in robot.limbs.values():
        mechanism = Mechanism.of(limb)
        columns = [int(model.joint(f"{limb.name}_{j.name}").dofadr[0]) for j in limb.joints]
        for _ in range(10):
            q, qd, qdd = rng.uniform(-2, 2, (3, mechanism.count))
            data.qpos[columns], data.qvel[columns], data.qacc[columns] = q, qd, qdd
            mujoco.mj_inverse(model, data)
            # It counts limits that are violated as forces; they are no part of the question.
            torque = (data.qfrc_inverse + data.qfrc_constraint)[columns]
            np.testing.assert_allclose(inverse_dynamics(mechanism, q, qd, qdd), torque, atol=1e-12)
            M = np.zeros((model.nv, model.nv))
            mujoco.mj_fullM(model, data, M)
            np.testing.assert_allclose(mass_matrix(mechanism, q), M[np.ix_(columns, columns)], atol=1e-12)


def test_a_push_at_the_hand_accelerates_the_arm_as_mujoco_says():
    robot = ROBOTS["receptionist-arm"]
    limb = robot.limb()
    model, mechanism = of_urdf(robot), Mechanism.of(limb)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    data = mujoco.MjData(model)
    columns = [int(model.joint(f"{limb.name}_{j.name}").dofadr[0]) for j in limb.joints]
    rng = np.random.default_rng(6)
    for _ in range(10):
        q, qd, torque = rng.uniform(-1, 1, (3, 3))
        wrench = rng.uniform(-5, 5, 6)
        data.qpos[columns], data.qvel[columns], data.qfrc_applied[columns] = q, qd, torque
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        # The limb frame of the arm has the attitude of the body, so the force needs no turn.
        tip, push = data.body(f"{limb.name}_tip"), np.zeros(model.nv)
        mujoco.mj_applyFT(model, data, wrench[:3], wrench[3:], tip.xpos, tip.id, push)
        data.qfrc_applied[columns] += push[columns]
        mujoco.mj_forward(model, data)
        found = forward_dynamics(mechanism, q, qd, torque, wrench)
        np.testing.assert_allclose(found, data.qacc[columns], rtol=1e-8, atol=1e-8)


def test_sliding_joints_are_mujocos(chain, motion):
    """A chain with skew axes and sliding joints, written out for MuJoCo by hand."""
    root = ET.Element("mujoco")
    ET.SubElement(root, "compiler", inertiafromgeom="false")
    ET.SubElement(root, "option", gravity=" ".join(map(repr, chain.gravity.tolist())))
    parent, offset = ET.SubElement(root, "worldbody"), np.zeros(3)
    for axis, link, mass, centre, inertia, slides in chain.rows:
        parent = ET.SubElement(parent, "body", pos=" ".join(map(repr, map(float, offset))))
        ET.SubElement(
            parent, "joint", type="slide" if slides else "hinge", axis=" ".join(map(repr, axis)), pos="0 0 0"
        )
        full = [inertia[i][j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        ET.SubElement(
            parent, "inertial", mass=repr(mass),
            pos=" ".join(map(repr, centre)), fullinertia=" ".join(map(repr, full)),
        )  # fmt: skip
        offset = np.array(link)
    model = mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))
    data = mujoco.MjData(model)
    torque = inverse_dynamics(chain, *motion)
    for i, (q, qd, qdd) in enumerate(zip(*motion, strict=True)):
        data.qpos[:], data.qvel[:], data.qacc[:] = q, qd, qdd
        mujoco.mj_inverse(model, data)
        np.testing.assert_allclose(torque[i], data.qfrc_inverse, rtol=1e-9, atol=1e-9)
