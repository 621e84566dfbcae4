"""Orders of steps: duty factors, wave gaits, speeds. Fractions are of the cycle; mm, s and mm/s."""

import math
from fractions import Fraction
from functools import cache

from kinlab.gait import Gait, plan, wave_gait
from kinlab.gait.limits import assess
from kinlab.lessons.robots import find_gait, load_robot

ROWS = ("1", "2", "3")


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
    """In how many orders legs can be lifted one after the other."""
    return math.factorial(legs)


def rounds(legs: int) -> int:
    """The same, where it does not matter with which leg one begins."""
    return math.factorial(legs - 1)


def touchdown(beta: str, row: int) -> float:
    """When a left leg of a hexapod lands in the wave gait; its front leg is row 0, and lands at 0."""
    return float(wave_gait(3, Fraction(beta))[2 * row])


def rear_touchdown(beta: str) -> float:
    """That of the rear leg."""
    return touchdown(beta, 2)


def touchdown_from_the_front(beta: str, row: int) -> float:
    """As `touchdown`, the wave running from the front to the rear."""
    return float(-row * Fraction(beta) % 1)


def touchdown_beyond_the_cycle(beta: str, row: int) -> float:
    """As `touchdown`, whole cycles kept."""
    return float(row * Fraction(beta))


def order(beta: str) -> list[str]:
    """The legs of a hexapod in the order in which the wave gait sets them down."""
    phases = wave_gait(3, Fraction(beta))
    legs = [f"{side}{row}" for row in ROWS for side in "LR"]
    return [leg for _, leg in sorted(zip(phases, legs, strict=True))]


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
