"""Files that are whole at every moment, or not there."""

import os
from pathlib import Path

from kinlab.errors import FileError


def write_whole(path: Path, content: str | bytes) -> None:
    """Put `content` into the file in one step: who reads it meanwhile sees the old one.

    What stands there and is no file, such as /dev/stdout, is written to and never replaced.

    Raises:
        FileError: it cannot be written.
    """
    data = content.encode() if isinstance(content, str) else content
    goal = path.resolve()
    draft = goal.with_name(f".{goal.name}.{os.getpid()}")
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(data)
            return
        draft.write_bytes(data)
        # A link stays a link: what it names is replaced.
        os.replace(draft, goal)
    except OSError as error:
        draft.unlink(missing_ok=True)
        raise FileError(f"{path}: cannot be written: {error.strerror}") from None


def check_writable(path: Path) -> None:
    """Refuse a file that could not be written, before the work whose result it is for.

    Raises:
        FileError: its folder is missing or closed, or it is itself a folder.
    """
    if path.is_dir():
        raise FileError(f"{path}: cannot be written: it is a folder")
    if path.exists() and not path.is_file():
        return
    folder = path.resolve().parent
    if not folder.is_dir():
        raise FileError(f"{path}: cannot be written: there is no folder {folder}")
    if not os.access(folder, os.W_OK):
        raise FileError(f"{path}: cannot be written: the folder {folder} is closed to you")
