"""`kinlab walk` as a shell runs it."""

import csv
import io
from pathlib import Path

import pytest

from kinlab.cli import walk_live
from kinlab.dynamixel import SimulatedClock

SHORT = ("walk", "krsri-hexapod", "--speed", 40, "--distance", 200, "--rate", 25)


@pytest.fixture
def terminal(monkeypatch):
    """Standard output and error that say they are a terminal."""

    class Terminal(io.StringIO):
        def isatty(self):
            return True

    def make(name):
        stream = Terminal()
        monkeypatch.setattr(f"sys.{name}", stream)
        return stream

    return make


def test_a_walk(kinlab, tmp_path):
    out = kinlab(*SHORT, "--gait", "tripod", "--csv", tmp_path / "ticks.csv").out
    for word in (
        "krsri-hexapod, tripod",
        "energy",
        "idle share",
        "Wh/m",
        "tracking error",
        "femur",
        "AX-12A",
        "estimated",
    ):
        assert word in out
    rows = list(csv.DictReader((tmp_path / "ticks.csv").read_text().splitlines()))
    assert float(rows[-1]["way_mm"]) == 200
    assert float(rows[-1]["energy_wh"]) > float(rows[0]["energy_wh"])


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no disk that is always full")
def test_a_full_disk_costs_the_file_and_not_what_was_measured(kinlab):
    run = kinlab(*SHORT, "--csv", "/dev/full", "--json")
    assert run.code != 0
    assert run.err.startswith("kinlab: /dev/full: cannot be written: No space left")
    assert run.json["energy"]["wh"] > 0


def test_json(kinlab):
    data = kinlab(*SHORT, "--json").json
    assert (data["robot"], data["gait"], data["speed_mm_s"]) == ("krsri-hexapod", "tripod", 40)
    assert data["energy"]["wh"] > data["energy"]["idle_wh"] > 0
    assert 0 < data["tracking"]["mean_mm"] < data["tracking"]["max_mm"]
    assert len(data["joints"]) == 18
    assert (data["lost"], data["alarms"], data["torque_off_unconfirmed"]) == ({}, {}, [])


def test_a_servo_chain_by_name_is_the_same(kinlab):
    one, other = kinlab(*SHORT, "--json").json, kinlab(*SHORT, "--port", "emu:krsri-hexapod", "--json").json
    assert one == other


def test_protocol_two(kinlab):
    data = kinlab("walk", "xl430", "--distance", 50, "--speed", 50, "--json").json
    assert data["achieved_rate_hz"] == pytest.approx(50, rel=0.02)
    assert data["joints"][0]["model"] == "2XL430-W250"


def test_a_sweep(kinlab, tmp_path):
    path = tmp_path / "sweep.csv"
    answer = kinlab(*SHORT, "--set", "speed", "30:40:10", "--csv", path)
    assert "30" in answer.out
    rows = list(csv.DictReader(path.read_text().splitlines()))
    assert [float(row["speed_mm_s"]) for row in rows] == [30, 40]
    assert [row["gait"] for row in rows] == ["tripod", "tripod"]
    data = kinlab(*SHORT, "--set", "turn", "0,5", "--json").json
    assert [walk["turn_deg_s"] for walk in data["walks"]] == [0, pytest.approx(5)]


def test_a_comparison(kinlab, tmp_path):
    args = (*SHORT, "--compare", "wave", "tripod", "--set", "speed", "10:40:15")
    path = tmp_path / "both.csv"
    out = kinlab(*args, "--csv", path).out
    for word in (
        "KinLab's rig: emulated",
        "the paper, Table 2: measured on flat",
        "Table 4",
        "crossover",
        "fitted",
        "P0",
    ):
        assert word in out
    assert "0.338" in out
    assert [row["gait"] for row in csv.DictReader(path.read_text().splitlines())] == ["wave"] * 3 + [
        "tripod"
    ] * 3
    data = kinlab(*args, "--json").json
    rig, flat, _ = data["sources"]
    assert [row["speed_mm_s"] for row in rig["rows"]] == [10, 25, 40]
    assert flat["crossings_mm_s"] == [pytest.approx(15, abs=0.5)]
    # Slowly the wave costs less, quickly the tripod.
    assert rig["rows"][0]["wave_wh_per_m"] < rig["rows"][0]["tripod_wh_per_m"]
    assert rig["rows"][-1]["wave_wh_per_m"] > rig["rows"][-1]["tripod_wh_per_m"]


def test_a_progress_bar_where_a_person_looks(kinlab, terminal):
    stream = terminal("stderr")
    # capsys cannot see a stream that was put in its place: the bar goes there.
    kinlab(*SHORT)
    assert "%" in stream.getvalue()


def test_a_live_panel(kinlab, monkeypatch):
    monkeypatch.setattr("kinlab.dynamixel.RealClock", SimulatedClock)
    out = kinlab(*SHORT, "--live").out
    for word in ("timer 1.0 s", "voltage", "current", "power", "energy", "Wh", "40.0 mm/s (100%)"):
        assert word in out


def test_a_live_panel_on_a_terminal(errand_of_the_panel, terminal):
    stream = terminal("stdout")
    panel, tell = errand_of_the_panel
    with panel as show:
        tell(show)
    for word in ("krsri-hexapod, tripod", "voltage", "Wh", "speed", "mm/s"):
        assert word in stream.getvalue()


@pytest.fixture
def errand_of_the_panel():
    """A panel, and a function that tells it of a walk."""
    from kinlab.gait import find_gait
    from kinlab.rig import Order, Rig, Throttle, prepare, walk_on
    from kinlab.robots import load_robot

    robot = load_robot("krsri-hexapod")
    errand = prepare(Order(robot, find_gait(robot), 0.04, 0.0, 0.02, 20.0))
    panel = walk_live.Panel(errand, Throttle(errand))

    def tell(show):
        with Rig.open(robot) as rig:
            for sample in walk_on(rig, errand):
                show(errand, sample)

    return panel, tell


def test_keys_change_the_speed(errand_of_the_panel):
    panel, _ = errand_of_the_panel
    typed = iter(["++", "\x1b[A", "-", "-x", "q", "+"])
    panel._listen(lambda: next(typed))
    assert panel._throttle.tempo == pytest.approx(1.05)
    assert panel._throttle.stopped


@pytest.mark.parametrize("after", [0, 30])
def test_ctrl_c_ends_a_walk(kinlab, monkeypatch, after):
    import kinlab.rig as room

    rigs = []
    whole = room.walk_on

    def interrupted(rig, *args):
        rigs.append(rig)
        for number, sample in enumerate(whole(rig, *args)):
            if number == after:
                raise KeyboardInterrupt
            yield sample

    monkeypatch.setattr(room, "walk_on", interrupted)
    answer = kinlab(*SHORT)
    assert answer.code == 130
    assert ("before its end" in answer.out) == bool(after)
    assert ("before the first step" in answer.err) == (not after)
    assert {servo.memory["torque_enable"] for servo in rigs[0].chain.servos} == {0}


def test_a_servo_that_does_not_let_go_is_named(kinlab, monkeypatch):
    monkeypatch.setattr("kinlab.rig.release._is_off", lambda bus, servo: servo != 7)
    answer = kinlab(*SHORT, "--json")
    assert answer.json["torque_off_unconfirmed"] == [7]
    assert answer.err == "kinlab: torque off is not confirmed by servo 7\n"


@pytest.mark.parametrize(
    ("args", "code", "word"),
    [
        (
            ["krsri-hexapod", "--speed", 400],
            1,
            "the fastest possible speed with a stride of 99.2 mm is 224 mm/s",
        ),
        (["krsri-hexapod", "--gait", "wave", "--speed", 50], 1, "the femur of R1"),
        (["udiebot"], 2, "not on a bus but on PWM"),
        (["eros"], 2, "names no servos"),
        (["receptionist-arm"], 2, "no legs"),
        (["krsri-hexapod", "--gait", "trot"], 2, "there are: tripod, wave"),
        (["krsri-hexapod", "--speed", 0], 2, "a speed or a turn"),
        (["krsri-hexapod", "--baud", 0], 2, "more than 0"),
        (["krsri-hexapod", "--distance", -5], 2, "got -5 mm"),
        (["krsri-hexapod", "--set", "speed", "40:10:3"], 2, "never comes"),
        (["krsri-hexapod", "--set", "sped", "1:2"], 2, "did you mean speed"),
        (["krsri-hexapod", "--compare", "wave", "wave"], 2, "twice"),
        (["krsri-hexapod", "--compare", "wave", "tripod", "--gait", "wave"], 2, "no place"),
        (["krsri-hexapod", "--compare", "wave", "tripod", "--set", "turn", "1:2"], 2, "not over turn"),
        (["krsri-hexapod", "--compare", "wave", "tripod", "--distance", 50], 2, "at least"),
        (["krsri-hexapod", "--live", "--json"], 2, "--live"),
        (["krsri-hexapod", "--port", "/dev/there-is-none"], 1, "no such device"),
        (["krsri-hexapod", "--port", "emu:AX-12A:1-17"], 1, "servo 18"),
        (["krsri-hexapod", "--csv", "/there/is/none.csv"], 2, "no folder"),
    ],
)
def test_mistakes(kinlab, args, code, word):
    answer = kinlab("walk", *args)
    assert answer.code == code
    assert word in answer.err
    assert answer.out == ""


def test_a_rate_at_which_power_would_be_guessed_is_refused(kinlab):
    answer = kinlab("walk", "krsri-hexapod", "--distance", 50, "--rate", 2)
    assert answer.code == 2
    assert "at least 20 commands a second" in answer.err
