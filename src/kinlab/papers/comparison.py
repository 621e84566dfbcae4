"""Two gaits on KinLab's rig beside what the paper measured of them: curves, models, crossovers, each with its label."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array
from kinlab.papers.energy import GAITS, PAPER, Crossover, EnergyModel, crossover, fit, measured_energy
from kinlab.robots import Robot

# What is needed to say how well two terms fit.
LEAST_SPEEDS = 3
WHY = (
    "the paper's figures are measured on its robot, KinLab's are computed on an emulated chain, and nothing in the "
    "rig was fitted to the paper",
    "no length of a leg, no mass, no stroke and no lift is printed: those of the rig are assumed, and with them the "
    "torque at every joint",
    "the rig knows the servos' standby current, copper losses, friction and back-EMF; it does not know the "
    "controller, the weight of swinging legs, slip on the ground, or what legs push against each other",
    "in the rig the wave costs less by the second, since five legs share the weight and copper losses go with the "
    "square of the load, and more by the metre, since at the same stroke a swing has a fifth of the tripod's time",
)


@dataclass(frozen=True, eq=False)
class Curves:
    """What two gaits cost over speed, from one source.

    Attributes:
        label: where they come from.
        speed: (N,), m/s, ascending.
        energy: by gait (N,), Wh per metre.
        models: by gait; empty with fewer than three speeds.
        fitted: where the models cost the same; None without models.
        crossings: speeds at which the curves themselves cross, straight between their points, m/s.
    """

    label: str
    speed: Array
    energy: Mapping[str, Array]
    models: Mapping[str, EnergyModel]
    fitted: Crossover | None
    crossings: tuple[float, ...]

    @property
    def cheaper(self) -> str | None:
        """The gait that costs less at every speed; None where there is a crossing."""
        (one, first), (other, second) = self.energy.items()
        return None if self.crossings else one if (first < second).all() else other

    def to_json(self) -> dict[str, Any]:
        """In mm/s and Wh per metre."""
        rows = [
            {
                "speed_mm_s": float(v) * 1000,
                **{f"{gait}_wh_per_m": float(e[i]) for gait, e in self.energy.items()},
            }
            for i, v in enumerate(self.speed)
        ]
        return {
            "label": self.label,
            "rows": rows,
            "models": {gait: model.to_json() for gait, model in self.models.items()},
            **(self.fitted or Crossover(None, None)).to_json(),
            "crossings_mm_s": [v * 1000 for v in self.crossings],
            "cheaper": self.cheaper,
        }


def curves(
    label: str, speed: ArrayLike, energy: Mapping[str, ArrayLike], duration: ArrayLike | None = None
) -> Curves:
    """Curves of two gaits from what they cost per metre (N,), Wh, at speeds (N,), m/s.

    Args:
        duration: of a metre (N,), s; default what the speed makes it. The paper prints whole seconds.
    """
    order = np.argsort(speed)
    v = np.asarray(speed, float)[order]
    t = 1 / v if duration is None else np.asarray(duration, float)[order]
    costs = {gait: np.asarray(e, float)[order] for gait, e in energy.items()}
    models, fitted = {}, None
    if len(np.unique(v)) >= LEAST_SPEEDS:
        models = {gait: fit(t, np.ones(len(v)), e) for gait, e in costs.items()}
        fitted = crossover(*models.values())
    one, other = costs.values()
    return Curves(label, v, costs, models, fitted, crossings(v, one - other))


def crossings(x: Array, y: Array) -> tuple[float, ...]:
    """Where a line through points (N,) changes its sign."""
    found = []
    for (x0, y0), (x1, y1) in pairwise(zip(x.tolist(), y.tolist(), strict=True)):
        if y0 * y1 < 0:
            found.append(x0 - y0 * (x1 - x0) / (y1 - y0))
        elif y0 == 0 != y1:
            found.append(x0)
    return tuple(found)


@dataclass(frozen=True)
class Comparison:
    """Two gaits, source by source, KinLab's rig first.

    Attributes:
        robot: who walks.
        sources: the rig, and each ground of the robot's paper where it measured these gaits.
    """

    robot: Robot
    sources: tuple[Curves, ...]

    @property
    def notes(self) -> tuple[str, ...]:
        """Why the sources differ, where there is more than one."""
        return WHY if len(self.sources) > 1 else ()

    def to_json(self) -> dict[str, Any]:
        """Each source, and why they differ."""
        return {
            "robot": self.robot.name,
            "sources": [source.to_json() for source in self.sources],
            "notes": list(self.notes),
        }


def compare(robot: Robot, speed: ArrayLike, energy: Mapping[str, ArrayLike]) -> Comparison:
    """The rig's curves of two gaits, Wh per metre (N,) at speeds (N,) in m/s, beside those of the robot's paper."""
    sources = [curves("KinLab's rig: emulated servos, steady walking", speed, energy)]
    if robot.paper == PAPER and set(energy) == set(GAITS):
        for name in ("flat", "broken"):
            ground = measured_energy(name)
            label = f"the paper, Table {ground.energy_table}: measured on {ground.name} ground"
            costs = {gait: ground.energy[gait] / ground.distance for gait in energy}
            sources.append(curves(label, ground.speed, costs, ground.duration / ground.distance))
    return Comparison(robot, tuple(sources))
