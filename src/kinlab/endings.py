"""The signals by which a program is told to end, besides Ctrl-C."""

import signal


def endings() -> list[signal.Signals]:
    """SIGTERM, and SIGHUP where the system has it and nobody has had it ignored, as nohup does."""
    found = [signal.SIGTERM]
    hangup = getattr(signal, "SIGHUP", None)
    if hangup is not None and signal.getsignal(hangup) != signal.SIG_IGN:
        found.append(hangup)
    return found
