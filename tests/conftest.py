"""Every run draws the same examples: a test that fails here fails everywhere."""

import os
import select
import signal
import struct
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress

import pytest
from hypothesis import HealthCheck, settings

# A busy machine may be slow at drawing them.
settings.register_profile(
    "kinlab", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("kinlab")

# Under nohup, or behind a shell's `&`, these are ignored, by every program that a test starts as well.
signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP"):
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

PATIENCE = 60.0  # s that a busy machine may take to start a program, or to let it answer


@pytest.fixture
def eventually() -> Callable[[Callable[[], object]], None]:
    """`eventually(holds)` comes back when that holds, and fails if it never does."""

    def wait(holds: Callable[[], object]) -> None:
        end = time.monotonic() + PATIENCE
        while not holds():
            assert time.monotonic() < end, "waited in vain"
            time.sleep(0.01)

    return wait


class Terminal:
    """A `kinlab` command on a terminal of its own, 80 x 24."""

    def __init__(self, *args: str, **env: str) -> None:
        import fcntl
        import pty
        import termios

        self.master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("4H", 24, 80, 0, 0))
        self.process = subprocess.Popen(
            [sys.executable, "-m", "kinlab", *args], stdin=slave, stdout=slave, stderr=slave, start_new_session=True,
            env={**os.environ, "TERM": "xterm", **env}, preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )  # fmt: skip
        os.close(slave)

    def read(self, seconds: float) -> str:
        """What it shows next; nothing where the time is over, or it has ended."""
        with suppress(OSError):
            if select.select([self.master], [], [], seconds)[0]:
                return os.read(self.master, 65536).decode(errors="replace")
        return ""

    def until(self, text: str) -> str:
        """What it shows up to a text, and what came with that."""
        seen, end = "", time.monotonic() + PATIENCE
        while text not in seen and time.monotonic() < end and self.process.poll() is None:
            seen += self.read(0.2)
        assert text in seen, seen
        return seen

    def press(self, keys: str) -> None:
        """Type."""
        os.write(self.master, keys.encode())

    def ends(self) -> tuple[int, str]:
        """Its exit code, and what it shows until then."""
        seen, end = "", time.monotonic() + PATIENCE
        while self.process.poll() is None:
            assert time.monotonic() < end, "it does not end"
            seen += self.read(0.1)
        return self.process.wait(), seen + self.read(0)

    def close(self) -> None:
        """Whatever it is doing."""
        self.process.kill()
        self.process.wait()
        os.close(self.master)


@pytest.fixture
def terminal() -> Iterator[Callable[..., Terminal]]:
    """`terminal("gait", ...)` starts a command on a terminal of its own."""
    pytest.importorskip("pty", reason="this system has no pseudo-terminals")
    opened: list[Terminal] = []

    def start(*args: str, **env: str) -> Terminal:
        opened.append(Terminal(*args, **env))
        return opened[-1]

    yield start
    for each in opened:
        each.close()
