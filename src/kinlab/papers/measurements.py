"""How far off the papers measured their feet to land: the error of the whole machine, not of the arithmetic."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array
from kinlab.papers.tables import printed_table
from kinlab.robots import Limb, Robot


@dataclass(frozen=True)
class Measured:
    """A measured error.

    Attributes:
        where: the tables and rows that it comes from.
        axes_mm: the absolute error on x, y and z of the paper.
        error_mm: the distance between target and foot; for several rows its mean.
        printed_mm: what the paper prints for it on x, y and z: its Table 4, or the averages below that.
    """

    where: str
    axes_mm: tuple[float, float, float]
    error_mm: float
    printed_mm: tuple[float, float, float]


def measured(robot: Robot, limb: Limb, target: ArrayLike) -> Measured | None:
    """What the paper measured for `target` (3,), limb frame, metres: its own row, else the mean of all rows.

    None for robots whose paper measured no foot. Source: xl430-hexapod, Tables 2 and 3.
    """
    if robot.paper != "xl430-hexapod" or limb.group != "legs":
        return None
    wanted, reached, printed = (_places(number) for number in ("2", "3", "4"))
    off = np.abs(wanted - reached)
    asked = limb.from_limb(target, "paper") * 1000
    same = np.flatnonzero(np.abs(wanted - asked).max(axis=1) < 1e-6)
    rows = same if len(same) else np.arange(len(off))
    if len(same):
        where, shown = (
            f"Tables 2 and 3, test {' and '.join(str(i + 1) for i in same)}",
            printed[same].mean(axis=0),
        )
    else:
        where, shown = "Tables 2 and 3, mean of 9", _averages()
    distance = np.linalg.norm(off[rows], axis=1).mean()
    return Measured(where, _three(off[rows].mean(axis=0)), float(distance), _three(shown))


def _places(number: str) -> Array:
    table = printed_table("xl430-hexapod", number)
    return np.stack([table.column(axis) for axis in "xyz"], axis=-1)


def _averages() -> list[float]:
    return [cell.figure.value for cell in printed_table("xl430-hexapod", "4").rows["average"].values()]


def _three(values: ArrayLike) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in np.asarray(values))
    return x, y, z
