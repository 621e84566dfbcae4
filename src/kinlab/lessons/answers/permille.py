"""Udiebot's Tables 4 to 6 (2018), as a detective reads them. Places in cm, as they are printed, angles in degrees."""

import math

import numpy as np

from kinlab.lessons.answers.leg import lengths
from kinlab.papers.udiebot_quadruped import TABLES_PI, tables_ik, tables_tip

# The paper's own slips, all of which are needed for its digits: see `kinlab.papers.udiebot_quadruped`.
AS_PRINTED = frozenset({"coxa", "pi", "cut"})
# The x errors of Table 6, row by row, cm; that of z = -4 is the eighth.
TABLE_6_X = (0.004, 0.005, 0.006, 0.006, 0.007, 0.007, 0.007, 0.236, 0.006, 0.005)
OUTLIER = 7
FRACTIONS = {"twenty-two": 22 / 7, "three-fourteen": 3.14, "four-digits": 3.1416, "tsu": 355 / 113}


def printed(robot: str, x: float) -> dict[str, float]:
    """The row of Table 4 for a foot at x, 0, 0: its three angles and, from them, the paper's forward kinematics."""
    q = tables_ik(np.array([x / 100, 0.0, 0.0]), _metres(robot), AS_PRINTED).q
    tip = tables_tip(q, _metres(robot)) * 100
    angles = [round(float(a), 3) + 0.0 for a in np.degrees(q)]
    return {
        "theta1": angles[0], "theta2": angles[1], "theta3": angles[2],
        "short_mm": float(x - tip[0]) * 10, "low_mm": float(-tip[2]) * 10,
    }  # fmt: skip


def exact(robot: str, x: float) -> float:
    """theta2 for a foot at x, 0, 0 on a leg of femur and tibia alone."""
    return _exact(robot, x)[1]


def exact_with_coxa(robot: str, x: float) -> float:
    """As `exact`, with the coxa of Table 2."""
    q = tables_ik(np.array([x / 100, 0.0, 0.0]), _metres(robot)).q
    return float(np.degrees(q[1]))


def leg_of_table(robot: str, x: float) -> str:
    """Which leg gives the printed theta2: "whole", with the coxa, or "bare", without it."""
    shown = printed(robot, x)["theta2"]
    return "bare" if abs(shown - exact(robot, x)) < abs(shown - exact_with_coxa(robot, x)) else "whole"


def off(robot: str, x: float) -> float:
    """By how many degrees the printed theta2 is less than the exact one."""
    return exact(robot, x) - printed(robot, x)["theta2"]


def ratio(robot: str, x: float) -> float:
    """The printed theta2, as a share of the exact one."""
    return printed(robot, x)["theta2"] / exact(robot, x)


def inverse_ratio(robot: str, x: float) -> float:
    """As `ratio`, upside down."""
    return 1 / ratio(robot, x)


def their_pi(robot: str, x: float) -> float:
    """The value of pi that turns the exact angle in radians into the printed one in degrees."""
    return math.radians(exact(robot, x)) * 180 / printed(robot, x)["theta2"]


def pi_upside_down(robot: str, x: float) -> float:
    """As `their_pi`, the ratio used upside down."""
    return math.pi * ratio(robot, x)


def fraction(robot: str, x: float) -> str:
    """Which of the well-known values for pi that is."""
    found = their_pi(robot, x)
    return min(FRACTIONS, key=lambda name: abs(FRACTIONS[name] - found))


def excess(robot: str) -> float:
    """By how many percent that value is too large."""
    return (TABLES_PI / math.pi - 1) * 100


def knee(robot: str, x: float) -> float:
    """theta3 = K - 180, where only K went through the wrong pi."""
    q = tables_ik(np.array([x / 100, 0.0, 0.0]), _metres(robot), frozenset({"coxa", "pi"})).q
    return float(np.degrees(q[2]))


def exact_knee(robot: str, x: float) -> float:
    """theta3 as it should be."""
    return _exact(robot, x)[2]


def knee_all_scaled(robot: str, x: float) -> float:
    """As `knee`, the 180 taken through the wrong pi as well."""
    return exact_knee(robot, x) * math.pi / TABLES_PI


def knee_not_taken(robot: str, x: float) -> float:
    """As `knee`, before 180 is taken off."""
    return knee(robot, x) + 180


def average() -> float:
    """Of Table 6's x errors, cm."""
    return sum(TABLE_6_X) / len(TABLE_6_X)


def average_without_outlier() -> float:
    """The same without the row of z = -4."""
    rest = [error for i, error in enumerate(TABLE_6_X) if i != OUTLIER]
    return sum(rest) / len(rest)


def average_by_ten() -> float:
    """As `average_without_outlier`, the remaining nine divided by ten."""
    return average_without_outlier() * (len(TABLE_6_X) - 1) / len(TABLE_6_X)


def share(x: float) -> float:
    """The average error, in percent of x cm."""
    return average() / x * 100


def _exact(robot: str, x: float) -> list[float]:
    q = tables_ik(np.array([x / 100, 0.0, 0.0]), _metres(robot), frozenset({"coxa"})).q
    return [float(a) for a in np.degrees(q)]


def _metres(robot: str) -> tuple[float, ...]:
    return tuple(length / 1000 for length in lengths(robot).values())
