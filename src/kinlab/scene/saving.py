"""Recordings as files, whole or not there."""

from pathlib import Path

from kinlab.errors import FileError
from kinlab.files import check_writable, write_whole
from kinlab.scene.recording import Recording

# With these bytes a recording begins, whatever the version of its format.
MARK = b"RRF"


def check_new(path: Path, force: bool = False) -> None:
    """Refuse a file that could not be written, or must not be, before the work whose result it is for.

    Raises:
        FileError: it exists and `force` is not given, is no file, is not called .rrd, or its folder is missing or
            closed.
    """
    check_writable(path)
    if path.suffix.lower() != ".rrd":
        raise FileError(f"{path}: rerun knows a recording by its ending; call it {path.stem or path}.rrd")
    if path.exists() and not path.is_file():
        raise FileError(f"{path}: is a device or a pipe; a recording is a file")
    if path.exists() and not force:
        raise FileError(f"{path}: exists already; --force replaces it")


def check_recording(path: Path) -> None:
    """Refuse a file that is no recording, before a viewer has to.

    Raises:
        FileError: it cannot be read, or does not begin as recordings do.
    """
    try:
        with path.open("rb") as file:
            beginning = file.read(len(MARK))
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}") from None
    if beginning != MARK:
        raise FileError(f"{path}: is no recording of rerun")


def save(recording: Recording, path: Path, force: bool = False) -> int:
    """Write a recording; how many bytes it has.

    Raises:
        FileError: as `check_new`, or the disk is full; what stood there before is still there.
    """
    check_new(path, force)
    data = recording.data()
    write_whole(path, data)
    return len(data)
