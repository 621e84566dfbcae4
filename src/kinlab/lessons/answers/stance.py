"""A body that moves over feet that stand. Millimetres and degrees, in the body's frame."""

import numpy as np

from kinlab.kinematics.body import feet_from_body
from kinlab.kinematics.transforms import rpy_to_rotation
from kinlab.lessons.results import Reach, limb_reach
from kinlab.lessons.robots import load_robot
from kinlab.robots import Limb
from kinlab.robots.body import body_pose


def standing(robot: str, limb: str) -> list[float]:
    """Where a foot stands before the body moves."""
    one = load_robot(robot)
    return [float(v) for v in one.standing_feet[_index(robot, limb)] * 1000]


def foot(
    robot: str,
    limb: str,
    tx: float = 0.0,
    ty: float = 0.0,
    tz: float = 0.0,
    roll: float = 0.0,
    pitch: float = 0.0,
    yaw: float = 0.0,
) -> list[float]:
    """Where that foot is, seen from the body that has moved and turned."""
    R = rpy_to_rotation(np.radians([roll, pitch, yaw]))
    seen = feet_from_body(np.array([standing(robot, limb)]), np.array([tx, ty, tz]), R)
    return [float(v) for v in seen[0]]


def foot_carried_along(
    robot: str, limb: str, tx: float = 0.0, ty: float = 0.0, tz: float = 0.0, yaw: float = 0.0
) -> list[float]:
    """As `foot`, moved the way the body moves: R p + t."""
    R = rpy_to_rotation(np.radians([0.0, 0.0, yaw]))
    return [float(v) for v in R @ np.array(standing(robot, limb)) + [tx, ty, tz]]


def foot_turned_first(
    robot: str, limb: str, tx: float = 0.0, ty: float = 0.0, tz: float = 0.0, yaw: float = 0.0
) -> list[float]:
    """As `foot`, the turn undone before the shift."""
    R = rpy_to_rotation(np.radians([0.0, 0.0, yaw]))
    return [float(v) for v in R.T @ np.array(standing(robot, limb)) - [tx, ty, tz]]


def foot_turned_along(
    robot: str, limb: str, tx: float = 0.0, ty: float = 0.0, tz: float = 0.0, yaw: float = 0.0
) -> list[float]:
    """As `foot`, the shift undone, but turned the way the body turns."""
    R = rpy_to_rotation(np.radians([0.0, 0.0, yaw]))
    return [float(v) for v in R @ (np.array(standing(robot, limb)) - [tx, ty, tz])]


def stands_at(robot: str, limb: str) -> float:
    """z of a foot before the body moves."""
    return standing(robot, limb)[2]


def height(robot: str, limb: str, tz: float) -> float:
    """z of a foot under a body that has risen by tz."""
    return foot(robot, limb, tz=tz)[2]


def height_carried_along(robot: str, limb: str, tz: float) -> float:
    """As `height`, the foot taken along."""
    return standing(robot, limb)[2] + tz


def height_rolled(robot: str, limb: str, roll: float) -> float:
    """z of a foot under a body that has rolled."""
    return foot(robot, limb, roll=roll)[2]


def height_rolled_back(robot: str, limb: str, roll: float) -> float:
    """As `height_rolled`, rolled the other way."""
    return height_rolled(robot, limb, -roll)


def height_without_its_own(robot: str, limb: str, roll: float) -> float:
    """As `height_rolled`, for a foot at the body's own height."""
    return height_rolled(robot, limb, roll) - stands_at(robot, limb) * float(np.cos(np.radians(roll)))


def follow(robot: str, limb: str, tx: float, tz: float) -> Reach:
    """The joint angles that keep a foot in its place while the body moves."""
    return limb_reach(*_in_leg(robot, limb, foot(robot, limb, tx=tx, tz=tz)))


def follow_carried_along(robot: str, limb: str, tx: float, tz: float) -> Reach:
    """As `follow`, the foot moved the way that the body moves."""
    return limb_reach(*_in_leg(robot, limb, foot_carried_along(robot, limb, tx=tx, tz=tz)))


def follow_not_turned(robot: str, limb: str, tx: float, tz: float) -> Reach:
    """As `follow`, the leg's x taken for the body's."""
    leg, start = _in_leg(robot, limb, standing(robot, limb))
    return limb_reach(leg, [start[0] - tx, start[1], start[2] - tz])


def follow_not(robot: str, limb: str) -> Reach:
    """As `follow`, the angles from before."""
    return limb_reach(*_in_leg(robot, limb, standing(robot, limb)))


def seen_by_its_leg(robot: str, limb: str, tx: float, tz: float) -> list[float]:
    """Where that foot is in the frame of its leg."""
    return _in_leg(robot, limb, foot(robot, limb, tx=tx, tz=tz))[1]


def can_follow(robot: str, limb: str, tx: float, tz: float) -> bool:
    """Whether the leg can, and could to the wrong places as well."""
    try:
        for where in (follow, follow_carried_along, follow_not_turned):
            where(robot, limb, tx, tz)
    except ValueError:
        return False
    return True


def _in_leg(robot: str, limb: str, place: list[float]) -> tuple[Limb, list[float]]:
    leg = load_robot(robot).limb(limb)
    return leg, [float(v) for v in leg.to_limb(np.array(place) / 1000, "body") * 1000]


def impossible(robot: str, roll: float) -> dict[str, float | str]:
    """The first leg that cannot follow a roll, and the angle of which joint would have to go beyond which limit."""
    one = load_robot(robot)
    pose = body_pose(one, np.zeros(3), np.radians([roll, 0.0, 0.0]))
    i = int(np.argmin(pose.reachable))
    leg = one.legs[i]
    q = leg.ik(leg.to_limb(pose.feet[i], "body")).solutions[0]
    over = np.maximum(leg.limits[0] - q, q - leg.limits[1])
    worst = int(np.argmax(over))
    side = 0 if q[worst] < leg.limits[0, worst] else 1
    return {
        "leg": leg.name,
        "joint": leg.joint_names[worst],
        "needs": float(np.degrees(q[worst])),
        "limit": float(np.degrees(leg.limits[side, worst])),
    }


def misprint(robot: str, tx: float, ty: float) -> str:
    """Where R p + t, as krsri-hexapod's (16) prints it, lets a body go that is told to go by t.

    "backwards" where the feet move the way that the body should.
    """
    limb = load_robot(robot).legs[0].name
    before = np.array(standing(robot, limb))
    right = np.array(foot(robot, limb, tx, ty)) - before
    printed = np.array(foot_carried_along(robot, limb, tx, ty)) - before
    return "backwards" if right @ printed < 0 else "forwards"


def _index(robot: str, limb: str) -> int:
    one = load_robot(robot)
    return [leg.name for leg in one.legs].index(one.limb(limb).name)
