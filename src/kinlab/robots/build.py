"""From the checked shape of a robots file to robots: what its figures mean together."""

from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np

from kinlab.kinematics.transforms import Array, homogeneous, rotation
from kinlab.names import suggestion
from kinlab.robots.model import Joint, Limb, Robot, frozen
from kinlab.robots.provenance import KINDS, UNSOURCED, Dimension, Provenance
from kinlab.robots.schema import (
    Area,
    Current,
    Group,
    JointSpec,
    Length,
    Mass,
    Member,
    PaperAxes,
    Point,
    Range,
    RobotSpec,
    ServoModelSpec,
    Sourced,
)
from kinlab.robots.servo import Servo, ServoModel

LEG = [
    JointSpec("coxa", "z", {"x": "coxa"}),
    JointSpec("femur", "-y", {"x": "femur"}),
    JointSpec("tibia", "-y", {"x": "tibia"}),
]
_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_EVERYWHERE = Range((-180.0, 180.0))
# A figure beyond this (mm) is a mistake of units in a desk robot's file.
LONGEST_MM = 100_000.0


class SpecError(Exception):
    """A robots file says something that cannot be; `place` is the path of the field, below the robot."""

    def __init__(self, place: tuple[Any, ...], message: str) -> None:
        super().__init__(message)
        self.place = place


def build_servo_model(name: str, spec: ServoModelSpec) -> ServoModel:
    """The servo model of a file's `servo_models`.

    Raises:
        SpecError: an empty range, or a step that is not positive.
    """
    low, high = spec.positions
    if low >= high:
        raise SpecError(("positions",), f"the range is inside out: {low} is not below {high}")
    for key in ("deg_per_step", "torque_nm", "speed_rpm"):
        if getattr(spec, key) <= 0:
            raise SpecError((key,), f"expected a positive number, got {getattr(spec, key):g}")
    speed = spec.speed_rpm * 2 * np.pi / 60
    model = ServoModel(
        name, spec.protocol, low, high, spec.deg_per_step, spec.torque_nm, speed, provenance(spec, ())
    )
    if spec.standby is None:
        return model
    place = ("standby",)
    if isinstance(spec.standby, Current):
        standby, source = spec.standby.ma, provenance(spec.standby, place)
    else:
        standby, source = spec.standby, UNSOURCED
    if standby < 0:
        raise SpecError(place, f"expected a current in mA, not below 0, got {standby:g}")
    return replace(model, standby=standby / 1000, standby_source=source)


def build_robot(name: str, spec: RobotSpec, models: dict[str, ServoModel]) -> Robot:
    """The robot of a file's `robots`.

    Raises:
        SpecError: figures that contradict each other, or names that refer to nothing.
    """
    limbs: dict[str, Limb] = {}
    taken: dict[tuple[str, int], str] = {}
    if not spec.groups:
        raise SpecError((), "a robot needs at least one group of limbs (legs, arms, ...)")
    for group_name, group in spec.groups.items():
        if not group.members:
            raise SpecError((group_name, "members"), "a group needs at least one limb")
        for limb in _limbs(group_name, group, models):
            place = (group_name, "members", limb.name)
            if limb.name in limbs:
                raise SpecError(place, f"limb {limb.name} exists already, in {limbs[limb.name].group}")
            for joint in limb.joints:
                if joint.servo:
                    key = (joint.servo.model.protocol, joint.servo.id)
                    mine = f"{limb.name} {joint.name}"
                    if key in taken:
                        raise SpecError(
                            (*place, "ids"), f"servo id {joint.servo.id} is taken by {taken[key]}"
                        )
                    taken[key] = mine
            limbs[limb.name] = limb
    body = [_length(key, value, ("body", key)) for key, value in spec.body.items()]
    mass, centre = None, np.zeros(3)
    if spec.mass is not None:
        body.append(_mass("mass", spec.mass, ("mass",)))
        mass = body[-1].value / 1000  # type: ignore[operator]
        parts = sum(joint.mass or 0.0 for limb in limbs.values() for joint in limb.joints)
        if parts > mass:
            raise SpecError(("mass",), f"the links alone weigh {parts * 1000:g} g")
    if spec.centre is not None:
        centre, source = _point(spec.centre, ("centre",))
        body.append(Dimension("centre of mass", tuple(centre.tolist()), "mm", source))
    return Robot(
        name, spec.title, spec.kind, spec.paper, MappingProxyType(limbs), tuple(body), tuple(spec.notes),
        mass, tuple((centre / 1000).tolist()),
    )  # fmt: skip


def _limbs(name: str, group: Group, models: dict[str, ServoModel]) -> list[Limb]:
    figures = {k: _length(k, v, (name, k)) for k, v in group.lengths.items()}
    specs = LEG if group.joints == "leg" else list(group.joints)
    joints = _joints(name, group, specs, figures)
    dimensions = list(figures.values())
    stance = None
    if group.stance is not None:
        point, source = _point(group.stance, (name, "stance"))
        stance = frozen(point / 1000)
        dimensions.append(Dimension("stance", tuple(point.tolist()), "mm", source))
    sole = None
    if group.sole is not None:
        area, source = (
            (group.sole.mm, provenance(group.sole, (name, "sole")))
            if isinstance(group.sole, Area)
            else (group.sole, UNSOURCED)
        )
        if not all(0 < side <= LONGEST_MM for side in area):
            raise SpecError((name, "sole"), "expected a length and a width in mm, above 0")
        sole = (area[0] / 1000, area[1] / 1000)
        dimensions.append(Dimension("sole", area, "mm", source))
    limbs = []
    for member_name, member in group.members.items():
        place = (name, "members", member_name)
        at, source = _point(member.at, (*place, "at"))
        mount = frozen(homogeneous(rotation((0, 0, 1), np.radians(member.turn)), at / 1000))
        axes = member.paper_axes or group.paper_axes
        axes_place = (*place, "paper_axes") if member.paper_axes else (name, "paper_axes")
        limbs.append(
            Limb(
                member_name,
                name,
                _servos(name, group, member_name, member, joints, models),
                mount,
                source,
                stance,
                *_paper_axes(axes, axes_place),
                tuple(dimensions),
                sole,
            )
        )
    return limbs


def _joints(
    name: str, group: Group, specs: list[JointSpec], figures: dict[str, Dimension]
) -> tuple[Joint, ...]:
    names = [s.name for s in specs]
    if not specs:
        raise SpecError((name, "joints"), "a limb needs at least one joint")
    for i, joint_name in enumerate(names):
        if joint_name in names[:i]:
            raise SpecError((name, "joints", i), f"joint '{joint_name}' stands here twice")
    for key in (*group.limits, *group.masses):
        if key not in names:
            part = "limits" if key in group.limits else "masses"
            raise SpecError((name, part, key), f"no joint is named '{key}'{suggestion(key, names)}")
    used: set[str] = set()
    joints = []
    for i, spec in enumerate(specs):
        link = _link(spec, figures, group.joints == "leg", (name,), (name, "joints", i, "link"))
        used.update(term.removeprefix("-") for term in spec.link.values())
        lower, upper, source = _limits(group.limits.get(spec.name, _EVERYWHERE), (name, "limits", spec.name))
        mass = group.masses.get(spec.name)
        kg, weighed = None, UNSOURCED
        if mass is not None:
            figure = _mass(spec.name, mass, (name, "masses", spec.name))
            kg, weighed = figure.value / 1000, figure.source  # type: ignore[operator]
        axis = _axis(spec.axis, (name, "joints", i, "axis"))
        joints.append(Joint(spec.name, axis, link, lower, upper, source, mass=kg, mass_source=weighed))
    if not used:
        raise SpecError((name, "joints"), "a limb needs at least one link")
    for key in figures:
        if key not in used:
            known = [*used, *(f for f in Group.__struct_fields__ if f != "lengths")]
            raise SpecError((name, key), f"no joint uses the length '{key}'{suggestion(key, known)}")
    return tuple(joints)


def _link(
    spec: JointSpec, figures: dict[str, Dimension], leg: bool, group: tuple[Any, ...], place: tuple[Any, ...]
) -> tuple[float, float, float]:
    link = dict.fromkeys(_AXES, 0.0)
    for direction, term in spec.link.items():
        key = term.removeprefix("-")
        if key not in figures and leg:
            near = suggestion(key, [f for f in figures if f not in {s.name for s in LEG}])
            raise SpecError(group, f"'{key}' is missing: the length of the {key} in mm{near}")
        if key not in figures:
            raise SpecError(place, f"no length is named '{key}'{suggestion(key, figures)}")
        if direction not in link:
            raise SpecError(place, f"a link goes along x, y and z, not '{direction}'")
        link[direction] = (-1 if term.startswith("-") else 1) * figures[key].value / 1000  # type: ignore[operator]
    return link["x"], link["y"], link["z"]


def _servos(
    name: str,
    group: Group,
    limb: str,
    member: Member,
    joints: tuple[Joint, ...],
    models: dict[str, ServoModel],
) -> tuple[Joint, ...]:
    place = (name, "members", limb)
    if member.mounting is None:
        if member.ids:
            raise SpecError((*place, "ids"), "servo ids without a mounting")
        return joints
    if member.mounting not in group.mountings:
        near = suggestion(member.mounting, group.mountings)
        raise SpecError((*place, "mounting"), f"no mounting is named '{member.mounting}'{near}")
    mounting = group.mountings[member.mounting]
    if len(member.ids) != len(joints):
        raise SpecError(
            (*place, "ids"), f"expected {len(joints)} servo ids, one a joint, got {len(member.ids)}"
        )
    worn = []
    for joint, number in zip(joints, member.ids, strict=True):
        there = (name, "mountings", member.mounting)
        if joint.name not in mounting:
            raise SpecError(there, f"'{joint.name}' is missing: the servo of that joint")
        spec = mounting[joint.name]
        if spec.model not in models:
            near = suggestion(spec.model, models)
            raise SpecError((*there, joint.name, "model"), f"no servo model is named '{spec.model}'{near}")
        if not 0 <= number <= 252:
            raise SpecError((*place, "ids"), f"expected a servo id of 0 to 252, got {number}")
        source = provenance(spec, (*there, joint.name))
        worn.append(replace(joint, servo=Servo(number, models[spec.model], spec.zero, spec.sign, source)))
    for key in mounting:
        if key not in [j.name for j in joints]:
            near = suggestion(key, [j.name for j in joints])
            raise SpecError((name, "mountings", member.mounting, key), f"no joint is named '{key}'{near}")
    return tuple(worn)


def provenance(spec: Sourced, place: tuple[Any, ...]) -> Provenance:
    """Where a figure comes from, of what its file says.

    Raises:
        SpecError: two sources at once.
    """
    given = [(kind, getattr(spec, kind)) for kind in KINDS if getattr(spec, kind) is not None]
    if len(given) > 1:
        names = " and ".join(kind for kind, _ in given)
        raise SpecError(place, f"a figure has one source, not {names} at once")
    if given and not given[0][1].strip():
        raise SpecError((*place, given[0][0]), "a source needs words: the place, or the reason")
    return Provenance(*given[0]) if given else UNSOURCED  # type: ignore[arg-type]


def _length(name: str, spec: float | Length, place: tuple[Any, ...]) -> Dimension:
    value, source = (
        (spec.mm, provenance(spec, place)) if isinstance(spec, Length) else (float(spec), UNSOURCED)
    )
    if not 0 < value <= LONGEST_MM:
        raise SpecError(place, f"expected a length in mm, above 0 and at most {LONGEST_MM:g}, got {value:g}")
    return Dimension(name, value, "mm", source)


def _mass(name: str, spec: float | Mass, place: tuple[Any, ...]) -> Dimension:
    value, source = (spec.g, provenance(spec, place)) if isinstance(spec, Mass) else (float(spec), UNSOURCED)
    if value <= 0:
        raise SpecError(place, f"expected a mass in g, above 0, got {value:g}")
    return Dimension(name, value, "g", source)


def _point(spec: Point | tuple[float, float, float], place: tuple[Any, ...]) -> tuple[Array, Provenance]:
    values, source = (spec.mm, provenance(spec, place)) if isinstance(spec, Point) else (spec, UNSOURCED)
    point = np.array(values, dtype=float)
    if (np.abs(point) > LONGEST_MM).any():
        raise SpecError(place, f"expected a place within {LONGEST_MM:g} mm")
    return point, source


def _limits(spec: Range | tuple[float, float], place: tuple[Any, ...]) -> tuple[float, float, Provenance]:
    (low, high), source = (
        (spec.deg, provenance(spec, place)) if isinstance(spec, Range) else (spec, UNSOURCED)
    )
    if low >= high:
        raise SpecError(place, f"the limits are inside out: {low:g} is not below {high:g}")
    return float(np.radians(low)), float(np.radians(high)), source


def _axis(spec: str | tuple[float, float, float], place: tuple[Any, ...]) -> tuple[float, float, float]:
    if isinstance(spec, str):
        sign = -1.0 if spec.startswith("-") else 1.0
        x, y, z = (sign * c + 0.0 for c in _AXES[spec[-1]])
        return x, y, z
    length = float(np.linalg.norm(spec))
    if length == 0:
        raise SpecError(place, "an axis must have a direction, got [0, 0, 0]")
    x, y, z = (float(c) / length for c in spec)
    return x, y, z


def _paper_axes(spec: PaperAxes | None, place: tuple[Any, ...]) -> tuple[Array, Provenance]:
    if spec is None:
        return np.eye(3), UNSOURCED
    columns = [_axis(getattr(spec, paper), place) for paper in "xyz"]
    if len({axis[-1] for axis in (spec.x, spec.y, spec.z)}) != 3:
        raise SpecError(place, "the paper's three axes must lie along three different axes of the limb")
    return frozen(np.array(columns).T), provenance(spec, place)
