"""How far a limb reaches: bounds, volume, and cross-sections, within the limits of joints and servos."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.canvas import Point
from kinlab.errors import UsageError
from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array
from kinlab.robots.inverse import inverse_kinematics
from kinlab.robots.model import Limb, Robot

SAMPLES = 20_000
MOST_SAMPLES = 2_000_000


@dataclass(frozen=True, eq=False)
class Section:
    """A cut through the workspace.

    Attributes:
        plane: what is held fixed, in words.
        across, up: coordinates of the columns and rows (from the bottom), limb frame, metres.
        reachable: (rows, columns).
    """

    plane: str
    across: Array
    up: Array
    reachable: Array

    def holds(self, across: float, up: float) -> bool:
        """Whether the place of the section nearest to (`across`, `up`), metres, is reachable."""
        j, i = int(_nearest(self.across, across)), int(_nearest(self.up, up))
        return 0 <= i < len(self.up) and 0 <= j < len(self.across) and bool(self.reachable[i, j])

    def held(self, across: ArrayLike, up: ArrayLike) -> list[list[bool]]:
        """`holds` for every place of a grid, metres, row by row."""
        j, i = _nearest(self.across, across), _nearest(self.up, up)
        rows, columns = self.reachable.shape
        known = ((i >= 0) & (i < rows))[:, None] & ((j >= 0) & (j < columns))
        found = known & self.reachable[np.clip(i, 0, rows - 1)[:, None], np.clip(j, 0, columns - 1)]
        answer: list[list[bool]] = found.tolist()
        return answer

    def to_json(self) -> dict[str, Any]:
        """Coordinates in mm, and rows of 0 and 1."""
        return {
            "plane": self.plane,
            "across_mm": np.round(self.across * 1000, 6).tolist(),
            "up_mm": np.round(self.up * 1000, 6).tolist(),
            "reachable": self.reachable.astype(int).tolist(),
        }


@dataclass(frozen=True, eq=False)
class Workspace:
    """What a limb reaches.

    Attributes:
        robot, limb: whose it is.
        samples: poses, and places, that were tried.
        lower, upper: corners (3,) of the box around it, limb frame, metres.
        nearest, farthest: distances of the tip from the first joint, metres.
        volume: in m^3, by trying places in the box; None where the limb has no closed form to try them with.
        volume_error: its standard error, m^3.
        side, top: sections through y = 0, and through the height of the stance (else the middle of the box).
    """

    robot: Robot
    limb: Limb
    samples: int
    lower: Array
    upper: Array
    nearest: float
    farthest: float
    volume: float | None
    volume_error: float | None
    side: Section
    top: Section

    def to_json(self) -> dict[str, Any]:
        """Lengths in mm, volume in cm^3."""
        return {
            "robot": self.robot.name,
            "limb": self.limb.name,
            "frame": "limb",
            "samples": self.samples,
            "lower_mm": (self.lower * 1000).tolist(),
            "upper_mm": (self.upper * 1000).tolist(),
            "nearest_mm": self.nearest * 1000,
            "farthest_mm": self.farthest * 1000,
            "volume_cm3": None if self.volume is None else self.volume * 1e6,
            "volume_error_cm3": None if self.volume_error is None else self.volume_error * 1e6,
            "side": self.side.to_json(),
            "top": self.top.to_json(),
        }


def workspace(
    robot: Robot, limb: Limb, *, samples: int = SAMPLES, columns: int = 120, rows: int = 80
) -> Workspace:
    """The workspace of a limb; the soles of six-joint legs are held level.

    Bounds come from random poses and so lie inside the true ones by a little; volume and sections
    come from the inverse at random, and at regular, places.

    Args:
        robot, limb: whose.
        samples: how many poses and places to try.
        columns, rows: of the sections.

    Raises:
        UsageError: a number of samples that is too small or too large.
    """
    if not 100 <= samples <= MOST_SAMPLES:
        raise UsageError(f"samples must be 100 to {MOST_SAMPLES}, got {samples}")
    rng = np.random.default_rng(0)
    tips = reached(limb, samples, rng)
    low, high = tips.min(axis=0), tips.max(axis=0)
    volume = error = None
    if limb.closed_form is not None:
        box = float(np.prod(high - low))
        share = float(inverse_kinematics(limb, rng.uniform(low, high, (samples, 3))).reachable.mean())
        volume, error = share * box, box * float(np.sqrt(share * (1 - share) / samples))
    height = float(limb.stance[2]) if limb.stance is not None else float((low[2] + high[2]) / 2)
    distance = np.linalg.norm(tips, axis=1)
    return Workspace(
        robot, limb, samples, low, high, float(distance.min()), float(distance.max()), volume, error,
        _section(limb, tips, low, high, 1, 0.0, columns, rows),
        _section(limb, tips, low, high, 2, height, columns, rows),
    )  # fmt: skip


def cut(
    limb: Limb,
    origin: ArrayLike,
    across: ArrayLike,
    up: ArrayLike,
    spans: tuple[Point, Point],
    *,
    rotation: ArrayLike | None = None,
    columns: int = 96,
    rows: int = 72,
) -> Section | None:
    """A cut through the workspace on any plane; None for limbs without a closed form to try places with.

    Args:
        limb: whose.
        origin: a point (3,) of the plane, metres, limb frame.
        across, up: unit vectors (3,) in it.
        spans: from where to where it goes across, and up, metres.
        rotation: the attitude (3, 3) of the tip, for limbs that choose it; level where not given.
        columns, rows: how many places are tried.
    """
    if limb.closed_form is None:
        return None
    x, y = np.linspace(*spans[0], columns), np.linspace(*spans[1], rows)
    grid = np.asarray(origin) + x[:, None] * np.asarray(across) + y[:, None, None] * np.asarray(up)
    posed = rotation if limb.closed_form.needs_pose else None
    return Section("", x, y, inverse_kinematics(limb, grid, posed).reachable)


def _section(
    limb: Limb, tips: Array, low: Array, high: Array, fixed: int, value: float, columns: int, rows: int
) -> Section:
    """The cut at `value` of coordinate `fixed`: by the inverse, else by the poses that came near it."""
    first, second = (i for i in range(3) if i != fixed)
    across = np.linspace(low[first], high[first], columns)
    up = np.linspace(low[second], high[second], rows)
    plane = f"{'xyz'[fixed]} = {value * 1000:g} mm"
    if limb.closed_form is not None:
        grid = np.empty((rows, columns, 3))
        grid[..., first], grid[..., second], grid[..., fixed] = across, up[:, None], value
        return Section(plane, across, up, inverse_kinematics(limb, grid).reachable)
    thickness = (high - low).max() / rows
    near = tips[np.abs(tips[:, fixed] - value) <= thickness]
    reached = np.zeros((rows, columns), dtype=bool)
    if len(near):
        reached[_nearest(up, near[:, second]), _nearest(across, near[:, first])] = True
    return Section(plane, across, up, reached)


def _nearest(places: Array, values: ArrayLike) -> Array:
    """The index of the evenly spaced place nearest to each value; the first one where all are the same."""
    span = max(float(places[-1] - places[0]), 1e-12)
    index = np.rint((np.asarray(values, float) - places[0]) / span * (len(places) - 1))
    return np.asarray(np.clip(index, -1, len(places)), dtype=int)


def reached(limb: Limb, samples: int, rng: np.random.Generator | None = None) -> Array:
    """Places (k, 3) of the tip in up to `samples` random poses within the limits, limb frame, metres.

    Soles of six-joint legs are held level, so that fewer places are left of their poses.
    """
    rng = rng or np.random.default_rng(0)
    lower, upper = limb.limits
    q = rng.uniform(lower, upper, (samples, len(lower)))
    # A share of poses with joints straight or at a limit: there lie the extremes.
    edges = np.clip(np.stack([lower, upper, np.zeros_like(lower)]), lower, upper)
    q = np.where(rng.random(q.shape) < 0.2, edges[rng.integers(0, 3, q.shape), np.arange(len(lower))], q)
    tips = chain.fk(limb.axes, limb.links, q)[:, :3, 3]
    return tips if limb.closed_form is None else np.asarray(tips[inverse_kinematics(limb, tips).reachable])
