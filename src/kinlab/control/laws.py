"""Position and compliance control of the arm paper: (2.7), (2.20), (2.26), and its low-pass filter."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics.transforms import Array


class PositionGains(NamedTuple):
    """Kp (1/s2) and Kv (1/s) of (2.20)."""

    kp: float
    kv: float


class Environment(NamedTuple):
    """The virtual mass, damper and spring that yields to a torque (2.7): kf / (menv s^2 + denv s + kenv).

    The paper prints no units. Torques in kgf cm and angles in rad make it kf in rad kgf^-1 cm^-1 times
    those of kenv, denv and menv: 1, s, s2.
    """

    kf: float
    kenv: float
    denv: float
    menv: float

    def check(self) -> "Environment":
        """Itself.

        Raises:
            UsageError: it has no mass, or anything negative or not finite.
        """
        if not (np.isfinite(self).all() and self.menv > 0 and min(self) >= 0):
            raise UsageError(
                "Kf, Kenv, Denv must be finite and not negative, and Menv more than 0: got "
                f"{', '.join(f'{name} {value:g}' for name, value in self._asdict().items())}"
            )
        return self


class Yielding(NamedTuple):
    """How far a virtual environment has given way (...): angle in rad, its rate, its acceleration."""

    angle: Array
    rate: Array
    acceleration: Array


AT_REST = Yielding(np.zeros(()), np.zeros(()), np.zeros(()))


def position_control(
    gains: PositionGains, command: ArrayLike, command_rate: ArrayLike, real: ArrayLike, real_rate: ArrayLike
) -> Array:
    """The acceleration (...) in rad/s2 that (2.20) asks for: Kp (cmd - real) + Kv (cmd' - real')."""
    away, faster = np.subtract(command, real), np.subtract(command_rate, real_rate)
    return np.asarray(gains.kp * away + gains.kv * faster)


def compliance_control(
    gains: PositionGains,
    environment: Environment,
    command: ArrayLike,
    command_rate: ArrayLike,
    real: ArrayLike,
    real_rate: ArrayLike,
    given_way: Yielding,
) -> Array:
    """The acceleration (...) in rad/s2 that (2.26) asks for, letter for letter.

    It weighs the yielding again with Kenv, Denv and Menv, which (2.6), from which it is taken, does not.
    """
    command = np.subtract(command, environment.kenv * given_way.angle)
    command_rate = np.subtract(command_rate, environment.denv * given_way.rate)
    pull = environment.menv * given_way.acceleration
    return np.asarray(position_control(gains, command, command_rate, real, real_rate) - pull)


def yield_to(environment: Environment, state: Yielding, torque: ArrayLike, dt: float) -> Yielding:
    """How far the environment has given way after `dt` seconds of a torque (...), in kgf cm: (2.7) and (2.25).

    By the trapezoidal rule, which is stable for every mass, damper and spring.
    """
    kf, k, d, m = environment
    drive = kf * np.asarray(torque, float)
    ahead = state.angle + dt * state.rate + dt * dt / 4 * state.acceleration
    quicker = state.rate + dt / 2 * state.acceleration
    acceleration = (drive - d * quicker - k * ahead) / (m + d * dt / 2 + k * dt * dt / 4)
    return Yielding(ahead + dt * dt / 4 * acceleration, quicker + dt / 2 * acceleration, acceleration)


def low_pass(before: ArrayLike, now: ArrayLike, alpha: float) -> Array:
    """The filter of section 4.2.1: y + alpha (x - y)."""
    before = np.asarray(before, float)
    return np.asarray(before + alpha * (np.asarray(now, float) - before))
