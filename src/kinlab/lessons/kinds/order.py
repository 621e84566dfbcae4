"""Things in their order, which may begin anywhere where it goes round."""

import re
from collections.abc import Sequence
from itertools import pairwise

from kinlab.lessons.parameters import shuffled
from kinlab.lessons.replies import UnreadableError, clean, quote
from kinlab.lessons.task import Task, Verdict, parts_of

_BETWEEN = re.compile(r"\s*(?:->|→|>|,|;|\s)\s*")


def labels(task: Task) -> dict[str, str]:
    """What a student types for each key: a letter where the items have texts, else the key itself."""
    keys = mixed(task)
    if not task.wording.items:
        return {key: key for key in keys}
    return {key: chr(ord("a") + i) for i, key in enumerate(keys)}


def mixed(task: Task) -> list[str]:
    """The keys in an order of the student's own, never the right one."""
    keys = sorted(_want(task))
    for attempt in range(100):
        found = shuffled(keys, [*parts_of(task), attempt])
        if not _same(task, found):
            return found
    return keys


def offers(task: Task) -> dict[str, str]:
    """The items by what is typed for them."""
    return {mark: task.text(task.wording.items.get(key, key)) for key, mark in labels(task).items()}


def shape(task: Task) -> str:
    """The items, and that they go in one line."""
    marks = labels(task)
    if task.wording.items:
        items = [f"{mark}) {text}" for mark, text in offers(task).items()]
        return "  \n".join(items) + "\n\n" + task.say("order.shape", example=" ".join(marks.values()))
    return task.say("order.shape-keys", items="   ".join(marks))


def right(task: Task) -> str:
    """The order, as a student types it."""
    marks = labels(task)
    return " ".join(marks[key] for key in _want(task))


def wrong(task: Task) -> Sequence[str]:
    """Two neighbours in each other's place, wherever that makes another order."""
    marks, want = labels(task), _want(task)
    found = []
    for i in range(len(want) - 1):
        order = list(want)
        order[i], order[i + 1] = want[i + 1], want[i]
        if not _same(task, order):
            found.append(" ".join(marks[key] for key in order))
    return found


def _want(task: Task) -> list[str]:
    return [_normal(key) for key in task.answer]


def _normal(key: str) -> str:
    """Several at once in one spelling: L1+R2 is R2+L1."""
    return "+".join(sorted(key.split("+")))


def _same(task: Task, order: Sequence[str]) -> bool:
    want = _want(task)
    if not task.field.get("rotation"):
        return list(order) == want
    return any(list(order) == want[i:] + want[:i] for i in range(len(want)))


def judge(task: Task, reply: str) -> Verdict:
    """By the order; the first pair that does not follow is named."""
    by_label = {mark.casefold(): key for key, mark in labels(task).items()}
    words = [w for w in _BETWEEN.split(clean(re.sub(r"\s*\+\s*", "+", reply))) if w]
    if len(words) == 1 and len(words[0]) == len(by_label) and task.wording.items:
        words = list(words[0])
    got = []
    for word in words:
        key = by_label.get(word.casefold().strip("().")) or by_label.get(_normal(word).casefold())
        folded = {_normal(k).casefold(): k for k in by_label.values()}
        key = key or folded.get(_normal(word.upper()).casefold())
        if key is None:
            raise UnreadableError("no-item", text=quote(word), items=", ".join(labels(task).values()))
        got.append(key)
    marks = labels(task)
    missing = [marks[key] for key in by_label.values() if key not in got]
    if missing or len(got) != len(by_label):
        raise UnreadableError("items", missing=", ".join(missing) or "-", count=len(by_label), got=len(got))
    if _same(task, got):
        return task.verdict(True, "right")
    for number, slip in enumerate(task.slips):
        if [_normal(str(key)) for key in slip] == got:
            return task.slip(number)
    want = _want(task)
    if _same(task, got[::-1]):
        return task.verdict(False, "reversed")
    if not task.field.get("rotation") and got[0] != want[0]:
        return task.verdict(False, "first", faults=[0], item=_named(task, got[0]))
    follows = {want[i]: want[(i + 1) % len(want)] for i in range(len(want))}
    at = next(i for i, (a, b) in enumerate(pairwise(got)) if follows[a] != b)
    first, second = (_named(task, key) for key in got[at : at + 2])
    return task.verdict(False, "wrong", faults=[at, at + 1], first=first, second=second)


def _named(task: Task, key: str) -> str:
    return labels(task)[key]
