"""Udiebot (2018): leg (3) to (10), the way of its Tables 4 to 6, Denavit-Hartenberg (1), (2)."""

import math

import numpy as np

from kinlab.kinematics.leg import leg_fk
from kinlab.kinematics.transforms import Array
from kinlab.papers.equations import (
    NONE,
    Answer,
    ForwardEquations,
    InverseEquations,
    Misprint,
    NotComputable,
    Printed,
    acos,
    quotient,
)


def ik(target: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Answer:
    """Angles of the leg for a foot at `target` (3,), metres, in the tables' axes.

    x points outwards, y up, z sideways; theta1 to theta3, as the tables print them, are KinLab's coxa,
    femur and tibia.
    """
    x, y, z = target
    coxa, femur, tibia = lengths
    leg = math.hypot(x, y if "3" in printed else z)
    z_length = math.hypot(z, leg) if "4" in printed else math.hypot(y, leg - coxa)
    theta_a = math.atan(quotient(leg - coxa, y, "5")) if "5" in printed else math.atan2(y, leg - coxa)
    opposite, adjacent = (z_length, tibia) if "6" in printed else (tibia, z_length)
    J = acos(quotient(opposite**2 - femur**2 - adjacent**2, -2 * femur * z_length, "6"), "6")
    knee = femur**2 + tibia**2 - z_length**2
    K = acos(quotient(knee if "7" in printed else -knee, -2 * femur * tibia, "7"), "7")
    theta1 = math.atan2(x, y) if "8" in printed else math.atan2(z, x)
    theta3 = math.pi / 2 - K if "10" in printed else K - math.pi
    return Answer(np.array([theta1, J + theta_a, theta3]))


INVERSE = InverseEquations(
    variant="equations",
    where="equations (3) to (10)",
    kind="leg",
    misprints=(
        Misprint("3", "sqrt(posX^2 + posY^2)", "sqrt(posX^2 + posZ^2)"),
        Misprint(
            "4",
            "sqrt(posZ^2 + legLength^2)",
            "sqrt(posY^2 + (legLength - coxaLength)^2)",
            "leaves out the coxa",
        ),
        Misprint("5", "atan((legLength - coxaLength) / posY)", "atan2(posY, legLength - coxaLength)"),
        Misprint(
            "6",
            "acos((Zlength^2 - femur^2 - tibia^2) / (-2 femur Zlength))",
            "acos((tibia^2 - femur^2 - Zlength^2) / (-2 femur Zlength))",
        ),
        Misprint(
            "7",
            "acos((femur^2 + tibia^2 - Zlength^2) / (-2 femur tibia))",
            "acos((Zlength^2 - femur^2 - tibia^2) / (-2 femur tibia))",
        ),
        Misprint(
            "8", "atan(posX, posY)", "atan2(posZ, posX)", "read as atan2 with its arguments in that order"
        ),
        Misprint("10", "90 deg - K", "K - 180 deg"),
    ),
    note=(
        "In the axes of Tables 4 to 6: x outwards, y up, z sideways. Were z up instead, (3) and the axes of "
        "(4) would be right, (5) would have the wrong axis, and every other fault would remain."
    ),
    solve=ik,
)

# The value of pi that gives all thirty printed rows.
TABLES_PI = 22 / 7


def tables_ik(target: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Answer:
    """Angles as Tables 4 to 6 have them, for a foot at `target` (3,), metres, in the tables' axes."""
    coxa, femur, tibia = lengths
    q = ik(target, (0.0 if "coxa" in printed else coxa, femur, tibia)).q
    if "pi" in printed:
        # The knee's K - 180 is taken in degrees, so that only K suffers.
        q = np.array([q[0], q[1], q[2] + math.pi]) * (math.pi / TABLES_PI) - [0, 0, math.pi]
    if "cut" in printed:
        q = np.radians(np.trunc(np.degrees(q) * 1e3) / 1e3)
    return Answer(q)


def tables_tip(q: Array, lengths: tuple[float, ...]) -> Array:
    """The foot (3,), metres, limb frame, of the leg that the tables compute with: one without a coxa."""
    return leg_fk(q, 0.0, lengths[1], lengths[2])


TABLES = InverseEquations(
    variant="tables",
    where="Tables 4 to 6",
    kind="leg",
    misprints=(
        Misprint("coxa", "no coxa", "the coxa of Table 2"),
        Misprint("pi", "22/7", "pi", "in turning the results of acos and atan into degrees"),
        Misprint("cut", "cut after three decimals of a degree", "not rounded"),
    ),
    note=(
        "The tables' angles follow from the corrected equations with pi = 22/7, without the coxa, and cut "
        "after three decimals: all 90 printed angles exactly. Beside the foot of the real leg stands that of "
        "the tables' own leg, without a coxa, which their forward kinematics gives."
    ),
    solve=tables_ik,
    own_tip=tables_tip,
)


def dh(q: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Array:
    """The pose (4, 4) of the foot by (1), (2): coxa twisted by 90 deg, femur and tibia by none."""
    if "2" in printed:
        raise NotComputable("equation (2) has alpha_i, an angle, where the length a_i belongs")
    T = np.eye(4)
    for theta, a, alpha in zip(q, lengths, (math.pi / 2, 0.0, 0.0), strict=True):
        c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
        T = T @ [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, 0], [0, 0, 0, 1]]
    return T


FORWARD = ForwardEquations(
    where="equations (1), (2)",
    axes=((0, 0, 1), (0, -1, 0), (0, -1, 0)),
    frame="limb",
    misprints=(
        Misprint("2", "alpha_i cos(theta_i), alpha_i sin(theta_i)", "a_i cos(theta_i), a_i sin(theta_i)"),
    ),
    note="a and alpha look alike in a scan. The table of DH parameters is not printed.",
    pose=dh,
    attitude=False,
)
