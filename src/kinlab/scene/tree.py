"""A robot as a tree of transforms: body, limb, joint, link. Geometry hangs in its joint's frame and never changes."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array, homogeneous, quaternion, rotation_vector
from kinlab.robots import Limb, Robot
from kinlab.scene import colours
from kinlab.scene.recording import Recording, Times, part
from kinlab.units import to_mm

WORLD = "world"
# Thickness of links, as a share of the longest limb; of ghosts and tips, and length of axes, in links.
LINK, GHOST, TIP, AXIS = 0.03, 0.4, 1.2, 3.0


class Tree:
    """The entities of a robot in a recording.

    Attributes:
        recording: that they are in.
        robot: drawn.
        root: the entity in whose frame the body moves.
        thick: radius of a link, mm.
    """

    def __init__(self, recording: Recording, robot: Robot, root: str = WORLD) -> None:
        self.recording, self.robot, self.root = recording, robot, root
        self.body = f"{root}/body"
        self._taken = {name for limb in robot.limbs.values() for name in (limb.name, *limb.joint_names)}
        self.thick = LINK * float(to_mm(reach(robot)))

    def limb(self, limb: Limb, under: str = "") -> str:
        """The entity of a limb's frame; of its ghost called `under`, where that is given."""
        return f"{self.beside(self.body, under) if under else self.body}/" + part(limb.name)

    def beside(self, path: str, name: str) -> str:
        """The entity under `path` of what is no limb and no joint, by `name`, or one like it that none of them has."""
        while name in self._taken:
            name += "_"
        return f"{path}/" + part(name)

    def joints(self, limb: Limb, under: str = "") -> list[str]:
        """The entities of a limb's joints, from the body to the tip, then that of the tip."""
        names = limb.joint_names
        found = [f"{self.limb(limb, under)}/" + part(*names[: i + 1]) for i in range(len(names))]
        return [*found, self.beside(found[-1], "tip")]

    def draw(self, label: Limb | None = None, frames: bool = False) -> None:
        """Log what never changes: geometry and names.

        Args:
            label: the limb whose links have their names written beside them.
            frames: whether every frame is drawn as three arrows.
        """
        rr, rec = self.recording.rr, self.recording
        rec.still(self.root, rr.ViewCoordinates.RIGHT_HAND_Z_UP)
        mounts = to_mm([limb.mount[:3, 3] for limb in self.robot.limbs.values()])
        low, high = mounts.min(axis=0), mounts.max(axis=0)
        size = np.maximum((high - low) / 2, self.thick)
        box = rr.Boxes3D(
            centers=(low + high) / 2, half_sizes=size, colors=colours.BODY, labels=self.robot.name,
            show_labels=False, fill_mode="solid",
        )  # fmt: skip
        rec.still(self.beside(self.body, "shape"), box)
        for limb in self.robot.limbs.values():
            self.draw_limb(limb, names=limb is label, frames=frames)
        if frames:
            rec.still(self.body, rr.TransformAxes3D(10 * self.thick))

    def draw_limb(
        self,
        limb: Limb,
        *,
        names: bool = False,
        frames: bool = False,
        ghost: str = "",
        colour: tuple[int, int, int] = colours.GHOST,
    ) -> None:
        """Log a limb's geometry; as a thin ghost beside the limb, of one colour, where `ghost` names one."""
        rr, rec, thick = self.recording.rr, self.recording, self.thick
        rec.pose(self.limb(limb, ghost), limb.mount)
        at = self.joints(limb, ghost)
        for i, (joint, path) in enumerate(zip(limb.joints, at, strict=False)):
            link = to_mm(joint.link)
            length = float(np.linalg.norm(link))
            if length:
                capsule = rr.Capsules3D(
                    lengths=length, radii=GHOST * thick if ghost else thick,
                    quaternions=_from_z(link / length), colors=colour if ghost else colours.LINKS[i % 3],
                    labels=joint.name, show_labels=names, fill_mode="solid",
                )  # fmt: skip
                rec.still(self.beside(path, "link"), capsule)
            if not ghost:
                axis = AXIS * thick * np.array(joint.axis)
                arrow = rr.Arrows3D(
                    vectors=2 * axis, origins=-axis, radii=thick / 5, colors=colours.AXIS,
                    labels=f"axis of {limb.name} {joint.name}", show_labels=False,
                )  # fmt: skip
                rec.still(self.beside(path, "axis"), arrow)
            if frames and not ghost:
                rec.still(path, rr.TransformAxes3D(5 * thick))
        tip = homogeneous(np.eye(3), limb.links[-1])
        rec.pose(at[-1], tip)
        point = rr.Points3D(
            [[0, 0, 0]], radii=TIP * (GHOST if ghost else 1) * thick,
            colors=colour if ghost else colours.LINKS[-1], labels=limb.name, show_labels=not (ghost or names),
        )  # fmt: skip
        rec.still(self.beside(at[-1], "point"), point)
        if limb.sole and not ghost:
            half = [*(to_mm(side) / 2 for side in limb.sole), thick / 5]
            rec.still(
                self.beside(at[-1], "sole"),
                rr.Boxes3D(half_sizes=half, colors=colours.LINKS[-1], fill_mode="solid"),
            )
        if frames and not ghost:
            rec.still(at[-1], rr.TransformAxes3D(5 * thick))

    def pose(self, limb: Limb, q: ArrayLike, times: Times | None = None, ghost: str = "") -> None:
        """Log joint angles (n,) that stay, or (F, n) over time, in rad; rows that nobody knows are left out."""
        q = np.asarray(q, float)
        rec = self.recording
        before = np.vstack([np.zeros(3), limb.links[:-1]])
        for j, path in enumerate(self.joints(limb, ghost)[:-1]):
            if times is None:
                turn = rec.rr.Quaternion(xyzw=quaternion(limb.axes[j] * q[j]))
                rec.still(path, rec.rr.Transform3D(translation=to_mm(before[j]), quaternion=turn))
                continue
            known = np.isfinite(q[:, j])
            if not known.any():
                continue
            rec.over(
                path,
                times.at(known),
                rec.rr.Transform3D,
                translation=np.tile(to_mm(before[j]), (int(known.sum()), 1)),
                quaternion=quaternion(limb.axes[j] * q[known, j, None]),
            )

    def poses(self, angles: Mapping[str, ArrayLike], times: Times | None = None) -> None:
        """Log joint angles of limbs by name."""
        for name, q in angles.items():
            self.pose(self.robot.limbs[name], q, times)


def reach(robot: Robot) -> float:
    """The length of the longest limb, m."""
    return max(float(np.linalg.norm(limb.links, axis=1).sum()) for limb in robot.limbs.values())


def stood(robot: Robot) -> Array:
    """The pose (4, 4) of a standing body over the ground, metres; of one without legs, in the origin."""
    height = -float(robot.standing_feet[:, 2].min()) if robot.legs else 0.0
    return homogeneous(np.eye(3), [0.0, 0.0, height])


def _from_z(direction: Array) -> Array:
    """The quaternion (4,) that turns z, along which rerun lays its capsules, to `direction` (3,), a unit vector."""
    x, y, z = direction
    if z < -1 + 1e-12:
        return quaternion([np.pi, 0.0, 0.0])
    # The columns of the turn by the shortest way.
    R = np.array(
        [
            [1 - x * x / (1 + z), -x * y / (1 + z), x],
            [-x * y / (1 + z), 1 - y * y / (1 + z), y],
            [-x, -y, z],
        ]
    )
    return quaternion(rotation_vector(R))
