"""The limb in 3-D as well: its pose goes to a rerun viewer on this machine, as long as a person wishes."""

import os
from typing import TYPE_CHECKING

from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb, Robot

if TYPE_CHECKING:
    from kinlab.scene import Mirror


class Reflection:
    """A mirror that is opened for the robot of now, and closed when it is no longer wished for."""

    def __init__(self) -> None:
        self._mirror: Mirror | None = None

    def show(self, robot: Robot, limb: Limb, q: Array | None) -> None:
        """Show a pose (n,), rad; another robot takes the place of the one before.

        Raises:
            KinlabError: no viewer answers, rerun is not installed, or the session is a guest's.
        """
        if self._mirror is None or self._mirror.robot is not robot:
            self.close()
            # What rerun would print stands in the middle of the screen.
            os.environ.setdefault("RUST_LOG", "off")
            from kinlab.scene import Mirror

            self._mirror = Mirror(robot)
        if q is not None:
            self._mirror.show({limb.name: q})

    def close(self) -> None:
        """Let go of the viewer.

        Raises:
            KinlabError: it is gone.
        """
        mirror, self._mirror = self._mirror, None
        if mirror is not None:
            mirror.close()
