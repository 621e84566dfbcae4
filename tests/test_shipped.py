"""What stands beside the code, and how what is missing is added."""

import shlex
import sys
from pathlib import Path

import pytest

from kinlab import shipped


def test_the_line_adds_the_extra_to_this_python_from_this_checkout() -> None:
    line = shlex.split(shipped.install_line("view"))
    assert line[:4] == [sys.executable, "-m", "pip", "install"]
    assert line[4] == "-e"
    assert (Path(line[5].removesuffix("[view]")) / "pyproject.toml").is_file()


def test_where_kinlab_was_installed_its_name_is_enough(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shipped, "HERE", tmp_path / "site-packages" / "kinlab" / "shipped")
    assert shipped.install_line("view").endswith("pip install 'kinlab[view]'")
