"""A paper's own tables against each other: xl430-hexapod, Tables 2 to 4. Places and errors in mm."""

from functools import cache

import numpy as np

from kinlab.papers import eros_humanoid
from kinlab.papers.tables import printed_table

PAPER = "xl430-hexapod"
AXES = ("x", "y", "z")
Place = tuple[float, float, float]


def target(test: int) -> list[float]:
    """Table 2: where the foot was to go."""
    return list(_rows("2")[test - 1])


def reached(test: int) -> list[float]:
    """Table 3: where it came to."""
    return list(_rows("3")[test - 1])


def off(test: int) -> list[float]:
    """What follows from the two: how far off, on each axis."""
    return [abs(a - b) for a, b in zip(target(test), reached(test), strict=True)]


def printed(test: int) -> list[float]:
    """Table 4: what is printed for it."""
    return list(_rows("4")[test - 1])


def shown(place: int, wrong_at: int, wrong: int, first: int) -> int:
    """The test that stands in the line `place` from 1: `wrong` at `wrong_at`, else the next sound one after `first`."""
    if place == wrong_at:
        return wrong
    sound = [test for test in range(1, 10) if off(test) == printed(test)]
    return sound[(first + place) % len(sound)]


def line(test: int) -> str:
    """Target, place reached and printed error of a test, in one line."""
    places = ", ".join(f"{v:g}" for v in target(test))
    came = ", ".join(f"{v:g}" for v in reached(test))
    return f"({places}) → ({came}): {', '.join(f'{v:g}' for v in printed(test))}"


def contradicts(wrong_at: int, wrong: int) -> int:
    """The line whose printed error does not follow from its places."""
    return wrong_at if off(wrong) != printed(wrong) else 0


def errors(axis: str) -> list[float]:
    """What follows from Tables 2 and 3 for all tests, on one axis."""
    return [off(test)[AXES.index(axis)] for test in range(1, 10)]


def mean_of_the_places(axis: str) -> float:
    """The average that follows from Tables 2 and 3."""
    return sum(errors(axis)) / len(errors(axis))


def mean(axis: str) -> float:
    """The average of Table 4's own column."""
    column = [row[AXES.index(axis)] for row in _rows("4")]
    return sum(column) / len(column)


def mean_of_eight(axis: str) -> float:
    """As `mean`, divided by one test too few."""
    return mean(axis) * 9 / 8


def printed_mean(axis: str) -> float:
    """The average that is printed for it."""
    return printed_table(PAPER, "4").rows["average"][axis].figure.value


def total(axis: str) -> float:
    """The sum of Table 4's own column."""
    return round(mean(axis) * 9, 9)


def cause(axis: str) -> str:
    """Which change of the column's sum gives the printed average: "one-more", "eight", "none-needed", or "unknown"."""
    wanted = f"{printed_mean(axis):.2f}"
    # Two decimals, cut as well as rounded, since the paper does both.
    for key, value in (
        ("none-needed", total(axis) / 9),
        ("one-more", (total(axis) + 1) / 9),
        ("eight", total(axis) / 8),
    ):
        if wanted in (f"{value:.2f}", f"{int(value * 100) / 100:.2f}"):
            return key
    return "unknown"


def wrong_line_of_the_head() -> int:
    """Of eros-humanoid's equation (3), P_x, P_y and P_z: the line that differs from the head's own kinematics."""
    q, lengths = np.array([0.5, 0.8]), (0.03, 0.08)
    as_printed = eros_humanoid.head(q, lengths, frozenset({"3"}))
    off_by = np.abs(as_printed - eros_humanoid.head(q, lengths))[:3, 3]
    return int(np.argmax(off_by)) + 1


@cache
def _rows(number: str) -> list[Place]:
    columns = [printed_table(PAPER, number).column(axis).tolist() for axis in AXES]
    return list(zip(*columns, strict=True))
