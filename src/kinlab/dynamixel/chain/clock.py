"""Time as something that is passed in: the real one, or one that runs as fast as the machine."""

import time
from typing import Protocol


class Clock(Protocol):
    """Where the time comes from, and how one waits."""

    def now(self) -> float:
        """Seconds since some fixed moment."""

    def wait(self, seconds: float) -> None:
        """Come back that much later."""


class RealClock:
    """The time outside."""

    def now(self) -> float:
        """Seconds on the machine's steady clock."""
        return time.monotonic()

    def wait(self, seconds: float) -> None:
        """Sleep."""
        time.sleep(max(0.0, seconds))


class SimulatedClock:
    """A time that passes only when somebody waits: every run is the same, however fast the machine."""

    def __init__(self) -> None:
        self._now = 0.0

    def now(self) -> float:
        """Seconds since the clock was made."""
        return self._now

    def wait(self, seconds: float) -> None:
        """Let that much time pass at once."""
        self._now += max(0.0, seconds)
