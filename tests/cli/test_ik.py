"""`kinlab ik`: the contract that other people's scripts rely on."""

import numpy as np
import pytest

import kinlab as package

KEYS = {"robot", "limb", "frame", "target_mm", "reachable", "chosen", "solutions"}
SOLUTION_KEYS = {
    "name", "angles_deg", "within_limits", "fk_mm", "error_mm", "servos", "quantised_fk_mm", "quantised_error_mm",
}  # fmt: skip


def test_json_holds_the_contract(kinlab):
    answer = kinlab("ik", "xl430-hexapod", 75, 10, -46, "--limb", "R1", "--json")
    assert answer.code == 0
    assert answer.err == ""
    found = answer.json
    assert set(found) >= KEYS
    assert (found["robot"], found["limb"], found["frame"]) == ("xl430-hexapod", "R1", "limb")
    assert found["target_mm"] == [75, 10, -46]
    assert found["reachable"] is True
    best = found["solutions"][found["chosen"]]
    assert set(best) >= SOLUTION_KEYS
    assert best["name"] == "knee-up"
    assert list(best["angles_deg"]) == ["coxa", "femur", "tibia"]
    assert best["error_mm"] < 1e-9
    assert 0 < best["quantised_error_mm"] < 0.2
    assert "as_printed" not in found


# Printed with four digits, some of them cut.
@pytest.mark.parametrize(
    ("limb", "y", "z", "printed"),
    [
        ("R1", 10, -46, (82.40, 151.7, 67.15)),
        ("R2", 10, -60, (82.40, 168.5, 79.85)),
        ("R3", -10, -60, (97.59, 168.5, 79.85)),
        ("R1", -10, -46, (97.59, 151.7, 67.15)),
        ("L1", 10, -46, (97.59, 151.7, 112.8)),
        ("L2", 10, -60, (97.59, 168.5, 100.2)),
        ("L3", -10, -60, (82.40, 168.5, 100.2)),
    ],
)
def test_table_1_of_the_xl430_paper_comes_out_of_the_mountings(kinlab, limb, y, z, printed):
    found = kinlab("ik", "xl430-hexapod", 75, y, z, "--limb", limb, "--frame", "paper", "--json").json
    servos = found["solutions"][found["chosen"]]["servos"]
    for joint, value in zip(("coxa", "femur", "tibia"), printed, strict=True):
        digits = 2 if value < 100 else 1
        assert abs(servos[joint]["servo_deg"] - value) < 10**-digits


def test_servo_angles_are_shown_to_the_digits_of_table_1(kinlab):
    shown = kinlab("ik", "xl430-hexapod", 75, 10, -46, "--limb", "R1").out
    assert "82.40" in shown
    assert "151.7" in shown
    assert "67.15" in shown


def test_udiebot_agrees_with_the_truth_and_its_tables_with_table_6(kinlab):
    args = ("ik", "udiebot", 26, 0, 10, "--unit", "cm", "--frame", "paper", "--as-printed", "--json")
    found = kinlab(*args).json
    best = found["solutions"][found["chosen"]]
    # r = sqrt(26^2 + 10^2) - 6 = 21.8568 cm; cos(theta2) = r / 30, theta3 = -2 theta2, theta1 = atan(10 / 26).
    theta2 = np.degrees(np.arccos((np.hypot(26, 10) - 6) / 30))
    assert best["angles_deg"]["coxa"] == pytest.approx(np.degrees(np.arctan2(10, 26)), abs=1e-9)
    assert best["angles_deg"]["femur"] == pytest.approx(theta2, abs=1e-9)
    assert best["angles_deg"]["tibia"] == pytest.approx(-2 * theta2, abs=1e-9)
    tables = next(v for v in found["as_printed"] if v["variant"] == "tables")
    assert tables["angles_deg"]["coxa"] == pytest.approx(21.029, abs=1e-3)
    assert tables["angles_deg"]["femur"] == pytest.approx(21.779, abs=1e-3)
    assert tables["angles_deg"]["tibia"] == pytest.approx(-43.632, abs=1e-3)


def test_pwm_servos_have_pulses_and_no_ticks(kinlab):
    found = kinlab("ik", "udiebot", 160, 0, -140, "--json").json
    servo = found["solutions"][found["chosen"]]["servos"]["coxa"]
    assert servo["ticks"] is None
    assert 750 <= servo["pulse_us"] <= 2250


def test_a_robot_without_printed_servos_has_no_servo_angles(kinlab):
    found = kinlab("ik", "eros", 0, 0, -235, "--limb", "left_leg", "--json").json
    best = found["solutions"][found["chosen"]]
    assert best["servos"] == {}
    assert best["quantised_error_mm"] is None


def test_units_and_frames_name_the_same_place(kinlab):
    machine = package.load_robot("xl430-hexapod")
    place = machine.limbs["L2"].from_limb([0.075, 0.010, -0.046], "body") * 1000
    in_limb = kinlab("ik", "xl430", 7.5, 1.0, -4.6, "--unit", "cm", "--limb", "L2", "--json").json
    in_body = kinlab("ik", "xl430", *place, "--frame", "body", "--limb", "L2", "--json").json
    assert in_body["target_mm"] == pytest.approx(place.tolist())
    for name, angle in in_limb["solutions"][0]["angles_deg"].items():
        assert in_body["solutions"][0]["angles_deg"][name] == pytest.approx(angle, abs=1e-9)


def test_an_unreachable_target_says_why_how_far_and_where_the_limb_gets(kinlab):
    answer = kinlab("ik", "udiebot", 400, 0, 0, "--json")
    assert answer.code == 1
    found = answer.json
    assert found["reachable"] is False
    assert found["chosen"] is None
    assert "out of reach" in found["reason"]
    # The leg is 60 + 150 + 150 mm long.
    assert found["nearest_mm"] == pytest.approx([360, 0, 0], abs=1e-6)
    assert found["missed_mm"] == pytest.approx(40, abs=1e-6)
    assert kinlab("ik", "udiebot", 400, 0, 0).code == 1


def test_a_target_beyond_the_limits_is_refused_with_its_solutions_shown(kinlab):
    answer = kinlab("ik", "xl430-hexapod", -75, 0, -60, "--json")
    assert answer.code == 1
    assert "limit" in answer.json["reason"]
    assert answer.json["solutions"]
    assert not any(s["within_limits"] for s in answer.json["solutions"])


@pytest.mark.parametrize(
    ("args", "says"),
    [
        (("nan", 0, 0), "finite"),
        (("inf", 0, 0), "finite"),
        ((0, "-inf", 0), "finite"),
        (("x", 0, 0), "expected a number, got 'x'"),
        ((1, 2), "three numbers X Y Z, got 2"),
        ((1, 2, 3, 4), "three numbers X Y Z, got 4"),
        ((75, 0, -60, "--unit", "inch"), "no unit is named 'inch'"),
        ((75, 0, -60, "--limb", "R7"), "no limb of xl430-hexapod is named 'R7'"),
        ((75, 0, -60, "--limb", "R"), "ambiguous: R1, R2, R3"),
        ((75, 0, -60, "--frame", "word"), "no frame is named 'word'"),
        ((75, 0, -60, "--method", "newtn"), "did you mean newton"),
        ((75, 0, -60, "--rpy", 0, 0, 5), "cannot choose its attitude"),
        ((75, 0, -60, "--rpy", 0, 0, 5, "--yaw", 5), "give one of the two"),
        ((75, 0, -60, "--trace"), "--method"),
        ((75, 0, -60, "--jsno"), "--json"),
        ((1e200, 0, 0), "is the unit right?"),
        ((1e5, 0, 0), "out of reach"),
    ],
)
def test_wrong_input_is_answered_in_words(kinlab, args, says):
    answer = kinlab("ik", "xl430-hexapod", *args)
    assert answer.code == (1 if says == "out of reach" else 2)
    assert says in answer.err + answer.out


def test_an_unknown_robot_is_answered_with_the_nearest_name(kinlab):
    answer = kinlab("ik", "udibot", 1, 2, 3)
    assert answer.code == 2
    assert answer.err == "kinlab: no robot is named 'udibot'; did you mean udiebot?\n"


@pytest.mark.parametrize(
    "numbers", [("-20", "-30", "-50"), ("-2e1", "-.3e2", "-50."), ("-20,0", "-30", "-50")]
)
def test_negative_numbers_are_plain_arguments(kinlab, numbers):
    found = kinlab("ik", "xl430-hexapod", *numbers, "--json").json
    assert found["target_mm"] == [-20, -30, -50]


@pytest.mark.parametrize("at", range(5))
def test_options_stand_anywhere_between_the_numbers(kinlab, at):
    args = ["xl430-hexapod", "75", "-10", "-46"]
    args[at:at] = ["--limb", "L3"]
    assert kinlab("ik", *args, "--json").json["limb"] == "L3"


def test_an_attitude_is_asked_for_by_rpy_or_by_yaw(kinlab):
    by_rpy = kinlab("ik", "eros", 10, 5, -220, "--rpy", 0, 0, -12.5, "--json").json
    by_yaw = kinlab("ik", "eros", 10, 5, -220, "--yaw", -12.5, "--json").json
    assert by_rpy["solutions"] == by_yaw["solutions"]
    best = by_yaw["solutions"][by_yaw["chosen"]]
    machine = package.load_robot("eros")
    T = machine.limb().fk(np.radians(list(best["angles_deg"].values())))
    assert np.degrees(np.arctan2(T[1, 0], T[0, 0])) == pytest.approx(-12.5)


@pytest.mark.parametrize("method", ["rmrc", "dls", "gauss-newton", "lm", "ccd"])
def test_a_method_tells_its_steps_and_its_residual(kinlab, method):
    found = kinlab("ik", "xl430-hexapod", 75, 10, -46, "--method", method, "--json").json
    run = found["method"]
    assert run["converged"]
    assert run["residual_mm"] <= 1e-6
    assert len(run["trace"]) == run["iterations"] + 1
    assert found["solutions"][0]["error_mm"] == pytest.approx(run["residual_mm"], abs=1e-9)


def test_a_method_that_fails_says_so_and_exits_1(kinlab):
    answer = kinlab("ik", "xl430-hexapod", 400, 0, 0, "--method", "lm", "--json")
    assert answer.code == 1
    assert not answer.json["method"]["converged"]
    assert "lm did not get there" in answer.json["reason"]


def test_compare_runs_every_method_on_the_same_target(kinlab):
    answer = kinlab("ik", "xl430-hexapod", 75, 10, -46, "--compare", "--json")
    names = [run["name"] for run in answer.json["methods"]]
    assert names == ["rmrc", "dls", "newton", "gauss-newton", "lm", "ccd"]
    shown = kinlab("ik", "xl430-hexapod", 75, 10, -46, "--compare").out
    assert all(name in shown for name in names)


def test_the_four_errors_stand_side_by_side(kinlab):
    shown = kinlab("ik", "xl430-hexapod", 75, 10, -45).out
    for depth in (
        "of the mathematics",
        "of the servos' resolution",
        "of the printed equations",
        "as the paper measured",
    ):
        assert depth in shown
    assert "Tables 2 and 3, test 1" in shown


def test_all_shows_every_solution(kinlab):
    assert "knee-down" in kinlab("ik", "xl430-hexapod", 75, 10, -46, "--all").out
    assert "knee-down" not in kinlab("ik", "xl430-hexapod", 75, 10, -46).out


def test_servos_can_be_left_out(kinlab):
    assert "2XL430" not in kinlab("ik", "xl430-hexapod", 75, 10, -46, "--no-servos").out
    found = kinlab("ik", "xl430-hexapod", 75, 10, -46, "--no-servos", "--json").json
    assert found["solutions"][0]["servos"] == {}


def test_a_method_beyond_the_limits_does_not_make_a_target_unreachable(kinlab):
    """rmrc folds the knee the other way here; the closed form gets there within the limits."""
    answer = kinlab("ik", "udiebot", 166.39, 99.37, 16.81, "--method", "rmrc", "--json")
    assert answer.code == 1
    assert answer.json["reachable"] is True
    assert answer.json["chosen"] is None
    assert answer.json["method"]["converged"]
    assert answer.json["method"]["within_limits"] is False
    assert "there is a solution within the limits: knee-up" in answer.json["reason"]


def test_compare_fails_where_no_method_stays_within_the_limits(kinlab):
    answer = kinlab("ik", "receptionist-arm", 0, -10, -65, "--compare", "--json")
    assert answer.code == 1
    assert not any(run["within_limits"] for run in answer.json["methods"])


def test_a_place_in_reach_with_another_attitude_is_said_to_be_that(kinlab):
    found = kinlab("ik", "eros", 0, 0, -250.9, "--rpy", 0, 30, 0, "--json").json
    assert found["reachable"] is False
    assert "not with this attitude" in found["reason"]


@pytest.mark.parametrize(
    ("args", "says"),
    [
        (("--rpy", 0, 0), "--rpy takes 3 values, got 0 0"),
        (("--json", "--limb"), "--limb takes a value, got none"),
        (("--compare", "--method", "lm"), "--compare shows every method by itself"),
        (("--yaw", "inf"), "finite"),
    ],
)
def test_options_that_lack_a_value_or_make_no_sense_together_are_named(kinlab, args, says):
    answer = kinlab("ik", "eros", 0, 0, -235, *args)
    assert answer.code == 2
    assert says in answer.err


def test_a_minus_sign_from_a_printed_page_is_a_minus(kinlab):
    found = kinlab("ik", "xl430-hexapod", "75", "\N{MINUS SIGN}10", "\N{MINUS SIGN}46", "--json").json
    assert found["target_mm"] == [75, -10, -46]


def test_measured_errors_stand_beside_what_the_paper_prints_of_them(kinlab):
    shown = kinlab("ik", "xl430-hexapod", 75, 0, -60).out
    assert "1.56, 1.56, 0.67" in shown
    assert "Table 4 prints 1.56, 0.88, 0.78" in shown
