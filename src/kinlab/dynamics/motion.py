"""Forward dynamics and energy: what torques do to a chain, by the composite-rigid-body method.

Walker and Orin 1982, method 3, with all inertias in the base frame, where they simply add up.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamics.mechanism import Mechanism, poses
from kinlab.dynamics.newton_euler import TIP, Contact, inverse_dynamics
from kinlab.kinematics.transforms import Array


def mass_matrix(mechanism: Mechanism, q: ArrayLike) -> Array:
    """The joint-space inertia (..., n, n), in kg m2 (kg where joints slide), at `q` (..., n)."""
    R, origins = poses(mechanism, q)
    origins = origins[..., :-1, :]
    axes = (R @ mechanism.axes[..., None])[..., 0]
    c = origins + (R @ mechanism.centres[..., None])[..., 0]
    m = mechanism.mass
    squares = np.sum(c * c, axis=-1)[..., None, None] * np.eye(3) - c[..., :, None] * c[..., None, :]
    about_base = R @ mechanism.inertia @ np.swapaxes(R, -1, -2) + m[:, None, None] * squares
    # The composite body of joint i is all that hangs on it: sums from the tip inwards.
    mass, first, second = (
        np.flip(np.cumsum(np.flip(x, axis), axis), axis)
        for x, axis in ((m, -1), (m[:, None] * c, -2), (about_base, -3))
    )
    slides = np.array(mechanism.slides)[:, None]
    spin = np.where(slides, 0.0, axes)
    speed = np.where(slides, axes, np.cross(origins, axes))  # of the body's point in the base's origin
    force = mass[:, None] * speed + np.cross(spin, first)
    moment = (second @ spin[..., None])[..., 0] + np.cross(first, speed)
    lower = np.tril(force @ np.swapaxes(speed, -1, -2) + moment @ np.swapaxes(spin, -1, -2))
    return np.asarray(lower + np.swapaxes(np.tril(lower, -1), -1, -2))


def forward_dynamics(
    mechanism: Mechanism,
    q: ArrayLike,
    qd: ArrayLike,
    torque: ArrayLike,
    wrench: ArrayLike | None = None,
    at: Contact = TIP,
) -> Array:
    """The accelerations (..., n) in rad/s2 that `torque` (..., n), in N m, brings; see `inverse_dynamics`."""
    torque = mechanism.check("torques", torque)
    resting = inverse_dynamics(mechanism, q, qd, np.zeros(mechanism.count), wrench, at)
    return np.asarray(np.linalg.solve(mass_matrix(mechanism, q), (torque - resting)[..., None])[..., 0])


def kinetic_energy(mechanism: Mechanism, q: ArrayLike, qd: ArrayLike) -> Array:
    """In J, (...)."""
    qd = mechanism.check("rates", qd)
    return np.asarray(np.einsum("...i,...ij,...j->...", qd, mass_matrix(mechanism, q), qd) / 2)


def potential_energy(mechanism: Mechanism, q: ArrayLike) -> Array:
    """In J, (...), against all mass in the base's origin."""
    R, origins = poses(mechanism, q)
    centres = origins[..., :-1, :] + (R @ mechanism.centres[..., None])[..., 0]
    return np.asarray(-(centres @ mechanism.gravity) @ mechanism.mass)
