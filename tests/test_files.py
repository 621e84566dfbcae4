"""Files that are whole or not there."""

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


def test_what_could_not_be_written_is_refused_before_the_work(tmp_path):
    (tmp_path / "file").write_text("")
    folder, none, inside = tmp_path, tmp_path / "none" / "a", tmp_path / "file" / "a"
    for path, word in ((folder, "it is a folder"), (none, "no folder"), (inside, "no folder")):
        with pytest.raises(FileError, match=word):
            check_writable(path)
