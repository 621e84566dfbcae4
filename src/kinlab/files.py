"""Files that are whole at every moment, or not there; and where those lie that are the user's own."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kinlab.errors import FileError
from kinlab.guests import is_guest


def own_folder() -> Path:
    """Where settings and history are kept: $KINLAB_HOME, else the place that the system has for a program's state."""
    if home := os.environ.get("KINLAB_HOME"):
        return Path(home)
    from platformdirs import user_state_path

    return user_state_path("kinlab")


def file_named(text: str) -> Path:
    """The file that a user means; a guest's have plain names and lie in a folder of their own.

    Raises:
        FileError: a guest names a file elsewhere.
    """
    path = Path(text)
    if not is_guest():
        return path
    if not text or path.name != text or text.startswith(".") or "\\" in text:
        raise FileError(f"{text}: a session in the browser keeps its files in one folder; give a plain name")
    folder = own_folder() / "files"
    folder.mkdir(parents=True, exist_ok=True)
    return folder / text


def write_whole(path: Path, content: str | bytes, *, lasting: bool = False) -> None:
    """Put `content` into the file in one step: who reads it meanwhile sees the old one.

    What stands there and is no file, such as /dev/stdout, is written to and never replaced.

    Args:
        path: of the file.
        content: all of it; text as UTF-8.
        lasting: come back only when it would survive a power cut.

    Raises:
        FileError: it cannot be written.
    """
    data = content.encode() if isinstance(content, str) else content
    goal = path.resolve()
    if is_guest() and not goal.is_relative_to(own_folder().resolve()):
        raise FileError(f"{path}: a session in the browser writes only into a folder of its own")
    draft = goal.with_name(f".{goal.name}.{os.getpid()}")
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(data)
            return
        with draft.open("wb") as file:
            file.write(data)
            if lasting:
                file.flush()
                os.fsync(file.fileno())
        # A link stays a link: what it names is replaced.
        os.replace(draft, goal)
        if lasting and os.name == "posix":
            _sync_folder(goal.parent)
    except (OSError, KeyboardInterrupt) as error:
        draft.unlink(missing_ok=True)
        if isinstance(error, KeyboardInterrupt):
            raise
        raise FileError(f"{path}: cannot be written: {error.strerror}") from None


def _sync_folder(folder: Path) -> None:
    """Make a file's new name last: that stands in its folder."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


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


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Keep other windows out of a file; the system lets go when a program dies.

    Raises:
        FileError: the lock's file cannot be made.
    """
    try:
        file = path.with_name(f"{path.name}.lock").open("a+b")
    except OSError as error:
        raise FileError(f"{path.parent}: cannot be written: {error.strerror}") from None
    with file:
        if sys.platform == "win32":
            import msvcrt

            file.seek(0)
            msvcrt.locking(file.fileno(), msvcrt.LK_LOCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX)
        yield
