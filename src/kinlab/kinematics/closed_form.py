"""Which closed-form inverse a chain has: recognised from its axes and links, whatever robot it is of."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import humanoid_leg, shoulder_arm
from kinlab.kinematics.leg import leg_ik
from kinlab.kinematics.transforms import Array

LEG_NAMES = ("knee-up", "knee-down", "backwards, knee-up", "backwards, knee-down")
_LEG_AXES = ((0, 0, 1), (0, -1, 0), (0, -1, 0))
_HUMANOID_AXES = ((0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 1, 0), (0, 1, 0), (1, 0, 0))


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """A closed-form inverse: `names` of its solutions, and what target it needs.

    Attributes:
        kind: "leg", "humanoid leg" or "shoulder arm".
        names: of the solutions, in the order in which `solve` gives them.
        needs_pose: whether the target is a pose (..., 4, 4) instead of a position (..., 3).
        lengths: the link lengths, in metres.
        to_model: rotation from the chain's base axes to those of the derivation, (3, 3).
    """

    kind: str
    names: tuple[str, ...]
    needs_pose: bool
    lengths: tuple[float, ...]
    to_model: Array

    def solve(self, target: ArrayLike) -> tuple[Array, Array]:
        """All solutions (..., k, n) in rad, NaN where unreachable, and the reachability (...).

        Args:
            target: position (..., 3) or, where `needs_pose`, pose (..., 4, 4), in metres and the
                chain's base frame.
        """
        target = np.asarray(target, float)
        if self.kind == "humanoid leg":
            return humanoid_leg.humanoid_leg_ik(target, *self.lengths)
        if self.kind == "shoulder arm":
            return shoulder_arm.shoulder_arm_ik(target @ self.to_model.T, *self.lengths)
        q = np.empty((*target.shape[:-1], len(self.names), 3))
        reachable = np.zeros(target.shape[:-1], dtype=bool)
        for i, (backwards, knee_up) in enumerate(
            [(False, True), (False, False), (True, True), (True, False)]
        ):
            c, f, t = self.lengths
            q[..., i, :], one = leg_ik(target, c, f, t, knee_up=knee_up, backwards=backwards)
            reachable |= one
        return q, reachable


def recognise(axes: ArrayLike, links: ArrayLike) -> ClosedForm | None:
    """The closed form of a chain `axes` (n, 3), `links` (n, 3), or None where KinLab has none."""
    axes, links = np.asarray(axes, float), np.asarray(links, float)
    if _same(axes, _LEG_AXES) and not links[:, 1:].any() and (links[1:, 0] > 0).all():
        return ClosedForm("leg", LEG_NAMES, False, _floats(links[:, 0]), np.eye(3))
    hanging = _same(axes, _HUMANOID_AXES) and not links[:, :2].any() and not links[[0, 1, 4], 2].any()
    if hanging and (links[[2, 3], 2] < 0).all():
        return ClosedForm("humanoid leg", humanoid_leg.NAMES, True, _floats(-links[[2, 3, 5], 2]), np.eye(3))
    if len(axes) == 3 and np.array_equal(axes[0], axes[2]) and not links[0].any():
        first, second = axes[0], axes[1]
        along = np.cross(second, first)
        upper, fore = links[1] @ along, links[2] @ along
        straight = np.allclose(links[1:], [upper * along, fore * along], atol=1e-12)
        if abs(first @ second) < 1e-12 and straight and upper > 0 and fore > 0:
            names = shoulder_arm.NAMES
            return ClosedForm(
                "shoulder arm", names, False, _floats([upper, fore]), np.array([along, second, first])
            )
    return None


def _same(axes: Array, wanted: tuple[tuple[int, ...], ...]) -> bool:
    return axes.shape == (len(wanted), 3) and np.array_equal(axes, wanted)


def _floats(values: Any) -> tuple[float, ...]:
    return tuple(float(v) for v in values)
