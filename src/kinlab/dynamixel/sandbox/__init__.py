"""The packet sandbox: one line in, what happened out; for the REPL, `-c`, scripts, lessons and the TUI."""

from kinlab.dynamixel.sandbox.commands import VERBS, execute, run_script
from kinlab.dynamixel.sandbox.session import ExpectationError, Outcome, Session

__all__ = ["VERBS", "ExpectationError", "Outcome", "Session", "execute", "run_script"]
