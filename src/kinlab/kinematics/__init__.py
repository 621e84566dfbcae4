"""Kinematics on arrays alone: it knows no robot, only axes, links and angles, in metres and radians."""

from kinlab.kinematics.chain import fk, frames, jacobian, manipulability
from kinlab.kinematics.closed_form import ClosedForm, recognise

__all__ = ["ClosedForm", "fk", "frames", "jacobian", "manipulability", "recognise"]
