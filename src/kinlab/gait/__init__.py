"""Gaits: schedules, foot trajectories, walking, stability, and what servos and legs allow."""

from kinlab.gait.cycle import Cycle, cycle_of
from kinlab.gait.limits import Limits, assess
from kinlab.gait.motion import Motion
from kinlab.gait.plan import plan
from kinlab.gait.schedule import Event, Gait, Phase, wave_gait, wave_margin
from kinlab.gait.stability import Stability, least_margins, stability, theory
from kinlab.gait.swing import CURVES, Curve, find_curve, jumps
from kinlab.gait.table import find_gait, gaits_for, load_gaits, shipped_gaits
from kinlab.gait.walk import Walk

__all__ = [
    "CURVES",
    "Curve",
    "Cycle",
    "Event",
    "Gait",
    "Limits",
    "Motion",
    "Phase",
    "Stability",
    "Walk",
    "assess",
    "cycle_of",
    "find_curve",
    "find_gait",
    "gaits_for",
    "jumps",
    "least_margins",
    "load_gaits",
    "plan",
    "shipped_gaits",
    "stability",
    "theory",
    "wave_gait",
    "wave_margin",
]
