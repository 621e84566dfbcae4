"""An arm on its bus: the control loop of the receptionist's arm, on emulated servos or real ones."""

from kinlab.rig.arm.lab import GAIN_SETS, Lab
from kinlab.rig.arm.loop import LAWS, RunawayError, Settings, run
from kinlab.rig.arm.push import Push, parse_push
from kinlab.rig.arm.record import Moment, Record
from kinlab.rig.arm.servos import ArmServos, Setup
from kinlab.rig.arm.world import World, WorldClock

__all__ = [
    "GAIN_SETS",
    "LAWS",
    "ArmServos",
    "Lab",
    "Moment",
    "Push",
    "Record",
    "RunawayError",
    "Settings",
    "Setup",
    "World",
    "WorldClock",
    "parse_push",
    "run",
]
