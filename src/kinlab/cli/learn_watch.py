"""Answers from a file, checked whenever it is saved."""

import sys
import time
from pathlib import Path

import typer

from kinlab.cli.learn_prose import lines
from kinlab.cli.printing import print_lines
from kinlab.errors import FileError
from kinlab.files import write_whole
from kinlab.lessons.sheet import blank, read_sheet
from kinlab.lessons.sitting import Sitting
from kinlab.lessons.task import did_you_mean

# How often the file is looked at, s.
GLANCE = 0.2


def watch_file(sitting: Sitting, path: Path) -> None:
    """Check the answers in a file whenever it changes, until all are right."""
    if not path.exists():
        write_whole(path, blank(sitting))
        typer.echo(sitting.say("talk.sheet-made", path=path))
    typer.echo(sitting.say("talk.watching", path=path))
    seen: tuple[int, int] | None = None
    before: tuple[int, int] | None = None
    known: dict[str, str] = {}
    while sitting.open:
        now = _look(path)
        # A file that is still being written is left alone: half an answer is a wrong one.
        if now in (seen, None) or now != before:
            before = now
            time.sleep(GLANCE)
            continue
        seen = now
        replies = read_sheet(_read(path))
        for name, reply in replies.items():
            if known.get(name) == reply:
                continue
            known[name] = reply
            if name not in sitting.tasks:
                typer.echo(
                    sitting.say(
                        "talk.sheet-unknown",
                        path=path,
                        name=name,
                        near=did_you_mean(sitting.language, name, sitting.tasks),
                    )
                )
                continue
            if sitting.standing(name).done:
                continue
            verdict = sitting.check(name, reply)
            style = "good" if verdict.ok else "bad" if verdict.counts else "odd"
            print_lines([[(style, text) for _, text in line] for line in lines(f"{name}: {verdict.message}")])
        sys.stdout.flush()
    each = [sitting.standing(name).status for name in sitting.tasks]
    typer.echo(
        sitting.say("talk.finished", solved=each.count("solved"), count=len(each), shown=each.count("shown"))
    )


def _look(path: Path) -> tuple[int, int] | None:
    """When the file was saved, and its size; None in the moment in which an editor has put it away."""
    try:
        state = path.stat()
    except FileNotFoundError:
        return None
    return state.st_mtime_ns, state.st_size


def _read(path: Path) -> str:
    try:
        return path.read_bytes().decode("utf-8", errors="replace")
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}") from None
