"""EROS (EMITTER, 2018): leg (9) to (28), head (2), (3), arms (5) to (8)."""

import math

import numpy as np

from kinlab.kinematics.transforms import Array, homogeneous, rotation
from kinlab.papers.equations import (
    NONE,
    Answer,
    ForwardEquations,
    InverseEquations,
    Misprint,
    Printed,
    acos,
    quotient,
)


def ik(target: Array, lengths: tuple[float, ...], printed: Printed = NONE, heading: float = 0.0) -> Answer:
    """Angles of the leg for a level sole at `target` (3,), metres, turned by `heading` rad.

    x forwards, y left, z up; the joints turn as Table 5 writes them, Rz, Rx, Ry, Ry, Ry, Rx,
    counter-clockwise positive, so that angles need no mapping.
    """
    x, y, z = target
    thigh, shank, foot = lengths
    R0 = math.hypot(x, y)
    beta = (math.atan(quotient(y, x, "11")) if "11" in printed else math.atan2(y, x)) - heading
    dy = R0 * math.sin(beta) + (y if "12" in printed else 0)
    dx = x - R0 * math.cos(beta) if "13" in printed else R0 * math.cos(beta)
    z6 = z + foot
    theta2 = math.atan(quotient(dy, z6, "15")) if "15" in printed else math.atan2(dy, -z6)
    R1 = math.hypot(dy, z6)
    R2 = math.hypot(dx, z6 if "17" in printed else R1)
    inside = acos(quotient(thigh**2 + shank**2 - R2**2, 2 * thigh * shank, "20"), "20")
    ahead = math.atan(quotient(dx, R1, "21"))
    numerator = -(thigh if "22" in printed else shank) * math.sin(inside)
    denominator = -thigh - (shank if "23" in printed else -shank) * math.cos(inside)
    # Both count downwards, so that their quotient is that of two positive lengths.
    lead = math.atan2(-numerator, -denominator)
    theta3 = ahead + lead if "25" in printed else -(ahead + lead)
    theta4 = math.pi - inside
    theta5 = theta3 + theta4 if "27" in printed else -(theta3 + theta4)
    return Answer(np.array([heading, theta2, theta3, theta4, theta5, -theta2]))


INVERSE = InverseEquations(
    variant="equations",
    where="equations (9) to (28)",
    kind="humanoid leg",
    misprints=(
        Misprint("11", "atan(P_y / P_x) - theta1", "atan2(P_y, P_x) - theta1", "the same where P_x > 0"),
        Misprint("12", "dP_y = P_y + R0 sin(beta)", "dP_y = R0 sin(beta)", "at heading 0 it is 2 P_y"),
        Misprint(
            "13", "dP_x = P_x - R0 cos(beta)", "dP_x = R0 cos(beta)", "at heading 0 it is 0: no step forwards"
        ),
        Misprint(
            "15", "atan(dP_y / P_6z)", "atan(dP_y / -P_6z)", "P_6z is negative, so that the roll is reversed"
        ),
        Misprint("17", "sqrt(dP_x^2 + P_6z^2)", "sqrt(dP_x^2 + R1^2)"),
        Misprint(
            "22", "-d_z3 sin(gamma_c)", "-d_z4 sin(gamma_c)", "the same where thigh and shank are equal"
        ),
        Misprint(
            "23", "-d_z3 + (-d_z4) cos(gamma_c)", "-d_z3 + d_z4 cos(gamma_c)", "the cosine of theta4 is meant"
        ),
        Misprint(
            "25",
            "theta3 = gamma_a + gamma_b",
            "theta3 = -(gamma_a + gamma_b)",
            "right were the hip alone to count forwards as positive",
        ),
        Misprint("27", "theta5 = theta3 + theta4", "theta5 = -(theta3 + theta4)", "the sole is not level"),
    ),
    note=(
        "Joints turn as Table 5 writes them, counter-clockwise positive; there the angles of joints 4 to 6 "
        "carry the numbers of 2 and 3. With a knee that bends backwards no choice of signs makes (25), (26) "
        "and (27) true together. A level sole only: (9) takes the heading as the hip's yaw. No length is "
        "printed."
    ),
    solve=ik,
)


def head(q: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Array:
    """The pose (4, 4) of the head by (2), (3), for pan and tilt in rad."""
    (t1, t2), (d1, d2) = q, lengths
    y = d2 * math.sin(t2 if "3" in printed else t1) * math.sin(t2)
    p = [d2 * math.cos(t1) * math.sin(t2), y, d1 + d2 * math.cos(t2)]
    return homogeneous(rotation((0, 0, 1), t1) @ rotation((0, 1, 0), t2), p)


HEAD = ForwardEquations(
    where="equations (1) to (3)",
    axes=((0, 0, 1), (0, 1, 0)),
    frame="paper",
    misprints=(Misprint("3", "P_y = d_z2 sin(theta2) sin(theta2)", "P_y = d_z2 sin(theta1) sin(theta2)"),),
    note="The same entry is wrong in (2).",
    pose=head,
)


def arm(q: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Array:
    """The pose (4, 4) of the hand by (5) to (8), without d_y1, which belongs to the shoulder's place."""
    (s1, s2, s3), (c1, c2, c3) = np.sin(q), np.cos(q)
    d1, d2, d3 = lengths
    phi = d2 * c2 + d3 * c3 * (s2 if "phi" in printed else c2)
    R = [
        [c1 * c3 - c2 * s1 * (1 if "R11" in printed else s3), s1 * s2, c1 * s3 + c3 * c2 * s1],
        [s2 * s3, c2, -c3 * s2],
        [-c3 * s1 - c1 * c2 * s3, c1 * s2, c1 * c2 * c3 - s1 * s3],
    ]
    p = [-d1 * s1 - s1 * phi - d3 * c1 * s3, d2 * s2 + d3 * c3 * s2, d3 * s1 * s3 - c1 * phi - d1 * c1]
    return homogeneous(R, p)


ARM = ForwardEquations(
    where="equations (4) to (8)",
    axes=((0, 1, 0), (1, 0, 0), (0, 1, 0)),
    frame="paper",
    misprints=(
        Misprint(
            "R11",
            "cos(theta1) cos(theta3) - cos(theta2) sin(theta1)",
            "cos(theta1) cos(theta3) - cos(theta2) sin(theta1) sin(theta3)",
        ),
        Misprint(
            "phi",
            "d_z2 cos(theta2) + d_z3 cos(theta3) sin(theta2)",
            "d_z2 cos(theta2) + d_z3 cos(theta3) cos(theta2)",
            "the scan is damaged here and may have taken sin(theta2) from the line before",
        ),
    ),
    note=(
        "R24 has d_x1, which Table 3 calls d_y1: the shoulder's place, left out of the limb frame. A second "
        "line named R33 holds R13, and is right."
    ),
    pose=arm,
)
