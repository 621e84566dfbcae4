"""The path for one target, every station of it: angles, servo angles, commands, and the error at each depth.

What `kinlab ik` shows, as data; figures for people in millimetres and degrees.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array, rpy_to_rotation, wrap
from kinlab.names import resolve
from kinlab.robots.inverse import inverse_kinematics, nearest
from kinlab.robots.model import FRAMES, Limb, Robot
from kinlab.robots.reasons import beyond_limits, why_unreachable
from kinlab.units import check_place, finite, shown_mm

if TYPE_CHECKING:
    from kinlab.kinematics.numeric import Solution

# Poses of which no joint differs by more (rad) are one.
SAME_POSE = 1e-6


@dataclass(frozen=True)
class ServoReading:
    """A servo at a joint angle: `command` in ticks, or microseconds for PWM; None beyond its range."""

    id: int
    model: str
    servo_deg: float
    command: int | None
    unit: str

    def to_json(self) -> dict[str, Any]:
        """The contract's `servos` entry; a PWM servo has `pulse_us` and no ticks."""
        pulse = self.unit == "us"
        found: dict[str, Any] = {"id": self.id, "model": self.model, "servo_deg": self.servo_deg}
        found["ticks"] = None if pulse else self.command
        if pulse:
            found["pulse_us"] = self.command
        return found


@dataclass(frozen=True, eq=False)
class PoseReport:
    """One solution.

    Attributes:
        name: which of the solutions it is.
        q: angles (n,), rad.
        within_limits: of joints and servos.
        beyond: what breaks a limit, in words; empty where nothing does.
        tip: where forward kinematics puts the tip (3,), limb frame, metres.
        error_m: its distance from the target.
        servos: by joint name; empty where the paper names none.
        quantised: the tip (3,) at the servos' nearest commands, limb frame, metres; None without servos
            or beyond their range.
        quantised_error_m: its distance from the target.
    """

    name: str
    q: Array
    within_limits: bool
    beyond: tuple[str, ...]
    tip: Array
    error_m: float
    servos: dict[str, ServoReading]
    quantised: Array | None
    quantised_error_m: float | None


@dataclass(frozen=True, eq=False)
class TargetReport:
    """What comes of asking a limb for a target.

    Attributes:
        robot, limb: asked.
        frame: in which places are shown: limb, body or paper.
        target: (3,), limb frame, metres.
        rotation: the attitude asked for (3, 3), or None.
        poses: all solutions.
        chosen: index of the chosen one; None where none of them is within the limits.
        reachable: whether the limb gets there within its limits, by whatever method.
        reason: why none is chosen; empty where one is.
        nearest: the nearest reachable point (3,), limb frame, metres; None where the target is reachable.
        attempt: the run of a numeric method, where one was asked for.
    """

    robot: Robot
    limb: Limb
    frame: str
    target: Array
    rotation: Array | None
    poses: tuple[PoseReport, ...]
    chosen: int | None
    reachable: bool
    reason: str
    nearest: Array | None
    attempt: "Solution | None" = None

    @property
    def missed_mm(self) -> float:
        """The distance from the target to the nearest reachable point."""
        return (
            0.0
            if self.nearest is None
            else round(float(np.linalg.norm(self.nearest - self.target)) * 1000, 9)
        )

    def place_mm(self, point: Array) -> list[float]:
        """A point of the limb frame (3,), in metres, as millimetres in the frame shown."""
        return place_mm(self.limb, point, self.frame)

    def to_json(self, *, servos: bool = True) -> dict[str, Any]:
        """The contract of `kinlab ik --json`, without `as_printed`."""
        found: dict[str, Any] = {
            "robot": self.robot.name,
            "limb": self.limb.name,
            "frame": self.frame,
            "target_mm": self.place_mm(self.target),
            "reachable": self.reachable,
            "chosen": self.chosen,
            "solutions": [self._pose_json(pose, servos) for pose in self.poses],
        }
        if self.chosen is None:
            found["reason"] = self.reason
        if self.nearest is not None:
            found["nearest_mm"] = self.place_mm(self.nearest)
            found["missed_mm"] = self.missed_mm
        if self.attempt is not None:
            from kinlab.robots.methods import attempt_json

            found["method"] = attempt_json(self.limb, self.attempt)
        return found

    def _pose_json(self, pose: PoseReport, servos: bool) -> dict[str, Any]:
        return {
            "name": pose.name,
            "angles_deg": angles_deg(self.limb, pose.q),
            "within_limits": pose.within_limits,
            "beyond": list(pose.beyond),
            "fk_mm": self.place_mm(pose.tip),
            "error_mm": pose.error_m * 1000,
            "servos": {name: servo.to_json() for name, servo in pose.servos.items() if servos},
            "quantised_fk_mm": None if pose.quantised is None else self.place_mm(pose.quantised),
            "quantised_error_mm": None if pose.quantised_error_m is None else pose.quantised_error_m * 1000,
        }


def place_mm(limb: Limb, point: Array, frame: str) -> list[float]:
    """A point of the limb frame (3,), in metres, as millimetres in `frame`."""
    return shown_mm(limb.from_limb(point, frame))


def angles_deg(limb: Limb, q: ArrayLike) -> dict[str, float]:
    """Joint angles (n,) in rad as degrees by name."""
    return {name: round(float(a), 12) + 0.0 for name, a in zip(limb.joint_names, np.degrees(q), strict=True)}


def solve_target(
    robot: Robot,
    limb: Limb,
    target: ArrayLike,
    *,
    frame: str = "limb",
    rpy: ArrayLike | None = None,
    method: str | None = None,
) -> TargetReport:
    """Every station of the path for one target.

    Args:
        robot, limb: asked.
        target: (3,), in metres and in `frame`.
        frame: limb, body or paper.
        rpy: roll, pitch, yaw (3,) of the tip in the limb frame, rad, for limbs that can choose it.
        method: a numeric method (see `kinlab.kinematics.numeric`) instead of the closed form.

    Raises:
        UsageError: numbers that are not finite, a wrong name, an attitude that the limb cannot choose.
    """
    check_place(target, "a target's numbers")
    frame = resolve(frame, FRAMES, "frame")
    point = limb.to_limb(target, frame)
    rotation = None
    if rpy is not None:
        finite(rpy, "roll, pitch and yaw")
        rotation = rpy_to_rotation(rpy)
    found = inverse_kinematics(limb, point, rotation)
    attempt = None
    if method is None:
        named = [(n, q) for n, q in zip(found.names, found.solutions, strict=True) if np.isfinite(q).all()]
    else:
        from kinlab.robots.methods import attempt_target

        attempt = attempt_target(limb, point, method, rotation)
        named = [(attempt.method, attempt.q)] if attempt.converged else []
    poses = tuple(_pose(limb, name, q, point) for name, q in named)
    chosen = next((i for i, pose in enumerate(poses) if pose.within_limits), None)
    reasons, closest = [], None
    if attempt is not None and chosen is None:
        reasons.append(_why_not(attempt, poses))
        if found.reachable:
            reasons.append(f"there is a solution within the limits: {found.names[int(found.chosen)]}")
    if not found.reachable:
        closest = nearest(limb, point)
        reasons.append(why_unreachable(limb, point, found, closest))
    reachable, reason = bool(found.reachable), "; ".join(reasons)
    return TargetReport(
        robot, limb, frame, point, rotation, poses, chosen, reachable, reason, closest, attempt
    )


def solve_angles(robot: Robot, limb: Limb, q: ArrayLike, *, frame: str = "limb") -> TargetReport:
    """The path begun at joint angles (n,), rad: the target is where they bring the tip.

    The pose that was given stands first, as "as given"; behind it, other ways to the same place.

    Raises:
        UsageError: numbers that are not finite, a wrong count of them, a wrong name.
    """
    finite(q, "angles")
    q = np.asarray(q, float)
    frame = resolve(frame, FRAMES, "frame")
    pose = limb.fk(q)
    point, rotation = pose[:3, 3], pose[:3, :3] if len(limb.joints) >= 6 else None
    poses = [_pose(limb, "as given", q, point)]
    if limb.closed_form is not None:
        found = inverse_kinematics(limb, point, rotation)
        for name, other in zip(found.names, found.solutions, strict=True):
            if np.isfinite(other).all() and np.abs(wrap(other - q)).max() > SAME_POSE:
                poses.append(_pose(limb, name, other, point))
    fits = poses[0].within_limits
    return TargetReport(
        robot, limb, frame, point, rotation, tuple(poses), 0 if fits else None, fits,
        "; ".join(poses[0].beyond), None,
    )  # fmt: skip


def _why_not(attempt: "Solution", poses: tuple[PoseReport, ...]) -> str:
    if not attempt.converged:
        return f"{attempt.method} did not get there: {attempt.reason}"
    return f"{attempt.method} got there with angles beyond the limits: {', '.join(poses[0].beyond)}"


def _pose(limb: Limb, name: str, q: Array, target: Array) -> PoseReport:
    tip = limb.fk(q)[:3, 3]
    beyond = beyond_limits(limb, q)
    servos, quantised = read_servos(limb, q)
    error = None if quantised is None else float(np.linalg.norm(quantised - target))
    return PoseReport(
        name, q, not beyond, beyond, tip, float(np.linalg.norm(tip - target)), servos, quantised, error
    )


def read_servos(limb: Limb, q: Array) -> tuple[dict[str, ServoReading], Array | None]:
    """The servos at angles `q` (n,), rad, and the tip (3,), metres, at their nearest commands (None if beyond)."""
    servos: dict[str, ServoReading] = {}
    rounded = []
    for joint, angle in zip(limb.joints, q, strict=True):
        if joint.servo is None:
            continue
        command = float(joint.servo.command(angle))
        inside = np.isfinite(command)
        servos[joint.name] = ServoReading(
            joint.servo.id, joint.servo.model.name, float(joint.servo.degrees(angle)),
            int(command) if inside else None, joint.servo.model.unit,
        )  # fmt: skip
        rounded.append(joint.servo.joint(command))
    whole = len(rounded) == len(limb.joints) and bool(np.isfinite(rounded).all())
    return servos, limb.fk(np.array(rounded))[:3, 3] if whole else None
