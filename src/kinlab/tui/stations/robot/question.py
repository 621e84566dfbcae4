"""What the station asks the core."""

from dataclasses import dataclass

from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb, Robot


@dataclass(frozen=True, eq=False)
class Question:
    """What a person has set.

    Attributes:
        target: (3,), metres, limb frame; None for the place where the limb's paper begins.
        rpy: attitude (3,), rad; None for limbs that cannot choose it.
        q: joint angles (n,), rad, where the path begins at them; else None.
        frame: in which places are shown.
        solution: the name of the wished one.
        powered: whether the emulated chain has its supply.
        mirrored: whether the pose is shown in a viewer too.
    """

    robot: Robot
    limb: Limb
    target: Array | None
    rpy: Array | None
    q: Array | None
    frame: str
    solution: str
    powered: bool
    mirrored: bool = False
