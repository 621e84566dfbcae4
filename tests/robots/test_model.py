"""Limbs in their frames, and their servos."""

import numpy as np
import pytest

import kinlab
from kinlab.errors import UsageError
from kinlab.kinematics import chain
from kinlab.kinematics.transforms import apply

ROBOTS = kinlab.load_robots()
LIMBS = {f"{robot.name} {limb.name}": limb for robot in ROBOTS.values() for limb in robot.limbs.values()}
every_limb = pytest.mark.parametrize("limb", LIMBS.values(), ids=LIMBS)
SERVOS = {
    f"{name} {joint.name}": joint.servo
    for name, limb in LIMBS.items()
    for joint in limb.joints
    if joint.servo
}
every_servo = pytest.mark.parametrize("servo", SERVOS.values(), ids=SERVOS)


@every_limb
def test_fk_in_the_body_frame_is_the_mount_before_fk_in_the_limbs(limb):
    q = np.random.default_rng(1).uniform(*limb.limits, (5, len(limb.joints)))
    np.testing.assert_allclose(limb.fk(q, frame="body"), limb.mount @ limb.fk(q), atol=1e-15)
    np.testing.assert_allclose(limb.fk(q), chain.fk(limb.axes, limb.links, q), atol=1e-15)
    np.testing.assert_allclose(limb.frames(q)[:, -1], limb.fk(q), atol=1e-14)


@every_limb
@pytest.mark.parametrize("frame", ["limb", "body", "paper"])
def test_points_go_into_the_limb_frame_and_back(limb, frame):
    points = np.random.default_rng(2).uniform(-1, 1, (4, 5, 3))
    np.testing.assert_allclose(limb.from_limb(limb.to_limb(points, frame), frame), points, atol=1e-15)


@every_limb
def test_the_papers_axes_lie_along_the_limbs(limb):
    A = limb.paper_axes
    np.testing.assert_array_equal(np.sort(np.abs(A)), [[0, 0, 1]] * 3)
    np.testing.assert_array_equal(A @ A.T, np.eye(3))


def test_the_mount_takes_the_limbs_origin_to_its_place_on_the_body():
    leg = ROBOTS["xl430-hexapod"].limbs["R1"]
    np.testing.assert_allclose(apply(leg.mount, [0, 0, 0]), [0.070, -0.040, 0], atol=1e-15)
    # A right leg points to the right, which is -y.
    np.testing.assert_allclose(leg.mount[:3, :3] @ [1, 0, 0], [0, -1, 0], atol=1e-15)


def test_limits_are_the_narrower_of_the_file_and_the_servo():
    for limb in LIMBS.values():
        for joint, (lower, upper) in zip(limb.joints, limb.limits.T, strict=True):
            assert joint.lower <= lower < upper <= joint.upper
            if joint.servo:
                degrees = [joint.servo.zero_deg + joint.servo.sign * np.degrees(q) for q in (lower, upper)]
                low, high = joint.servo.model.range_deg
                assert low - 1e-9 <= min(degrees)
                assert max(degrees) <= high + 1e-9


@pytest.mark.parametrize("q", [0.1, [0.1, 0.2], [[0.1] * 4], [], None])
def test_a_wrong_number_of_angles_is_refused_with_the_joints_names(q):
    with pytest.raises(UsageError, match=r"limb R1 has 3 joints \(coxa, femur, tibia\), got"):
        ROBOTS["xl430-hexapod"].limbs["R1"].fk(q)


def test_limbs_are_found_by_name_or_unique_beginning():
    robot = ROBOTS["eros"]
    assert robot.limb().name == "right_leg"
    assert robot.limb("left_l").name == "left_leg"
    with pytest.raises(UsageError, match="ambiguous: right_leg, right_arm"):
        robot.limb("right")
    with pytest.raises(UsageError, match="no limb of eros is named 'tail'"):
        robot.limb("tail")
    with pytest.raises(UsageError, match="no frame is named 'bdy'; did you mean body"):
        robot.limb().fk(np.zeros(6), frame="bdy")


@every_servo
def test_a_servos_command_is_the_nearest_to_its_angle_over_its_whole_range(servo):
    low, high = servo.model.range_deg
    degrees = np.random.default_rng(3).uniform(low, high, 1000)
    joint = np.radians(servo.sign * (degrees - servo.zero_deg))
    command = servo.command(joint)
    assert (command == np.round(command)).all()
    assert (command >= servo.model.lowest).all()
    assert (command <= servo.model.highest).all()
    back = np.angle(np.exp(1j * (servo.joint(command) - joint)))
    assert np.degrees(np.abs(back)).max() <= servo.model.deg_per_step / 2 + 1e-9


@every_servo
def test_every_command_gives_itself_back(servo):
    commands = np.arange(servo.model.lowest, servo.model.highest + 1)
    np.testing.assert_array_equal(servo.command(servo.joint(commands)), commands)


@every_servo
def test_an_angle_out_of_the_servos_range_is_refused_and_never_clipped(servo):
    low, high = servo.model.range_deg
    if high < 359:
        beyond = np.array([low - 1, high + 1])
        assert np.isnan(servo.command(np.radians(servo.sign * (beyond - servo.zero_deg)))).all()


@every_servo
def test_the_sign_of_each_servo_is_that_of_its_mounting(servo):
    middle = sum(servo.model.range_deg) / 2
    joint = np.radians(servo.sign * (middle - servo.zero_deg))
    assert servo.degrees(joint) == pytest.approx(middle)
    assert servo.degrees(joint + 0.1) - servo.degrees(joint) == pytest.approx(servo.sign * np.degrees(0.1))


def test_table_1_of_the_xl430_paper_comes_out_of_the_mountings():
    leg = ROBOTS["xl430-hexapod"].limbs["R1"]
    q = leg.ik([0.075, 0.010, -0.046]).q
    servos = [float(joint.servo.degrees(angle)) for joint, angle in zip(leg.joints, q, strict=True)]
    assert servos == pytest.approx([82.405, 151.725, 67.159], abs=0.001)


def test_objects_say_what_they_are():
    assert repr(ROBOTS["udiebot"]) == "<Robot udiebot: LF (3), RF (3), LH (3), RH (3)>"
    assert repr(ROBOTS["udiebot"].limbs["LF"]) == "<Limb LF: coxa - femur - tibia>"
