"""Foot trajectories as the papers print them, beside what they must mean: krsri (24) to (27), eros (36) to (43)."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.gait.swing import CURVES
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array


@dataclass(frozen=True, eq=False)
class FootstepAsPrinted:
    """A foot's way through the air, letter for letter, and corrected.

    Attributes:
        where: the equations.
        s: progress of the swing (N,).
        printed, corrected: way and height (N, 2), metres.
        note: what is wrong with the print, and how it was read.
    """

    where: str
    s: Array
    printed: Array
    corrected: Array
    note: str

    def to_json(self) -> dict[str, Any]:
        """Rows of s, and mm."""
        keys = ("along_mm", "height_mm", "corrected_along_mm", "corrected_height_mm")
        values = np.hstack([self.printed, self.corrected]) * 1000 + 0.0
        rows = [
            {"s": s, **dict(zip(keys, row, strict=True))}
            for s, row in zip(self.s.tolist(), values.tolist(), strict=True)
        ]
        return {"where": self.where, "rows": rows, "note": self.note}


KRSRI_NOTE = (
    "(26) prints z = z_max + sin x (pi t): read in mm, the foot hangs z_max above the ground at lift-off and "
    "touch-down alike and rises by 1 mm; z = z_max sin(pi t) is meant. (24) and (25) are a straight line at "
    "constant speed, which the ground does not share: see the jumps."
)
EROS_NOTE = (
    "(39) prints (1 - sin(T) + 90) for 1 - sin(T + 90): as printed the foot ends 90 lifts below the ground. (37) "
    "prints 1 - cos(T) for every step: with it the landing is a straight line, which stops in the middle of the "
    "swing; sin(T) makes it the quarter circle that the text speaks of."
)


def krsri_printed(s: ArrayLike, stroke: float, lift: float) -> Array:
    """Way and height (..., 2), metres, by (24) and (26) as printed, at progress `s` (...)."""
    t = np.asarray(s, float)
    # (26) adds a length and a number: the paper's lengths are in mm.
    return np.stack([t * stroke, lift + np.sin(np.pi * t) / 1000], axis=-1)


def eros_printed(s: ArrayLike, stroke: float, lift: float) -> Array:
    """Way and height (..., 2), metres, by (37) to (39) as printed: lifting, then landing, half of `s` (...) each."""
    s = np.asarray(s, float)
    landing = s > 0.5
    T = np.pi * np.where(landing, s - 0.5, s)
    along = stroke / 2 * (1 - np.cos(T)) + np.where(landing, stroke / 2, 0.0)
    down = lift - lift * (1 - np.sin(T) + 90)
    return np.stack([along, np.where(landing, down, lift * np.sin(T))], axis=-1)


PRINTED = {
    "krsri-hexapod": ("equations (24) to (27)", krsri_printed, "line-sine", KRSRI_NOTE),
    "eros-humanoid": ("equations (36) to (43)", eros_printed, "quarter-circle", EROS_NOTE),
}


def footstep_as_printed(walk: Walk, count: int = 9) -> FootstepAsPrinted | None:
    """The foot trajectory of the robot's paper for the stroke and lift of `walk`; None where it prints none.

    Args:
        walk: whose stroke and lift.
        count: of instants, evenly spaced over the swing.
    """
    if walk.robot.paper not in PRINTED:
        return None
    where, printed, name, note = PRINTED[walk.robot.paper]
    s = np.linspace(0.0, 1.0, count)
    curve = CURVES[name]
    corrected = np.stack([walk.stroke * curve.along.value(s), walk.lift * curve.height.value(s)], axis=-1)
    return FootstepAsPrinted(where, s, printed(s, walk.stroke, walk.lift), corrected, note)
