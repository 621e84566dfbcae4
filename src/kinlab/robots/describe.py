"""A robot as data for people and for other programs: every figure with its source."""

from typing import Any

import numpy as np

from kinlab.robots.model import Limb, Robot
from kinlab.robots.provenance import Dimension, Provenance


def describe(robot: Robot) -> dict[str, Any]:
    """Everything about a robot, in mm, degrees and grams; `source` and `why` beside each figure."""
    return {
        "robot": robot.name,
        "title": robot.title,
        "kind": robot.kind,
        "paper": robot.paper,
        "notes": list(robot.notes),
        "body": [_figure(d) for d in robot.dimensions],
        "limbs": [_limb(limb) for limb in robot.limbs.values()],
    }


def _limb(limb: Limb) -> dict[str, Any]:
    yaw = float(np.degrees(np.arctan2(limb.mount[1, 0], limb.mount[0, 0])))
    return {
        "limb": limb.name,
        "group": limb.group,
        "lengths": [_figure(d) for d in limb.dimensions],
        "mount": {
            "at_mm": [float(v) for v in limb.mount[:3, 3] * 1000],
            "turn_deg": yaw,
            **_source(limb.mount_source),
        },
        "paper_axes": {"to_limb": limb.paper_axes.tolist(), **_source(limb.paper_source)},
        "closed_form": limb.closed_form.kind if limb.closed_form else None,
        "joints": [
            {
                "joint": joint.name,
                "axis": list(joint.axis),
                "link_mm": [v * 1000 for v in joint.link],
                "mass_g": None if joint.mass is None else joint.mass * 1000,
                "mass": None if joint.mass is None else _source(joint.mass_source),
                "limits_deg": [round(float(v), 9) for v in np.degrees(limits)],
                "set_by_servo": [limits[0] > joint.lower, limits[1] < joint.upper],
                "limits": _source(joint.limit_source),
                "servo": None
                if joint.servo is None
                else {
                    "id": joint.servo.id,
                    "model": joint.servo.model.name,
                    "zero_deg": joint.servo.zero_deg,
                    "sign": joint.servo.sign,
                    **_source(joint.servo.source),
                },
            }
            for joint, limits in zip(limb.joints, limb.limits.T.tolist(), strict=True)
        ],
    }


def _figure(dimension: Dimension) -> dict[str, Any]:
    value = list(dimension.value) if isinstance(dimension.value, tuple) else dimension.value
    return {"name": dimension.name, "value": value, "unit": dimension.unit, **_source(dimension.source)}


def _source(source: Provenance) -> dict[str, str]:
    return {"source": source.kind, "why": source.text}
