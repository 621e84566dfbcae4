"""Files that are whole or not there."""

import os

import pytest

from kinlab.errors import FileError
from kinlab.files import check_writable, write_whole


def test_a_file_is_replaced_in_one_step(tmp_path):
    path = tmp_path / "a.csv"
    for text in ("one\n", "two\r\n"):
        check_writable(path)
        write_whole(path, text)
        assert path.read_bytes() == text.encode()
    assert list(tmp_path.iterdir()) == [path]


def test_a_failure_leaves_nothing_behind(tmp_path):
    (tmp_path / "folder").mkdir()
    with pytest.raises(FileError, match="cannot be written"):
        write_whole(tmp_path / "folder", "text")
    assert [p.name for p in tmp_path.iterdir()] == ["folder"]


def test_ctrl_c_leaves_nothing_behind_and_is_passed_on(tmp_path, monkeypatch):
    def stopped(*args):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", stopped)
    with pytest.raises(KeyboardInterrupt):
        write_whole(tmp_path / "file", "text")
    assert list(tmp_path.iterdir()) == []


def test_what_could_not_be_written_is_refused_before_the_work(tmp_path):
    (tmp_path / "file").write_text("")
    folder, none, inside = tmp_path, tmp_path / "none" / "a", tmp_path / "file" / "a"
    for path, word in ((folder, "it is a folder"), (none, "no folder"), (inside, "no folder")):
        with pytest.raises(FileError, match=word):
            check_writable(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_what_is_no_file_is_written_to_and_never_replaced(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        check_writable(pipe)
        write_whole(pipe, "row\n")
        assert os.read(reader, 100) == b"row\n"
    finally:
        os.close(reader)
    assert pipe.is_fifo()


def test_a_link_stays_a_link(tmp_path):
    link, target = tmp_path / "link.csv", tmp_path / "target.csv"
    target.write_text("old")
    link.symlink_to(target)
    write_whole(link, "new")
    assert link.is_symlink()
    assert target.read_text() == "new"
