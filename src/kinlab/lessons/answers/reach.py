"""Where a leg can stand, and where its triangle does not exist. Places in millimetres, in the limb frame."""

import numpy as np

from kinlab.lessons.answers.leg import lengths
from kinlab.lessons.robots import load_robot
from kinlab.papers.as_printed import as_printed


def distance(robot: str, x: float, y: float, z: float) -> float:
    """From the femur's joint to a place."""
    return float(np.hypot(np.hypot(x, y) - lengths(robot)["coxa"], z))


def distance_with_coxa(robot: str, x: float, y: float, z: float) -> float:
    """From the coxa's joint to a place."""
    return float(np.hypot(np.hypot(x, y), z))


def cosine(robot: str, x: float, y: float, z: float) -> float:
    """What the law of cosines asks the acos of, for the knee."""
    return _cosine(robot, distance(robot, x, y, z))


def cosine_with_coxa(robot: str, x: float, y: float, z: float) -> float:
    """As `cosine`, measured from the coxa's joint."""
    return _cosine(robot, distance_with_coxa(robot, x, y, z))


def cosine_of_inner_angle(robot: str, x: float, y: float, z: float) -> float:
    """As `cosine`, for the angle between femur and tibia inside the triangle."""
    return -cosine(robot, x, y, z)


def _cosine(robot: str, d: float) -> float:
    leg = lengths(robot)
    f, t = leg["femur"], leg["tibia"]
    return (d * d - f * f - t * t) / (2 * f * t)


def why(robot: str, x: float, y: float, z: float) -> str:
    """What is the matter with a place: "far", "near" or "nothing"."""
    c = cosine(robot, x, y, z)
    return "far" if c > 1 else "near" if c < -1 else "nothing"


def too_far(robot: str, x: float, y: float, z: float) -> bool:
    """Whether a place is beyond the stretched leg."""
    return why(robot, x, y, z) == "far"


def outermost(robot: str, z: float) -> float:
    """The farthest x, straight outwards, at which the foot can be at the height z."""
    leg = lengths(robot)
    return float(leg["coxa"] + np.sqrt((leg["femur"] + leg["tibia"]) ** 2 - z * z))


def outermost_without_coxa(robot: str, z: float) -> float:
    """As `outermost`, from the femur's joint."""
    return outermost(robot, z) - lengths(robot)["coxa"]


def outermost_as_if_level(robot: str, z: float) -> float:
    """As `outermost`, as if a foot at another height reached as far as a level leg."""
    return outermost(robot, 0.0)


def missing(robot: str, x: float, y: float, z: float) -> float:
    """How far a stretched leg remains from a place that is too far away."""
    leg = lengths(robot)
    return distance(robot, x, y, z) - leg["femur"] - leg["tibia"]


def missing_from_the_coxa(robot: str, x: float, y: float, z: float) -> float:
    """As `missing`, both measured from the coxa's joint."""
    return distance_with_coxa(robot, x, y, z) - sum(lengths(robot).values())


def ring(robot: str) -> dict[str, float]:
    """How near to the femur's joint, and how far from it, the foot can be: by the lengths, and by the limits."""
    leg, limb = lengths(robot), load_robot(robot).limb()
    f, t = leg["femur"], leg["tibia"]
    folded = float(np.abs(limb.limits[:, 2]).max())
    folded_mm = float(np.sqrt(f * f + t * t + 2 * f * t * np.cos(folded)))
    return {
        "inner": abs(f - t), "outer": f + t, "folded": folded_mm, "limit": float(-np.degrees(folded)),
    }  # fmt: skip


def asked_of_the_acos(robot: str, x: float, y: float, z: float) -> float:
    """What krsri-hexapod's (21) asks the acos of, by (18) and (19) as they are printed; z counts downwards."""
    level = float(np.hypot(x, y))
    return z / float(np.hypot(level - lengths(robot)["coxa"], y))


def misprint(robot: str, x: float, y: float, z: float, equations: list[str]) -> int:
    """Which of the paper's `equations`, taken letter for letter by itself, leads the foot farthest astray.

    Args:
        robot, x, y, z: a place in the limb frame.
        equations: their numbers, in the order in which a lesson shows them.
    """
    one = load_robot(robot)
    limb = one.limb()
    faults = as_printed(one, limb, np.array([x, y, z]) / 1000)[0].faults
    cost = {
        fault.equation: np.inf if fault.cost_m is None else fault.cost_m
        for fault in faults
        if fault.equation in equations
    }
    return equations.index(max(cost, key=lambda number: cost[number])) + 1
