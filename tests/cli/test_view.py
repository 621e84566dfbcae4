"""`kinlab view`, and `--rrd` of other commands."""

import os
import signal
import subprocess
import sys

import pytest

from kinlab.cli.commands import COMMANDS
from kinlab.shipped import install_line

pytest.importorskip("rerun")
psutil = pytest.importorskip("psutil")
ROBOTS = ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros", "receptionist-arm"]


@pytest.fixture(autouse=True)
def _no_display(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(sys, "platform", "linux")


def whole(path):
    data = path.read_bytes()
    return data[:4] == b"RRF2" and len(data) > 10_000


@pytest.mark.parametrize("robot", ROBOTS)
def test_every_robot_can_be_saved_without_a_display(kinlab, tmp_path, robot):
    run = kinlab("view", robot, "--save", tmp_path / "a.rrd", "--frames", "--workspace")
    assert run.code == 0, run.err
    assert run.out == ""
    assert (
        f"a.rrd: {(tmp_path / 'a.rrd').stat().st_size / 1000:.0f} kB; look at it with: kinlab view" in run.err
    )
    assert whole(tmp_path / "a.rrd")


@pytest.mark.parametrize(
    "subject",
    [
        ("xl430", "--limb", "R1", "--target", -7.5, 1, -4.6, "--unit", "cm"),
        ("krsri", "--gait", "wave", "--turn", 3, "--cycles", 1),
        ("receptionist", "--arm", "observe"),
        ("receptionist", "--arm", "track"),
    ],
)
def test_every_subject_can_be_saved(kinlab, tmp_path, subject):
    run = kinlab("view", *subject, "--save", tmp_path / "a.rrd")
    assert run.code == (1 if "--target" in subject else 0), run.err
    assert ("not reached" in run.err) == ("--target" in subject)
    assert whole(tmp_path / "a.rrd")


def test_what_was_saved_is_told_to_programs(kinlab, tmp_path):
    path = tmp_path / "a.rrd"
    run = kinlab("view", "xl430", "--gait", "tripod", "--save", path, "--json")
    found = {"robot": "xl430-hexapod", "subject": "gait", "file": str(path), "page": None}
    assert run.json == found | {"bytes": path.stat().st_size}


@pytest.mark.parametrize("name", ["a b.rrd", "A.RRD"])
def test_what_was_saved_can_be_looked_at_again(kinlab, tmp_path, name):
    file = tmp_path / name
    assert kinlab("view", "eros", "--save", str(file)).code == 0
    run = kinlab("view", str(file))
    assert run.code == 1
    assert "no display" in run.err


@pytest.mark.parametrize(
    ("content", "more", "word"),
    [
        (None, [], "cannot be read: No such file"),
        (b"robots:", [], "is no recording of rerun"),
        (b"", [], "is no recording of rerun"),
        (b"RRF2", ["--gait", "wave"], "only --spawn, --serve and ports"),
        (b"RRF2", ["--json"], "only --spawn, --serve and ports"),
    ],
)
def test_what_is_no_recording_is_not_opened(kinlab, tmp_path, content, more, word):
    file = tmp_path / "a.rrd"
    if content is not None:
        file.write_bytes(content)
    run = kinlab("view", str(file), *more)
    assert run.code == 2
    assert word in run.err


def test_without_a_display_and_without_a_switch_it_says_what_can_be_done(kinlab):
    run = kinlab("view", "krsri")
    assert run.code == 1
    assert "no display" in run.err
    assert "--save FILE.rrd" in run.err


@pytest.mark.parametrize(
    ("args", "word"),
    [
        (("--gait", "wave", "--target", 1, 2, 3), "--target and --gait are pictures of their own"),
        (("--spawn", "--serve"), "ask for one of them"),
        (("--force", "--serve"), "--force is for --save"),
        (("--gait", "wave", "--cycles", 0, "--save", "a.rrd"), "--cycles is a number from 1 to 100"),
        (("--gait", "wave", "--workspace"), "--workspace says nothing about --gait"),
        (("--speed", 30), "--speed says nothing about a robot that stands"),
        (("--gait", "wav3", "--save", "a.rrd"), "did you mean wave"),
        (("--arm", "track", "--save", "a.rrd"), "not of krsri-hexapod"),
        (("--target", 1, 2, "nan", "--save", "a.rrd"), "must be finite"),
        (("--serve", "--page-port", 70000), "from 1 to 65535"),
        (("--save", "a.rrd", "--port", 9000), "--port is for a viewer"),
        (("--save", "a.rrd", "--spawn", "--page-port", 9000), "--page-port is for the page of --serve"),
        (("--save", "a.txt"), "call it a.rrd"),
    ],
)
def test_what_makes_no_picture_is_refused(kinlab, tmp_path, monkeypatch, args, word):
    monkeypatch.chdir(tmp_path)
    run = kinlab("view", "krsri", *args)
    assert run.code == 2
    assert word in run.err
    assert list(tmp_path.iterdir()) == []


def test_an_experiment_has_a_name(kinlab, tmp_path):
    run = kinlab("view", "receptionist", "--arm", "compl", "--save", tmp_path / "a.rrd")
    assert run.code == 0
    run = kinlab("view", "receptionist", "--arm", "map", "--save", tmp_path / "b.rrd")
    assert run.code == 2
    assert "there are: track, comply, observe" in run.err


RECORDED = [
    ("ik", "xl430", 75, 10, -46),
    ("gait", "krsri"),
    ("walk", "krsri", "--distance", 20, "--rate", 20),
    ("arm", "track", "--seconds", 0.3),
    ("arm", "observe"),
]


@pytest.mark.parametrize("command", RECORDED)
def test_answers_are_recorded_beside_being_printed(kinlab, tmp_path, command):
    path = tmp_path / "a.rrd"
    plain, recorded = kinlab(*command, "--json"), kinlab(*command, "--json", "--rrd", path)
    assert (recorded.code, recorded.out) == (plain.code, plain.out)
    assert whole(path)
    before = path.read_bytes()
    again = kinlab(*command, "--json", "--rrd", path)
    assert (again.code, again.out) == (2, "")
    assert "exists already; --force replaces it" in again.err
    assert path.read_bytes() == before
    assert kinlab(*command, "--json", "--rrd", path, "--force").code == plain.code


def test_a_walk_too_long_to_be_recorded_is_refused_before_it_begins(kinlab, tmp_path):
    run = kinlab("walk", "krsri", "--distance", 20_000, "--rrd", tmp_path / "a.rrd")
    assert run.code == 2
    assert "at most 6.7 min at 50 commands a second" in run.err


def test_one_walk_is_recorded_or_mirrored_and_no_sweep(kinlab, tmp_path):
    for option in (("--rrd", tmp_path / "a.rrd"), ("--mirror", "9876")):
        run = kinlab("walk", "krsri", "--set", "speed", "10:20:5", *option)
        assert run.code == 2
        assert "show one walk" in run.err
    run = kinlab("walk", "krsri", "--distance", 20, "--mirror", "example.org:9876")
    assert run.code == 2
    assert "on this machine" in run.err


def test_a_missing_rerun_is_answered_with_the_line_that_installs_it(kinlab, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "rerun", None)
    for args in (("view", "krsri"), ("ik", "xl430", 75, 10, -46)):
        run = kinlab(*args, "--save" if args[0] == "view" else "--rrd", tmp_path / "a.rrd")
        assert run.code == 1
        assert run.out == ""
        assert install_line("view") in run.err
    assert list(tmp_path.iterdir()) == []


def python(code: str, **more) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, **more)


def test_nothing_that_does_not_draw_imports_rerun():
    runs = [["--help"], *([name, "--help"] for name in COMMANDS), *(list(map(str, c)) for c in RECORDED[:2])]
    code = (
        "import sys\nfrom kinlab.cli import main\n"
        f"for args in {runs!r}:\n"
        "    try:\n        main(args)\n"
        "    except SystemExit:\n        pass\n"
        "    heavy = {'rerun', 'pyarrow', 'kinlab.scene'} & set(sys.modules)\n"
        "    assert not heavy, (args, heavy)\n"
    )
    done = python(code)
    assert done.returncode == 0, done.stderr


@pytest.mark.skipif(not hasattr(signal, "SIGXFSZ"), reason="this system limits no file sizes")
def test_a_full_disk_leaves_what_was_there(tmp_path):
    path = tmp_path / "a.rrd"
    path.write_text("mine")
    code = (
        "import resource, signal\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))\n"
        f"from kinlab.cli import main\nmain(['view', 'krsri', '--save', {str(path)!r}, '--force'])\n"
    )
    done = python(code, env={k: v for k, v in os.environ.items() if "DISPLAY" not in k})
    assert done.returncode == 2
    assert done.stderr == f"kinlab: {path}: cannot be written: File too large\n"
    assert path.read_text() == "mine"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    "ending", [signal.SIGINT, signal.SIGTERM, *([signal.SIGHUP] if hasattr(signal, "SIGHUP") else [])]
)
def test_the_page_is_served_until_it_is_told_to_end(tmp_path, ending):
    from urllib.request import urlopen

    from kinlab.scene.viewer import free_port

    ports = [str(free_port()), str(free_port())]
    command = ["view", "udiebot", "--serve", "--port", ports[0], "--page-port", ports[1]]
    served = subprocess.Popen(
        [sys.executable, "-m", "kinlab", *command],
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "HOME": str(tmp_path)},
    )
    try:
        assert served.stderr is not None
        said = served.stderr.readline()
        assert said.startswith(f"kinlab: open http://127.0.0.1:{ports[1]}/?url=")
        with urlopen(f"http://127.0.0.1:{ports[1]}/") as page:
            assert page.status == 200
        children = psutil.Process(served.pid).children(recursive=True)
        assert children
        served.send_signal(ending)
        assert served.communicate() == (None, "")
        assert served.returncode == 0
        assert not any(child.is_running() for child in children)
    finally:
        served.kill()


def test_tables_of_energy_have_no_picture(kinlab, tmp_path):
    run = kinlab("gait", "krsri", "--energy", "--rrd", tmp_path / "a.rrd")
    assert run.code == 2
    assert "leave --rrd out" in run.err
