"""The whole path for one target or one pose, through every room: what the Robot station shows."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array
from kinlab.papers.as_printed import as_printed, fk_as_printed
from kinlab.papers.measurements import Measured, measured
from kinlab.papers.results import AsPrinted, FkAsPrinted
from kinlab.rig.bench import Arrival, LimbBench, bench_of
from kinlab.robots import Limb, Robot
from kinlab.robots.target import PoseReport, TargetReport, solve_angles, solve_target


@dataclass(frozen=True, eq=False)
class WholePath:
    """From a target, or from joint angles, to where the servos say that the tip is.

    Attributes:
        answer: targets, solutions, servo angles and commands.
        pose: the solution that was sent on; None where there is none.
        printed: what the paper's equations make of the target.
        printed_fk: what they make of the angles, where the path began at angles.
        measured: how far off the paper measured.
        arrival: what came of sending `pose` to the servos; None where it was not sent.
        unsent: why not; empty where it was.
    """

    answer: TargetReport
    pose: PoseReport | None
    printed: tuple[AsPrinted, ...]
    printed_fk: tuple[FkAsPrinted, ...]
    measured: Measured | None
    arrival: Arrival | None
    unsent: str

    @property
    def arrival_error_m(self) -> float | None:
        """How far from the target the servos have brought the tip; None where they did not answer."""
        if self.arrival is None or not self.arrival.answered:
            return None
        return self.arrival.error_m(self.answer.target)


def whole_path(
    robot: Robot,
    limb: Limb,
    *,
    target: ArrayLike | None = None,
    rpy: ArrayLike | None = None,
    q: ArrayLike | None = None,
    frame: str = "limb",
    solution: str = "",
    bench: LimbBench | None = None,
    no_bench: str = "",
) -> WholePath:
    """Walk the path once.

    Args:
        robot, limb: whose.
        target: (3,), metres, in `frame`; or
        q: joint angles (n,), rad, from which the path begins.
        rpy: attitude (3,) for limbs that choose it, rad.
        frame: limb, body or paper.
        solution: the name of the one to be sent on; the first within the limits where there is none of that name,
            or where it breaks a limit.
        bench: the limb's emulated servos.
        no_bench: why there are none.

    Raises:
        UsageError: see `solve_target` and `solve_angles`.
    """
    if q is not None:
        answer = solve_angles(robot, limb, q, frame=frame)
        printed_fk = fk_as_printed(robot, limb, q)
    else:
        assert target is not None
        answer = solve_target(robot, limb, target, frame=frame, rpy=rpy)
        printed_fk = ()
    printed = as_printed(robot, limb, answer.target, answer.rotation)
    wished = (pose for pose in answer.poses if pose.name == solution and pose.within_limits)
    chosen = None if answer.chosen is None else answer.poses[answer.chosen]
    pose = next(wished, chosen)
    arrival, unsent = (None, no_bench) if pose is None else _sent(bench, no_bench, pose.q)
    return WholePath(answer, pose, printed, printed_fk, measured(robot, limb, answer.target), arrival, unsent)


def sent_on(robot: Robot, limb: Limb, q: ArrayLike) -> tuple[Arrival | None, str]:
    """What comes of sending the limb to `q` (n,), rad, on emulated servos; and why it was not sent, else empty."""
    return _sent(*bench_of(robot, limb), q)


def _sent(bench: LimbBench | None, no_bench: str, q: ArrayLike) -> tuple[Arrival | None, str]:
    if bench is None:
        return None, no_bench
    try:
        return bench.go(q), ""
    except KinlabError as error:
        return None, str(error)


def angles_of(variant: AsPrinted, limb: Limb) -> Array | None:
    """The angles (n,), rad, that printed equations give; None where they give none."""
    if variant.angles is None:
        return None
    return np.array([variant.angles[name] for name in limb.joint_names])
