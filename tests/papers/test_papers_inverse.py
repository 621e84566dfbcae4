"""The papers' inverse equations: the corrected form is true, the printed form is what the print says."""

import json

import numpy as np
import pytest

from kinlab import load_robot
from kinlab.kinematics.transforms import rotation, wrap
from kinlab.papers import as_printed
from kinlab.papers.receptionist_arm import START, inverse_jacobian, jacobian, position
from kinlab.papers.tables import printed_table


def rows(paper, *numbers):
    """The rows of tables, as (table, row, cells)."""
    tables = [printed_table(paper, number) for number in numbers]
    return [
        pytest.param(t.number, row, t.rows[row], id=f"{t.number} {row}") for t in tables for row in t.runs
    ]


def place(cells, scale=1.0):
    """The place of the foot that a row begins with."""
    return [scale * cells[axis].figure.value for axis in "xyz"]


def limb_of(robot, limb=None):
    machine = load_robot(robot)
    return machine, machine.limb(limb)


def at(robot, limb, mm, *, frame="limb", heading=None, **options):
    """The paper's variants for a target in mm."""
    machine, which = limb_of(robot, limb)
    attitude = None if heading is None else rotation((0, 0, 1), heading)
    return as_printed(machine, which, which.to_limb(np.array(mm) / 1000, frame), attitude, **options)


def degrees(variant):
    return np.degrees(list(variant.angles.values()))


def costs(variant):
    """Millimetres, by equation."""
    return {f.equation: None if f.cost_m is None else f.cost_m * 1000 for f in variant.faults}


LEGS = [(r, limb) for r in ("xl430-hexapod", "krsri-hexapod", "udiebot") for limb in load_robot(r).limbs]


@pytest.mark.parametrize(("robot", "limb"), LEGS)
def test_corrected_leg_equations_are_the_inverse_kinematics_of_the_leg(robot, limb):
    machine, leg = limb_of(robot, limb)
    for q in np.random.default_rng(1).uniform([-1.0, -1.2, -2.4], [1.0, 1.2, -0.1], (60, 3)):
        target = leg.fk(q)[:3, 3]
        true = leg.ik(target).solutions[0]
        for variant in as_printed(machine, leg, target, printed=()):
            assert variant.error_m < 1e-12
            assert wrap(np.array(list(variant.angles.values())) - true) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("limb", ["right_leg", "left_leg"])
def test_corrected_humanoid_equations_are_the_inverse_kinematics_of_the_leg(limb):
    machine, leg = limb_of("eros", limb)
    rng = np.random.default_rng(2)
    for _ in range(60):
        target = rng.uniform([-0.08, -0.06, -0.23], [0.08, 0.06, -0.15])
        turned = rotation((0, 0, 1), rng.uniform(-0.8, 0.8))
        (variant,) = as_printed(machine, leg, target, turned, printed=())
        true = leg.ik(target, turned).solutions[0]
        assert variant.error_m < 1e-12
        assert wrap(np.array(list(variant.angles.values())) - true) == pytest.approx(0, abs=1e-12)
        assert "off by 0.0 deg" in variant.note


def test_corrected_rate_control_arrives_at_a_true_solution_of_the_arm():
    machine, arm = limb_of("receptionist-arm")
    rng = np.random.default_rng(3)
    for _ in range(60):
        target = arm.fk(rng.uniform([-1.0, -0.5, 0.8], [1.0, 0.5, 2.3]))[:3, 3]
        (variant,) = as_printed(machine, arm, target, printed=())
        found = np.array(list(variant.angles.values()))
        assert variant.error_m < 1e-12
        assert np.nanmin(np.abs(wrap(arm.ik(target).solutions - found)).max(axis=-1)) < 1e-9


# xl430-hexapod


@pytest.mark.parametrize(("table", "row", "cells"), rows("xl430-hexapod", "1"))
def test_table_1_of_the_xl430_hexapod_is_the_corrected_form_through_the_servo_mountings(table, row, cells):
    side = "R1" if row.startswith("right") else "L1"
    leg = load_robot("xl430-hexapod").limb(side)
    (variant,) = at("xl430-hexapod", side, place(cells), frame="paper", printed=())
    for joint, name in zip(leg.joints, "cft", strict=True):
        figure = cells[f"theta_{name}"].figure
        # Four digits, some cut and some rounded: within one of the last.
        assert abs(joint.servo.degrees(variant.angles[joint.name]) - figure.value) < 10.0**-figure.decimals


def test_xl430_equations_4_and_5_have_no_value_letter_for_letter():
    # x0 = 75.664, a^2 = 50.664^2 + 46^2 = 4682.8; (4682.8 + 2500 - 4900) / 2 = 1141.
    (variant,) = at("xl430-hexapod", "R1", (75, 10, -46))
    assert variant.angles is None
    assert variant.tip is None
    assert variant.error_m is None
    assert "(4) asks for the acos of 1141" in variant.note
    assert "not counted against the authors" in variant.note
    assert costs(variant)["4"] is None


def test_xl430_equation_5_alone_points_the_leg_upwards():
    # acos(2282.8 / 6843.1) = 70.513 and atan(6843.1 / 50.664) = 89.576: a femur at 160.089 deg.
    (variant,) = at("xl430-hexapod", "R1", (75, 10, -46), printed={"5"})
    assert degrees(variant) == pytest.approx([7.595, 160.089, -112.840], abs=1e-3)
    assert costs(variant)["5"] == pytest.approx(variant.error_m * 1000)
    assert costs(variant)["1"] == pytest.approx(0, abs=1e-9)


# krsri-hexapod


def test_krsri_equations_have_no_value_for_a_standing_leg():
    # L1 = 130, L2 = sqrt((130 - 52)^2 + 0) = 78, and 90 / 78 = 1.154.
    (variant,) = at("krsri-hexapod", "R1", (130, 0, -90))
    assert variant.angles is None
    assert "(21) asks for the acos of 1.154" in variant.note


def test_krsri_equations_where_they_have_a_value():
    # L1 = 130, L2 = sqrt(78^2 + 50^2) = 92.650; beta1 = acos(60 / 92.650) = 49.639,
    # beta2 = acos((8.1240 + 9.6255 - 11.4018) / 12229.8) = 89.970, beta - 90 = 49.609;
    # gamma - 180 = acos((8.1240 + 11.4018 - 9.6255) / 17160) - 180 = 89.967 - 180.
    (variant,) = at("krsri-hexapod", "R1", (120, 50, -60))
    assert degrees(variant) == pytest.approx([22.620, 49.609, -90.033], abs=1e-3)
    assert variant.error_m * 1000 == pytest.approx(68.822, abs=1e-3)
    assert {k for k, v in costs(variant).items() if v > 1e-6} == {"19", "20", "23"}


def test_krsri_equation_21_loses_the_sign_of_a_foot_nearer_than_the_coxa_is_long():
    (near,) = at("krsri-hexapod", "R1", (40, 0, -100), printed={"21"})
    (far,) = at("krsri-hexapod", "R1", (64, 0, -100), printed={"21"})
    # The foot lands as far outside the coxa's end, 52 mm, as it should stand inside: 64 for 40.
    assert near.tip * 1000 == pytest.approx(far.tip * 1000)
    assert near.error_m * 1000 == pytest.approx(24)
    assert far.error_m == pytest.approx(0, abs=1e-12)


# udiebot


def test_udiebot_equations_have_no_value_where_y_is_zero():
    equations, _ = at("udiebot", None, (260, 0, 100), frame="paper")
    assert equations.angles is None
    assert "(5) divides by zero" in equations.note


def test_udiebot_equations_where_they_have_a_value():
    # (3) hypot(260, 40) = 263.059, (4) hypot(100, 263.059) = 281.425, squared 79200;
    # (5) atan(203.059 / 40) = 78.856; (6) acos(34200 / -84427) = 113.897, their sum 192.752;
    # (7) acos(-34200 / -45000) = 40.536, (10) 90 - 40.536 = 49.464; (8) atan2(260, 40) = 81.254.
    equations, _ = at("udiebot", None, (260, 40, 100), frame="paper")
    assert degrees(equations) == pytest.approx([81.254, 192.752, 49.464], abs=1e-3)
    assert equations.error_m * 1000 == pytest.approx(433.126, abs=1e-3)
    assert all(cost > 1 for cost in costs(equations).values())


@pytest.mark.parametrize(("table", "row", "cells"), rows("udiebot-quadruped", "4", "5", "6"))
def test_every_angle_of_udiebots_tables_4_to_6(table, row, cells):
    _, tables = at("udiebot", None, place(cells, 10), frame="paper")
    printed = [cells[f"theta{i}"].figure.value for i in (1, 2, 3)]
    assert degrees(tables) == pytest.approx(printed, abs=1e-9)


def test_the_row_of_table_6_that_is_off_has_the_knee_of_its_neighbour():
    """25.764, 0.424, -3.961 follows from theta1 and theta2 of its row and theta3 of the row before, but for a sign."""
    alpha, beta, gamma = np.radians([-8.742, 28.722, -59.31])
    r = 15 * (np.cos(beta) + np.cos(beta + gamma))
    foot = [r * np.cos(alpha), 15 * (np.sin(beta) + np.sin(beta + gamma)), r * np.sin(alpha)]
    assert np.trunc(np.array(foot) * 1000) / 1000 == pytest.approx([25.764, -0.424, -3.961])


def test_the_tables_error_is_that_of_pi_and_on_the_real_leg_that_of_the_coxa():
    _, tables = at("udiebot", None, (260, 0, 100), frame="paper")
    found = costs(tables)
    assert found["coxa"] == pytest.approx(60)
    assert found["pi"] == pytest.approx(0.159, abs=1e-3)
    assert found["cut"] < 0.006
    assert tables.own_error_m * 1000 == pytest.approx(0.192, abs=1e-3)
    assert tables.error_m * 1000 == pytest.approx(59.947, abs=1e-3)


# eros


def test_eros_equations_letter_for_letter():
    # dP_y = 10 + 10, dP_x = 30 - 30, P_6z = -225 + 38.3 = -186.7; theta2 = atan(20 / -186.7) = -6.114;
    # gamma_c = acos((22641.9 - 34856.9) / 22641.9) = 122.649, theta4 = 57.351; gamma_a = 0,
    # gamma_b = atan(sin / (1 + cos)) = gamma_c / 2 = 61.324; theta5 = 118.676.
    (variant,) = at("eros", "right_leg", (30, 10, -225))
    assert degrees(variant) == pytest.approx([0, -6.114, 61.324, 57.351, 118.676, 6.114], abs=1e-3)
    assert variant.error_m * 1000 == pytest.approx(306.799, abs=1e-3)
    # Pitch angles sum to 237.351 deg where a level sole needs 0: 122.6 deg the short way round.
    assert "off by 122.6 deg" in variant.note


def test_what_each_fault_of_eros_costs_straight_ahead():
    (variant,) = at("eros", "right_leg", (30, 10, -225))
    found = costs(variant)
    assert found["12"] == pytest.approx(10)  # twice as far sideways
    assert found["13"] == pytest.approx(30)  # no step forwards
    assert found["15"] == pytest.approx(20)  # to the other side
    assert found["22"] == pytest.approx(0, abs=1e-9)  # thigh and shank are equal
    assert found["11"] == pytest.approx(0, abs=1e-9)
    # The ankle stands right and the sole turns by 2 (theta3 + theta4) in the leg's plane, to which the
    # foot's 38.3 mm are inclined by the ankle's roll: a chord.
    _, _, hip, knee, _, roll = degrees(at("eros", "right_leg", (30, 10, -225), printed=())[0])
    assert found["27"] == pytest.approx(
        2 * 38.3 * np.cos(np.radians(roll)) * abs(np.sin(np.radians(hip + knee)))
    )
    # R2 = hypot(30, 186.7) for hypot(30, 186.97): the leg is 0.26 mm too short.
    assert found["17"] == pytest.approx(np.sqrt(30**2 + 10**2 + 186.7**2) - np.hypot(30, 186.7), abs=1e-6)


def test_eros_equation_11_has_no_value_for_a_standing_leg():
    (variant,) = at("eros", "right_leg", (0, 0, -235))
    assert variant.angles is None
    assert "(11) divides by zero" in variant.note


def test_the_heading_is_the_hips_yaw():
    (variant,) = at("eros", "left_leg", (30, 10, -225), heading=0.2)
    assert variant.angles["hip_yaw"] == pytest.approx(0.2)


# receptionist-arm


def test_the_start_of_the_receptionists_experiment_is_at_whole_angles():
    assert position(START, (0.185, 0.25)) * 100 == pytest.approx([-11.322, 7.653, 0], abs=0.02)


def test_the_printed_jacobian_is_right_and_one_entry_of_its_inverse_is_not():
    q, lengths = np.array([0.4, 0.3, 1.2]), (0.185, 0.25)
    J = jacobian(q, lengths)
    step = 1e-7
    columns = [
        (position(q + step * e, lengths) - position(q - step * e, lengths)) / (2 * step) for e in np.eye(3)
    ]
    theta1, theta0, theta2 = columns
    assert np.column_stack([theta1, theta2, theta0]) == pytest.approx(J, abs=1e-8)
    assert J @ inverse_jacobian(J) == pytest.approx(np.eye(3), abs=1e-12)
    wrong = inverse_jacobian(J, frozenset(["J_inv32"])) - np.linalg.inv(J)
    assert np.abs(wrong).max() > 1
    wrong[2, 1] = 0
    assert wrong == pytest.approx(0, abs=1e-9)


def test_the_misprint_costs_nothing_in_the_plane_of_the_experiment():
    (variant,) = at("receptionist-arm", None, (-113.22, 276.53, 0), frame="paper")
    assert variant.error_m < 1e-12
    assert "there after 6 steps, corrected there after 6 steps" in variant.note


def test_out_of_the_plane_the_misprint_keeps_the_arm_from_arriving():
    (variant,) = at("receptionist-arm", None, (-29, 261, 60), frame="paper")
    assert "not there after 200 steps, corrected there after" in variant.note
    assert variant.error_m > 0.1
    assert costs(variant)["J_inv32"] == pytest.approx(variant.error_m * 1000)


# all of them


@pytest.mark.parametrize("robot", ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros", "receptionist-arm"])
def test_json_holds_numbers_and_null_alone(robot):
    machine, limb = limb_of(robot)
    for target in ([0.1, 0.02, -0.08], [0, 0, 0], [5, 5, 5], [1e5, 0, 0], [1e200, 1e200, 0]):
        for variant in as_printed(machine, limb, target):
            found = variant.to_json(limb, "body")
            json.dumps(found, allow_nan=False)
            assert {"variant", "where", "angles_deg", "fk_mm", "error_mm", "note", "faults"} <= set(found)
            assert (found["angles_deg"] is None) == (found["error_mm"] is None)


def test_a_limb_without_printed_inverse_kinematics_has_no_variants():
    assert at("eros", "head", (0, 0, 100)) == ()
    assert at("eros", "left_arm", (0, 0, -200)) == ()
