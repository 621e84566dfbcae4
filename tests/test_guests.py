"""What a guest is refused, wherever in KinLab it is tried."""

import pytest

from kinlab import load_robot
from kinlab.dynamixel import open_port
from kinlab.dynamixel.sandbox import Session, execute
from kinlab.errors import FileError, UsageError
from kinlab.files import file_named, own_folder, write_whole
from kinlab.guests import GUEST, is_guest
from kinlab.scene.mirror import Mirror
from kinlab.scene.viewer import viewing


@pytest.fixture
def _guest(monkeypatch, tmp_path):
    monkeypatch.setenv(GUEST, "1")
    monkeypatch.setenv("KINLAB_HOME", str(tmp_path / "home"))


pytestmark = pytest.mark.usefixtures("_guest")


@pytest.mark.parametrize("name", ["/dev/ttyUSB0", "COM3", "localhost:5000", "./ttyDXL"])
def test_a_real_port_is_out_of_reach(name):
    with pytest.raises(UsageError, match="out of reach of a session in the browser"):
        open_port(name)


def test_a_viewer_on_the_machine_is_out_of_reach():
    robot = load_robot("udiebot")
    with pytest.raises(UsageError, match="a viewer is out of reach"):
        Mirror(robot)
    with pytest.raises(UsageError, match="a viewer is out of reach"), viewing(None, None):
        pass


def test_an_emulated_chain_is_not():
    assert open_port("emu:AX-12A:1").name == "emulated chain"


@pytest.mark.parametrize("name", ["/etc/passwd", "../x", "a/b", ".hidden", "..", "a\\b", ""])
def test_files_elsewhere_are_out_of_reach(name):
    with pytest.raises(FileError, match="plain name"):
        file_named(name)


def test_a_file_of_its_own_can_be_saved_and_loaded():
    session = Session("AX-12A:1")
    execute(session, "ping 1")
    execute(session, "save mine")
    assert (own_folder() / "files" / "mine").exists()
    assert "servo 1: ok" in execute(session, "load mine").text


def test_nothing_is_written_outside_its_folder(tmp_path):
    with pytest.raises(FileError, match="a folder of its own"):
        write_whole(tmp_path / "x", "text")
    own_folder().mkdir()
    (own_folder() / "link").symlink_to(tmp_path / "x")
    with pytest.raises(FileError, match="a folder of its own"):
        write_whole(own_folder() / "link", "text")
    assert not (tmp_path / "x").exists()


def test_others_are_no_guests(monkeypatch, tmp_path):
    for value in ("", "0"):
        monkeypatch.setenv(GUEST, value)
        assert not is_guest()
    monkeypatch.delenv(GUEST)
    assert not is_guest()
    assert file_named("/etc/passwd").name == "passwd"
    write_whole(tmp_path / "x", "text")
