"""Control laws and observers: pure functions of arrays, joint by joint. What runs them on a bus is `kinlab.rig`."""

from kinlab.control.laws import (
    AT_REST,
    Environment,
    PositionGains,
    Yielding,
    compliance_control,
    low_pass,
    position_control,
    yield_to,
)
from kinlab.control.observers import Observed, observe
from kinlab.control.response import SecondOrder, sampled_radius

__all__ = [
    "AT_REST",
    "Environment",
    "Observed",
    "PositionGains",
    "SecondOrder",
    "Yielding",
    "compliance_control",
    "low_pass",
    "observe",
    "position_control",
    "sampled_radius",
    "yield_to",
]
