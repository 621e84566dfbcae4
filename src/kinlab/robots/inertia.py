"""What the links weigh, and how that is spread: each a rod, with its centre of mass in the middle."""

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.robots.model import Joint

# A link whose mass nobody printed still needs one, or no simulator loads the model.
ASSUMED_KG = 0.05
RADIUS = 0.006


def link_inertia(joint: Joint) -> tuple[float, Array, Array]:
    """Mass (kg), centre of mass (3,) in m, and inertia (3, 3) about it in kg m2, in the frame of the link.

    The arm paper takes each link for a slender rod with its centre of mass in the middle (section 3.4). All
    links are taken so, with a radius of RADIUS that gives them an inertia about their own length too.
    """
    along = np.array(joint.link)
    length = float(np.linalg.norm(along))
    mass = joint.mass or ASSUMED_KG
    thin, full = mass * RADIUS**2 / 2, mass * (length**2 / 12 + RADIUS**2 / 4)
    direction = along / length if length else np.array([0.0, 0.0, 1.0])
    return mass, along / 2, full * np.eye(3) + (thin - full) * np.outer(direction, direction)
