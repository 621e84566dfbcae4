"""Every run draws the same examples: a test that fails here fails everywhere."""

import signal
import time
from collections.abc import Callable

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
