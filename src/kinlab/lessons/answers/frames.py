"""Two links in a plane, and places carried from a leg to the body. Angles in degrees, places in millimetres."""

import numpy as np

from kinlab.kinematics.transforms import rotation_to_rpy
from kinlab.lessons.answers.leg import foot, lengths
from kinlab.lessons.robots import load_robot


def two_links(robot: str, beta: float, gamma: float) -> list[float]:
    """Where femur and tibia end: outwards and upwards from the femur's joint."""
    x, _, z = foot(robot, 0.0, beta, gamma)
    return [x - lengths(robot)["coxa"], z]


def two_links_with_bare_gamma(robot: str, beta: float, gamma: float) -> list[float]:
    """As `two_links`, the tibia's angle taken from the ground and not from the femur."""
    femur, tibia = two_links(robot, beta, 0.0), two_links(robot, gamma, 0.0)
    share = lengths(robot)["femur"] / (lengths(robot)["femur"] + lengths(robot)["tibia"])
    return [share * f + (1 - share) * t for f, t in zip(femur, tibia, strict=True)]


def tibia_turns(robot: str, beta: float, gamma: float, lift: float) -> str:
    """What the tibia does, seen from the ground, when the femur rises: "along", "still" or "back"."""
    leg = load_robot(robot).limb()
    before, after = (leg.fk(np.radians([0.0, b, gamma]))[:3, :3] for b in (beta, beta + lift))
    # About -y: a joint that turns up turns the tip's pitch down.
    turned = -float(np.degrees(rotation_to_rpy(before.T @ after)[1]))
    return "still" if abs(turned) < 1e-6 else "along" if turned * lift > 0 else "back"


def mounting(robot: str, limb: str) -> dict[str, float]:
    """Where a leg's frame sits on the body: the place a, b, and the turn about the vertical."""
    mount = load_robot(robot).limb(limb).mount
    yaw = float(np.degrees(np.arctan2(mount[1, 0], mount[0, 0])))
    return {"a": float(mount[0, 3]) * 1000, "b": float(mount[1, 3]) * 1000, "turn": yaw}


def stance(robot: str, limb: str) -> list[float]:
    """Where the foot of a leg stands, in the leg's frame."""
    place = load_robot(robot).limb(limb).stance
    assert place is not None
    return [float(v) for v in place * 1000]


def stance_in_body(robot: str, limb: str) -> list[float]:
    """Where the foot of a leg stands, in the body's frame."""
    return in_body(robot, limb, *stance(robot, limb))


def in_body(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """A place of a leg's frame, in the body's."""
    found = load_robot(robot).limb(limb).from_limb(np.array([x, y, z]) / 1000, "body")
    return [float(v) for v in found * 1000]


def in_body_shifted_first(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """As `in_body`, shifted before it is turned."""
    mount = load_robot(robot).limb(limb).mount
    return [float(v) for v in mount[:3, :3] @ (np.array([x, y, z]) + mount[:3, 3] * 1000)]


def in_body_turned_back(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """As `in_body`, turned the other way."""
    mount = load_robot(robot).limb(limb).mount
    return [float(v) for v in mount[:3, :3].T @ np.array([x, y, z]) + mount[:3, 3] * 1000]


def in_body_not_turned(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """As `in_body`, shifted only."""
    mount = load_robot(robot).limb(limb).mount
    return [float(v) for v in np.array([x, y, z]) + mount[:3, 3] * 1000]


def in_leg(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """A place of the body's frame, in a leg's."""
    found = load_robot(robot).limb(limb).to_limb(np.array([x, y, z]) / 1000, "body")
    return [float(v) for v in found * 1000]


def in_leg_turned_first(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """As `in_leg`, the turn undone before the shift."""
    mount = load_robot(robot).limb(limb).mount
    return [float(v) for v in mount[:3, :3].T @ np.array([x, y, z]) - mount[:3, 3] * 1000]


def in_leg_turned_again(robot: str, limb: str, x: float, y: float, z: float) -> list[float]:
    """As `in_leg`, turned the leg's way once more in the place of back."""
    mount = load_robot(robot).limb(limb).mount
    return [float(v) for v in mount[:3, :3] @ (np.array([x, y, z]) - mount[:3, 3] * 1000)]
