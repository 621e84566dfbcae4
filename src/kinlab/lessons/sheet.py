"""Answers in a file: `exercise = reply` on a line, or `[exercise]` with the lines of the reply below it."""

import re

from kinlab.lessons.sitting import Sitting

_LINE = re.compile(r"([a-z0-9]+(?:-[a-z0-9]+)*)\s*=\s*(.*)")
_HEAD = re.compile(r"\[([a-z0-9]+(?:-[a-z0-9]+)*)\]")
LARGEST = 200_000


def blank(sitting: Sitting) -> str:
    """A sheet to fill in: the questions as comments, a place for each answer."""
    lines = [f"# {sitting.lesson.title(sitting.language)}", ""]
    for name in sitting.tasks:
        lines += [f"# {line}".rstrip() for line in sitting.question(name).splitlines()]
        lines += [f"[{name}]" if sitting.tasks[name].exercise.kind == "state" else f"{name} =", ""]
    return "\n".join(lines)


def read_sheet(text: str) -> dict[str, str]:
    """The replies by exercise, those that are there; what stands before the first one is passed over."""
    found: dict[str, list[str]] = {}
    several = ""
    for line in text[:LARGEST].splitlines():
        bare = line.strip()
        if not bare or bare.startswith("#"):
            continue
        head, one = _HEAD.fullmatch(bare), _LINE.fullmatch(bare)
        if head:
            several = head[1]
        elif one and (not several or one[1] not in ("x", "y", "z")):
            several = ""
            found[one[1]] = [one[2]]
        elif several:
            found.setdefault(several, []).append(bare)
    return {name: "\n".join(lines) for name, lines in found.items() if "".join(lines).strip()}
