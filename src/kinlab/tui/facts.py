"""Short facts in one line, as many as there is room for."""

from collections.abc import Sequence

BETWEEN = "  ·  "


def fitting(facts: Sequence[str], width: int, between: str = BETWEEN) -> str:
    """The first of these facts in one line, as many as have room in `width` characters, and at least one."""
    line = facts[0]
    for fact in facts[1:]:
        if len(line) + len(between) + len(fact) > width:
            break
        line += between + fact
    return line
