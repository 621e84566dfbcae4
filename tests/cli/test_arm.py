"""`kinlab arm` as people type it."""

import csv
import math
import threading

import pytest

from kinlab.dynamixel import Chain
from kinlab.dynamixel.serving import Server
from kinlab.dynamixel.serving.pty import PtyLink
from kinlab.dynamixel.servo.breaking import motor_of


@pytest.fixture
def served(tmp_path, monkeypatch):
    """The servos of the right arm behind a pty, in real time, near the start of the line; and how to reach them."""
    # A busy machine may let an answer wait.
    monkeypatch.setattr("kinlab.dynamixel.ports.serialport.SerialPort.latency", 0.2)
    link = PtyLink(tmp_path / "ttyArm", 1_000_000)
    chain = Chain.of([("RX-24F", [i]) for i in (2, 4, 6)])
    for servo, joint_deg in ((2, 44.0), (4, 1.0), (6, 146.0)):
        motor_of(chain.servo(servo)).angle = math.radians(150 + joint_deg)
    with Server(chain) as server:
        server.add(link)
        thread = threading.Thread(target=server.run)
        thread.start()
        yield link.link, chain
        server.stop()
        thread.join()


def test_the_four_experiments_print_the_verdict_beside_the_claim(kinlab):
    for args, claim, verdict in (
        (("track", "--law", "none"), "more than 6 deg of error", "reproduced"),
        (("track",), "less than 6 deg of error", "contradicted"),
        (("observe",), "torque errors of up to", "kgf cm"),
        (("comply",), "deviation of more than 15 deg", "reproduced"),
    ):
        run = kinlab("arm", *args)
        assert run.code == 0
        line = next(row for row in run.out.splitlines() if claim in row)
        assert verdict in line
        assert "elbow" in run.out
        assert "y -" in run.out


def test_json_has_the_claims_and_every_cycle(kinlab):
    found = kinlab("arm", "track", "--json").json
    (claim,) = found["claims"]
    assert set(claim) == {"where", "claim", "measured", "unit", "verdict", "cause"}
    run = found["runs"]["position"]
    assert run["overruns"] == 0
    assert len(run["columns"]["real_elbow_deg"]) == 81
    assert run["busy_ms"]["max"] < run["cycle_ms"] == 16


def test_csv_has_a_row_for_each_cycle_and_a_file_for_each_run(kinlab, tmp_path):
    assert kinlab("arm", "comply", "--csv", tmp_path / "push.csv").code == 0
    for name in ("push.csv", "push-compliance.csv"):
        with (tmp_path / name).open() as file:
            rows = list(csv.DictReader(file))
        assert len(rows) == 81
        assert {"t_s", "command_elbow_deg", "load_elbow_nm", "pushed_elbow_nm"} <= set(rows[0])
    gone = kinlab("arm", "comply", "--csv", tmp_path / "no" / "push.csv")
    assert (gone.code, "cannot be written" in gone.err) == (2, True)


def test_the_trace_of_a_cycle_is_read_by_the_packet_sandbox(kinlab, tmp_path):
    script = tmp_path / "cycle.txt"
    assert kinlab("arm", "track", "--trace", script).code == 0
    read = kinlab("packet", script)
    assert read.code == 0
    for word in ("READ", "WRITE", "present_position", "Goal Position", "Moving Speed"):
        assert word in read.out


def test_a_push_is_seen_by_the_observers(kinlab):
    run = kinlab("arm", "observe", "--push", "t=0.4 dur=0.5 at=hand force=-3,0,0")
    assert run.code == 0
    assert "observer (2.37): off by" in run.out


def test_a_small_map_is_drawn_with_its_bounds(kinlab):
    run = kinlab("arm", "map", "kp", "kv", "--size", 4, 2, "--x-range", 2, 400, "--y-range", 1, 40)
    assert run.code == 0
    assert "runs away" in run.out
    assert "damping ratio 1" in run.out
    found = kinlab(
        "arm", "map", "kf", "kenv", "--size", 2, 2, "--x-range", 0.1, 0.5, "--y-range", 5, 20, "--json"
    ).json
    assert found["law"] == "compliance"
    assert found["critical_damping"] is None
    assert len(found["states"]) == 2


@pytest.mark.parametrize(
    ("args", "code", "complaint"),
    [
        (("track", "--law", "positon"), 2, "did you mean position"),
        (("track", "--law", "compliance"), 2, "kinlab arm comply"),
        (("track", "--law", "comp"), 2, "kinlab arm comply"),
        (("track", "--profile", "cubic"), 2, "no profile is named"),
        (("track", "--to", -113, 600, 0), 1, "leaves the workspace"),
        (("track", "--to", "nan", 600, 0), 2, "finite"),
        (("track", "--kp", 4000, "--seconds", 3), 1, "ran away at"),
        (("track", "--kp", "nan"), 2, "gains must be finite"),
        (("track", "--kp", "1e300"), 1, "e+296 deg from its command"),
        (("track", "--seconds", 0), 2, "more than 0 s"),
        (("track", "--seconds", "1e9"), 2, "at most 600"),
        (("track", "--slope", 400), 2, "slope of a servo is 0 to 254"),
        (("track", "--drop", 0.3), 1, "has not answered for 10 cycles"),
        (("track", "--drop", 1), 2, "less than 1"),
        (("track", "--real", "/dev/nowhere"), 1, "cannot open the port"),
        (("comply", "--push", "force=0,inf,0"), 2, "finite forces"),
        (("comply", "--push", "at=hend force=0,1,0"), 2, "did you mean hand"),
        (("comply", "-e", "table-4.2"), 2, "did you mean table-4.1"),
        (("comply", "--menv", 0), 2, "Menv more than 0: got kf 0.3, kenv 12, denv 5, menv 0"),
        (("comply", "--real", "/dev/nowhere", "--push", "force=0,1,0"), 2, "pushed by hand"),
        (("track", "--real", "/dev/nowhere", "--drop", 0.1), 2, "--drop is for the emulated one"),
        (("track", "--baud", 57600), 2, "it goes with --real"),
        (("observe", "--alpha", 0), 2, "alpha of the filter"),
        (("map", "kp", "kp"), 2, "two different gains"),
        (("map", "kp", "kw"), 2, "no gain is named 'kw'"),
        (("map", "--size", 1, 1), 2, "2 to 200 values"),
        (("map", "--x-range", 5, 1), 2, "rises from more than 0"),
    ],
)
def test_bad_input_is_answered_in_words(kinlab, args, code, complaint):
    run = kinlab("arm", *args)
    assert run.code == code, run.err
    assert complaint in run.err


def test_the_beginning_of_a_law_is_that_law(kinlab):
    whole, short = (kinlab("arm", "track", "--law", law, "--seconds", 0.2) for law in ("none", "n"))
    assert "section 4.1.1" in whole.out
    assert short.out == whole.out


def test_lost_packets_are_held_over_and_counted(kinlab):
    run = kinlab("arm", "track", "--drop", 0.03)
    assert run.code == 0
    assert "answers missed, held: " in run.out
    assert kinlab("arm", "track", "--drop", 0.03, "--json").json["runs"]["position"]["missed"] > 0


def test_a_real_arm_is_driven_through_the_same_code(kinlab, served):
    """Over a pty: a chain without links, in real time."""
    link, chain = served
    run = kinlab("arm", "track", "--real", link, "--seconds", 0.4, "--json")
    assert run.code == 0
    found = run.json["runs"]["position"]
    assert found["columns"]["pushed_elbow_nm"][0] is None
    assert found["columns"]["t_s"][-1] > 0.39
    assert [servo.memory["torque_enable"] for servo in chain.servos] == [0, 0, 0]


def test_every_command_has_help_with_an_example(kinlab):
    for command in ("track", "comply", "observe", "map"):
        assert f"Example: kinlab arm {command}" in kinlab("arm", command, "--help").out
