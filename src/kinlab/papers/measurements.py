"""How far off the papers measured their feet to land: the error of the whole machine, not of the arithmetic."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.papers.tables import table
from kinlab.robots import Limb, Robot


@dataclass(frozen=True)
class Measured:
    """A measured error.

    Attributes:
        where: the tables and rows that it comes from.
        axes_mm: the absolute error on x, y and z of the paper.
        error_mm: the distance between target and foot; for several rows its mean.
    """

    where: str
    axes_mm: tuple[float, float, float]
    error_mm: float


def measured(robot: Robot, limb: Limb, target: ArrayLike) -> Measured | None:
    """What the paper measured for `target` (3,), limb frame, metres: its own row, else the mean of all rows.

    None for robots whose paper measured no foot. Source: xl430-hexapod, Tables 2 and 3.
    """
    if robot.paper != "xl430-hexapod" or limb.group != "legs":
        return None
    wanted, reached = (
        np.array([[row["x_mm"], row["y_mm"], row["z_mm"]] for row in table("xl430-hexapod", number)])
        for number in ("2", "3")
    )
    off = np.abs(wanted - reached)
    asked = limb.from_limb(target, "paper") * 1000
    same = np.flatnonzero(np.abs(wanted - asked).max(axis=1) < 1e-6)
    rows = same if len(same) else np.arange(len(off))
    where = (
        f"Tables 2 and 3, test {' and '.join(str(i + 1) for i in same)}"
        if len(same)
        else "Tables 2 and 3, mean of 9"
    )
    x, y, z = off[rows].mean(axis=0)
    distance = np.linalg.norm(off[rows], axis=1).mean()
    return Measured(where, (float(x), float(y), float(z)), float(distance))
