"""`kinlab gait`: the contract, the diagram, the phases, and the keys."""

import signal

import pytest

KEYS = {"robot", "gait", "duty_factor", "period_s", "speed_mm_s", "events", "frames"}


def test_json_holds_the_contract(kinlab):
    answer = kinlab("gait", "krsri-hexapod", "--gait", "wave", "--speed", 20, "--json")
    assert answer.code == 0
    assert answer.err == ""
    found = answer.json
    assert set(found) >= KEYS
    assert (found["robot"], found["gait"]) == ("krsri-hexapod", "wave")
    assert found["duty_factor"] == pytest.approx(5 / 6)
    assert found["speed_mm_s"] * found["period_s"] == pytest.approx(found["stride_mm"])
    assert [event["swing"] for event in found["events"]] == [["R1"], ["R2"], ["R3"], ["L1"], ["L2"], ["L3"]]
    for event in found["events"]:
        assert set(event) >= {"phase", "t_s", "swing", "stance", "stability_margin_mm"}
        assert event["t_s"] == pytest.approx(event["phase"] * found["period_s"])
        assert len(event["stance"]) == 5
        assert event["stability_margin_mm"] > 0
    assert len(found["frames"]) == 60
    for frame in found["frames"]:
        assert set(frame) >= {"t_s", "feet_mm", "angles_deg", "swing"}
        assert list(frame["angles_deg"]["R1"]) == ["coxa", "femur", "tibia"]
        assert len(frame["feet_mm"]["L3"]) == 3
        assert len(frame["swing"]) == 1
        assert frame["stability_margin_mm"] >= found["margins"]["static_mm"] - 1e-9
    assert found["slip_mm"] < 1e-6


def test_the_diagram_of_the_wave_is_that_of_krsris_figure_7(kinlab):
    shown = kinlab("gait", "krsri-hexapod", "--gait", "wave").out.splitlines()
    rows = {line.split()[0]: line.split()[1] for line in shown if "██" in line}
    assert list(rows) == ["R1", "R2", "R3", "L1", "L2", "L3"]
    for i, bar in enumerate(rows.values()):
        assert bar == "·" * 10 * i + "█" * 10 + "·" * 10 * (5 - i)


def test_one_phase_shows_its_legs_and_their_joints(kinlab):
    shown = kinlab("gait", "krsri-hexapod", "--gait", "wave", "--phase", 4).out
    assert "phase 4 of 6   1/2 to 2/3 of the cycle" in shown
    assert "swing L1   stance R1 R2 R3 L2 L3" in shown
    assert "coxa, femur, tibia [deg]" in shown
    found = kinlab("gait", "krsri-hexapod", "--gait", "wave", "--phase", 4, "--json").json
    assert [event["swing"] for event in found["events"]] == [["L1"]]


@pytest.mark.parametrize("robot", ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros"])
def test_every_robot_with_legs_shows_its_default_gait(kinlab, robot):
    answer = kinlab("gait", robot)
    assert answer.code == 0
    assert "one cycle" in answer.out
    assert "assumed" in answer.out
    assert kinlab("gait", robot, "--json").json["margins"]["static_mm"] > 0


def test_theory_stands_beside_the_margin_of_a_wave_gait(kinlab):
    found = kinlab("gait", "udiebot", "--json").json["margins"]
    assert found["theory_mm"] == pytest.approx(found["longitudinal_mm"])


def test_eros_shows_its_touch_down_with_and_without_deceleration_and_heel_strike(kinlab):
    found = kinlab("gait", "eros", "--json").json["landing"]
    assert found["deceleration"]["down_mm_s"] < found["plain"]["down_mm_s"] / 2
    assert found["heel strike"]["toe_up_deg"] > 0
    shown = kinlab("gait", "eros").out
    assert f"{found['plain']['down_mm_s']:.1f}" in shown
    assert f"{found['deceleration']['down_mm_s']:.1f}" in shown
    assert "single" in shown
    assert "double" in shown


def test_a_humanoid_stands_more_safely_on_two_feet_than_on_one(kinlab):
    support = kinlab("gait", "eros", "--json").json["support"]
    for margin in ("static_mm", "zmp_mm"):
        assert support["double"][margin] > support["single"][margin] > 0


def test_the_experiments_of_eros_are_presets(kinlab):
    found = kinlab("gait", "eros", "--experiment", 16, "--json").json
    assert [found["stride_mm"] / 2, found["sway_mm"], found["lift_mm"]] == pytest.approx([16, 35, 95])


def test_the_printed_footstep_stands_beside_the_corrected_one(kinlab):
    (printed,) = kinlab("gait", "krsri-hexapod", "--lift", 30, "--as-printed", "--json").json["as_printed"]
    middle, end = printed["rows"][4], printed["rows"][-1]
    # z_max + sin(pi / 2) and z_max + sin(pi), in mm, for z_max sin(pi t).
    assert [middle["height_mm"], middle["corrected_height_mm"]] == pytest.approx([31, 30])
    assert [end["height_mm"], end["corrected_height_mm"]] == pytest.approx([30, 0], abs=1e-9)
    (printed,) = kinlab("gait", "eros", "--lift", 10, "--as-printed", "--json").json["as_printed"]
    assert printed["rows"][-1]["height_mm"] == pytest.approx(10 - 10 * 90)
    assert "as printed: equations (24) to (27)" in kinlab("gait", "krsri-hexapod", "--as-printed").out
    assert "prints no foot trajectory" in kinlab("gait", "udiebot", "--as-printed").out


def test_sideways_turning_and_posture_are_taken_together(kinlab):
    found = kinlab(
        "gait", "krsri", "--speed", -15, "--sideways", 10, "--turn", -8, "--height", -5, "--rpy", 2, -3, 1,
        "--trajectory", "matched-cycloid", "--json",
    ).json  # fmt: skip
    assert (found["speed_mm_s"], found["sideways_mm_s"]) == pytest.approx((-15, 10))
    assert found["turn_deg_s"] == pytest.approx(-8)
    assert found["slip_mm"] < 1e-6
    assert found["jumps"]["matched-cycloid"]["velocity_along_mm_s"] == [0, 0]


@pytest.mark.parametrize(
    ("args", "code", "message"),
    [
        (("krsri", "--speed", 500), 1, "femur of .* AX-12A does 354 deg/s.*fastest possible speed"),
        (("krsri", "--stride", 600), 1, "cannot follow at phase"),
        (("udiebot", "--gait", "tripod"), 2, "there are: creep, trot, pace, bound"),
        (("krsri", "--gait", "waves"), 2, "did you mean wave"),
        (("krsri", "--gait", "wave", "--phase", 7), 2, "phases 1 to 6, got 7"),
        (("krsri", "--gait", "wave", "--phase", 0), 2, "phases 1 to 6, got 0"),
        (("krsri", "--step"), 2, "no terminal"),
        (("krsri", "--step", "--json"), 2, "neither --json nor --phase"),
        (("krsri", "--speed", "nan"), 2, "finite"),
        (("krsri", "--stride", 50, "--period", 1), 2, "name one of them"),
        (("krsri", "--trajectory", "cycloi"), 0, None),
        (("krsri", "--trajectory", "circle"), 2, "no foot trajectory is named 'circle'"),
        (("krsri", "--experiment", 8), 2, "krsri-hexapod is a hexapod"),
        (("krsri", "--frames", 0), 2, "at least 1 frame"),
        (("receptionist-arm",), 2, "has no legs"),
    ],
)
def test_bad_input_is_answered_in_a_sentence(kinlab, args, code, message):
    answer = kinlab("gait", *args)
    assert answer.code == code
    if message:
        assert answer.out == ""
        import re

        assert re.search(message, answer.err), answer.err


def test_a_gait_of_ones_own_comes_from_the_robots_file(kinlab, tmp_path):
    file = tmp_path / "own.yaml"
    file.write_text("gaits:\n  amble:\n    kind: quadruped\n    duty: 0.7\n"
                    "    touchdown: {LF: 0, RF: 1/2, LH: 3/4, RH: 1/4}\n")  # fmt: skip
    found = kinlab("gait", "udiebot", "--gait", "amble", "--robots", file, "--json").json
    assert found["duty_factor"] == pytest.approx(0.7)
    file.write_text("gaits:\n  amble:\n    kind: quadruped\n    duty: 0.7\n    touchdwn: {LF: 0}\n")
    answer = kinlab("gait", "udiebot", "--gait", "amble", "--robots", file)
    assert answer.code == 2
    assert "own.yaml:5: gaits.amble.touchdwn: no such field; did you mean touchdown" in answer.err


def test_energy_shows_models_crossover_and_averages_of_the_paper(kinlab):
    shown = kinlab("gait", "krsri-hexapod", "--energy")
    assert shown.code == 0
    assert "crossover" in shown.out
    assert "not by KinLab" in shown.out
    (flat, broken) = kinlab("gait", "krsri-hexapod", "--energy", "--json").json["energy"]
    assert flat["ground"] == "flat"
    assert broken["averages"]["wave"]["printed_percent"] == 83.7
    assert kinlab("gait", "udiebot", "--energy").code == 2


def test_keys_walk_the_phases_forwards_and_back(terminal):
    shown = terminal("gait", "krsri-hexapod", "--gait", "wave", "--step", COLUMNS="100")
    shown.until("q: quit")
    shown.press(" ")
    assert "swing R2" in shown.until("q: quit")
    shown.press("\x1b[D")
    assert "swing R1" in shown.until("q: quit")
    shown.press("b")
    assert "swing L3" in shown.until("q: quit")
    shown.press("q")
    assert shown.ends()[0] == 0


def test_ctrl_c_ends_the_steps_quietly(terminal):
    shown = terminal("gait", "krsri-hexapod", "--step")
    shown.until("q: quit")
    shown.press("\x03")
    code, seen = shown.ends()
    assert code in (130, -signal.SIGINT)
    assert "Traceback" not in seen


def test_a_negative_margin_is_said_in_words(kinlab):
    falling, dynamic, steady = (
        kinlab("gait", *args, "--json").json["notes"][0]
        for args in (("udiebot", "--gait", "pace"), ("eros", "--speed", 5000), ("krsri-hexapod",))
    )
    assert "a robot that stopped there would fall" in falling
    assert "outside too, and it tips" in falling
    assert "its zero moment point stays" in dynamic
    assert steady.startswith("gait tripod")


def test_a_margin_that_does_not_exist_is_null(kinlab):
    found = kinlab("gait", "udiebot", "--gait", "pace", "--json").json
    assert found["margins"]["longitudinal_mm"] is None
    assert found["frames"][0]["longitudinal_margin_mm"] is None
    assert found["margins"]["static_mm"] < 0


def test_the_fastest_possible_mixed_motion_names_both_its_parts(kinlab):
    answer = kinlab("gait", "krsri-hexapod", "--turn", 1000)
    assert answer.code == 1
    assert "mm/s while turning" in answer.err
