"""How a path is run through in time: the share of it that is done, with its first and second derivatives."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array

# The share of the time that a trapezoid spends on each of its ramps.
RAMP = 0.25


def constant(t: ArrayLike, duration: float) -> Array:
    """Equal steps, as the arm paper's: at full speed from the first moment to the last. (3, ...): s, s', s''."""
    u = np.clip(np.asarray(t, float) / duration, 0, 1)
    inside = (u > 0) & (u < 1)
    return np.stack([u, inside / duration, np.zeros_like(u)])


def trapezoid(t: ArrayLike, duration: float) -> Array:
    """Constant acceleration, constant speed, constant deceleration. (3, ...): s, s' in 1/s, s'' in 1/s2."""
    u = np.clip(np.asarray(t, float) / duration, 0, 1)
    top = 1 / (1 - RAMP)
    up, down = u < RAMP, u > 1 - RAMP
    s = np.where(up, u * u / RAMP / 2, np.where(down, 1 / top - (1 - u) ** 2 / RAMP / 2, u - RAMP / 2)) * top
    rate = np.where(up, u / RAMP, np.where(down, (1 - u) / RAMP, 1.0)) * top
    change = np.where(up & (u > 0), top / RAMP, np.where(down & (u < 1), -top / RAMP, 0.0))
    return np.stack([s, rate / duration, change / duration**2])


def quintic(t: ArrayLike, duration: float) -> Array:
    """10 u^3 - 15 u^4 + 6 u^5: at rest, without acceleration, at both ends. (3, ...): s, s' in 1/s, s'' in 1/s2."""
    u = np.clip(np.asarray(t, float) / duration, 0, 1)
    s = u**3 * (10 + u * (6 * u - 15))
    rate = 30 * u**2 * (1 - u) ** 2
    return np.stack([s, rate / duration, 60 * u * (1 - u) * (1 - 2 * u) / duration**2])


PROFILES: dict[str, Callable[[ArrayLike, float], Array]] = {
    "steps": constant,
    "trapezoid": trapezoid,
    "quintic": quintic,
}
