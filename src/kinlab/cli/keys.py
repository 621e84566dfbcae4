"""One key at a time from a terminal."""

import os
import sys

from kinlab.errors import UsageError


def read_key() -> str:
    """The next key as its characters ("\\x1b[C" for an arrow), empty at the end of input. Ctrl-C interrupts.

    Raises:
        UsageError: standard input is no terminal.
    """
    if not sys.stdin.isatty():
        raise UsageError("standard input is no terminal, so that no key can be pressed")
    if sys.platform == "win32":
        import msvcrt

        key = msvcrt.getwch()
        if key == "\x03":
            raise KeyboardInterrupt
        return key
    import termios
    import tty

    handle = sys.stdin.fileno()
    before = termios.tcgetattr(handle)
    try:
        # Keys at once and unseen; Ctrl-C still is one.
        tty.setcbreak(handle)
        return os.read(handle, 8).decode(errors="replace")
    finally:
        termios.tcsetattr(handle, termios.TCSADRAIN, before)
