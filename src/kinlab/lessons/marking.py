"""Where in a reply a verdict finds fault, so that a face can mark it where it was typed."""

import re

from kinlab.lessons.task import Task, Verdict

Span = tuple[int, int]
_NUMBER = re.compile(r"(?<![\w.,])[+\-−–]?\s?(?:\d+(?:[.,]\d+)?|[.,]\d+)(?:[eE][+-]?\d+)?\s?[A-Za-zµμ°%]*")
_BYTE = re.compile(r"(?:0[xX]|\\[xX])?([0-9a-fA-F]{1,2})")
_ITEM = re.compile(r"[^\s,;>→-]+")


def marked(task: Task, reply: str, verdict: Verdict) -> list[Span]:
    """The places in a reply that are at fault, from and up to a character; none where it is right.

    Where a verdict speaks of no part, or the reply's parts cannot be told apart, that is all of it.
    """
    if verdict.ok:
        return []
    parts = _parts(task, reply)
    found = [parts[i] for i in verdict.faults if i < len(parts)]
    start = len(reply) - len(reply.lstrip())
    return found or ([(start, len(reply.rstrip()))] if reply.strip() else [])


def _parts(task: Task, reply: str) -> list[Span]:
    """The parts of a reply, in their order; none where there are not as many as asked for."""
    kind = task.exercise.kind
    if kind in ("vector", "joints"):
        found = _spans(_NUMBER, reply)
        return found if len(found) == len(task.field["names"]) else []
    pattern = {"bytes": _BYTE, "order": _ITEM}.get(kind)
    return _spans(pattern, reply) if pattern else []


def _spans(pattern: re.Pattern[str], text: str) -> list[Span]:
    found = []
    for match in pattern.finditer(text):
        blank = len(match[0]) - len(match[0].lstrip())
        found.append((match.start() + blank, match.start() + len(match[0].rstrip())))
    return found
