"""Compliance control of a receptionist robot's arm: forward (3.8) to (3.13), inverse (3.14) to (3.22).

theta1 turns the shoulder about z, theta0 about y, theta2 the elbow about z:
T = Rz(theta1) Ry(theta0) Tx(L1) Rz(theta2) Tx(L2). KinLab's joints are theta1, theta0, theta2.
"""

import math

import numpy as np

from kinlab.kinematics.numeric import HALVINGS, INVERSE_ERROR_M, MAX_ITERATIONS
from kinlab.kinematics.transforms import Array, homogeneous, rotation, wrap
from kinlab.papers.equations import (
    NONE,
    Answer,
    ForwardEquations,
    InverseEquations,
    Misprint,
    NotComputable,
    Printed,
)

# Where the experiment of section 4.1.1 starts, (-11.322, 7.653, 0) cm: theta1, theta0, theta2.
START = np.radians([45.0, 0.0, 147.5])
ARRIVED_M = 1e-12


def position(q: Array, lengths: tuple[float, ...]) -> Array:
    """The hand (3,), metres, in the paper's axes, by (3.13)."""
    (t1, t0, t2), (L1, L2) = q, lengths
    c0, s0, c1, s1, c2, s2 = (g(t) for t in (t0, t1, t2) for g in (math.cos, math.sin))
    return np.array(
        [
            L1 * c0 * c1 - L2 * (s1 * s2 - c0 * c1 * c2),
            L2 * (c1 * s2 + c0 * c2 * s1) + L1 * c0 * s1,
            -L1 * s0 - L2 * c2 * s0,
        ]
    )


def jacobian(q: Array, lengths: tuple[float, ...]) -> Array:
    """The printed Jacobian (3, 3) of (3.17), m/rad, with columns theta1, theta2, theta0."""
    (t1, t0, t2), (L1, L2) = q, lengths
    c0, s0, c1, s1, c2, s2 = (g(t) for t in (t0, t1, t2) for g in (math.cos, math.sin))
    return np.array(
        [
            [
                -L1 * c0 * s1 - L2 * (c1 * s2 + c0 * s1 * c2),
                -L2 * (s1 * c2 + c0 * c1 * s2),
                -L1 * s0 * c1 - L2 * s0 * c1 * c2,
            ],
            [
                L2 * (-s1 * s2 + c0 * c2 * c1) + L1 * c0 * c1,
                L2 * (c1 * c2 - c0 * s2 * s1),
                -L2 * s0 * c2 * s1 - L1 * s0 * s1,
            ],
            [0.0, L2 * s2 * s0, -L1 * c0 - L2 * c2 * c0],
        ]
    )


def inverse_jacobian(J: Array, printed: Printed = NONE) -> Array:
    """The inverse (3, 3) of a Jacobian by (3.20), entry by entry as printed."""
    (a, b, c), (d, e, f), (g, h, i) = J.tolist()
    det = a * (e * i - h * f) - b * (d * i - g * f) + c * (d * h - g * e)
    if det == 0:
        raise NotComputable("equation (3.20) divides by a determinant of zero")
    J32 = -(a * g - g * b) if "J_inv32" in printed else -(a * h - g * b)
    adjugate = [
        [e * i - h * f, -(b * i - h * c), b * f - e * c],
        [-(d * i - g * f), a * i - g * c, -(a * f - d * c)],
        [d * h - g * e, J32, a * e - d * b],
    ]
    return np.asarray(np.array(adjugate) / det)


def ik(target: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Answer:
    """Angles of the arm for a hand at `target` (3,), metres, in the paper's axes: steps 1 to 7 from START."""
    q = START
    for step in range(MAX_ITERATIONS + 1):
        dX = target - position(q, lengths)
        left = float(np.linalg.norm(dX))
        if left < ARRIVED_M or step == MAX_ITERATIONS:
            break
        J = jacobian(q, lengths)
        J_inv = inverse_jacobian(J, printed)
        halvings = 0
        while not np.linalg.norm(dX - J @ (J_inv @ dX)) <= INVERSE_ERROR_M:
            dX, halvings = dX / 2, halvings + 1
            if halvings > HALVINGS:
                raise NotComputable("step 5 halves dX without end")
        dq = J_inv @ dX
        q = q + dq[[0, 2, 1]]
    remark = f"{'there' if left < ARRIVED_M else 'not there'} after {step} steps"
    if printed:
        remark += f", corrected {ik(target, lengths).remark}"
    return Answer(wrap(q), remark)


INVERSE = InverseEquations(
    variant="equations",
    where="equations (3.13) to (3.22)",
    kind="shoulder arm",
    misprints=(Misprint("J_inv32", "-(J11 J31 - J31 J12) / det", "-(J11 J32 - J31 J12) / det"),),
    note=(
        "Resolved motion rate control from the start of section 4.1.1, theta1 45, theta2 147.5 deg. J31 is "
        "0, so that J_inv32 is printed as 0: nothing is lost in the plane theta0 = 0, where J32 is 0 as "
        "well. Out of it step 5 takes the misprint for an inaccurate inverse and halves its steps until the "
        "arm crawls; its bound e is not printed, 0.001 mm is taken."
    ),
    solve=ik,
)


def product(q: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Array:
    """The pose (4, 4) of the hand as the product of matrices in (3.8), (3.9), in the paper's axes."""
    t1, t0, t2 = q
    T = np.eye(4)
    for axis, angle, length in (
        ((0, 0, 1), t1, 0.0),
        ((0, 1, 0), t0, lengths[1]),
        ((0, 0, 1), t2, lengths[2]),
    ):
        T = T @ homogeneous(rotation(axis, angle), np.zeros(3))
        if length:
            along = homogeneous(np.eye(3), [length, 0, 0])
            along[0, 0] = 0 if "3.9" in printed else 1
            T = T @ along
    return T


def multiplied(q: Array, lengths: tuple[float, ...], printed: Printed = NONE) -> Array:
    """The pose (4, 4) of the hand as the one matrix of (3.9), in the paper's axes."""
    t1, t0, t2 = q
    c0, s0, c1, s1, c2, s2 = (g(t) for t in (t0, t1, t2) for g in (math.cos, math.sin))
    if "order" in printed:
        R = [
            [c0 * c1 * c2 - c0 * s1 * s2, -c0 * c1 * s2 - c0 * s1 * c2, s0],
            [c1 * s2 + c2 * s1, c1 * c2 - s1 * s2, 0.0],
            [s0 * s1 * s2 - c1 * c2 * s0, c1 * s0 * s2 + c2 * s0 * s1, c0],
        ]
    else:
        R = [
            [c0 * c1 * c2 - s1 * s2, -c0 * c1 * s2 - s1 * c2, c1 * s0],
            [c1 * s2 + c0 * c2 * s1, c1 * c2 - c0 * s1 * s2, s1 * s0],
            [-c2 * s0, s0 * s2, c0],
        ]
    if "R32" in printed:
        R[2][1] = c1 * s0 * s2 + c0 * s0 * s1
    return homogeneous(R, position(q, lengths[1:]))


_AXES = ((0, 0, 1), (0, 1, 0), (0, 0, 1))

PRODUCT = ForwardEquations(
    where="equation (3.9), the product",
    axes=_AXES,
    frame="paper",
    misprints=(Misprint("3.9", "0 in the first entry of both translations", "1 in the first entry"),),
    note="As printed, what lies along x at the elbow is lost: the forearm keeps L2 sin(theta2) alone.",
    pose=product,
)

MULTIPLIED = ForwardEquations(
    where="equation (3.9) multiplied out, and (3.10) to (3.13)",
    axes=_AXES,
    frame="paper",
    misprints=(
        Misprint(
            "order",
            "attitude Ry(theta0) Rz(theta1) Rz(theta2)",
            "attitude Rz(theta1) Ry(theta0) Rz(theta2)",
            "the shoulder's axes in the other order; the position keeps the right one",
        ),
        Misprint("R32", "c1 s0 s2 + c0 s0 s1", "s0 s2", "in that order of axes c2 s0 s1 would stand there"),
    ),
    note="The position, and with it (3.12) and (3.13), is right. The attitude is that of another arm.",
    pose=multiplied,
)
