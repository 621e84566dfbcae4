"""A limb in two small views: from the side, in its own plane, and from the top."""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.canvas import Canvas, Point
from kinlab.kinematics.transforms import Array
from kinlab.robots.model import Limb


def draw_limb(
    limb: Limb,
    q: ArrayLike,
    target: ArrayLike | None = None,
    *,
    columns: int = 36,
    rows: int = 11,
    ascii_only: bool = False,
) -> tuple[Canvas, Canvas]:
    """The side view (along the limb's plane, z up) and the top view (x right, y up) of a pose.

    Args:
        limb: the limb.
        q: its angles (n,) in rad.
        target: a place (3,) to mark, metres, limb frame.
        columns, rows: of each view, in characters.
        ascii_only: without braille.
    """
    points = limb.frames(q)[:, :3, 3] * 1000
    goal = None if target is None else np.asarray(target, float) * 1000
    reach = points if goal is None else np.vstack([points, goal])
    far = reach[np.argmax(np.hypot(reach[:, 0], reach[:, 1]))]
    distance = float(np.hypot(far[0], far[1]))
    outwards = far[:2] / distance if distance > 1e-6 else np.array([1.0, 0.0])
    views = []
    for side in (True, False):
        flat = _flatten(points, outwards if side else None)
        mark = None if goal is None else _flatten(goal[None], outwards if side else None)[0]
        # However folded the limb is, the view shows a good part of its length.
        around = 0.2 * float(np.linalg.norm(limb.links, axis=1).sum()) * 1000
        frame = [*flat, (-around, -around), (around, around), *([mark] if mark else [])]
        canvas = Canvas(columns, rows, frame, ascii_only=ascii_only)
        draw_links(canvas, limb, flat, mark)
        views.append(canvas)
    return views[0], views[1]


def _flatten(points: Array, outwards: Array | None) -> list[Point]:
    if outwards is None:
        return [(float(p[0]), float(p[1])) for p in points]
    return [(float(p[:2] @ outwards), float(p[2])) for p in points]


def draw_links(
    canvas: Canvas, limb: Limb, points: list[Point], target: Point | None, *, thick: bool = False
) -> None:
    """The links of a limb between the places of its joints, joints and tip marked, and a target that is missed."""
    joint, foot, cross = ("o", "V", "+") if canvas.ascii_only else ("●", "▼", "✚")
    for i in range(len(limb.joints)):
        canvas.line(points[i], points[i + 1], f"link{i % 3}", thick=thick)
    for point in points[:-1]:
        canvas.mark(point, joint, "joint")
    canvas.mark(points[-1], foot, "tip")
    if (
        target is not None
        and max(abs(target[0] - points[-1][0]), abs(target[1] - points[-1][1])) > canvas.cell_width
    ):
        canvas.mark(target, cross, "target")
    for i, name in enumerate(limb.joint_names):
        if any(limb.joints[i].link):
            middle = ((points[i][0] + points[i + 1][0]) / 2, (points[i][1] + points[i + 1][1]) / 2)
            canvas.label(middle, name, f"link{i % 3}")
