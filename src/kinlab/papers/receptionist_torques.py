"""The receptionist arm's simplified torque equations (3.26) to (3.36), as printed and corrected.

Two slender rods in the paper's axes, x along gravity: link 1 from A to B, link 2 from B on, C1 and C2 in
their middles. F21 is the force that (3.34) finds at B: the one on link 2. The print sets the moments on a
link equal to its inertia times its acceleration and calls that the servo's torque; the servo itself is not
in the balance.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamics import GRAVITY, Mechanism, inverse_dynamics
from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array
from kinlab.papers.equations import NONE, Misprint, Printed

# theta1, theta0, theta2, in the paper's axes; the order of KinLab's joints.
AXES = np.array([[0.0, 0, 1], [0, 1, 0], [0, 0, 1]])

MISPRINTS = (
    Misprint(
        "3.28",
        "m1 g z_C1 + F21z x_B - F21x z_B",
        "m1 L1^2 / 3 theta0'' - (m1 g z_C1 + F21z x_B - F21x z_B)",
        "the moments on the link, without its inertia, and not those of the servo",
    ),
    Misprint(
        "3.31",
        "m1 g y_C1 + F21y x_B - F21x y_B",
        "m1 L1^2 / 3 theta1'' + m1 g y_C1 + F21y x_B - F21x y_B + torque of servo 3",
        "without the link's inertia and without the moment that the elbow's servo leaves on it",
    ),
    Misprint(
        "3.36",
        "F21y (x_B - x_C2) - F21x (z_B - z_C2)",
        "m2 L2^2 / 12 (theta1'' + theta2'') - F21y (x_B - x_C2) + F21x (y_B - y_C2)",
        "z for y; and the inertia about C2, for C2 is what the moments are taken about",
    ),
)
NOTE = (
    "Corrected, (3.31) and (3.36) are true in the plane theta0 = 0. Out of it they still miss that theta0 "
    "turns about an axis that theta1 carries along, and all of the gyroscopic moments."
)


def torques(
    q: ArrayLike,
    qd: ArrayLike,
    qdd: ArrayLike,
    lengths: tuple[float, float],
    masses: tuple[float, float],
    printed: Printed = NONE,
) -> Array:
    """The servos' torques (..., 3), N m, for theta1, theta0, theta2.

    Args:
        q, qd, qdd: angles, rates and accelerations (..., 3), in rad, rad/s and rad/s2, in that order.
        lengths, masses: of both links, m and kg.
        printed: the equations to take letter for letter; the rest is corrected.
    """
    q, qd, qdd = (np.asarray(a, float) for a in (q, qd, qdd))
    (L1, L2), (m1, m2) = lengths, masses
    whole, half = (np.array([[0, 0, 0], [L1, 0, 0], [x, 0, 0]]) for x in (0.0, L2 / 2))
    B = chain.fk(AXES, whole, q)[..., :3, 3]
    C2 = chain.fk(AXES, half, q)[..., :3, 3]
    linear = chain.jacobian(AXES, half, q)[..., :3, :]
    bent = chain.position_hessian(AXES, half, q)
    acceleration = (linear @ qdd[..., None])[..., 0] + np.einsum("...ijk,...j,...k->...i", bent, qd, qd)
    F21 = m2 * (acceleration - [GRAVITY, 0, 0])  # (3.34)
    C1 = B / 2

    arm = B - C2
    if "3.36" in printed:
        elbow = F21[..., 1] * arm[..., 0] - F21[..., 0] * arm[..., 2]
    else:
        elbow = m2 * L2**2 / 12 * (qdd[..., 0] + qdd[..., 2])
        elbow = elbow - F21[..., 1] * arm[..., 0] + F21[..., 0] * arm[..., 1]
    about_y = m1 * GRAVITY * C1[..., 2] + F21[..., 2] * B[..., 0] - F21[..., 0] * B[..., 2]
    roll = about_y if "3.28" in printed else m1 * L1**2 / 3 * qdd[..., 1] - about_y
    about_z = m1 * GRAVITY * C1[..., 1] + F21[..., 1] * B[..., 0] - F21[..., 0] * B[..., 1]
    pitch = about_z if "3.31" in printed else about_z + m1 * L1**2 / 3 * qdd[..., 0] + elbow
    return np.stack([pitch, roll, elbow], axis=-1)


def missed(
    mechanism: Mechanism, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, printed: Printed = NONE
) -> Array:
    """What the equations miss of the servos' torques (..., 3), in N m: Newton-Euler's less theirs.

    Args:
        mechanism: the arm, whose lengths and masses they are given; see `torques` for the rest.
    """
    upper, fore = np.linalg.norm(mechanism.links[1:], axis=1).tolist()
    masses = (float(mechanism.mass[1]), float(mechanism.mass[2]))
    theirs = torques(q, qd, qdd, (upper, fore), masses, printed)
    return np.asarray(inverse_dynamics(mechanism, q, qd, qdd) - theirs)
