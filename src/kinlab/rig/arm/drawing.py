"""The arm in characters: its line, itself, the way of its hand, and the force on it."""

from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlab.canvas import Canvas, Point
from kinlab.kinematics.resolved_motion import Track
from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb

# What is to the right and what is up, in the limb frame, by view.
VIEWS = {
    "side": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
    "behind": np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]),
}
MM_PER_NEWTON = 20.0
STRONGEST = 10.0  # N that a hand on the drawing pulls with
# How far around the line the hand stays in sight, mm.
ROOM = 100.0


def draw_arm(
    limb: Limb,
    q: ArrayLike,
    track: Track,
    *,
    view: str = "side",
    reference: ArrayLike | None = None,
    trail: Iterable[Array] = (),
    force: Sequence[float] | None = None,
    columns: int = 36,
    rows: int = 11,
    ascii_only: bool = False,
) -> Canvas:
    """An arm on its line.

    Args:
        q: where the joints are (n,), rad.
        track: the line; it and the arm at both of its ends stay in sight.
        view: one of VIEWS.
        reference: where they are sent (n,), rad: drawn as its hand's place.
        trail: places of the hand (3,), m, the oldest first.
        force: on the hand (3,), N.
    """
    plane = VIEWS[view] * 1000

    def flat(places: Array) -> list[Point]:
        return [(float(x), float(y)) for x, y in places @ plane.T]

    far = int(np.argmax(np.linalg.norm(track.points - track.points[0], axis=1)))
    begin, end = flat(track.points[[0, far]])
    poses = [flat(limb.frames(angles)[:, :3, 3]) for angles in track.q[[0, far]]]
    sight = [point for pose in poses for point in pose]
    sight += [(x + dx, y + dy) for x, y in (begin, end) for dx in (-ROOM, ROOM) for dy in (-ROOM, ROOM)]
    canvas = Canvas(columns, rows, sight, ascii_only=ascii_only)
    joint, hand, goal = ("o", "V", "+") if ascii_only else ("●", "▼", "✚")
    canvas.line(begin, end, "axis", dashed=True)
    for start, end in pairwise(flat(np.array(list(trail)).reshape(-1, 3))):
        canvas.line(start, end, "link2")
    points = flat(limb.frames(q)[:, :3, 3])
    for i, (start, end) in enumerate(pairwise(points)):
        canvas.line(start, end, f"link{i % 2}")
    if force is not None and any(force):
        x, y = points[-1]
        push = plane @ np.asarray(force) / 1000 * MM_PER_NEWTON
        end = (x + float(push[0]), y + float(push[1]))
        canvas.line((x, y), end, "bad")
        heads = "><^v" if ascii_only else "→←↑↓"
        across = abs(push[0]) > abs(push[1])
        canvas.mark(end, heads[int(push[0] < 0) if across else 2 + int(push[1] < 0)], "bad")
    for point in points[:-1]:
        canvas.mark(point, joint, "joint")
    if reference is not None:
        canvas.mark(flat(limb.fk(reference)[None, :3, 3])[0], goal, "target")
    canvas.mark(points[-1], hand, "tip")
    return canvas


def pull(limb: Limb, q: ArrayLike, view: str, place: Point) -> tuple[float, float, float]:
    """The force (3,), N, limb frame, of a rubber band from the hand to a place of the drawing, in mm.

    Its arrow in `draw_arm` ends at that place; it pulls with no more than STRONGEST.
    """
    plane = VIEWS[view]
    away = np.asarray(place, float) / 1000 - plane @ limb.fk(q)[:3, 3]
    force = away * 1000 / MM_PER_NEWTON
    force = force * min(1.0, STRONGEST / max(float(np.hypot(*force)), 1e-12))
    x, y, z = (force @ plane).tolist()
    return x, y, z
