"""Recordings as files: whole, never over another unasked."""

import pytest

from kinlab.errors import FileError
from kinlab.robots import load_robot
from kinlab.scene import check_new, robot_scene, save

pytest.importorskip("rerun")


@pytest.fixture
def scene():
    return robot_scene(load_robot("udiebot"))


def test_a_file_is_written_and_its_size_told(scene, tmp_path):
    path = tmp_path / "a.rrd"
    assert save(scene, path) == path.stat().st_size > 10_000
    assert path.read_bytes()[:4] == b"RRF2"
    assert [p.name for p in tmp_path.iterdir()] == ["a.rrd"]


def test_what_exists_is_replaced_only_by_force(scene, tmp_path):
    path = tmp_path / "a.rrd"
    path.write_text("mine")
    with pytest.raises(FileError, match=r"a\.rrd: exists already; --force replaces it"):
        save(scene, path)
    assert path.read_text() == "mine"
    save(scene, path, force=True)
    assert path.read_bytes()[:4] == b"RRF2"


def test_folders_devices_and_places_that_are_not_there_are_refused(tmp_path):
    for path, word in (
        (tmp_path, "it is a folder"),
        (tmp_path / "none" / "a.rrd", "there is no folder"),
        (tmp_path / "pipe.rrd", "is a device or a pipe"),
        (tmp_path / "a.txt", "knows a recording by its ending; call it a.rrd"),
    ):
        if path.name == "pipe.rrd":
            import os

            os.mkfifo(path)
        with pytest.raises(FileError, match=word):
            check_new(path, force=True)


def test_two_recordings_of_one_robot_stay_two(scene, tmp_path):
    from rerun.chunk import RrdReader

    names = []
    for i, recording in enumerate((scene, robot_scene(load_robot("udiebot")))):
        save(recording, path := tmp_path / f"{i}.rrd")
        (found,) = RrdReader(path).recordings()
        names.append(found.recording_id)
    assert len(set(names)) == 2
    assert all(name.startswith("udiebot ") for name in names)
