"""A limb in its workspace, from the side and from the top: poses, limits, and how far it reaches from there."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from kinlab.canvas import Canvas, Point
from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array
from kinlab.robots.drawing import draw_links
from kinlab.robots.inverse import inverse_kinematics
from kinlab.robots.model import Limb
from kinlab.robots.workspace import Section, cut

SIDE, TOP = "side", "top"
# Poses that give the size of the picture, and how much of a link a limit's mark is long.
POSES = 4000
MARK = 0.45


@dataclass(frozen=True, eq=False)
class View:
    """A limb seen along a direction, with one scale whatever pose it takes.

    Attributes:
        limb: whose.
        name: side or top.
        across, up: what is to the right and upwards in the picture: unit vectors (3,), limb frame.
        corners: of the picture: the lower left, and the upper right, metres.
        reach: the cut through the workspace in this plane; None where it is not known.
    """

    limb: Limb
    name: str
    across: Array
    up: Array
    corners: tuple[Point, Point]
    reach: Section | None

    def flat(self, points: Array) -> list[Point]:
        """Points (..., 3), metres, limb frame, as places of the picture, in mm."""
        flat = np.stack([points @ self.across, points @ self.up], axis=-1) * 1000
        return [(float(x), float(y)) for x, y in flat.reshape(-1, 2)]

    def point(self, x: float, y: float, before: Array) -> Array:
        """The point (3,), metres, limb frame, at a place of the picture in mm, as deep in it as `before` (3,)."""
        normal = np.cross(self.across, self.up)
        return np.asarray((x * self.across + y * self.up) / 1000 + normal * (before @ normal))


def size_of(limb: Limb) -> Array:
    """The box (2, 3), metres, limb frame, that holds the limb's joints in poses all over its limits.

    Of limbs that hold their tip level only such poses count.
    """
    lower, upper = limb.limits
    q = np.random.default_rng(0).uniform(lower, upper, (POSES, len(lower)))
    if limb.closed_form is not None and limb.closed_form.needs_pose:
        level = inverse_kinematics(limb, limb.fk(q)[:, :3, 3])
        q = level.q[level.reachable]
    places = chain.frames(limb.axes, limb.links, q)[..., :3, 3].reshape(-1, 3)
    return np.stack([places.min(axis=0), places.max(axis=0)])


def view(
    limb: Limb, name: str, target: Array, box: Array, rotation: Array | None = None, fineness: int = 60
) -> View:
    """The view from the side, in the upright plane through the first joint and `target`, or from the top.

    Args:
        limb: whose.
        name: side or top.
        target: (3,), metres, limb frame: the cut goes through it.
        box: what must be in sight, see `size_of`.
        rotation: attitude of the tip for limbs that choose it.
        fineness: how many places the cut has along the longer side.
    """
    if name == TOP:
        across, up = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
        spans = (_span(box[:, 0]), _span(box[:, 1]))
        origin = np.array([0.0, 0.0, target[2]])
    else:
        distance = float(np.hypot(target[0], target[1]))
        across = np.array([1.0, 0.0, 0.0])
        if distance > 1e-6:
            across = np.array([target[0] / distance, target[1] / distance, 0.0])
        up = np.array([0.0, 0.0, 1.0])
        # The plane turns with the target: the picture holds the box whichever way it is cut.
        wide = float(np.hypot(*np.abs(box[:, :2]).max(axis=0)))
        narrow = wide if box[0, 0] < -0.5 * wide else -float(box[0, 0])
        spans = (_span(np.array([-narrow, wide])), _span(box[:, 2]))
        origin = np.zeros(3)
    wide, high = spans[0][1] - spans[0][0], spans[1][1] - spans[1][0]
    columns = max(int(fineness * wide / max(wide, high)), 8)
    rows = max(int(fineness * high / max(wide, high)), 8)
    reach = cut(limb, origin, across, up, spans, rotation=rotation, columns=columns, rows=rows)
    corners = ((spans[0][0], spans[1][0]), (spans[0][1], spans[1][1]))
    return View(limb, name, across, up, corners, reach)


def _span(ends: Array) -> tuple[float, float]:
    low, high = float(ends[0]), float(ends[1])
    margin = 0.05 * max(high - low, 1e-3)
    return min(low, 0.0) - margin, max(high, 0.0) + margin


@dataclass(frozen=True, eq=False)
class Drawn:
    """A pose to be drawn thinly beside the chosen one.

    Attributes:
        q: its angles (n,), rad.
        label: written at its tip.
        role: what it is.
    """

    q: Array
    label: str
    role: str


def draw_view(
    seen: View,
    q: Array | None,
    target: Array | None,
    *,
    beside: Sequence[Drawn] = (),
    nearest: Array | None = None,
    limits: bool = False,
    columns: int,
    rows: int,
    ascii_only: bool = False,
) -> Canvas:
    """A view as characters.

    Args:
        seen: the view.
        q: the chosen pose (n,), rad; None where there is none.
        target: (3,), metres, limb frame, to be marked.
        beside: other poses, dashed.
        nearest: the point (3,), metres, limb frame, that is marked as the nearest to a target out of reach.
        limits: whether the limits of the joints are marked at `q`.
        columns, rows: of the picture.
        ascii_only: without braille.
    """
    corners = [(x * 1000, y * 1000) for x, y in seen.corners]
    canvas = Canvas(columns, rows, corners, ascii_only=ascii_only, margin=1)
    if seen.reach is not None:
        reach = seen.reach
        canvas.outline(lambda xs, ys: reach.held(np.array(xs) / 1000, np.array(ys) / 1000), "outline")
    limb = seen.limb
    if limits and q is not None:
        _draw_limits(canvas, seen, q)
    for other in beside:
        places = seen.flat(limb.frames(other.q)[:, :3, 3])
        for start, end in pairwise(places):
            canvas.line(start, end, other.role, dashed=True)
    mark = None if target is None else seen.flat(np.asarray(target)[None])[0]
    if q is not None:
        draw_links(canvas, limb, seen.flat(limb.frames(q)[:, :3, 3]), mark, thick=True)
    elif mark is not None:
        canvas.mark(mark, "+" if ascii_only else "✚", "target")
    if nearest is not None:
        canvas.mark(seen.flat(nearest[None])[0], "x" if ascii_only else "×", "bad")
    for other in beside:
        tip = seen.flat(limb.fk(other.q)[None, :3, 3])[0]
        canvas.label(tip, other.label, other.role)
    return canvas


def _draw_limits(canvas: Canvas, seen: View, q: Array) -> None:
    """Where each joint's own link would point at either limit, as far as it turns in the picture's plane."""
    limb = seen.limb
    normal = np.cross(seen.across, seen.up)
    frames = limb.frames(q)
    for i in range(len(limb.joints)):
        axis = frames[i][:3, :3] @ limb.axes[i]
        if abs(axis @ normal) < 0.7 or not np.any(limb.links[i]):
            continue
        for end in limb.limits[:, i]:
            turned = q.copy()
            turned[i] = end
            joint, tip = limb.frames(turned)[[i, i + 1], :3, 3]
            start, stop = seen.flat(np.stack([joint + 0.15 * (tip - joint), joint + MARK * (tip - joint)]))
            canvas.line(start, stop, f"link{i % 3}", dashed=True)
