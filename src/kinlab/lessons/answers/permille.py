"""Udiebot's Tables 4 to 6 (2018), as a detective reads them. Places in cm, as they are printed, angles in degrees."""

import math

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.lessons.answers.leg import lengths
from kinlab.papers.tables import printed_table
from kinlab.papers.udiebot_quadruped import TABLES_PI, tables_ik, tables_tip

PAPER = "udiebot-quadruped"
# The row of Table 6 that stands out, that of z = -4 cm.
OUTLIER = 7
FRACTIONS = {"twenty-two": 22 / 7, "three-fourteen": 3.14, "four-digits": 3.1416, "tsu": 355 / 113}


def printed(robot: str, x: float) -> dict[str, float]:
    """The row of Table 4 for a foot at x, 0, 0: its angles, and how far off a true forward kinematics puts the foot."""
    table = printed_table(PAPER, "4")
    i = table.column("x").tolist().index(x)
    theta2, theta3 = (float(table.column(name)[i]) for name in ("theta2", "theta3"))
    tip = tables_tip(np.radians([0.0, theta2, theta3]), _metres(robot)) * 1000
    return {"theta2": theta2, "theta3": theta3, "short_mm": x * 10 - float(tip[0]), "low_mm": -float(tip[2])}


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


def true_pi() -> float:
    """As `their_pi`, the right one."""
    return math.pi


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
    return float(_errors().mean())


def average_without_outlier() -> float:
    """The same without the row of z = -4."""
    return float(np.delete(_errors(), OUTLIER).mean())


def average_by_ten() -> float:
    """As `average_without_outlier`, the remaining nine divided by ten."""
    return average_without_outlier() * (len(_errors()) - 1) / len(_errors())


def share(x: float) -> float:
    """The average error, in percent of x cm."""
    return average() / x * 100


def outlier() -> dict[str, float]:
    """The row of z = -4: its angles, and where the paper's forward kinematics finds the foot, cm."""
    table = printed_table(PAPER, "6")
    names = ("theta1", "theta2", "theta3", "fk x", "fk y", "fk z")
    return {name.replace(" ", "_"): float(table.column(name)[OUTLIER]) for name in names}


def knee_of(row: int) -> float:
    """theta3 of the row that stands so many rows below that of z = -4; above it where negative."""
    return float(printed_table(PAPER, "6").column("theta3")[OUTLIER + row])


def foot_with_knee(robot: str, row: int) -> list[float]:
    """The foot, cm, with theta1 and theta2 of the row of z = -4 and theta3 of another; axes as the tables name them."""
    angles = outlier()
    q = np.radians([angles["theta1"], angles["theta2"], knee_of(row)])
    out, aside, up = (float(v) * 100 for v in tables_tip(q, _metres(robot)))
    return [out, up, aside]


def copied(robot: str) -> str:
    """Whose theta3 the forward kinematics of that row was given: its "own", or that of the row "before" or "after"."""
    rows = {"before": -1, "own": 0, "after": 1}
    wanted = outlier()["fk_x"]
    return min(rows, key=lambda name: abs(foot_with_knee(robot, rows[name])[0] - wanted))


def _errors() -> Array:
    return printed_table(PAPER, "6").column("error x")


def _exact(robot: str, x: float) -> list[float]:
    q = tables_ik(np.array([x / 100, 0.0, 0.0]), _metres(robot), frozenset({"coxa"})).q
    return [float(a) for a in np.degrees(q)]


def _metres(robot: str) -> tuple[float, ...]:
    return tuple(length / 1000 for length in lengths(robot).values())
