"""The robots that lessons speak of."""

from kinlab import robots
from kinlab.robots.load import shipped_robot


def load_robot(name: str) -> robots.Robot:
    """KinLab's own robot of that name, though a user's file may replace it: every student's answers are the same.

    A robot that KinLab has not comes from the user's file.

    Raises:
        UsageError: there is none.
    """
    return shipped_robot(name) or robots.load_robot(name)
