"""A paper's own tables against each other: xl430-hexapod, Tables 2 to 4. Places and errors in mm."""

import numpy as np

from kinlab.papers import eros_humanoid
from kinlab.papers.measurements import foot_tests

AXES = ("x", "y", "z")


def target(test: int) -> list[float]:
    """Table 2: where the foot was to go."""
    return [float(v) for v in foot_tests().wanted[test - 1]]


def reached(test: int) -> list[float]:
    """Table 3: where it came to."""
    return [float(v) for v in foot_tests().reached[test - 1]]


def off(test: int) -> list[float]:
    """What follows from the two: how far off, on each axis."""
    return [float(v) for v in foot_tests().off[test - 1]]


def printed(test: int) -> list[float]:
    """Table 4: what is printed for it."""
    return [float(v) for v in foot_tests().printed[test - 1]]


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
    return [float(v) for v in foot_tests().off[:, AXES.index(axis)]]


def mean_of_the_places(axis: str) -> float:
    """The average that follows from Tables 2 and 3."""
    return sum(errors(axis)) / len(errors(axis))


def mean(axis: str) -> float:
    """The average of Table 4's own column."""
    return float(foot_tests().printed[:, AXES.index(axis)].mean())


def mean_of_eight(axis: str) -> float:
    """As `mean_of_the_places`, divided by one test too few."""
    return mean_of_the_places(axis) * 9 / 8


def printed_mean(axis: str) -> float:
    """The average that is printed for it."""
    return float(foot_tests().averages[AXES.index(axis)])


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
