"""Wave gait and tripod gait of the KRSRI robot (2025): leg (17) to (23), body (1) to (16)."""

import math

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array, rotation
from kinlab.papers.equations import NONE, Answer, InverseEquations, Misprint, Printed, acos, quotient


def ik(target: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Answer:
    """Angles of the leg for a foot at `target` (3,), metres: x outwards, z downwards.

    The paper's beta counts upwards from straight down and its gamma is the inside angle of the
    knee: KinLab's femur is beta - 90 deg, its tibia gamma - 180 deg.
    """
    # (20) and (23) as printed are not free of units; the paper's speeds and lengths are in millimetres.
    x, y, z = target * 1e3
    cx, fm, tb = (1e3 * length for length in lengths)
    alpha = math.atan(quotient(y, x, "17")) if "17" in printed else math.atan2(y, x)
    L1 = math.hypot(x, y)
    L2 = math.hypot(L1 - cx, y if "19" in printed else z)
    if "20" in printed:
        cos_beta2 = quotient(math.sqrt(fm) + math.sqrt(L2) - math.sqrt(L1), 2 * fm * L2, "20")
    else:
        cos_beta2 = quotient(fm * fm + L2 * L2 - tb * tb, 2 * fm * L2, "20")
    beta2 = acos(cos_beta2, "20")
    beta1 = acos(quotient(z, L2, "21"), "21") if "21" in printed else math.atan2(L1 - cx, z)
    if "23" in printed:
        cos_gamma = quotient(math.sqrt(fm) + math.sqrt(L1) - math.sqrt(L2), 2 * fm * L1, "23")
    else:
        cos_gamma = quotient(fm * fm + tb * tb - L2 * L2, 2 * fm * tb, "23")
    gamma = acos(cos_gamma, "23")
    return Answer(np.array([alpha, beta1 + beta2 - math.pi / 2, gamma - math.pi]))


INVERSE = InverseEquations(
    variant="equations",
    where="equations (17) to (23)",
    kind="leg",
    misprints=(
        Misprint("17", "atan(y / x)", "atan2(y, x)", "the same for every foot in front of the coxa, x > 0"),
        Misprint("19", "sqrt((L1 - cx)^2 + y^2)", "sqrt((L1 - cx)^2 + z^2)"),
        Misprint(
            "20",
            "acos((sqrt(fm) + sqrt(L2) - sqrt(L1)) / (2 fm L2))",
            "acos((fm^2 + L2^2 - tb^2) / (2 fm L2))",
        ),
        Misprint(
            "21",
            "acos(z / L2)",
            "atan2(L1 - cx, z)",
            "the same unless the foot is nearer than the coxa is long",
        ),
        Misprint(
            "23",
            "acos((sqrt(fm) + sqrt(L1) - sqrt(L2)) / (2 fm L1))",
            "acos((fm^2 + tb^2 - L2^2) / (2 fm tb))",
        ),
    ),
    note=(
        "Read in mm, with z downwards as (5) counts it. Roots stand where squares belong, and L1, the "
        "horizontal distance of (18), where the tibia's length belongs. No length of the leg is printed."
    ),
    solve=ik,
)


# Forwards, left and down, as (5) adds the robot's height to z: a left-handed frame.
_DOWN = np.array([1.0, 1.0, -1.0])


def body(feet: ArrayLike, hips: ArrayLike, xyz: ArrayLike, rpy: ArrayLike, printed: Printed = NONE) -> Array:
    """Where the feet (n, 3) are, seen from a body that has moved by `xyz` and turned by `rpy`.

    Args:
        feet: before the move, body frame, metres; polar coordinates (1), (2) describe the same points.
        hips: the coxas' places (n, 3), body frame, metres: the offsets of (3) to (5).
        xyz, rpy: the body's move, metres and rad, put into (16) as they stand.
        printed: the misprints in force, of BODY.
    """
    tx, ty, tz = np.asarray(xyz, float).tolist()
    phi, theta, psi = np.asarray(rpy, float).tolist()
    pivot = np.asarray(hips, float) * _DOWN if "3 to 5" in printed else np.zeros(3)
    # With z downwards, Rx Ry is already the inverse turn that feet make under a body; Rz is not.
    turn = psi if "8" in printed else -psi
    R = rotation((1, 0, 0), phi) @ rotation((0, 1, 0), theta) @ rotation((0, 0, 1), turn)
    p = np.asarray(feet, float) * _DOWN - pivot
    moved = p @ R.T + [tx, ty, tz] if "16" in printed else (p - [tx, ty, -tz]) @ R.T
    return np.asarray((moved + pivot) * _DOWN)


BODY = (
    Misprint(
        "3 to 5",
        "the hip's offset is taken off before the turn",
        "the hip's offset is taken off after it",
        "as printed every foot turns about its own hip",
    ),
    Misprint("8", "Rz(psi)", "Rz(-psi)", "as printed the body turns the other way"),
    Misprint(
        "16",
        "R p + (tx, ty, tz)",
        "R (p - (tx, ty, -tz))",
        "as printed the body goes backwards where tx is forwards, and along its turned axes",
    ),
)
BODY_WHERE = "equations (1) to (16)"
BODY_NOTE = (
    "x forwards, y left, z downwards, as (5) adds the robot's height. In that frame the printed order "
    "Rx Ry Rz is that of the inverse of KinLab's roll, pitch, yaw, and roll, pitch and tz have the right "
    "sign. (11) already holds the 1 that (16) adds once more."
)
