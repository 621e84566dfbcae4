"""The viewer: on this machine alone, told not to report, and clear where it cannot open. No window is needed."""

import json
import re
import socket
import subprocess
import sys
from contextlib import suppress
from urllib.request import urlopen

import numpy as np
import pytest

from kinlab.errors import KinlabError, UsageError
from kinlab.robots import load_robot
from kinlab.robots.body import resting
from kinlab.scene import Mirror, View, check_viewer, robot_scene, viewer
from kinlab.scene.page import LOOPBACK
from kinlab.scene.viewer import free_port, program, viewing

pytest.importorskip("rerun")
psutil = pytest.importorskip("psutil")


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A person who never had rerun."""
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.delenv("XDG_CONFIG_HOME", raising=False)
    return tmp_path


def test_without_a_display_no_window_is_promised(monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.raises(KinlabError, match=r"no display to open a window on; --serve .* --save"):
        check_viewer(View())
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    check_viewer(View(port=free_port()))


def test_a_port_that_is_taken_is_named_with_the_option_that_chooses_another():
    with socket.socket() as taken:
        taken.bind((LOOPBACK, 0))
        taken.listen()
        port = taken.getsockname()[1]
        for view, option in (
            (View(True, port, free_port()), "--port"),
            (View(True, free_port(), port), "--page-port"),
        ):
            with pytest.raises(KinlabError, match=f"port {port} cannot be used: .* with {option}$"):
                check_viewer(view)
    for view, word in ((View(True, 0), "from 1 to 65535"), (View(True, 9000, 9000), "must differ")):
        with pytest.raises(UsageError, match=word):
            check_viewer(view)


def test_a_missing_viewer_is_answered_with_the_line_that_installs_it(monkeypatch):
    monkeypatch.setattr(viewer, "find_spec", lambda name: None)
    with pytest.raises(KinlabError, match=r"pip install --force-reinstall rerun-sdk"):
        program()


def test_a_viewer_that_fails_says_why(monkeypatch, home):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("DISPLAY", ":4711")
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    scene, view = robot_scene(load_robot("udiebot")), View(port=free_port())
    with (
        pytest.raises(KinlabError, match=r"code \d+: .*X server.*(?<!\.); --serve shows it in a browser"),
        viewing(scene, view) as process,
    ):
        process.wait()


def test_a_viewer_that_ctrl_c_has_ended_too_is_no_complaint(monkeypatch, home):
    monkeypatch.setenv("DISPLAY", ":4711")
    scene, view = robot_scene(load_robot("udiebot")), View(port=free_port())

    def look():
        with viewing(scene, view) as process:
            process.kill()
            process.wait()
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        look()


@pytest.mark.skipif(sys.platform != "linux", reason="where the choice is kept differs")
def test_the_page_reaches_nothing_but_this_machine_and_nobody_is_reported_to(home):
    view = View(True, free_port(), free_port())
    with viewing(robot_scene(load_robot("udiebot")), view) as process:
        with urlopen(f"http://{LOOPBACK}:{view.page_port}/") as page:
            assert b"rerun" in page.read().lower()
            policy = page.headers["Content-Security-Policy"]
        hosts = set(re.findall(r"\w+://([\w.*-]+)", policy))
        assert hosts == {LOOPBACK}
        choice = json.loads((home / ".config/rerun/analytics.json").read_text())
        assert choice["analytics_enabled"] is False
        mine = [psutil.Process(), psutil.Process(process.pid)]
        open_ports = [c.laddr for p in mine for c in p.net_connections() if c.status == "LISTEN"]
        assert {ip for ip, _ in open_ports} == {LOOPBACK}
        assert {view.port, view.page_port} <= {port for _, port in open_ports}
    assert process.poll() is not None
    check_viewer(view)


@pytest.mark.skipif(sys.platform != "linux", reason="where the choice is kept differs")
def test_a_choice_that_was_made_is_left_alone(home):
    choice = home / ".config/rerun/analytics.json"
    choice.parent.mkdir(parents=True)
    choice.write_text("mine")
    viewer.decline_reports()
    assert choice.read_text() == "mine"


def test_a_mirror_needs_a_viewer_on_this_machine():
    robot, port = load_robot("udiebot"), free_port()
    with pytest.raises(
        KinlabError, match=rf"no viewer answers at 127.0.0.1:{port} .*kinlab view udiebot --spawn"
    ):
        Mirror(robot, str(port))
    for address, word in (
        ("example.org:9876", "on this machine"),
        ("here", "no address"),
        ("99999", "no address"),
    ):
        with pytest.raises(UsageError, match=word):
            Mirror(robot, address)


# rerun's listener does not finish its file when it is stopped.
@pytest.mark.filterwarnings("ignore:RRD file has no footer")
def test_a_mirror_shows_every_pose_that_it_is_told(home, tmp_path, read_file, eventually):
    def arrived():
        femur = ("/world/body/R2/coxa/femur", "translation", 3)
        with suppress(OSError, RuntimeError, ValueError, KeyError):
            found = read_file(path)
            rows = [femur, ("/world/body", "translation", 2), ("/angles/R2", "scalars", 2)]
            return all(len(found.values(entity, name)) >= count for entity, name, count in rows)

    robot, port, path = load_robot("krsri-hexapod"), free_port(), tmp_path / "live.rrd"
    options = ["--save", path, "--bind", LOOPBACK, "--port", str(port)]
    listener = subprocess.Popen([program(), *options], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:

        def listens():
            assert listener.poll() is None, "the listener has ended"
            with socket.socket() as caller:
                return caller.connect_ex((LOOPBACK, port)) == 0

        eventually(listens)
        bent = [0.1, 0.4, -1.2]
        body = np.eye(4)
        body[:3, 3] = 0.01, 0.02, 0.1
        with Mirror(robot, f"{LOOPBACK}:{port}") as mirror:
            mirror.show({"R2": bent}, t=1.0)
            mirror.show({"R2": [np.nan, 0.5, -1.2]}, body, t=2.0)
        eventually(arrived)
    finally:
        listener.terminate()
        listener.wait()
    found = read_file(path)
    limb = robot.limbs["R2"]
    assert {kind for (kind,) in found.opens["ViewBlueprint:class_identifier"]} == {"3D", "TimeSeries"}
    np.testing.assert_allclose(
        np.array(found.values("/angles/R2", "scalars")), np.degrees([resting(robot)["R2"], bent]), atol=1e-9
    )
    places = np.array(found.values("/world/body/R2/coxa/femur", "translation"))
    assert len(places) == 3
    assert len(found.values("/world/body/R2/coxa", "quaternion")) == 2
    np.testing.assert_allclose(found.transform("/world/body")[-1][:3, 3], [10, 20, 100], atol=1e-4)
    T = limb.fk(bent, frame="body")[:3, 3] * 1000
    chain = np.eye(4)
    parts = ["/world/body/R2", *(f"/world/body/R2/{'/'.join(limb.joint_names[: i + 1])}" for i in range(3))]
    for part in [*parts, parts[-1] + "/tip"]:
        own = found.transform(part)
        chain = chain @ own[min(1, len(own) - 1)]
    np.testing.assert_allclose(chain[:3, 3], T, atol=2e-3)
