"""The laboratory on a real terminal: it is suspended, stopped, resumed and hung up."""

import signal
import sys

import psutil
import pytest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals")
QUIT = "\x11"
SCREEN = "\x1b[?1049h"  # What a program begins with that takes the whole screen.


@pytest.fixture
def lab(terminal, tmp_path):
    shown = terminal(KINLAB_HOME=str(tmp_path), KINLAB_LANG="en")
    shown.until("quit")
    drain(shown)
    return shown


def drain(lab):
    """Forget what it has shown."""
    while lab.read(0.1):
        pass


def type_suspend(lab):
    lab.press("\x1a")


def stop_from_outside(lab):
    lab.process.send_signal(signal.SIGSTOP)


@pytest.mark.parametrize("stop", [type_suspend, stop_from_outside])
def test_it_comes_back_whole_after_it_was_stopped(lab, eventually, stop):
    def stopped():
        lab.read(0)
        return psutil.Process(lab.process.pid).status() == psutil.STATUS_STOPPED

    stop(lab)
    eventually(stopped)
    drain(lab)
    lab.process.send_signal(signal.SIGCONT)
    lab.until("Lessons")
    lab.press(QUIT)
    assert lab.ends()[0] == 0


def test_a_terminal_that_hangs_up_while_nothing_is_suspended_ends_it(lab):
    lab.process.send_signal(signal.SIGCONT)
    lab.until(SCREEN)
    lab.process.send_signal(signal.SIGHUP)
    assert lab.ends()[0] == 0
