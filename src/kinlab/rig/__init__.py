"""The path itself: a robot wired to a bus, driven along targets and trajectories, and measured."""

from kinlab.rig.follow import Sample, follow
from kinlab.rig.path import Path, path_of
from kinlab.rig.record import Record
from kinlab.rig.result import WalkResult, costs
from kinlab.rig.rig import Reading, Rig
from kinlab.rig.treadmill import Treadmill
from kinlab.rig.walking import Errand, Order, Throttle, check_steady, prepare, span, sweep, walk_on

__all__ = [
    "Errand",
    "Order",
    "Path",
    "Reading",
    "Record",
    "Rig",
    "Sample",
    "Throttle",
    "Treadmill",
    "WalkResult",
    "check_steady",
    "costs",
    "follow",
    "path_of",
    "prepare",
    "span",
    "sweep",
    "walk_on",
]
