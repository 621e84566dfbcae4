"""The other knee, and what limits leave. Angles in degrees, places in millimetres, in the limb frame."""

from dataclasses import replace

import numpy as np

from kinlab.lessons.results import Reach, limb_reach
from kinlab.lessons.robots import load_robot
from kinlab.robots import Limb
from kinlab.robots.inverse import Inverse


def ways(robot: str, x: float, y: float, z: float) -> int:
    """How many poses bring the foot to a place, limits aside."""
    return int(np.isfinite(_solve(robot, x, y, z).solutions[:, 0]).sum())


def ways_key(robot: str, x: float, y: float, z: float) -> str:
    """The same as the key of an option: "one", "two" or "four"."""
    return {1: "one", 2: "two", 4: "four"}[ways(robot, x, y, z)]


def ways_within_limits(robot: str, x: float, y: float, z: float) -> int:
    """How many of them the joints can take."""
    return int(_solve(robot, x, y, z).within_limits.sum())


def telling(robot: str, x: float, y: float, z: float) -> bool:
    """Whether limits allow some way to a place, and no angle is within a degree of one of them."""
    leg, found = _leg(robot), _solve(robot, x, y, z)
    near = np.abs(found.solutions[:2] - leg.limits[:, None, :]) < np.radians(1.0)
    return bool(found.reachable) and not near.any()


def knee_up(robot: str, x: float, y: float, z: float) -> dict[str, float]:
    """The pose with the knee above the line from the femur's joint to the foot: alpha, beta, gamma."""
    return dict(zip(("alpha", "beta", "gamma"), _pose(robot, x, y, z, "knee-up"), strict=True))


def knee_down(robot: str, x: float, y: float, z: float) -> list[float]:
    """Femur and tibia of its mirror image."""
    return _pose(robot, x, y, z, "knee-down")[1:]


def only_gamma_mirrored(robot: str, x: float, y: float, z: float) -> list[float]:
    """As `knee_down`, the femur left as it was."""
    _, beta, gamma = _pose(robot, x, y, z, "knee-up")
    return [beta, -gamma]


def mirrored_in_the_ground(robot: str, x: float, y: float, z: float) -> list[float]:
    """As `knee_down`, the level taken for the mirror in the place of the line to the foot."""
    _, beta, gamma = _pose(robot, x, y, z, "knee-up")
    return [-beta, -gamma]


def under_a_rail(robot: str, x: float, z: float) -> Reach:
    """The joint angles that bring the foot straight ahead of the leg, the knee not above the line to it."""
    leg = _leg(robot)
    reach = limb_reach(leg, (x, 0.0, z))
    below = tuple(_pose(robot, x, 0.0, z, "knee-down"))
    return replace(reach, solution_deg=below, lower_deg=(*reach.lower_deg[:2], 0.0))


def fits_under(robot: str, x: float, z: float) -> bool:
    """Whether both knees are allowed without the rail, and bent enough to be told apart."""
    return ways_within_limits(robot, x, 0.0, z) == 2 and abs(_pose(robot, x, 0.0, z, "knee-up")[2]) > 8


def line(robot: str, x: float, y: float, z: float) -> float:
    """The angle of the line from the femur's joint to the foot."""
    coxa = float(_leg(robot).links[0, 0]) * 1000
    return float(np.degrees(np.arctan2(z, np.hypot(x, y) - coxa)))


def two_knees_exist(robot: str, x: float, y: float, z: float) -> bool:
    """Whether the foot gets there with either knee."""
    found = _solve(robot, x, y, z)
    return bool(np.isfinite(found.solutions[:2]).all())


def change(robot: str, x: float, y: float, z: float) -> str:
    """How a standing leg changes its knee: "never", where the poses between the two move the foot.

    "freely" if some path from one pose to the other kept the foot in its place.
    """
    up, down = (_pose(robot, x, y, z, name) for name in ("knee-up", "knee-down"))
    leg = _leg(robot)
    # Wherever on the way, the tibia passes through zero: the leg is straight, and reaches too far.
    straight = float(np.linalg.norm(leg.links[1:], axis=1).sum()) * 1000
    coxa = float(leg.links[0, 0]) * 1000
    distance = float(np.hypot(np.hypot(x, y) - coxa, z))
    return "freely" if abs(straight - distance) < 1e-9 or up == down else "never"


def limits(robot: str, limb: str, joint: str) -> dict[str, float]:
    """Lower and upper limit of a joint."""
    leg = _leg(robot, limb)
    lower, upper = np.degrees(leg.limits[:, leg.joint_names.index(joint)])
    return {"lower": float(lower), "upper": float(upper)}


def servo_of(robot: str, limb: str, joint: str) -> dict[str, float]:
    """How a joint's servo is mounted: id, zero, sign."""
    leg = _leg(robot, limb)
    servo = leg.joints[leg.joint_names.index(joint)].servo
    assert servo is not None
    return {"id": servo.id, "zero": servo.zero_deg, "sign": servo.sign, "step": servo.model.deg_per_step}


def limit_ticks(robot: str, limb: str, joint: str, low: float, high: float) -> list[int]:
    """What the servo's CW Angle Limit and CCW Angle Limit are to hold: the lower tick, then the higher."""
    leg = _leg(robot, limb)
    servo = leg.joints[leg.joint_names.index(joint)].servo
    assert servo is not None
    return sorted(int(tick) for tick in servo.command(np.radians([low, high])))


def limit_ticks_swapped(robot: str, limb: str, joint: str, low: float, high: float) -> list[int]:
    """As `limit_ticks`, the higher one first."""
    return limit_ticks(robot, limb, joint, low, high)[::-1]


def limit_ticks_unmounted(robot: str, limb: str, joint: str, low: float, high: float) -> list[int]:
    """As `limit_ticks`, zero and sign of the mounting forgotten."""
    step = servo_of(robot, limb, joint)["step"]
    return [round(low / step), round(high / step)]


def _leg(robot: str, limb: str = "") -> Limb:
    return load_robot(robot).limb(limb or None)


def _solve(robot: str, x: float, y: float, z: float) -> Inverse:
    return _leg(robot).ik(np.array([x, y, z]) / 1000)


def _pose(robot: str, x: float, y: float, z: float, name: str) -> list[float]:
    found = _solve(robot, x, y, z)
    return [float(a) for a in np.degrees(found.solutions[found.names.index(name)])]
