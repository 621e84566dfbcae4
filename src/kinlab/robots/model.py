"""What a robot is: limbs of joints with links, limits and servos. Frozen data, in metres and radians."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics import ClosedForm, chain, recognise
from kinlab.kinematics.transforms import Array, apply, inverse
from kinlab.names import resolve
from kinlab.robots.provenance import UNSOURCED, Dimension, Provenance
from kinlab.robots.servo import Servo

if TYPE_CHECKING:
    from kinlab.robots.inverse import Inverse

FRAMES = ("limb", "body", "paper")
# A solution this far (rad) outside a limit is on it: where a limb is stretched or folded, the rounding
# of a target's last digit turns the joints by up to about 1e-7.
LIMIT_SLACK = 2e-7


def frozen(values: Array) -> Array:
    """The array itself, which can no longer be written to."""
    values.flags.writeable = False
    return values


@dataclass(frozen=True)
class Joint:
    """A revolute joint and the link that follows it.

    Attributes:
        name: within its limb.
        axis: unit vector in the frame of the link before it.
        link: translation to the next joint, after the turn, in metres.
        lower, upper: limits of the angle, in rad.
        limit_source: where the limits come from.
        servo: what moves it, or None where the paper names no servo.
        mass: of the link, in kg, or None where nobody gives one.
        mass_source: where it comes from.
    """

    name: str
    axis: tuple[float, float, float]
    link: tuple[float, float, float]
    lower: float
    upper: float
    limit_source: Provenance
    servo: Servo | None = None
    mass: float | None = None
    mass_source: Provenance = UNSOURCED


@dataclass(frozen=True, eq=False, repr=False)
class Limb:
    """A chain of joints on a body.

    Attributes:
        name: within its robot.
        group: the kind of limb in the robots file ("legs", "arms", "head").
        joints: from the body to the tip.
        mount: transform (4, 4) from the limb frame to the body frame, in metres.
        mount_source: where the mounting place comes from.
        stance: the tip's place when standing (3,), limb frame, metres; None for limbs that do not stand.
        paper_axes: rotation or reflection (3, 3) that takes the paper's axes to the limb's.
        paper_source: where that comes from.
        dimensions: the figures that its links and its stance are made of.
        sole: length and width of the foot below the tip, metres; None for limbs that stand on a point.
    """

    name: str
    group: str
    joints: tuple[Joint, ...]
    mount: Array
    mount_source: Provenance
    stance: Array | None
    paper_axes: Array
    paper_source: Provenance
    dimensions: tuple[Dimension, ...] = field(default=())
    sole: tuple[float, float] | None = None

    def __repr__(self) -> str:
        return f"<Limb {self.name}: {' - '.join(j.name for j in self.joints)}>"

    @cached_property
    def axes(self) -> Array:
        """The joints' axes, (n, 3)."""
        return frozen(np.array([j.axis for j in self.joints]))

    @cached_property
    def links(self) -> Array:
        """The links, (n, 3), in metres."""
        return frozen(np.array([j.link for j in self.joints]))

    @cached_property
    def limits(self) -> Array:
        """Lower and upper limits of the joints, (2, n), in rad: those of the file and the servo's range."""
        both = []
        for joint in self.joints:
            lower, upper = joint.lower, joint.upper
            if joint.servo:
                low, high = joint.servo.model.range_deg
                ends = np.radians([joint.servo.sign * (edge - joint.servo.zero_deg) for edge in (low, high)])
                lower, upper = max(lower, ends.min()), min(upper, ends.max())
            both.append((lower, upper))
        return frozen(np.array(both).T)

    @cached_property
    def closed_form(self) -> ClosedForm | None:
        """The closed-form inverse of this chain, or None where it is solved numerically."""
        return recognise(self.axes, self.links)

    @cached_property
    def joint_names(self) -> tuple[str, ...]:
        """The joints' names, from the body to the tip."""
        return tuple(j.name for j in self.joints)

    def fk(self, q: ArrayLike, frame: str = "limb") -> Array:
        """The pose of the tip (..., 4, 4), metres, for angles (..., n) in rad.

        Args:
            q: the joint angles.
            frame: "limb" or "body".

        Raises:
            UsageError: wrong number of angles, or no such frame.
        """
        q = self._angles(q)
        T = chain.fk(self.axes, self.links, q)
        frame = resolve(frame, FRAMES[:2], "frame")
        return self.mount @ T if frame == "body" else T

    def frames(self, q: ArrayLike) -> Array:
        """Every frame of the chain (..., n + 1, 4, 4) in the limb frame: the base, then each link's end."""
        return chain.frames(self.axes, self.links, self._angles(q))

    def jacobian(self, q: ArrayLike) -> Array:
        """The geometric Jacobian (..., 6, n) in the limb frame: m/rad, then rad/rad."""
        return chain.jacobian(self.axes, self.links, self._angles(q))

    def ik(self, target: ArrayLike, rotation: ArrayLike | None = None) -> "Inverse":
        """Joint angles for the tip at `target` (..., 3), metres, limb frame: see `kinlab.robots.inverse`.

        Args:
            target: positions.
            rotation: attitudes (..., 3, 3) for limbs that can choose it; level where not given.

        Returns:
            An `Inverse` with `q`, `reachable`, `solutions`.
        """
        from kinlab.robots.inverse import inverse_kinematics

        return inverse_kinematics(self, target, rotation)

    def to_limb(self, points: ArrayLike, frame: str) -> Array:
        """Points (..., 3), in metres, from `frame` (limb, body or paper) into the limb frame."""
        points = np.asarray(points, float)
        frame = resolve(frame, FRAMES, "frame")
        if frame == "body":
            return apply(inverse(self.mount), points)
        return points @ self.paper_axes.T if frame == "paper" else points

    def from_limb(self, points: ArrayLike, frame: str) -> Array:
        """Points (..., 3), in metres, from the limb frame into `frame` (limb, body or paper)."""
        points = np.asarray(points, float)
        frame = resolve(frame, FRAMES, "frame")
        if frame == "body":
            return apply(self.mount, points)
        return points @ self.paper_axes if frame == "paper" else points

    def _angles(self, q: ArrayLike) -> Array:
        q = np.asarray(q, float)
        if q.ndim == 0 or q.shape[-1] != len(self.joints):
            got = q.shape[-1] if q.ndim else 1
            raise UsageError(
                f"limb {self.name} has {len(self.joints)} joints ({', '.join(self.joint_names)}), got {got} angles"
            )
        return q


@dataclass(frozen=True, eq=False, repr=False)
class Robot:
    """A robot.

    Attributes:
        name: as typed on the command line.
        title: one line about it.
        kind: "hexapod", "quadruped", "humanoid" or "arm"; decides which gaits fit.
        paper: the name of the paper that describes it, or None.
        limbs: by name, in the order of the file.
        dimensions: of the body, with sources.
        notes: what a reader must know about the figures.
        mass: of the whole robot, kg; None where nobody gives one.
        centre: of the mass that is not in a link with a mass of its own (3,), body frame, metres.
    """

    name: str
    title: str
    kind: str
    paper: str | None
    limbs: Mapping[str, Limb]
    dimensions: tuple[Dimension, ...] = ()
    notes: tuple[str, ...] = ()
    mass: float | None = None
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __repr__(self) -> str:
        limbs = ", ".join(f"{limb.name} ({len(limb.joints)})" for limb in self.limbs.values())
        return f"<Robot {self.name}: {limbs}>"

    def limb(self, name: str | None = None) -> Limb:
        """The limb that `name` means (exact or unique prefix); the first one where it is None.

        Raises:
            UsageError: no such limb.
        """
        if name is None:
            return next(iter(self.limbs.values()))
        return self.limbs[resolve(name, self.limbs, f"limb of {self.name}")]

    @cached_property
    def legs(self) -> tuple[Limb, ...]:
        """The limbs that stand on the ground."""
        return tuple(limb for limb in self.limbs.values() if limb.stance is not None)

    @cached_property
    def leg_frames(self) -> Array:
        """Transforms (L, 4, 4) from the body frame into each leg's limb frame."""
        return inverse(np.stack([leg.mount for leg in self.legs]))

    def to_legs(self, feet: Array) -> Array:
        """Feet (..., L, 3) from the body frame, each into the limb frame of its leg, metres.

        Raises:
            UsageError: not one foot for each leg.
        """
        if feet.shape[-2:] != (len(self.legs), 3):
            raise UsageError(f"{self.name} has {len(self.legs)} legs, got feet of shape {feet.shape}")
        turn, shift = self._leg_map
        # One product for all legs at once is several times faster than one for each foot.
        local = (feet.reshape(-1, len(shift)) @ turn + shift).reshape(feet.shape)
        # It would carry one foot's NaN to the others.
        return local if np.isfinite(local.sum()) else apply(self.leg_frames, feet)

    @cached_property
    def _leg_map(self) -> tuple[Array, Array]:
        count = len(self.legs)
        turn = np.zeros((count, 3, count, 3))
        for i, frame in enumerate(self.leg_frames):
            turn[i, :, i, :] = frame[:3, :3].T
        return turn.reshape(3 * count, -1), self.leg_frames[:, :3, 3].ravel()

    @cached_property
    def standing_feet(self) -> Array:
        """Where the feet stand (L, 3), in the body frame, metres."""
        return np.array([leg.from_limb(leg.stance, "body") for leg in self.legs if leg.stance is not None])

    @cached_property
    def leg_bounds(self) -> Array:
        """Lower and upper limits (2, L, n) of the legs' joints, in rad, with their slack."""
        limits = np.stack([leg.limits for leg in self.legs], axis=1)
        return np.asarray(limits + np.array([-LIMIT_SLACK, LIMIT_SLACK])[:, None, None])

    @cached_property
    def equal_legs(self) -> tuple[float, float, float] | None:
        """Coxa, femur and tibia in metres, where all legs are three-joint legs of one size; else None."""
        forms = [leg.closed_form for leg in self.legs]
        lengths = {form.lengths if form and form.kind == "leg" else None for form in forms}
        one = lengths.pop() if len(lengths) == 1 else None
        return None if one is None else (one[0], one[1], one[2])

    @property
    def servos(self) -> tuple[Servo, ...]:
        """All servos, by id."""
        found = [j.servo for limb in self.limbs.values() for j in limb.joints if j.servo]
        return tuple(sorted(found, key=lambda s: s.id))
