"""One key at a time from a terminal."""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from kinlab.errors import UsageError

# How long a Ctrl-C may take at the most, s.
GLANCE = 0.2


@contextmanager
def keys() -> Iterator[Callable[[], str]]:
    """A function that waits for the next key and gives its characters ("\\x1b[C" for an arrow), empty at the end.

    Keys come at once and unseen until the context ends; Ctrl-C interrupts, as ever.

    Raises:
        UsageError: standard input is no terminal.
    """
    if not sys.stdin.isatty():
        raise UsageError("standard input is no terminal, so that no key can be pressed")
    if sys.platform == "win32":
        import msvcrt

        def read_windows() -> str:
            key = msvcrt.getwch()
            if key == "\x03":
                raise KeyboardInterrupt
            return key

        yield read_windows
        return
    import select
    import termios
    import tty

    handle = sys.stdin.fileno()

    def read() -> str:
        # A Ctrl-C that comes in the instant before a read would not end it: the wait is cut into short ones.
        while not select.select([handle], [], [], GLANCE)[0]:
            pass
        return os.read(handle, 8).decode(errors="replace")

    before = termios.tcgetattr(handle)
    try:
        # What was typed ahead is kept.
        tty.setcbreak(handle, termios.TCSADRAIN)
        yield read
    finally:
        termios.tcsetattr(handle, termios.TCSADRAIN, before)
