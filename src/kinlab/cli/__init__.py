"""The command line, `kinlab COMMAND ...`: each command in a module of its own, imported when it is used."""

import errno
import gc
import os
import sys

from kinlab.errors import KinlabError


def main(args: list[str] | None = None) -> None:
    """Run `kinlab` with `args` (default: those of the process) and exit with its code.

    0 done, 1 the job failed, 2 wrong usage, 130 interrupted.
    """
    # A command is short: collecting garbage at Python's own pace would be a tenth of its time.
    gc.set_threshold(200_000)
    # Consoles that cannot encode a degree sign or a braille dot get a substitute, not a crash.
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    try:
        from kinlab.cli.commands import kinlab

        try:
            kinlab(args=args, prog_name="kinlab")
        finally:
            sys.stdout.flush()
    except KinlabError as error:
        sys.stderr.write(f"kinlab: {error}\n")
        sys.exit(error.exit_code)
    except KeyboardInterrupt:
        sys.exit(130)
    except OSError as error:
        # A full disk or a reader that went away; what could not be written is not tried again at exit.
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
        if error.errno != errno.EPIPE:
            where = f"{error.filename}: " if error.filename else ""
            sys.stderr.write(f"kinlab: {where}{error.strerror}\n")
        sys.exit(1)
