"""Where the tip is at given angles: what `kinlab fk` shows, as data."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import dh, manipulability
from kinlab.kinematics.transforms import Array
from kinlab.names import resolve
from kinlab.robots.model import FRAMES, Limb, Robot
from kinlab.robots.reasons import beyond_limits
from kinlab.robots.target import angles_deg
from kinlab.units import finite, shown_mm


@dataclass(frozen=True, eq=False)
class PoseOfTip:
    """What `kinlab fk` shows.

    Attributes:
        robot, limb: asked.
        frame: limb, body or paper.
        q: angles (n,), rad.
        position: of the tip (3,), in `frame`, metres.
        rotation: of the tip (3, 3), in `frame`.
        jacobian: (6, n) in `frame`, m/rad and rad/rad.
    """

    robot: Robot
    limb: Limb
    frame: str
    q: Array
    position: Array
    rotation: Array
    jacobian: Array

    @property
    def manipulability(self) -> float:
        """Yoshikawa's measure: of the linear rows for limbs of up to three joints, else of all six."""
        rows = self.jacobian[:3] if len(self.q) <= 3 else self.jacobian
        return float(manipulability(rows))

    @property
    def outside(self) -> tuple[str, ...]:
        """What breaks a limit, in words."""
        return beyond_limits(self.limb, self.q)

    def dh_json(self) -> dict[str, Any]:
        """The limb's Denavit-Hartenberg parameters, with the transforms before and after them, in m."""
        found = dh.from_chain(self.limb.axes, self.limb.links)
        rows = zip(
            self.limb.joint_names,
            np.degrees(found.theta),
            found.d,
            found.a,
            np.degrees(found.alpha),
            strict=True,
        )
        return {
            "joints": [
                {
                    "joint": n,
                    "theta_deg": float(t),
                    "d_mm": d * 1000 + 0.0,
                    "a_mm": a * 1000 + 0.0,
                    "alpha_deg": float(al),
                }
                for n, t, d, a, al in rows
            ],
            "base": (found.base + 0.0).tolist(),
            "tool": (found.tool + 0.0).tolist(),
        }

    def to_json(self, *, jacobian: bool = False) -> dict[str, Any]:
        """The contract of `kinlab fk --json`."""
        found: dict[str, Any] = {
            "robot": self.robot.name,
            "limb": self.limb.name,
            "frame": self.frame,
            "angles_deg": angles_deg(self.limb, self.q),
            "position_mm": shown_mm(self.position),
            "rotation": (self.rotation + 0.0).tolist(),
            "within_limits": not self.outside,
        }
        if jacobian:
            found["jacobian"] = (self.jacobian + 0.0).tolist()
            found["manipulability"] = self.manipulability
        return found


def pose_of_tip(robot: Robot, limb: Limb, angles: ArrayLike, *, frame: str = "limb") -> PoseOfTip:
    """Where the tip of `limb` is at `angles` (n,), in degrees as people type them.

    Raises:
        UsageError: numbers that are not finite, a wrong count of them, a wrong name.
    """
    finite(angles, "angles")
    frame = resolve(frame, FRAMES, "frame")
    q = np.radians(np.asarray(angles, float))
    T = limb.fk(q)
    turn = {"limb": np.eye(3), "body": limb.mount[:3, :3], "paper": limb.paper_axes.T}[frame]
    J = limb.jacobian(q)
    # Angular rates are axial vectors: a reflection of the axes turns them around.
    axial = turn * np.linalg.det(turn)
    shown = np.concatenate([turn @ J[:3], axial @ J[3:]])
    # In the paper's axes both sides of the rotation are named anew; the body's only its base.
    rotation = turn @ T[:3, :3] @ (turn.T if frame == "paper" else np.eye(3))
    return PoseOfTip(robot, limb, frame, q, limb.from_limb(T[:3, 3], frame), rotation, shown)
