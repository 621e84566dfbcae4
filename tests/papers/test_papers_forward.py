"""The papers' forward and body equations: the corrected form is true, the printed form is what the print says."""

import json

import numpy as np
import pytest

from kinlab import load_robot
from kinlab.kinematics.transforms import rotation
from kinlab.papers import body_as_printed, fk_as_printed, krsri_hexapod, udiebot_quadruped

CHAINS = [
    ("eros", "head"),
    ("eros", "right_arm"),
    ("eros", "left_arm"),
    ("receptionist-arm", "right_arm"),
    ("receptionist-arm", "left_arm"),
]


def forms(robot, limb, q, **options):
    machine = load_robot(robot)
    return fk_as_printed(machine, machine.limb(limb), q, **options)


@pytest.mark.parametrize(("robot", "limb"), CHAINS)
def test_corrected_forward_equations_are_the_forward_kinematics(robot, limb):
    which = load_robot(robot).limb(limb)
    rng = np.random.default_rng(4)
    for _ in range(20):
        q = rng.uniform(-3, 3, len(which.joints))
        for form in forms(robot, limb, q, printed=()):
            assert form.pose == pytest.approx(which.fk(q), abs=1e-12)
            assert form.attitude_error < 1e-12


def test_corrected_dh_parameters_are_the_forward_kinematics_of_udiebots_leg():
    leg = load_robot("udiebot").limb()
    for q in np.random.default_rng(5).uniform(-3, 3, (20, 3)):
        assert udiebot_quadruped.dh(q, (0.06, 0.15, 0.15))[:3, 3] == pytest.approx(
            leg.fk(q)[:3, 3], abs=1e-12
        )
    (form,) = forms("udiebot", "LF", [0.1, 0.2, -0.3])
    assert form.pose is None
    assert "alpha_i, an angle, where the length a_i belongs" in form.note


def test_the_head_turns_sideways_by_the_sine_of_the_wrong_angle():
    (form,) = forms("eros", "head", np.radians([90, 30]))
    # 80 mm sin(30) sin(30) = 20 for 80 sin(90) sin(30) = 40.
    assert form.pose[:3, 3] * 1000 == pytest.approx([0, 20, 30 + 80 * np.cos(np.pi / 6)])
    assert form.error_m * 1000 == pytest.approx(20)
    assert form.attitude_error == pytest.approx(0, abs=1e-12)


def test_the_arms_phi_costs_the_forearm_and_r11_the_attitude():
    (form,) = forms("eros", "right_arm", np.zeros(3))
    # phi = 68.6 + 147.6 sin(0): the forearm is lost; R11 is the same, as sin(theta1) = 0.
    assert form.pose[:3, 3] * 1000 == pytest.approx([0, 0, -18.3 - 68.6])
    assert [f.cost_m * 1000 for f in form.faults] == pytest.approx([0, 147.6])
    (form,) = forms("eros", "right_arm", np.radians([90, 0, 0]), printed={"R11"})
    # cos(90) cos(0) - cos(0) sin(90) = -1 for 0.
    assert form.pose[0, 0] == pytest.approx(-1)
    assert form.attitude_error == pytest.approx(1)
    assert form.error_m < 1e-12


def test_the_receptionists_translations_with_a_zero_lose_the_forearm():
    product, multiplied = forms("receptionist-arm", None, np.zeros(3))
    # Stretched out along the paper's x, the limb's -z: L1 alone for L1 + L2.
    assert product.pose[:3, 3] * 1000 == pytest.approx([0, 0, -185])
    assert product.error_m * 1000 == pytest.approx(250)
    assert multiplied.error_m < 1e-12


def test_the_receptionists_attitude_is_that_of_an_arm_with_the_shoulders_axes_exchanged():
    t1, t0, t2 = 0.4, 0.9, 1.1
    arm = load_robot("receptionist-arm").limb()
    _, form = forms("receptionist-arm", None, [t1, t0, t2], printed={"order"})
    exchanged = rotation((0, 1, 0), t0) @ rotation((0, 0, 1), t1 + t2)
    assert arm.paper_axes.T @ form.pose[:3, :3] @ arm.paper_axes == pytest.approx(exchanged, abs=1e-12)
    assert form.error_m < 1e-12
    _, letter = forms("receptionist-arm", None, [t1, t0, t2])
    # Of its nine entries R32 alone is not even that: c0 s0 s1 stands for c2 s0 s1.
    off = np.abs(arm.paper_axes.T @ letter.pose[:3, :3] @ arm.paper_axes - exchanged)
    assert off[2, 1] == pytest.approx(abs(np.cos(t0) - np.cos(t2)) * np.sin(t0) * np.sin(t1))
    off[2, 1] = 0
    assert off.max() < 1e-12


def test_a_limb_without_printed_forward_kinematics_has_no_forms():
    assert forms("xl430-hexapod", "R1", np.zeros(3)) == ()
    assert forms("eros", "right_leg", np.zeros(6)) == ()


# krsri (1) to (16)


def standing():
    robot = load_robot("krsri-hexapod")
    feet = np.array([leg.from_limb(leg.stance, "body") for leg in robot.legs])
    return robot, feet, np.array([leg.mount[:3, 3] for leg in robot.legs])


def test_corrected_body_equations_keep_the_feet_where_they_stand():
    robot, feet, hips = standing()
    rng = np.random.default_rng(6)
    for _ in range(20):
        xyz, rpy = rng.uniform(-0.03, 0.03, 3), rng.uniform(-0.3, 0.3, 3)
        true = np.array(list(body_as_printed(robot, xyz, rpy).true_feet.values()))
        assert krsri_hexapod.body(feet, hips, xyz, rpy) == pytest.approx(true, abs=1e-12)


def test_the_printed_body_goes_backwards_and_up():
    robot, _, _ = standing()
    forwards = body_as_printed(robot, (0.02, 0, 0), (0, 0, 0))
    assert list(forwards.error_m.values()) == pytest.approx([0.04] * 6)  # feet 20 mm ahead, not behind
    upwards = body_as_printed(robot, (0, 0, 0.02), (0, 0, 0))
    assert list(upwards.error_m.values()) == pytest.approx([0] * 6, abs=1e-12)


def test_the_printed_yaw_turns_the_other_way_and_every_foot_about_its_own_hip():
    robot, feet, hips = standing()
    faults = {f.equation: f.cost_m for f in body_as_printed(robot, (0, 0, 0), (0, 0, 0.2)).faults}
    farthest = np.linalg.norm(feet[:, :2], axis=1).max()
    assert faults["8"] == pytest.approx(2 * farthest * np.sin(0.2))
    assert faults["3 to 5"] == pytest.approx(2 * np.linalg.norm(hips[:, :2], axis=1).max() * np.sin(0.1))
    assert faults["16"] == pytest.approx(0, abs=1e-12)


def test_roll_and_pitch_turn_the_right_way_about_the_wrong_point():
    robot, _, hips = standing()
    faults = {f.equation: f.cost_m for f in body_as_printed(robot, (0, 0, 0), (0.2, 0, 0)).faults}
    assert faults["8"] == pytest.approx(0, abs=1e-12)
    assert faults["3 to 5"] == pytest.approx(2 * np.abs(hips[:, 1]).max() * np.sin(0.1))


def test_json_holds_numbers_and_null_alone():
    robot, _, _ = standing()
    for forwards in (0.01, 1e200):
        json.dumps(body_as_printed(robot, (forwards, 0, 0), (0, 0.1, 0)).to_json(), allow_nan=False)
    for name, limb in [*CHAINS, ("udiebot", "LF")]:
        which = load_robot(name).limb(limb)
        for form in forms(name, limb, np.full(len(which.joints), 0.3)):
            json.dumps(form.to_json(which, "body"), allow_nan=False)


def test_a_paper_without_body_equations_says_nothing():
    assert body_as_printed(load_robot("udiebot"), (0, 0, 0), (0, 0, 0)) is None
