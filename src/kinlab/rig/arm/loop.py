"""The control loop of the arm paper on a bus: READ position and load, compute, WRITE goal and speed, every cycle."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from kinlab.control import (
    AT_REST,
    Environment,
    Observed,
    PositionGains,
    compliance_control,
    low_pass,
    observe,
    position_control,
    yield_to,
)
from kinlab.dynamics import GRAVITY, Mechanism
from kinlab.dynamics.straight_line import inverse_equations
from kinlab.dynamixel import BusError
from kinlab.errors import KinlabError, UsageError
from kinlab.kinematics.resolved_motion import Track, inverse_step
from kinlab.kinematics.transforms import Array
from kinlab.names import resolve
from kinlab.rig.arm.record import Moment, Record
from kinlab.rig.arm.servos import ArmServos

KGF_CM = GRAVITY / 100  # N m
# What the paper prints: in section 4.1.2, and in table 4.1.
TEXT, TABLE_4_1 = PositionGains(3.8, 0.2), Environment(0.3, 12, 5, 1)
LAWS = ("none", "position", "compliance")
# A reference this far (rad) from its command has run away: a servo turns no further in all.
AWAY = math.pi
# A READ without an answer is repeated twice. A joint that does not answer then keeps its last reading, and the
# loop goes on; after this many such cycles in a row it stops.
PATIENCE = 10


class RunawayError(KinlabError):
    """The loop diverged.

    Attributes:
        time: s since the motion began.
        joint: that ran away.
    """

    def __init__(self, time: float, joint: str, away: float) -> None:
        angle = f"{math.degrees(away):.4g} deg" if math.isfinite(away) else "no finite angle"
        super().__init__(
            f"the loop ran away at {time:.3f} s: the reference of {joint} is {angle} from its command"
        )
        self.time, self.joint = time, joint


@dataclass(frozen=True)
class Settings:
    """What a loop is run with.

    Attributes:
        law: by name or the beginning of one: "none" (each goal is the present angle and one step of the
            inverse Jacobian), "position" (2.20) or "compliance" (2.26).
        gains, environment: of these.
        running_sum: sum accelerations up into rates without the cycle time. The paper prints no integration.
        alpha: of the torque's low-pass filter.
        dt: the cycle, s.
        cutoff: of the observers, 1/s.
        inertia: nominal, of a motor with its gear, kg m2.
    """

    law: str = "position"
    gains: PositionGains = TEXT
    environment: Environment = TABLE_4_1
    running_sum: bool = False
    alpha: float = 0.05
    dt: float = 0.016
    cutoff: float = 20.0
    inertia: float = 0.0026

    def __post_init__(self) -> None:
        object.__setattr__(self, "law", resolve(self.law, LAWS, "law"))
        self.environment.check()
        if not np.isfinite(self.gains).all():
            raise UsageError(f"gains must be finite, got Kp {self.gains.kp:g} and Kv {self.gains.kv:g}")
        if not 0 < self.alpha <= 1:
            raise UsageError(f"alpha of the filter is more than 0 and at most 1, got {self.alpha}")
        if not 0 < self.dt < math.inf:
            raise UsageError(f"the cycle must last longer than 0 s, got {self.dt}")


def run(
    servos: ArmServos, track: Track, settings: Settings, tell: Callable[[int, Record], None] | None = None
) -> Record:
    """Drive the arm along `track`, one of its points each cycle, and record everything.

    The servos hold, at the track's first point. Cycles begin `settings.dt` apart on the bus's clock; one
    that takes longer delays the next, and is recorded.

    Args:
        tell: called after each cycle with its number and the record so far.

    Raises:
        RunawayError: the loop diverged.
        KinlabError: a servo has not answered for PATIENCE cycles in a row.
    """
    pushes = servos.world.pushes if servos.world else ()
    record = Record.empty(servos.limb, track, settings.dt, servos.bus.port.clock.now(), pushes)
    loop = Loop(servos, track, settings, record.causes)
    servos.bus.tap = record.packets.append
    try:
        for k in range(len(track.q)):
            record.note(k, loop.cycle(k))
            if tell:
                tell(k, record)
            loop.wait()
    finally:
        servos.bus.tap = None
    return record


class Loop:
    """The loop, one cycle at a time.

    Attributes:
        machine: that computes; its settings may change between two cycles, but for their cycle time.
        causes: why answers were missed, and how often.
    """

    def __init__(
        self, servos: ArmServos, track: Track, settings: Settings, causes: dict[str, int] | None = None
    ) -> None:
        self.machine = Machine(servos, track, settings)
        self.causes = {} if causes is None else causes
        self._servos, self._clock = servos, servos.bus.port.clock
        self._silent = np.zeros(len(servos.servos), int)
        self._start = self._due = self._clock.now()
        if servos.world:
            servos.world.began = self._start

    def cycle(self, k: int) -> Moment:
        """READ, compute and WRITE for the track's point `k`.

        Raises:
            RunawayError, KinlabError: as `run`.
        """
        servos, machine, clock = self._servos, self.machine, self._clock
        begun = clock.now()
        missed = np.zeros(len(servos.servos), bool)
        for j in range(len(missed)):
            try:
                machine.real[j], machine.load[j] = servos.read(j)
            except BusError as error:
                self._miss(j, missed, error)
        machine.step(k, begun - self._start)
        for j in range(len(missed)):
            try:
                servos.write(j, machine.reference[j], machine.rate[j])
            except BusError as error:
                self._miss(j, missed, error)
        self._silent = np.where(missed, self._silent + 1, 0)
        if self._silent.max() >= PATIENCE:
            joint = servos.limb.joint_names[int(self._silent.argmax())]
            raise KinlabError(
                f"the {joint} has not answered for {PATIENCE} cycles, until {begun - self._start:.3f} s"
            )
        return Moment.of(begun - self._start, clock.now() - begun, missed, machine, servos.world)

    def wait(self) -> None:
        """Until the next cycle is due."""
        self._due = max(self._due + self.machine.settings.dt, self._clock.now())
        self._clock.wait(self._due - self._clock.now())

    def _miss(self, joint: int, missed: Array, error: BusError) -> None:
        missed[joint] = True
        self.causes[error.cause] = self.causes.get(error.cause, 0) + 1


class Machine:
    """The state of a control loop, without a bus.

    Attributes:
        settings: that it computes with.
        command: (n,) where the track is, rad.
        real, load: (n,) what was read last: rad, N m.
        reference, rate: (n,) what is written next: rad, rad/s.
        filtered, dynamic, external: (n,) torques, N m: load through the filter, by Newton and Euler, and
            their difference (2.23).
        yielding: how far the environment has given way.
        disturbance, reaction: the observers.
    """

    def __init__(self, servos: ArmServos, track: Track, settings: Settings) -> None:
        self.limb, self.track, self.settings = servos.limb, track, settings
        self._inverse = inverse_equations(Mechanism.of(servos.limb))
        self.command = track.q[0]
        self.real, self.load = track.q[0].copy(), np.zeros(track.q.shape[1])
        self.reference, self.rate = self.real.copy(), np.zeros_like(self.load)
        self.filtered = self.dynamic = self.external = np.zeros_like(self.load)
        self.yielding = AT_REST
        self.disturbance: Observed | None = None
        self.reaction: Observed | None = None
        self.damping = 0.0
        self._before: Array | None = None

    def step(self, k: int, t: float) -> None:
        """Compute a cycle from what was read: the track's point `k`, `t` seconds after the beginning."""
        settings, track = self.settings, self.track
        self.command = track.q[k]
        real_rate = (self.real - (self.real if self._before is None else self._before)) / settings.dt
        self._estimate(track.qd[k], track.qdd[k], real_rate)
        self._before = self.real.copy()
        if settings.law == "none":
            self._follow_blindly(k)
        else:
            command = (track.q[k], track.qd[k], self.real, real_rate)
            if settings.law == "position":
                acceleration = position_control(settings.gains, *command)
            else:
                torque = self.external / KGF_CM
                self.yielding = yield_to(settings.environment, self.yielding, torque, settings.dt)
                acceleration = compliance_control(
                    settings.gains, settings.environment, *command, given_way=self.yielding
                )
            self.rate = self.rate + acceleration * (1.0 if settings.running_sum else settings.dt)
            self.reference = self.reference + settings.dt * self.rate
        away = self.reference - track.q[k]
        if not np.abs(away).max() <= AWAY:
            worst = int(np.argmax(np.where(np.isfinite(away), np.abs(away), np.inf)))
            raise RunawayError(t, self.limb.joint_names[worst], float(away[worst]))

    def _estimate(self, qd: Array, qdd: Array, real_rate: Array) -> None:
        settings, first = self.settings, self._before is None
        self.filtered = self.load.copy() if first else low_pass(self.filtered, self.load, settings.alpha)
        self.dynamic = np.array(self._inverse(*self.real.tolist(), *qd.tolist(), *qdd.tolist()))
        self.external = self.filtered - self.dynamic
        motor = (self.load, real_rate, settings.inertia, settings.cutoff, settings.dt)
        self.disturbance = observe(self.disturbance, *motor)
        self.reaction = observe(self.reaction, *motor, known=self.dynamic)

    def _follow_blindly(self, k: int) -> None:
        # Section 4.1.1: theta + J^-1 dX, from where the arm is, with the step that the trajectory makes.
        points = self.track.points
        dX = points[min(k + 1, len(points) - 1)] - points[k]
        taken = inverse_step(self.limb.axes, self.limb.links, self.real, dX)
        self.reference, self.damping = self.real + taken.dq, taken.damping
        self.rate = taken.dq / self.settings.dt
