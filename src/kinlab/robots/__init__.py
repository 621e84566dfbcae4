"""Robots: what they are, where their figures come from, and their files."""

from kinlab.robots.load import load_robot, load_robots, robot_names
from kinlab.robots.model import Joint, Limb, Robot
from kinlab.robots.provenance import Dimension, Provenance
from kinlab.robots.servo import Servo, ServoModel

__all__ = [
    "Dimension",
    "Joint",
    "Limb",
    "Provenance",
    "Robot",
    "Servo",
    "ServoModel",
    "load_robot",
    "load_robots",
    "robot_names",
]
