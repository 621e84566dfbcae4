"""Dry and viscous friction of joints, with sticking at rest (figure 2.12 of the arm paper)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics.transforms import Array

# Below this rate (rad/s) a joint counts as at rest.
REST = 1e-6


@dataclass(frozen=True)
class Friction:
    """Friction F + D qd of a joint (the paper's 2.21), and what it takes to break loose.

    Attributes:
        coulomb: while moving, N m.
        viscous: N m s/rad.
        static: at rest, N m; at least `coulomb`.
    """

    coulomb: float = 0.0
    viscous: float = 0.0
    static: float = 0.0

    def __post_init__(self) -> None:
        if not (0 <= self.coulomb <= self.static < np.inf and 0 <= self.viscous < np.inf):
            raise UsageError(
                "friction must be finite, not negative, and static at least Coulomb, "
                f"got coulomb {self.coulomb}, static {self.static}, viscous {self.viscous}"
            )

    def torque(self, qd: ArrayLike, drive: ArrayLike) -> Array:
        """What resists (...), in N m, at the rates `qd` (...) in rad/s.

        Args:
            drive: the torque (...), in N m, that all else exerts on the joint: at rest friction is equal to
                it, up to the static limit.
        """
        qd, drive = np.asarray(qd, float), np.asarray(drive, float)
        moving = self.coulomb * np.sign(qd) + self.viscous * qd
        return np.asarray(np.where(np.abs(qd) <= REST, np.clip(drive, -self.static, self.static), moving))
