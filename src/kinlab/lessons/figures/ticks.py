"""The places that a foot can stand at, servo step by servo step."""

from itertools import product

import numpy as np

from kinlab.canvas import Canvas
from kinlab.lessons.robots import load_robot


def lattice(
    robot: str, x: float, z: float, half_mm: float = 1.5, columns: int = 40, ascii_only: bool = False
) -> Canvas:
    """Where femur and tibia can put the foot around (x, 0, z), from the side, and that place itself."""
    leg = load_robot(robot).limb()
    wanted = np.array([x, 0.0, z]) / 1000
    q = leg.ik(wanted).q
    ranges = []
    for joint, angle in zip(leg.joints[1:], q[1:], strict=True):
        assert joint.servo is not None
        middle = int(joint.servo.command(angle))
        ranges.append([float(joint.servo.joint(middle + i)) for i in range(-40, 41)])
    poses = np.array([[q[0], beta, gamma] for beta, gamma in product(*ranges)])
    places = leg.fk(poses)[:, (0, 2), 3] * 1000 - [x, z]
    near = places[(np.abs(places) <= half_mm).all(axis=1)]
    canvas = Canvas(columns, 12, [(-half_mm, -half_mm / 2), (half_mm, half_mm / 2)], ascii_only=ascii_only)
    for u, h in near:
        canvas.mark((float(u), float(h)), "." if ascii_only else "·", "tip")
    canvas.mark((0.0, 0.0), "+" if ascii_only else "✚", "target")
    return canvas
