"""Two knees for one foot."""

import numpy as np

from kinlab.canvas import Canvas
from kinlab.lessons.robots import load_robot


def both(robot: str, x: float, y: float, z: float, columns: int = 40, ascii_only: bool = False) -> Canvas:
    """The leg in its own plane with both knees, and the line between femur's joint and foot that mirrors them."""
    leg = load_robot(robot).limb()
    poses = leg.ik(np.array([x, y, z]) / 1000).solutions[:2]
    joints = [leg.frames([0.0, *q[1:]])[:, (0, 2), 3] * 1000 for q in poses]
    points = [[(float(u), float(h)) for u, h in pose] for pose in joints]
    canvas = Canvas(columns, 12, [p for pose in points for p in pose], ascii_only=ascii_only)
    dot, tip = ("o", "V") if ascii_only else ("●", "▼")
    canvas.line(points[0][1], points[0][3], "axis", dashed=True)
    for i, pose in enumerate(points):
        for start, end in zip(pose[i:], pose[i + 1 :], strict=False):
            canvas.line(start, end, f"link{i}")
        for joint in pose[:3]:
            canvas.mark(joint, dot, "joint")
    canvas.mark(points[0][3], tip, "tip")
    for name, pose in zip(("up", "down"), points, strict=True):
        canvas.label(pose[2], name, "joint")
    return canvas
