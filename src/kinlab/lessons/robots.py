"""The robots that lessons speak of, and their gaits: KinLab's own, so that every student has the same answers."""

from typing import TYPE_CHECKING

from kinlab import robots
from kinlab.robots import Robot
from kinlab.robots.load import shipped_robot

if TYPE_CHECKING:
    from kinlab.gait import Gait


def load_robot(name: str) -> Robot:
    """KinLab's own robot of that name, though a user's file may replace it.

    A robot that KinLab has not comes from the user's file.

    Raises:
        UsageError: there is none.
    """
    return shipped_robot(name) or robots.load_robot(name)


def find_gait(robot: Robot, name: str | None = None) -> "Gait":
    """KinLab's own gait of that name for `robot` (the first of its kind where it is None), as `load_robot`.

    Raises:
        UsageError: there is none.
    """
    from kinlab import gait

    fitting = {key: each for key, each in gait.shipped_gaits().items() if each.kind == robot.kind}
    found = next(iter(fitting.values()), None) if name is None else fitting.get(name)
    return found or gait.find_gait(robot, name)
