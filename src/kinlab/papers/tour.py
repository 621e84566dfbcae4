"""One target of each paper, walked along the whole path: what `kinlab tour` shows."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.path import WholePath, whole_path
from kinlab.rig.bench import bench_of
from kinlab.robots import Limb, Robot
from kinlab.robots.load import shipped_robots
from kinlab.units import to_metres


@dataclass(frozen=True)
class Stop:
    """A target of a paper.

    Attributes:
        where: the place in the paper that the target comes from.
        path: for it, its chosen solution sent to emulated servos.
    """

    where: str
    path: WholePath

    def to_json(self) -> dict[str, Any]:
        """The contract of `kinlab ik --json --as-printed`, where the target comes from, and how the servos took it."""
        path, answer = self.path, self.path.answer
        arrived = None if path.arrival is None else path.arrival.to_json(answer.target)
        return {
            "where": self.where,
            **answer.to_json(),
            "as_printed": [variant.to_json(answer.limb, answer.frame) for variant in path.printed],
            "arrival": arrived or {"unsent": path.unsent},
        }


# Robot, limb, target, unit, frame, and the place in the paper.
TARGETS = (
    ("xl430-hexapod", "R1", (75, 10, -46), "mm", "paper", "Table 1, right leg, advancing"),
    ("krsri-hexapod", "R1", (130, 0, 90), "mm", "paper", "a standing leg; the paper prints no target"),
    ("udiebot", "LF", (26, 0, 10), "cm", "paper", "Table 6, row 1"),
    ("eros", "left_leg", (8, 0, -235), "mm", "paper", "one step of 8 mm, experiment 1"),
    (
        "receptionist-arm",
        "right_arm",
        (-11.322, 7.653, 0),
        "cm",
        "paper",
        "section 4.1.1, start of the experiment",
    ),
)


def first_target(robot: Robot, limb: Limb) -> Array:
    """A place (3,), metres, limb frame, to begin with: the tour's, else the stance, else the middle of the limits."""
    for name, limb_name, target, unit, frame, _ in TARGETS:
        if (name, limb_name) == (robot.name, limb.name):
            return limb.to_limb(to_metres(target, unit), frame)
    if limb.stance is not None:
        return limb.stance
    return np.asarray(limb.fk(limb.limits.mean(axis=0))[:3, 3])


def tour() -> list[Stop]:
    """The stops of the tour, one for each paper, with KinLab's own robots."""
    robots = shipped_robots()
    stops = []
    for name, limb_name, target, unit, frame, where in TARGETS:
        robot = robots[name]
        limb = robot.limbs[limb_name]
        bench, why = bench_of(robot, limb)
        there = to_metres(target, unit)
        path = whole_path(robot, limb, target=there, frame=frame, bench=bench, no_bench=why)
        stops.append(Stop(where, path))
    return stops
