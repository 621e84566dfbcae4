"""What a paper's equations give for a target or for angles, judged by the kinematics of the real robot."""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array, apply, homogeneous, inverse, rotation_vector, rpy_to_rotation
from kinlab.papers import eros_humanoid, krsri_hexapod, receptionist_arm, udiebot_quadruped, xl430_hexapod
from kinlab.papers.equations import (
    ForwardEquations,
    InverseEquations,
    Misprint,
    NotComputable,
    Printed,
)
from kinlab.papers.results import AsPrinted, BodyAsPrinted, Fault, FkAsPrinted
from kinlab.robots import Limb, Robot
from kinlab.units import FARTHEST

__all__ = [
    "AsPrinted",
    "BodyAsPrinted",
    "Fault",
    "FkAsPrinted",
    "as_printed",
    "body_as_printed",
    "fk_as_printed",
]

INVERSE: dict[str, tuple[InverseEquations, ...]] = {
    "xl430-hexapod": (xl430_hexapod.INVERSE,),
    "krsri-hexapod": (krsri_hexapod.INVERSE,),
    "udiebot-quadruped": (udiebot_quadruped.INVERSE, udiebot_quadruped.TABLES),
    "eros-humanoid": (eros_humanoid.INVERSE,),
    "receptionist-arm": (receptionist_arm.INVERSE,),
}
FORWARD: dict[str, tuple[ForwardEquations, ...]] = {
    "udiebot-quadruped": (udiebot_quadruped.FORWARD,),
    "eros-humanoid": (eros_humanoid.HEAD, eros_humanoid.ARM),
    "receptionist-arm": (receptionist_arm.PRODUCT, receptionist_arm.MULTIPLIED),
}


def as_printed(
    robot: Robot,
    limb: Limb,
    target: ArrayLike,
    rotation: ArrayLike | None = None,
    *,
    printed: Iterable[str] | None = None,
) -> tuple[AsPrinted, ...]:
    """What the inverse equations of the robot's paper give for `target` (3,), metres, limb frame.

    Args:
        robot: its paper decides whose equations.
        limb: of `robot`.
        target: where the tip shall go.
        rotation: attitude (3, 3) of a sole, of which the papers know only the heading; level where
            not given.
        printed: the faulty equations to take letter for letter, the rest corrected; all where not given.

    Returns:
        The paper's variants; none where it prints no inverse kinematics for such a limb.
    """
    target = np.asarray(target, float)
    form = limb.closed_form
    found = []
    for equations in INVERSE.get(robot.paper or "", ()):
        if form is not None and form.kind == equations.kind:
            found.append(_inverse(equations, limb, form.lengths, target, rotation, printed))
    return tuple(found)


def _inverse(
    equations: InverseEquations,
    limb: Limb,
    lengths: tuple[float, ...],
    target: Array,
    rotation: ArrayLike | None,
    printed: Iterable[str] | None,
) -> AsPrinted:
    point = limb.from_limb(target, "paper")
    mirrored = equations.kind == "leg" and np.linalg.det(limb.paper_axes[:2, :2]) < 0
    attitude = None
    more: dict[str, float] = {}
    if limb.closed_form and limb.closed_form.needs_pose:
        attitude = np.eye(3) if rotation is None else np.asarray(rotation, float)
        more["heading"] = float(np.arctan2(attitude[1, 0], attitude[0, 0]))

    def solve(letter_for_letter: Printed) -> tuple[Array, str]:
        if not np.abs(point).max() <= FARTHEST:
            raise NotComputable("no equation has a value for a target so far away")
        q, remark = equations.solve(point, lengths, letter_for_letter, **more)
        # A left leg whose paper counts y forwards on both sides turns its coxa the other way.
        return (q * [-1, 1, 1] if mirrored else q), remark

    def cost(misprint: Misprint) -> tuple[float, str]:
        q, remark = solve(frozenset([misprint.equation]))
        return _distance(limb.fk(q)[:3, 3], target), _join(remark, misprint.remark)

    faults = _faults(equations.misprints, cost)
    try:
        q, remark = solve(_in_force(equations.misprints, printed))
    except NotComputable as missing:
        note = f"It cannot be evaluated: {missing}. {equations.note}"
        return AsPrinted(equations.variant, equations.where, None, None, None, note, faults)
    pose = limb.fk(q)
    if attitude is not None:
        tilt = np.linalg.norm(rotation_vector(pose[:3, :3] @ attitude.T))
        remark = f"the sole's attitude is off by {np.degrees(tilt):.1f} deg"
    own = equations.own_tip(q, lengths) if equations.own_tip else None
    return AsPrinted(
        equations.variant,
        equations.where,
        dict(zip(limb.joint_names, q.tolist(), strict=True)),
        pose[:3, 3],
        _distance(pose[:3, 3], target),
        f"{equations.note} Here: {remark}." if remark else equations.note,
        faults,
        own,
        None if own is None else _distance(own, target),
    )


def fk_as_printed(
    robot: Robot, limb: Limb, q: ArrayLike, *, printed: Iterable[str] | None = None
) -> tuple[FkAsPrinted, ...]:
    """What the forward equations of the robot's paper give for angles `q` (n,) in rad.

    Args:
        robot, limb: whose equations.
        q: the joint angles.
        printed: the faulty equations to take letter for letter, the rest corrected; all where not given.

    Returns:
        The paper's forms; none where it prints no forward kinematics for such a limb.
    """
    q = np.asarray(q, float)
    found = []
    for equations in FORWARD.get(robot.paper or "", ()):
        to_limb = limb.paper_axes if equations.frame == "paper" else np.eye(3)
        axes = np.array(equations.axes)
        if limb.axes.shape == axes.shape and np.allclose(limb.axes @ to_limb, axes):
            found.append(_forward(equations, limb, to_limb, q, printed))
    return tuple(found)


def _forward(
    equations: ForwardEquations, limb: Limb, to_limb: Array, q: Array, printed: Iterable[str] | None
) -> FkAsPrinted:
    lengths = tuple(np.linalg.norm(limb.links, axis=1).tolist())
    true = limb.fk(q)

    def pose(letter_for_letter: Printed) -> Array:
        T = equations.pose(q, lengths, letter_for_letter)
        return homogeneous(to_limb @ T[:3, :3] @ to_limb.T, to_limb @ T[:3, 3])

    def cost(misprint: Misprint) -> tuple[float, str]:
        T = pose(frozenset([misprint.equation]))
        return _distance(T[:3, 3], true[:3, 3]), misprint.remark

    faults = _faults(equations.misprints, cost)
    try:
        T = pose(_in_force(equations.misprints, printed))
    except NotComputable as missing:
        note = f"It cannot be evaluated: {missing}. {equations.note}"
        return FkAsPrinted(equations.where, None, None, None, note, faults)
    off = float(np.abs(T[:3, :3] - true[:3, :3]).max()) if equations.attitude else None
    return FkAsPrinted(equations.where, T, _distance(T[:3, 3], true[:3, 3]), off, equations.note, faults)


def body_as_printed(robot: Robot, xyz: ArrayLike, rpy: ArrayLike) -> BodyAsPrinted | None:
    """What the body equations of the robot's paper give for its standing feet; None where it prints none.

    Args:
        robot: of which every leg stands at its stance.
        xyz, rpy: the body's move: metres, and roll, pitch, yaw in rad.
    """
    legs = [(leg.name, leg.mount, leg.stance) for leg in robot.legs if leg.stance is not None]
    if robot.paper != "krsri-hexapod" or not legs:
        return None
    names = [name for name, _, _ in legs]
    hips = np.array([mount[:3, 3] for _, mount, _ in legs])
    feet = np.array([apply(mount, stance) for _, mount, stance in legs])
    true = apply(inverse(homogeneous(rpy_to_rotation(rpy), xyz)), feet)

    def off(printed: Printed) -> Array:
        moved = krsri_hexapod.body(feet, hips, xyz, rpy, printed)
        return np.asarray(np.hypot.reduce(moved - true, axis=1))

    def cost(misprint: Misprint) -> tuple[float, str]:
        return float(off(frozenset([misprint.equation])).max()), misprint.remark

    all_of_them = _in_force(krsri_hexapod.BODY, None)
    printed = krsri_hexapod.body(feet, hips, xyz, rpy, all_of_them)
    return BodyAsPrinted(
        krsri_hexapod.BODY_WHERE,
        dict(zip(names, printed, strict=True)),
        dict(zip(names, true, strict=True)),
        dict(zip(names, off(all_of_them).tolist(), strict=True)),
        krsri_hexapod.BODY_NOTE,
        _faults(krsri_hexapod.BODY, cost),
    )


def _in_force(misprints: tuple[Misprint, ...], printed: Iterable[str] | None) -> Printed:
    return frozenset(m.equation for m in misprints) if printed is None else frozenset(printed)


def _faults(
    misprints: tuple[Misprint, ...], cost: Callable[[Misprint], tuple[float, str]]
) -> tuple[Fault, ...]:
    found = []
    for misprint in misprints:
        metres: float | None
        try:
            metres, reason = cost(misprint)
        except NotComputable as missing:
            metres, reason = None, _join(str(missing), misprint.remark)
        found.append(Fault(misprint.equation, misprint.printed, misprint.corrected, metres, reason))
    return tuple(found)


def _join(*remarks: str) -> str:
    return "; ".join(filter(None, remarks))


def _distance(a: Array, b: Array) -> float:
    return float(np.hypot.reduce(a - b))
