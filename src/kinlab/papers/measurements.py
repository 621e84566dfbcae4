"""How far off the papers measured their feet to land: the error of the whole machine, not of the arithmetic."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array
from kinlab.papers.tables import printed_table
from kinlab.robots import Limb, Robot


@dataclass(frozen=True, eq=False)
class FootTests:
    """The tests of one foot in xl430-hexapod's Tables 2 to 4: mm, the paper's axes.

    Attributes:
        wanted: Table 2, where the foot was sent (9, 3).
        reached: Table 3, where it was measured to be (9, 3).
        printed: Table 4, the absolute error that is printed for each test (9, 3).
        averages: its last row (3,).
    """

    wanted: Array
    reached: Array
    printed: Array
    averages: Array

    @property
    def off(self) -> Array:
        """The absolute error (9, 3) that follows from the first two."""
        return np.asarray(np.abs(self.wanted - self.reached))


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


def foot_tests() -> FootTests:
    """Where the foot of xl430-hexapod's paper was sent, where it came to, and what is printed for it."""
    tables = [printed_table("xl430-hexapod", number) for number in ("2", "3", "4")]
    wanted, reached, printed = (np.stack([table.column(axis) for axis in "xyz"], axis=-1) for table in tables)
    averages = [cell.figure.value for cell in tables[-1].rows["average"].values()]
    return FootTests(wanted, reached, printed, np.array(averages))


def measured(robot: Robot, limb: Limb, target: ArrayLike) -> Measured | None:
    """What the paper measured for `target` (3,), limb frame, metres: its own row, else the mean of all rows.

    None for robots whose paper measured no foot. Source: xl430-hexapod, Tables 2 and 3.
    """
    if robot.paper != "xl430-hexapod" or limb.group != "legs":
        return None
    tests = foot_tests()
    asked = limb.from_limb(target, "paper") * 1000
    same = np.flatnonzero(np.abs(tests.wanted - asked).max(axis=1) < 1e-6)
    if len(same):
        where, shown = f"test {' and '.join(str(i + 1) for i in same)}", tests.printed[same].mean(axis=0)
    else:
        where, shown = "mean of 9", tests.averages
    off = tests.off[same] if len(same) else tests.off
    distance = np.linalg.norm(off, axis=1).mean()
    return Measured(f"Tables 2 and 3, {where}", _three(off.mean(axis=0)), float(distance), _three(shown))


def _three(values: ArrayLike) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in np.asarray(values))
    return x, y, z
