"""The disturbance observer and the reaction-torque observer (2.27 to 2.37, figures 2.8 and 2.11)."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array


class Observed(NamedTuple):
    """An observer after some samples: its filter's value (...) and its estimate (...), both in N m."""

    filtered: Array
    estimate: Array


def observe(
    before: Observed | None,
    torque: ArrayLike,
    rate: ArrayLike,
    inertia: ArrayLike,
    cutoff: float,
    dt: float,
    known: ArrayLike = 0.0,
) -> Observed:
    """One sample: tau_dis = g/(s+g) (tau_m + g J rate - known) - g J rate.

    Without `known` it is the disturbance observer of figure 2.8; with the torques of inertia, gravity and
    friction as `known` it is the reaction-torque observer of (2.37), which prints J_n for the current in its
    first term. Positive is what resists positive motion.

    Args:
        before: after the last sample; None for the first, which takes the joint as at rest for long.
        torque: of the motor (...), N m.
        rate: of the joint (...), rad/s.
        inertia: nominal (...), kg m2, that `torque` accelerates besides what is `known`.
        cutoff: g, 1/s.
        dt: s.
    """
    momentum = cutoff * np.asarray(inertia, float) * np.asarray(rate, float)
    value = np.asarray(torque, float) + momentum - np.asarray(known, float)
    if before is None:
        return Observed(value, value - momentum)
    filtered = before.filtered - np.expm1(-cutoff * dt) * (value - before.filtered)
    return Observed(filtered, filtered - momentum)
