"""Dynamics of serial chains: torques for a motion, motion for torques, friction, energy; in SI units."""

from kinlab.dynamics.friction import Friction
from kinlab.dynamics.mechanism import GRAVITY, Mechanism
from kinlab.dynamics.motion import forward_dynamics, kinetic_energy, mass_matrix, potential_energy
from kinlab.dynamics.newton_euler import TIP, Contact, gravity_torque, inverse_dynamics

__all__ = [
    "GRAVITY",
    "TIP",
    "Contact",
    "Friction",
    "Mechanism",
    "forward_dynamics",
    "gravity_torque",
    "inverse_dynamics",
    "kinetic_energy",
    "mass_matrix",
    "potential_energy",
]
