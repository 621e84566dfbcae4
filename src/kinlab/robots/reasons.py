"""Why a limb does not get to a target, in words."""

from dataclasses import dataclass

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.robots.inverse import Inverse
from kinlab.robots.model import LIMIT_SLACK, Limb

# A nearest point this near (m) is the target itself.
SAME_PLACE = 1e-9


@dataclass(frozen=True)
class Breach:
    """An angle beyond a limit of its joint, both in degrees."""

    joint: str
    angle_deg: float
    limit_deg: float

    def __str__(self) -> str:
        side = "below" if self.angle_deg < self.limit_deg else "above"
        return f"{self.joint} {self.angle_deg:.2f} deg is {side} its limit of {self.limit_deg:.1f}"


def breaches(limb: Limb, q: Array) -> tuple[Breach, ...]:
    """The angles of `q` (n,), rad, that break a limit, from the body to the tip."""
    low, high = limb.limits
    found = []
    for i, (name, angle) in enumerate(zip(limb.joint_names, np.degrees(q), strict=True)):
        if q[i] < low[i] - LIMIT_SLACK or q[i] > high[i] + LIMIT_SLACK:
            limit = low[i] if q[i] < low[i] else high[i]
            found.append(Breach(name, float(angle), float(np.degrees(limit))))
    return tuple(found)


def beyond_limits(limb: Limb, q: Array) -> tuple[str, ...]:
    """What of the angles `q` (n,), rad, breaks a limit, in words."""
    return tuple(map(str, breaches(limb, q)))


def why_unreachable(limb: Limb, target: Array, found: Inverse, nearest: Array) -> str:
    """Why `found` holds no solution within the limits for `target` (3,), limb frame, metres.

    Args:
        limb: asked.
        target: the place.
        found: its inverse.
        nearest: the nearest point (3,) that the limb reaches with its attitude left free.
    """
    if found.exists:
        lower, upper = limb.limits
        excess = np.maximum(lower - found.solutions, found.solutions - upper).max(axis=-1)
        best = int(np.nanargmin(excess))
        broken = ", ".join(beyond_limits(limb, found.solutions[best]))
        return f"every solution breaks a limit; the one that does so least is {found.names[best]}: {broken}"
    if len(limb.joints) >= 6 and np.linalg.norm(nearest - target) < SAME_PLACE:
        return "the place is within reach, but not with this attitude of the tip"
    form = limb.closed_form
    if form is not None and form.kind == "leg":
        return _leg_too_short(form.lengths, target)
    distance, length = np.linalg.norm(target) * 1000, np.linalg.norm(limb.links, axis=1).sum() * 1000
    if distance > length:
        return f"out of reach: {distance:.1f} mm from the first joint, and the stretched limb is {length:.1f} mm long"
    return "out of reach: no angles of the joints bring the tip there"


def _leg_too_short(lengths: tuple[float, ...], target: Array) -> str:
    coxa, femur, tibia = (length * 1000 for length in lengths)
    x, y, z = target * 1000
    distance = np.hypot(np.hypot(x, y) - coxa, z)
    if distance < abs(femur - tibia):
        rest = f"and the folded leg keeps {abs(femur - tibia):.1f} mm away"
    else:
        rest = f"and femur and tibia reach {femur + tibia:.1f} mm"
    return f"out of reach: {distance:.1f} mm from the femur's joint, {rest}"
