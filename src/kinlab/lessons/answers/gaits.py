"""Orders of steps: duty factors, wave gaits, speeds. Fractions are of the cycle; mm, s and mm/s."""

import math
from fractions import Fraction
from functools import cache

from kinlab.gait import Gait, plan, wave_gait
from kinlab.gait.limits import assess
from kinlab.lessons.robots import find_gait, load_robot

MOST_LEGS = 100
# In the order in which `wave_gait` names them: from the front, on the left and on the right.
LEGS = ("L1", "R1", "L2", "R2", "L3", "R3")


def duty_of(robot: str, gait: str) -> float:
    """The duty factor of a gait of KinLab's."""
    return float(_gait(robot, gait).duty)


def air_of(robot: str, gait: str) -> float:
    """What remains of it."""
    return 1 - duty_of(robot, gait)


def aloft(robot: str, gait: str) -> int:
    """How many legs are in the air at a time."""
    return max(len(phase.swing) for phase in _gait(robot, gait).phases)


def orders(legs: int) -> int:
    """In how many orders legs can be lifted one after the other.

    Raises:
        ValueError: no robot has as many.
    """
    if legs > MOST_LEGS:
        raise ValueError(f"at most {MOST_LEGS} legs")
    return math.factorial(legs)


def rounds(legs: int) -> int:
    """The same, where it does not matter with which leg one begins."""
    return orders(legs - 1)


def landing(beta: str, leg: str) -> float:
    """When a leg of a hexapod lands in the wave gait, after L1."""
    return float(dict(zip(LEGS, wave_gait(3, Fraction(beta)), strict=True))[leg])


def mistaken_landing(beta: str, leg: str) -> float:
    """As `landing`: the wave of a left leg run from the front to the rear, the right leg set down with the left."""
    row = LEGS.index(leg) // 2
    return float(-row * Fraction(beta) % 1) if leg[0] == "L" else landing(beta, f"L{leg[1]}")


def entry(beta: str, leg: str, wrong: str) -> str:
    """A line of a table of landings, of which that of the leg `wrong` is mistaken."""
    at = mistaken_landing(beta, leg) if leg == wrong else landing(beta, leg)
    return f"{leg}   {at:.2f}"


def wrong_entry(beta: str, wrong: str, legs: list[str]) -> int:
    """Which line of that table is not as the rule has it, from 1."""
    return next(i for i, leg in enumerate(legs, 1) if entry(beta, leg, wrong) != entry(beta, leg, ""))


def tells(beta: str, wrong: str) -> bool:
    """Whether the mistaken entry is another than the right one."""
    return entry(beta, wrong, wrong) != entry(beta, wrong, "")


def order(beta: str) -> list[str]:
    """The legs of a hexapod in the order in which the wave gait sets them down."""
    return [leg for _, leg in sorted(zip(wave_gait(3, Fraction(beta)), LEGS, strict=True))]


def speed(stroke: float, time: float, beta: float) -> float:
    """Of the body, for a stroke and a time in the air."""
    return stroke * (1 - beta) / (beta * time)


def speed_of_the_foot(stroke: float, time: float, beta: float) -> float:
    """As `speed`, that of the foot in the air."""
    return stroke / time


def speed_upside_down(stroke: float, time: float, beta: float) -> float:
    """As `speed`, stance and swing in each other's place."""
    return stroke * beta / ((1 - beta) * time)


def fastest(robot: str, gait: str) -> float:
    """The highest speed that the servos allow at KinLab's usual stroke and lift."""
    return _fastest(robot, gait)


@cache
def _fastest(robot: str, gait: str) -> float:
    one = load_robot(robot)
    found = assess(plan(one, _gait(robot, gait))).fastest
    assert found is not None
    return found * 1000


@cache
def _gait(robot: str, gait: str) -> Gait:
    return find_gait(load_robot(robot), gait)
