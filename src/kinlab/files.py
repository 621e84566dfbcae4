"""Files that are whole at every moment, or not there."""

import os
from pathlib import Path

from kinlab.errors import FileError


def write_whole(path: Path, text: str) -> None:
    """Put `text` into the file in one step: who reads it meanwhile sees the old one.

    Raises:
        FileError: it cannot be written.
    """
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        draft.write_text(text, encoding="utf-8", newline="")
        os.replace(draft, path)
    except OSError as error:
        draft.unlink(missing_ok=True)
        raise FileError(f"{path}: cannot be written: {error.strerror}") from None


def check_writable(path: Path) -> None:
    """Refuse a file that could not be written, before the work whose result it is for.

    Raises:
        FileError: its folder is missing or closed, or it is itself a folder.
    """
    folder = path.parent
    if path.is_dir():
        raise FileError(f"{path}: cannot be written: it is a folder")
    if not folder.is_dir():
        raise FileError(f"{path}: cannot be written: there is no folder {folder}")
    if not os.access(folder, os.W_OK):
        raise FileError(f"{path}: cannot be written: the folder {folder} is closed to you")
