"""An arm that goes its way for as long as somebody looks, while gains, law and a hand on it change."""

from collections import deque

from kinlab.control.laws import AT_REST
from kinlab.errors import UsageError
from kinlab.kinematics.resolved_motion import Track
from kinlab.rig.arm.loop import Loop, Settings
from kinlab.rig.arm.record import Moment
from kinlab.rig.arm.servos import ArmServos
from kinlab.robots import Limb, Robot

KEPT = 5.0  # s of cycles that are kept


class Lab:
    """The loop on an emulated arm, in simulated time, which goes on only when it is asked to.

    with Lab(robot, limb, track, Settings("compliance")) as lab:
        lab.lean((-5.0, 0.0, 0.0))
        lab.cycle().torques["reaction"]

    Attributes:
        limb: that moves.
        track: that it goes along, again and again; it ends where it begins.
        moments: the latest cycles, oldest first.
    """

    def __init__(self, robot: Robot, limb: Limb, track: Track, settings: Settings) -> None:
        """Put the arm at the beginning of the track and switch its torque on, which stays on until `close`."""
        self.limb, self.track = limb, track
        self.moments: deque[Moment] = deque(maxlen=round(KEPT / settings.dt))
        self._servos = ArmServos.emulated(robot, limb, track.q[0].tolist())
        self._servos.hold()
        self._loop = Loop(self._servos, track, settings)
        self._count = 0

    def __enter__(self) -> "Lab":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Switch the torque off."""
        self._servos.__exit__(None, None, None)

    @property
    def settings(self) -> Settings:
        """What the loop is run with; may be set anew between two cycles.

        Raises:
            UsageError: another cycle time.
        """
        return self._loop.machine.settings

    @settings.setter
    def settings(self, settings: Settings) -> None:
        machine = self._loop.machine
        if settings.dt != machine.settings.dt:
            raise UsageError("the cycle time of a loop that runs cannot change")
        if settings.law != machine.settings.law:
            machine.yielding = AT_REST
        machine.settings = settings

    def lean(self, force: tuple[float, float, float] | None) -> None:
        """From now on somebody leans on the hand with `force` (3,), N, in the limb frame; None: nobody does."""
        assert self._servos.world, "an emulated arm has a world"
        self._servos.world.lean(force)

    def cycle(self) -> Moment:
        """One cycle.

        Raises:
            RunawayError: the loop diverged.
            KinlabError: a servo has not answered for long.
        """
        moment = self._loop.cycle(self._count % len(self.track.q))
        self.moments.append(moment)
        self._loop.wait()
        self._count += 1
        return moment
