"""What the linear model promises: the second-order response (2.8) to (2.19), and that of a sampled loop."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array


@dataclass(frozen=True)
class SecondOrder:
    """omega^2 / (s^2 + 2 zeta omega s + omega^2) of (2.10). Times in s; the estimates are the paper's.

    Attributes:
        omega: natural frequency, rad/s.
        zeta: damping ratio.
    """

    omega: float
    zeta: float

    @classmethod
    def of_position(cls, kp: float, kv: float) -> "SecondOrder":
        """(2.11), (2.12): of position control, whose response has a zero besides."""
        return cls(float(np.sqrt(kp)), kv / (2 * float(np.sqrt(kp))))

    @classmethod
    def of_environment(cls, kenv: float, denv: float, menv: float) -> "SecondOrder":
        """(2.13), (2.14), printed with W_env for M_env and zeta_p for zeta_f."""
        return cls(float(np.sqrt(kenv / menv)), denv / (2 * float(np.sqrt(menv * kenv))))

    @property
    def oscillates(self) -> bool:
        """Whether it overshoots."""
        return self.zeta < 1

    @property
    def peak_time(self) -> float:
        """(2.16)."""
        return float(np.pi / (self.omega * np.sqrt(1 - self.zeta**2))) if self.oscillates else np.inf

    @property
    def overshoot(self) -> float:
        """(2.17) as a share, with the minus that the print leaves out of its exponent."""
        return float(np.exp(-self.zeta * np.pi / np.sqrt(1 - self.zeta**2))) if self.oscillates else 0.0

    @property
    def settling_time(self) -> float:
        """(2.18): to within about 2 per cent."""
        return 4 / (self.zeta * self.omega) if self.zeta * self.omega > 0 else np.inf

    @property
    def rise_time(self) -> float:
        """(2.19)."""
        return 1.8 / self.omega

    def step(self, t: ArrayLike) -> Array:
        """The response (...) to a unit step at 0, at times (...) in s."""
        t = np.asarray(t, float)
        root = np.sqrt(complex(self.zeta**2 - 1)) * self.omega
        # Two roots that fall together are taken a hair apart.
        root = root if abs(root) > 1e-9 * self.omega else 1e-6 * self.omega
        a, b = -self.zeta * self.omega + root, -self.zeta * self.omega - root
        return np.asarray(np.real(1 + (b * np.exp(a * t) - a * np.exp(b * t)) / (a - b)))


def sampled_radius(kp: ArrayLike, kv: ArrayLike, dt: float, delay: int = 1) -> Array:
    """The spectral radius (...) of (2.20) sampled every `dt` s, its command reached `delay` cycles later.

    Above 1 the loop runs away, however strong the servo. State: reference, its rate, and the positions of
    the last cycles; the real rate is the difference of the last two.
    """
    kp, kv = np.broadcast_arrays(np.asarray(kp, float), np.asarray(kv, float))
    size = delay + 3
    A = np.zeros((*kp.shape, size, size))
    # x = (rate, reference now, reference one cycle ago, ...); what is measured is `delay` cycles old.
    real, before = 1 + delay, 2 + delay
    A[..., 0, 0] = 1.0
    A[..., 0, real] -= dt * kp + kv
    A[..., 0, before] += kv
    A[..., 1, :] = dt * A[..., 0, :]
    A[..., 1, 1] += 1.0
    for row in range(2, size):
        A[..., row, row - 1] = 1.0
    return np.asarray(np.abs(np.linalg.eigvals(A)).max(axis=-1))
