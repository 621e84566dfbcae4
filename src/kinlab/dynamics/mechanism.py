"""A chain with masses: what the equations of motion are written for."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics.transforms import Array, rotation
from kinlab.robots.inertia import link_inertia
from kinlab.robots.model import Limb

GRAVITY = 9.80665  # m/s2, standard; also what turns kgf into N


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A serial chain of n links. Joint i turns about its axis, or slides along it; then its link follows.

    Attributes:
        axes: unit vectors (n, 3), each in the frame of the link before it.
        links: (n, 3) from each link's frame to the next joint, metres.
        mass: (n,) of the links, kg.
        centres: (n, 3) of mass, in the frame of the link, metres.
        inertia: (n, 3, 3) about the centre of mass, in the frame of the link, kg m2.
        slides: (n,) whether a joint is prismatic; its coordinate is then in metres, its torque a force in N.
        gravity: (3,) in the base frame, m/s2.
    """

    axes: Array
    links: Array
    mass: Array
    centres: Array
    inertia: Array
    slides: tuple[bool, ...]
    gravity: Array

    @classmethod
    def of(cls, limb: Limb, gravity: float = GRAVITY) -> "Mechanism":
        """A limb with the masses of its robot's file, in the limb frame; its body stands upright.

        Robots files know revolute joints alone. See `kinlab.robots.inertia` for what is assumed of masses.
        """
        parts = [link_inertia(joint) for joint in limb.joints]
        return cls(
            axes=limb.axes,
            links=limb.links,
            mass=np.array([mass for mass, _, _ in parts]),
            centres=np.array([centre for _, centre, _ in parts]),
            inertia=np.array([inertia for _, _, inertia in parts]),
            slides=(False,) * len(parts),
            gravity=limb.mount[:3, :3].T @ [0.0, 0.0, -gravity],
        )

    @property
    def count(self) -> int:
        """How many joints there are."""
        return len(self.slides)

    @cached_property
    def rows(self) -> list[tuple[list[float], list[float], float, list[float], list[list[float]], bool]]:
        """Axis, link, mass, centre, inertia and whether it slides, of each joint, as plain numbers."""
        return list(
            zip(
                self.axes.tolist(),
                self.links.tolist(),
                self.mass.tolist(),
                self.centres.tolist(),
                self.inertia.tolist(),
                self.slides,
                strict=True,
            )
        )

    def check(self, what: str, values: ArrayLike) -> Array:
        """`values` as floats (..., n).

        Raises:
            UsageError: not one number for each joint; `what` names them.
        """
        array = np.asarray(values, float)
        if array.ndim == 0 or array.shape[-1] != self.count:
            got = array.shape[-1] if array.ndim else 1
            raise UsageError(f"{what} must have one number for each of {self.count} joints, got {got}")
        return array


def poses(mechanism: Mechanism, q: ArrayLike) -> tuple[Array, Array]:
    """Attitudes (..., n, 3, 3) and origins (..., n + 1, 3) of the links' frames and the tip, in the base frame."""
    q = mechanism.check("positions", q)
    R, p = np.broadcast_to(np.eye(3), (*q.shape[:-1], 3, 3)), np.zeros((*q.shape[:-1], 3))
    attitudes, origins = [], []
    for i, (axis, link, *_, slides) in enumerate(mechanism.rows):
        if slides:
            p = p + q[..., i, None] * (R @ axis)
        else:
            R = R @ rotation(axis, q[..., i])
        attitudes.append(R)
        origins.append(p)
        p = p + R @ link
    return np.stack(attitudes, axis=-3), np.stack([*origins, p], axis=-2)
