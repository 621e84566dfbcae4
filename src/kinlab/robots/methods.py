"""Iterative methods on a limb's target: one of them, or all side by side."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import numeric
from kinlab.kinematics.transforms import Array
from kinlab.robots.inverse import fit_limits
from kinlab.robots.model import Limb, Robot
from kinlab.robots.reasons import beyond_limits
from kinlab.robots.target import PoseReport, angles_deg, place_mm, solve_target


def attempt_target(limb: Limb, target: Array, method: str, rotation: Array | None = None) -> numeric.Solution:
    """A numeric method from the middle of the joints' limits to `target` (3,), limb frame, metres.

    Its angles are turned by whole turns into the limits where that fits.
    """
    if rotation is None and len(limb.joints) >= 6:
        rotation = np.eye(3)
    start = limb.limits.mean(axis=0)
    found = numeric.solve(limb.axes, limb.links, target, start, method=method, rotation=rotation)
    fit_limits(limb, found.q)
    return found


def outcome(limb: Limb, attempt: numeric.Solution) -> tuple[str, str]:
    """How a run ended: converged, beyond limits, or failed; and why, where it did not converge within them."""
    if not attempt.converged:
        return "failed", attempt.reason
    beyond = beyond_limits(limb, attempt.q)
    return ("beyond limits", ", ".join(beyond)) if beyond else ("converged", "")


def attempt_json(limb: Limb, attempt: numeric.Solution) -> dict[str, Any]:
    """A run of a numeric method: how it ended, and its trace."""
    return {
        "name": attempt.method,
        "converged": attempt.converged,
        "residual_mm": attempt.residual_m * 1000,
        "iterations": attempt.iterations,
        "reason": attempt.reason,
        "within_limits": attempt.converged and not beyond_limits(limb, attempt.q),
        "angles_deg": angles_deg(limb, attempt.q),
        "trace": [
            {"angles_deg": angles_deg(limb, step.q), "residual_mm": step.residual_m * 1000, "note": step.note}
            for step in attempt.trace
        ],
    }


@dataclass(frozen=True, eq=False)
class MethodComparison:
    """One target through every numeric method, beside the closed form.

    Attributes:
        robot, limb, frame, target: as in TargetReport.
        closed: the closed form's pose, or None.
        no_closed_form: why there is none; empty where there is.
        runs: one of each method, all from the middle of the joints' limits.
    """

    robot: Robot
    limb: Limb
    frame: str
    target: Array
    closed: PoseReport | None
    no_closed_form: str
    runs: tuple[numeric.Solution, ...]

    @property
    def reached(self) -> bool:
        """Whether any method got there within the limits."""
        return any(run.converged and not beyond_limits(self.limb, run.q) for run in self.runs)

    def place_mm(self, point: Array) -> list[float]:
        """A point of the limb frame (3,), in metres, as millimetres in the frame shown."""
        return place_mm(self.limb, point, self.frame)

    def to_json(self) -> dict[str, Any]:
        """The runs with their traces."""
        return {
            "robot": self.robot.name,
            "limb": self.limb.name,
            "frame": self.frame,
            "target_mm": self.place_mm(self.target),
            "closed_form": None if self.closed is None else angles_deg(self.limb, self.closed.q),
            "methods": [attempt_json(self.limb, run) for run in self.runs],
        }


def compare_methods(
    robot: Robot, limb: Limb, target: ArrayLike, *, frame: str = "limb", rpy: ArrayLike | None = None
) -> MethodComparison:
    """One target (3,), in metres and in `frame`, through every numeric method; arguments as in `solve_target`."""
    exact = solve_target(robot, limb, target, frame=frame, rpy=rpy)
    runs = tuple(attempt_target(limb, exact.target, name, exact.rotation) for name in numeric.METHODS)
    closed, why = None, exact.reason
    if limb.closed_form is None:
        why = "this chain has none"
    elif exact.chosen is not None:
        closed = exact.poses[exact.chosen]
    return MethodComparison(robot, limb, exact.frame, exact.target, closed, why, runs)
