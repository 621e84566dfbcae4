"""Every leg's joints for a pose of the body over feet that stay where they are."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics.body import feet_from_body
from kinlab.kinematics.leg import leg_ik
from kinlab.kinematics.transforms import Array, rpy_to_rotation
from kinlab.robots.inverse import inverse_kinematics
from kinlab.robots.model import Robot
from kinlab.robots.target import angles_deg, read_servos, solve_target
from kinlab.units import check_place, finite, shown_mm


@dataclass(frozen=True, eq=False, repr=False)
class BodyPose:
    """A pose of the body, or many (...), and what its L legs of n joints do for it.

    Attributes:
        legs: the legs' names.
        feet: in the frame of the moved body (..., L, 3), metres.
        q: joint angles (..., L, n) in rad, NaN where a foot is out of reach.
        reachable: for each leg (..., L).
    """

    legs: tuple[str, ...]
    feet: Array
    q: Array
    reachable: Array

    def __repr__(self) -> str:
        return f"<BodyPose of {', '.join(self.legs)}: {'all' if self.reachable.all() else 'not all'} feet in reach>"


def resting(robot: Robot) -> dict[str, Array]:
    """Joint angles (n,) of every limb, rad: legs stand, other joints are as near zero as they can be."""
    found = {}
    for limb in robot.limbs.values():
        lower, upper = limb.limits
        found[limb.name] = (
            np.clip(np.zeros(len(limb.joints)), lower, upper)
            if limb.stance is None
            else limb.ik(limb.stance).q
        )
    return found


def body_pose(robot: Robot, xyz: ArrayLike, rpy: ArrayLike, feet: ArrayLike | None = None) -> BodyPose:
    """The legs' joint angles when the body moves by `xyz` and turns by `rpy` over fixed feet.

    krsri-hexapod, equations 1 to 16, with the body moved instead of the feet.

    Args:
        robot: one with legs.
        xyz: displacement (..., 3) in the frame of the standing body, metres.
        rpy: roll, pitch, yaw (..., 3), rad.
        feet: where they stand (L, 3), body frame, metres; default: the standing feet.

    Raises:
        UsageError: the robot has no legs.
    """
    if not robot.legs:
        raise UsageError(f"{robot.name} has no legs to stand on: no group of its limbs has a stance")
    feet = robot.standing_feet if feet is None else np.asarray(feet, float)
    R = rpy_to_rotation(rpy)
    return legs_ik(robot, feet_from_body(feet, xyz, R), R)


def legs_ik(
    robot: Robot, feet: ArrayLike, turned: ArrayLike | None = None, soles: ArrayLike | None = None
) -> BodyPose:
    """Joint angles of all legs for feet (..., L, 3) in the body frame, metres.

    Equal three-joint legs are solved in one call, knee up, and only where that breaks a limit are the
    other solutions looked for. The soles of six-joint legs lie on the ground: `turned` (..., 3, 3) is
    the attitude of the body over it, `soles` (..., L, 3, 3) their own, level where not given.
    """
    feet = np.asarray(feet, float)
    legs, inverse = robot.legs, robot.leg_frames
    local = robot.to_legs(feet)
    names = tuple(leg.name for leg in legs)
    if robot.equal_legs is not None:
        q, reachable = leg_ik(local, *robot.equal_legs)
        lowest, highest = robot.leg_bounds
        if ((q >= lowest) & (q <= highest)).all():
            return BodyPose(names, feet, q, reachable)
    if len({len(leg.joints) for leg in legs}) > 1:
        raise UsageError(f"the legs of {robot.name} differ in their number of joints")
    level = None
    if turned is not None and len(legs[0].joints) >= 6:
        level = np.swapaxes(np.asarray(turned, float), -1, -2)[..., None, :, :]
        if soles is not None:
            level = level @ np.asarray(soles, float)
        level = np.broadcast_to(level, (*level.shape[:-3], len(legs), 3, 3))
    found = [
        inverse_kinematics(
            leg,
            local[..., i, :],
            None if level is None else inverse[i, :3, :3] @ level[..., i, :, :] @ leg.mount[:3, :3],
        )
        for i, leg in enumerate(legs)
    ]
    return BodyPose(
        names, feet, np.stack([f.q for f in found], axis=-2), np.stack([f.reachable for f in found], axis=-1)
    )


@dataclass(frozen=True, eq=False)
class Stand:
    """What `kinlab body` shows: the robot, the body's displacement (3,) in metres and rpy (3,) in rad, the legs."""

    robot: Robot
    xyz: Array
    rpy: Array
    pose: BodyPose

    def to_json(self) -> dict[str, Any]:
        """Feet in mm in the moved body's frame, angles in deg, the servos' commands."""
        legs = {}
        for i, leg in enumerate(self.robot.legs):
            reachable = bool(self.pose.reachable[i])
            q = self.pose.q[i]
            servos = read_servos(leg, q)[0] if reachable else {}
            legs[leg.name] = {
                "foot_mm": shown_mm(self.pose.feet[i]),
                "reachable": reachable,
                "angles_deg": angles_deg(leg, q) if reachable else None,
                "commands": {name: servo.command for name, servo in servos.items()},
            }
            if not reachable:
                legs[leg.name]["reason"] = solve_target(
                    self.robot, leg, self.pose.feet[i], frame="body"
                ).reason
        return {
            "robot": self.robot.name,
            "xyz_mm": (self.xyz * 1000).tolist(),
            "rpy_deg": np.degrees(self.rpy).tolist(),
            "reachable": bool(self.pose.reachable.all()),
            "legs": legs,
        }


def stand(robot: Robot, xyz_mm: ArrayLike, rpy_deg: ArrayLike) -> Stand:
    """The legs for one pose of the body, as people type it: millimetres and degrees.

    Raises:
        UsageError: numbers that are not finite, or a robot without legs.
    """
    xyz, rpy = np.asarray(xyz_mm, float) / 1000, np.radians(rpy_deg)
    check_place(xyz, "a displacement's numbers")
    finite(rpy, "angles")
    return Stand(robot, xyz, rpy, body_pose(robot, xyz, rpy))
