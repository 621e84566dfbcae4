"""An arm that goes its way for as long as somebody looks, while gains, law and a hand on it change."""

from collections import deque
from itertools import islice

import numpy as np

from kinlab.control import Environment, PositionGains
from kinlab.control.laws import AT_REST
from kinlab.errors import UsageError
from kinlab.kinematics.resolved_motion import Track
from kinlab.kinematics.transforms import Array
from kinlab.rig.arm.loop import TABLE_4_1, TEXT, Loop, Settings
from kinlab.rig.arm.record import Moment
from kinlab.rig.arm.servos import ArmServos
from kinlab.robots import Limb, Robot

KEPT = 5.0  # s of cycles that are kept
# Gains to begin with. Those that are printed run away on an arm that goes on and on; the firm ones, which are
# nobody's but ours, follow the line within 7 deg and come back from a push of 3 N.
GAIN_SETS = {
    "firm": (PositionGains(20, 8), Environment(0.1, 12, 8, 1)),
    "printed": (TEXT, TABLE_4_1),
}


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
        self._closed = False

    def __enter__(self) -> "Lab":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Switch the torque off, once."""
        if not self._closed:
            self._closed = True
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

    @property
    def off(self) -> float:
        """How far the hand was from its place on the line in the last cycle, m; 0 before the first."""
        if not self.moments:
            return 0.0
        angles = self.moments[-1].angles
        real, wanted = (self.limb.fk(angles[name])[:3, 3] for name in ("real", "command"))
        return float(np.linalg.norm(real - wanted))

    def trail(self, seconds: float) -> Array:
        """Where the hand was in the last `seconds` (N, 3), limb frame, m, the oldest first."""
        return np.asarray(self.limb.fk(self.column("real", seconds))[..., :3, 3])

    def column(self, name: str, seconds: float = KEPT) -> Array:
        """The last `seconds` of an angle (rad) or a torque (N m) of each joint (N, n), by its name in `Moment`."""
        count = round(seconds / self.settings.dt)
        kept = islice(self.moments, max(len(self.moments) - count, 0), None)
        rows = [(m.angles if name in m.angles else m.torques)[name] for m in kept]
        return np.array(rows).reshape(-1, len(self.limb.joints))

    @property
    def times(self) -> Array:
        """When the cycles that are kept began (N,), s."""
        return np.array([moment.t for moment in self.moments])
