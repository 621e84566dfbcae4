"""Names as people type them: exact, else by unique prefix, else refused with the nearest valid ones."""

from collections.abc import Iterable
from difflib import get_close_matches

from kinlab.errors import UsageError


def resolve(name: str, valid: Iterable[str], what: str) -> str:
    """The one of `valid` that `name` means.

    Args:
        name: what was typed. Case does not matter where the exact spelling fits none.
        valid: the names that exist.
        what: the kind of thing, for the message ("robot", "limb").

    Raises:
        UsageError: `name` fits none of them, or more than one.

    >>> resolve("xl", ["xl430-hexapod", "udiebot"], "robot")
    'xl430-hexapod'
    """
    names = list(valid)
    if name in names:
        return name
    folded = name.casefold()
    same = [n for n in names if n.casefold() == folded]
    if len(same) == 1:
        return same[0]
    starts = [n for n in names if n.casefold().startswith(folded)] if name else []
    if len(starts) == 1:
        return starts[0]
    if starts:
        raise UsageError(f"{what} '{name}' is ambiguous: {', '.join(starts)}")
    raise UsageError(f"no {what} is named '{name}'{suggestion(name, names)}")


def suggestion(name: str, names: Iterable[str]) -> str:
    """The end of an error message: the nearest of `names`, else all of them when they are few."""
    names = list(names)
    near = nearest(name, names)
    if near:
        return f"; did you mean {' or '.join(near)}?"
    return f"; there are: {', '.join(names)}" if names else ""


def nearest(name: str, names: Iterable[str]) -> list[str]:
    """Up to three of `names` that `name` may have been meant to be, the likeliest first."""
    by_fold = {n.casefold(): n for n in names}
    return [by_fold[f] for f in get_close_matches(name.casefold(), by_fold, n=3, cutoff=0.5)]
