"""`kinlab bus` and `kinlab emulate` as a shell runs them."""

import pytest

CHAIN = "emu:AX-12A:1,XL430-W250:2"


def test_scan(kinlab):
    answer = kinlab("bus", "scan", "--port", CHAIN, "--json")
    assert [(s["id"], s["model"]) for s in answer.json["servos"]] == [(1, "AX-12A"), (2, "XL430-W250-T")]
    assert "AX-12A" in kinlab("bus", "scan", "--port", CHAIN, "--ids", "1").out


def test_scan_finds_nobody(kinlab):
    answer = kinlab("bus", "scan", "--port", CHAIN, "--ids", "7,9")
    assert (answer.code, answer.out) == (1, "")
    assert "nobody answers" in answer.err


def test_read(kinlab):
    assert kinlab("bus", "read", 1, "present_position", "--port", CHAIN).out == "512 = 150 deg\n"
    answer = kinlab("bus", "read", 2, "present_position", "--unit", "deg", "--port", CHAIN, "--json")
    assert (answer.json["register"], answer.json["value"], answer.json["unit"]) == (
        "present_position",
        180.0,
        "deg",
    )


def test_write(kinlab):
    assert kinlab("bus", "write", 1, "goal_position", "90deg", "--port", CHAIN, "--json").json["value"] == 307
    assert kinlab("bus", "write", 2, "homing_offset", -5, "--port", CHAIN).code == 0


def test_monitor(kinlab, tmp_path):
    log = tmp_path / "log.csv"
    args = (
        "bus",
        "monitor",
        "1,2",
        "--register",
        "present_position",
        "--count",
        3,
        "--rate",
        500,
        "--port",
        CHAIN,
    )
    lines = kinlab(*args, "--csv", log).out.splitlines()
    assert lines[0] == "time_s id present_position_deg"
    assert len(lines) == 7
    assert len(log.read_text().splitlines()) == 7
    assert [s["id"] for s in kinlab(*args, "--json").json["servos"]] == [1, 2]


@pytest.mark.parametrize(
    ("args", "code", "word"),
    [
        (["read", "9", "led", "--port", CHAIN], 1, "servo 9, PING: no answer"),
        (["read", "1", "leg", "--port", CHAIN], 2, "did you mean led"),
        (
            ["write", "2", "goal_position", "9999", "--port", CHAIN],
            1,
            "servo 2, goal_position: the servo reports",
        ),
        (["write", "1", "present_load", "1", "--port", CHAIN], 2, "can only be read"),
        (["scan", "--port", "/dev/there-is-none"], 1, "no such device"),
        (["scan", "--port", "emu:udiebot"], 2, "not on a bus but on PWM"),
        (["scan", "--port", "emu:eros"], 2, "names no servos"),
        (["scan", "--port", CHAIN, "--baud", "0"], 2, "more than 0"),
        (["scan", "--port", CHAIN, "--ids", "1-"], 2, "no id"),
        (["monitor", "1", "--rate", "0", "--port", CHAIN], 2, "rate"),
    ],
)
def test_mistakes(kinlab, args, code, word):
    answer = kinlab("bus", *args)
    assert answer.code == code
    assert word in answer.err


@pytest.mark.parametrize(
    ("args", "code", "word"),
    [
        ([], 2, "name a robot, or servos"),
        (["udiebot"], 2, "not on a bus but on PWM"),
        (["no-such-robot"], 2, "no robot is named"),
        (["--servo", "AX-21A:1"], 2, "did you mean AX-12A"),
        (["--servo", "AX-12A"], 2, "write MODEL:ID"),
        (["--servo", "AX-12A:254"], 2, "254 is no id"),
        (["--servo", "2XL430-W250:1"], 2, "takes 2 ids"),
        (["--servo", "AX-12A:1", "--servo", "RX-24F:1"], 2, "stands twice"),
        (["--servo", "AX-12A:1", "--noise", "2"], 2, "chance from 0 to 1"),
        (["--servo", "AX-12A:1", "--baud", "-5"], 2, "more than 0"),
        (["--servo", "AX-12A:1", "--tcp", "nowhere"], 2, "no TCP address"),
        (["--servo", "AX-12A:1", "--fault", "1:overlaod"], 2, "did you mean overload"),
        (["--servo", "AX-12A:1", "--fault", "2:dead"], 2, "no servo has the id 2"),
        (["--servo", "AX-12A:1", "--fault", "1:baud fast"], 2, "no speed"),
    ],
)
def test_chains_that_cannot_be(kinlab, args, code, word, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    answer = kinlab("emulate", *args)
    assert answer.code == code
    assert word in answer.err
    assert list(tmp_path.iterdir()) == []
