"""Where a foot can be."""

import numpy as np

from kinlab.canvas import Canvas
from kinlab.lessons.robots import load_robot
from kinlab.robots.workspace import Section


def side(robot: str, z: float, columns: int = 40, ascii_only: bool = False) -> Canvas:
    """What the foot reaches in front of the body within the limits, from the side; the level z is drawn through it."""
    leg = load_robot(robot).limb()
    far = float(np.linalg.norm(leg.links, axis=1).sum())
    rows = 18
    across, up = np.linspace(0.0, far, 2 * columns), np.linspace(-far, far, 4 * rows)
    grid = np.stack(np.broadcast_arrays(across, 0.0, up[:, None]), axis=-1)
    cut = Section("y = 0 mm", across, up, leg.ik(grid).reachable)
    canvas = Canvas(columns, rows, [(0.0, -far), (far, far)], ascii_only=ascii_only)
    canvas.fill(cut.holds, "link0")
    canvas.mark((0.0, 0.0), "o" if ascii_only else "●", "joint")
    for x in np.linspace(0.0, far, 2 * columns):
        if not cut.holds(float(x), z / 1000):
            canvas.mark((float(x), z / 1000), "-" if ascii_only else "─", "axis")
    return canvas
