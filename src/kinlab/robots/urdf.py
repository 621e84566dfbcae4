"""A robot as URDF, for pinocchio, MuJoCo, RViz and the like: the same joints, axes, links and limits."""

from xml.etree import ElementTree as ET

import numpy as np

from kinlab.kinematics.transforms import Array, rotation_to_rpy
from kinlab.robots.inertia import ASSUMED_KG, RADIUS, link_inertia
from kinlab.robots.model import Joint, Limb, Robot

# Joints of a robot whose servo is not printed.
ASSUMED_TORQUE, ASSUMED_SPEED = 2.0, 6.0


def to_urdf(robot: Robot) -> str:
    """The model as XML text: base link `body`, joints `<limb>_<joint>`, tip links `<limb>_tip`; metres, radians."""
    root = ET.Element("robot", name=robot.name)
    root.append(
        ET.Comment(
            f" From KinLab's robot file. Masses are those of the file, else {ASSUMED_KG * 1000:g} g "
            "a link, assumed. "
        )
    )
    base = ET.SubElement(root, "link", name="body")
    _shape(base, np.zeros(3), "box")
    for limb in robot.limbs.values():
        _limb(root, limb)
    ET.indent(root)
    return '<?xml version="1.0"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def _limb(root: ET.Element, limb: Limb) -> None:
    parent, offset = "body", limb.mount[:3, 3]
    rpy = rotation_to_rpy(limb.mount[:3, :3])
    for i, joint in enumerate(limb.joints):
        link = f"{limb.name}_{joint.name}_link"
        element = ET.SubElement(root, "joint", name=f"{limb.name}_{joint.name}", type="revolute")
        ET.SubElement(element, "origin", xyz=_numbers(offset), rpy=_numbers(rpy))
        ET.SubElement(element, "parent", link=parent)
        ET.SubElement(element, "child", link=link)
        ET.SubElement(element, "axis", xyz=_numbers(limb.axes[i]))
        servo = joint.servo.model if joint.servo else None
        lower, upper = limb.limits[:, i]
        ET.SubElement(
            element, "limit", lower=_number(lower), upper=_number(upper),
            effort=_number(servo.torque if servo else ASSUMED_TORQUE),
            velocity=_number(servo.speed if servo else ASSUMED_SPEED),
        )  # fmt: skip
        _link(root, link, joint)
        parent, offset, rpy = link, limb.links[i], np.zeros(3)
    tip = ET.SubElement(root, "joint", name=f"{limb.name}_tip", type="fixed")
    ET.SubElement(tip, "origin", xyz=_numbers(offset), rpy="0 0 0")
    ET.SubElement(tip, "parent", link=parent)
    ET.SubElement(tip, "child", link=f"{limb.name}_tip")
    ET.SubElement(root, "link", name=f"{limb.name}_tip")


def _link(root: ET.Element, name: str, joint: Joint) -> None:
    element = ET.SubElement(root, "link", name=name)
    mass, centre, I = link_inertia(joint)  # noqa: E741 - the field's name
    inertial = ET.SubElement(element, "inertial")
    ET.SubElement(inertial, "origin", xyz=_numbers(centre), rpy="0 0 0")
    ET.SubElement(inertial, "mass", value=_number(mass))
    names = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    values = (I[0, 0], I[0, 1], I[0, 2], I[1, 1], I[1, 2], I[2, 2])
    ET.SubElement(inertial, "inertia", dict(zip(names, map(_number, values), strict=True)))
    if centre.any():
        _shape(element, 2 * centre, "cylinder")


def _shape(element: ET.Element, along: Array, kind: str) -> None:
    visual = ET.SubElement(element, "visual")
    if kind == "box":
        ET.SubElement(ET.SubElement(visual, "geometry"), "box", size="0.06 0.04 0.02")
        return
    length = float(np.linalg.norm(along))
    # The cylinder lies along z; pitch, then yaw, bring it along the link.
    pitch = np.arctan2(np.hypot(along[0], along[1]), along[2])
    yaw = np.arctan2(along[1], along[0])
    ET.SubElement(visual, "origin", xyz=_numbers(along / 2), rpy=_numbers([0.0, pitch, yaw]))
    geometry = ET.SubElement(visual, "geometry")
    ET.SubElement(geometry, "cylinder", radius=_number(RADIUS), length=_number(length))


def _number(value: float) -> str:
    return repr(float(value) + 0.0)


def _numbers(values: Array | list[float]) -> str:
    return " ".join(_number(v) for v in values)
