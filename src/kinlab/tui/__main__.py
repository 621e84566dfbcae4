"""`python -m kinlab.tui`: the laboratory without the command line around it, as a session in a browser runs it."""

import sys

from kinlab.tui.app import run

sys.exit(run())
