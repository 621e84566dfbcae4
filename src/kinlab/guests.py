"""Sessions that others use through a browser (`kinlab serve`): what is refused to them, in one place."""

import os

from kinlab.errors import UsageError

GUEST = "KINLAB_GUEST"


def is_guest() -> bool:
    """Whether the one who uses this program sits elsewhere, and came in through `kinlab serve`."""
    return os.environ.get(GUEST, "") not in ("", "0")


def refuse_to_guests(what: str) -> None:
    """Let only the machine's own people go on.

    Raises:
        UsageError: a guest tries it; `what` says what, as in "the port /dev/ttyUSB0".
    """
    if is_guest():
        raise UsageError(
            f"{what} is out of reach of a session in the browser; start KinLab on the machine itself"
        )
