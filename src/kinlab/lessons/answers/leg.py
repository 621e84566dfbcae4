"""The three-joint leg. Angles in degrees (alpha, beta, gamma), places in millimetres, in the limb frame."""

import numpy as np

from kinlab.lessons.results import Reach, limb_reach
from kinlab.lessons.robots import load_robot
from kinlab.robots import Limb


def lengths(robot: str, limb: str = "") -> dict[str, float]:
    """The lengths of the links by name, mm."""
    leg = _leg(robot, limb)
    return {
        name: round(float(np.linalg.norm(link)) * 1000, 9)
        for name, link in zip(leg.joint_names, leg.links, strict=True)
    }


def foot(robot: str, alpha: float, beta: float, gamma: float, limb: str = "") -> list[float]:
    """The foot (x, y, z), mm."""
    tip = _leg(robot, limb).fk(np.radians([alpha, beta, gamma]))[:3, 3]
    return [float(v) for v in tip * 1000]


def distance(robot: str, beta: float, gamma: float, limb: str = "") -> float:
    """How far the foot is from the coxa's axis, seen from above, mm."""
    return foot(robot, 0.0, beta, gamma, limb)[0]


def height(robot: str, beta: float, gamma: float, limb: str = "") -> float:
    """How high the foot is over the coxa, mm; below it is negative."""
    return foot(robot, 0.0, beta, gamma, limb)[2]


def distance_without_coxa(robot: str, beta: float, gamma: float, limb: str = "") -> float:
    """As `distance`, the coxa forgotten."""
    return distance(robot, beta, gamma, limb) - lengths(robot, limb)["coxa"]


def distance_with_bare_gamma(robot: str, beta: float, gamma: float, limb: str = "") -> float:
    """As `distance`, the tibia's angle taken from the horizontal and not from the femur."""
    leg = lengths(robot, limb)
    b, g = np.radians([beta, gamma])
    return float(leg["coxa"] + leg["femur"] * np.cos(b) + leg["tibia"] * np.cos(g))


def foot_with_x_and_y_swapped(
    robot: str, alpha: float, beta: float, gamma: float, limb: str = ""
) -> list[float]:
    """As `foot`, sine and cosine of alpha in each other's place."""
    x, y, z = foot(robot, alpha, beta, gamma, limb)
    return [y, x, z]


def same_height(robot: str, alpha: float, beta: float, gamma: float, turn: float, limb: str = "") -> str:
    """Whether the foot's height changes when the coxa turns by `turn`: "same", "up" or "down"."""
    change = foot(robot, alpha + turn, beta, gamma, limb)[2] - foot(robot, alpha, beta, gamma, limb)[2]
    return "same" if abs(change) < 1e-6 else "up" if change > 0 else "down"


def level_distance(x: float, y: float) -> float:
    """How far a place is from the coxa's axis, seen from above, mm."""
    return float(np.hypot(x, y))


def direction(x: float, y: float) -> float:
    """The angle at which a place lies, seen from above."""
    return float(np.degrees(np.arctan2(y, x)))


def knee(robot: str, x: float, y: float, z: float, limb: str = "") -> float:
    """The tibia's angle for a foot at (x, y, z), the knee up."""
    found = _leg(robot, limb).ik(np.array([x, y, z]) / 1000)
    return float(np.degrees(found.solutions[found.names.index("knee-up"), 2]))


def inner_angle(robot: str, x: float, y: float, z: float, limb: str = "") -> float:
    """As `knee`, the angle inside the triangle."""
    return 180 + knee(robot, x, y, z, limb)


def reach(robot: str, x: float, y: float, z: float, limb: str = "") -> Reach:
    """The joint angles that bring the foot to (x, y, z)."""
    return limb_reach(_leg(robot, limb), (x, y, z))


def reachable(robot: str, x: float, y: float, z: float, limb: str = "") -> bool:
    """Whether the foot gets to (x, y, z) within the limits of joints and servos."""
    return bool(_leg(robot, limb).ik(np.array([x, y, z]) / 1000).reachable)


def _leg(robot: str, limb: str) -> Limb:
    return load_robot(robot).limb(limb or None)
