"""What the station was set to the last time, as far as it still makes sense."""

from typing import TYPE_CHECKING, Any

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.robots.model import FRAMES

if TYPE_CHECKING:
    from kinlab.tui.stations.robot.station import RobotStation


def kept_in(station: "RobotStation", state: dict[str, Any]) -> None:
    """Take up a robot, a limb, a place; whatever does not fit the robots of today is left at its beginning."""
    robot = station.robots.get(str(state.get("robot")))
    limb = robot.limbs.get(str(state.get("limb"))) if robot else None
    if robot is None or limb is None:
        return
    station.set(robot, limb)
    if state.get("frame") in FRAMES:
        station.frame = str(state["frame"])
    target, rpy = _numbers(state.get("target_m"), 3), _numbers(state.get("rpy_rad"), 3)
    if target is not None and np.abs(target).max() < 1e3:
        station.target = target
    if rpy is not None:
        station.rpy = rpy
    station.angles = _numbers(state.get("angles_rad"), len(limb.joints))
    station.solution = str(state.get("solution") or "")
    station.ghost, station.bounds = bool(state.get("ghost")), bool(state.get("bounds", True))


def _numbers(values: Any, count: int) -> Array | None:
    """As many finite numbers; None where it is anything else."""
    if not isinstance(values, list) or len(values) != count:
        return None
    if not all(isinstance(v, int | float) and not isinstance(v, bool) and np.isfinite(v) for v in values):
        return None
    return np.array(values, float)
