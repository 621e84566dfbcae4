"""Every run draws the same examples: a test that fails here fails everywhere."""

import signal

from hypothesis import settings

settings.register_profile("kinlab", derandomize=True, deadline=None)
settings.load_profile("kinlab")

# Under nohup, or behind a shell's `&`, these are ignored, by every program that a test starts as well.
signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP"):
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
