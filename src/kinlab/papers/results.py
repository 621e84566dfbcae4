"""What comes of evaluating a paper letter for letter: values, what they cost, and their JSON."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb
from kinlab.robots.target import place_mm
from kinlab.units import to_mm


@dataclass(frozen=True)
class Fault:
    """An equation whose printed form is not true of the robot.

    Attributes:
        equation: its number.
        printed, corrected: both forms.
        cost_m: how far from the target this fault alone leaves the tip, all other equations
            corrected; None where it cannot be evaluated.
        reason: why it cannot be, or what else is to be known.
    """

    equation: str
    printed: str
    corrected: str
    cost_m: float | None
    reason: str

    def to_json(self) -> dict[str, Any]:
        """As in the contract: lengths in mm."""
        return {
            "equation": self.equation,
            "printed": self.printed,
            "corrected": self.corrected,
            "cost_mm": _mm(self.cost_m),
            "reason": self.reason,
        }


@dataclass(frozen=True, eq=False)
class AsPrinted:
    """A paper's inverse kinematics at a target, letter for letter.

    Attributes:
        variant: "equations", or "tables" for the way in which the tables were computed.
        where: the equations or tables.
        angles: joint angles in rad, by joint; None where they cannot be evaluated.
        tip: where they bring the real limb's tip (3,), metres, limb frame.
        error_m: its distance from the target.
        note: how the print was read, and why it has no value where it has none.
        faults: what is wrong with it, each with its cost.
        own_tip: where they bring the tip (3,) of the leg that the tables were computed with.
        own_error_m: its distance from the target.
    """

    variant: str
    where: str
    angles: dict[str, float] | None
    tip: Array | None
    error_m: float | None
    note: str
    faults: tuple[Fault, ...]
    own_tip: Array | None = None
    own_error_m: float | None = None

    def to_json(self, limb: Limb, frame: str = "limb") -> dict[str, Any]:
        """As in the contract: points in mm and `frame`, angles in degrees."""
        angles = self.angles
        result = {
            "variant": self.variant,
            "where": self.where,
            "angles_deg": None
            if angles is None
            else {k: round(float(np.degrees(v)), 12) for k, v in angles.items()},
            "fk_mm": _point(self.tip, limb, frame),
            "error_mm": _mm(self.error_m),
            "note": self.note,
            "faults": [fault.to_json() for fault in self.faults],
        }
        if self.own_tip is not None:
            result |= {"own_fk_mm": _point(self.own_tip, limb, frame), "own_error_mm": _mm(self.own_error_m)}
        return result


@dataclass(frozen=True, eq=False)
class FkAsPrinted:
    """A paper's forward kinematics at given angles, letter for letter.

    Attributes:
        where: the equations.
        pose: of the tip (4, 4), metres, limb frame; its attitude need not be a rotation. None where
            it cannot be evaluated.
        error_m: distance of its position from the true one.
        attitude_error: the largest difference between the entries of its attitude and the true ones.
        note: how the print was read.
        faults: what is wrong with it; costs are distances of the position.
    """

    where: str
    pose: Array | None
    error_m: float | None
    attitude_error: float | None
    note: str
    faults: tuple[Fault, ...]

    def to_json(self, limb: Limb, frame: str = "limb") -> dict[str, Any]:
        """The position in mm and `frame`, the attitude in the limb frame."""
        pose = self.pose
        return {
            "where": self.where,
            "fk_mm": None if pose is None else _point(pose[:3, 3], limb, frame),
            "rotation": None if pose is None else pose[:3, :3].tolist(),
            "error_mm": _mm(self.error_m),
            "attitude_error": self.attitude_error,
            "note": self.note,
            "faults": [fault.to_json() for fault in self.faults],
        }


@dataclass(frozen=True, eq=False)
class BodyAsPrinted:
    """A paper's body kinematics: where the feet go for a move of the body, letter for letter.

    Attributes:
        where: the equations.
        feet: by leg (3,), metres, body frame, as printed.
        true_feet: the same of a body that moves over fixed feet.
        error_m: the distance between the two, by leg.
        note: how the print was read.
        faults: what is wrong with it; costs are those of the leg that suffers most.
    """

    where: str
    feet: Mapping[str, Array]
    true_feet: Mapping[str, Array]
    error_m: Mapping[str, float]
    note: str
    faults: tuple[Fault, ...]

    def to_json(self) -> dict[str, Any]:
        """Points in mm and the body frame."""
        return {
            "where": self.where,
            "legs": {
                leg: {
                    "foot_mm": to_mm(foot).tolist(),
                    "true_foot_mm": to_mm(self.true_feet[leg]).tolist(),
                    "error_mm": _mm(self.error_m[leg]),
                }
                for leg, foot in self.feet.items()
            },
            "note": self.note,
            "faults": [fault.to_json() for fault in self.faults],
        }


def _mm(metres: float | None) -> float | None:
    return None if metres is None else float(to_mm(metres))


def _point(point: Array | None, limb: Limb, frame: str) -> list[float] | None:
    return None if point is None else place_mm(limb, point, frame)
