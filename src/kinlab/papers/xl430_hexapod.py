"""Design of 3 DOF hexapod leg movement (SINERGI 29-1, 2025), equations (1) to (7)."""

import math

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.equations import NONE, Answer, InverseEquations, Misprint, Printed, acos, quotient


def ik(target: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Answer:
    """Angles of the leg for a foot at `target` (3,), metres: x outwards, y forwards or left, z up.

    The paper's theta_c and theta_f are KinLab's coxa and femur; its theta_t is the inside angle of
    the knee less 90 deg, so that the tibia turns by theta_t - 90 deg.
    """
    # (4) and (5) as printed are not free of units; the paper's are millimetres.
    x, y, z = target * 1e3
    c, f, t = (1e3 * length for length in lengths)
    theta_c = math.atan(quotient(y, x, "1")) if "1" in printed else math.atan2(y, x)
    x0 = math.hypot(x, y)
    a = math.hypot(x0 - c, z)
    theta_f1 = acos(quotient(a * a + f * f - t * t, 2 if "4" in printed else 2 * a * f, "4"), "4")
    theta_f2 = math.atan(quotient(2 * a * f, x0 - c, "5")) if "5" in printed else math.atan2(z, x0 - c)
    theta_t = acos(quotient(f * f + t * t - a * a, 2 * f * t, "7"), "7") - math.pi / 2
    return Answer(np.array([theta_c, theta_f1 + theta_f2, theta_t - math.pi / 2]))


_SCAN = "most likely the scan's doing: 2af, the denominator of (4), stands in (5)"

INVERSE = InverseEquations(
    variant="equations",
    where="equations (1) to (7)",
    kind="leg",
    misprints=(
        Misprint("1", "atan(y / x)", "atan2(y, x)", "the same for every foot in front of the coxa, x > 0"),
        Misprint("4", "acos((a^2 + f^2 - t^2) / 2)", "acos((a^2 + f^2 - t^2) / (2 a f))", _SCAN),
        Misprint("5", "atan(2 a f / (x0 - c))", "atan2(z, x0 - c)", _SCAN),
    ),
    note=(
        "Read in mm. The text at hand is a scan that has moved 2af from (4) into (5), where z belonged; "
        "this is not counted against the authors, as Table 1 follows from the corrected form. "
        "Table 1 prints servo angles, not these."
    ),
    solve=ik,
)
