"""The signals by which a program is told to end."""

import signal

import pytest

from kinlab.endings import endings


@pytest.mark.skipif(not hasattr(signal, "SIGHUP"), reason="this system has no SIGHUP")
def test_a_closed_terminal_ends_it_but_not_under_nohup():
    assert endings() == [signal.SIGTERM, signal.SIGHUP]
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        assert endings() == [signal.SIGTERM]
    finally:
        signal.signal(signal.SIGHUP, before)
