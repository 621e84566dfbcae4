"""A limb's servos behind a bus: their registers as angles and torques of the joints, and torque off at the end."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from types import TracebackType

from kinlab.dynamixel import Bus, Chain, MemoryPort
from kinlab.dynamixel.outfit import worn_by
from kinlab.dynamixel.ports import open_port
from kinlab.dynamixel.tables import load_table
from kinlab.errors import KinlabError, UsageError
from kinlab.rig.arm.push import Push
from kinlab.rig.arm.world import World, WorldClock
from kinlab.rig.release import torque_off
from kinlab.robots import Limb, Robot

MEASURED = ("present_position", "present_speed", "present_load")
COMMANDED = ("goal_position", "moving_speed")
RPM = math.pi / 30
# How a real arm goes to its start, rad/s, how near is there, rad, and how long it may take, s.
GENTLE, NEAR, PATIENCE = math.radians(30), math.radians(4), 15.0


@dataclass(frozen=True)
class Setup:
    """How the servos are set up before they move; the defaults are printed in section 2.3.2 of the arm paper.

    Attributes:
        slope, margin, punch: registers of the servo's own compliance. No punch is printed: the factory's.
        torque_limit: the most that they may give, share of their stall torque.
        speed_limit: the most that they are told to turn, rad/s.
    """

    slope: int = 64
    margin: int = 0
    punch: int = 32
    torque_limit: float = 1.0
    speed_limit: float = math.inf

    def __post_init__(self) -> None:
        for name, most in (("slope", 254), ("margin", 255), ("punch", 1023)):
            if not 0 <= getattr(self, name) <= most:
                raise UsageError(f"the {name} of a servo is 0 to {most}, got {getattr(self, name)}")
        if not 0 < self.torque_limit <= 1:
            raise UsageError(
                f"the torque limit is a share, more than 0 and at most 1, got {self.torque_limit}"
            )
        if not self.speed_limit > 0:
            raise UsageError(f"the speed limit must be more than 0, got {self.speed_limit}")

    def registers(self) -> dict[str, int]:
        """What is written, by register."""
        sides = {"compliance_slope": self.slope, "compliance_margin": self.margin}
        both = {f"{side}_{name}": value for name, value in sides.items() for side in ("cw", "ccw")}
        return both | {"punch": self.punch, "torque_limit": round(1023 * self.torque_limit)}


# Only READ is answered (section 2.3.2 c): a WRITE costs the bus half as much.
ANSWER_READS = 1
SETTLING = 0.1  # s in which an arm that was just switched on sags until its servos carry it


class ArmServos:
    """The servos of one limb on a bus. Whatever happens inside its `with`, their torque is off afterwards.

    Attributes:
        bus: that they are on.
        world: what turns on the emulated ones; None where the arm is real.
        setup: of the servos.
        unconfirmed: ids of servos that did not confirm that their torque is off.
    """

    def __init__(self, limb: Limb, bus: Bus, setup: Setup, world: World | None = None) -> None:
        self.limb, self.bus, self.setup, self.world = limb, bus, setup, world
        self.unconfirmed: tuple[int, ...] = ()
        self.servos = [joint.servo for joint in limb.joints if joint.servo]
        if len(self.servos) != len(limb.joints) or any(s.model.protocol != "1.0" for s in self.servos):
            raise UsageError(
                f"{limb.name} has joints without servos of Protocol 1.0, which this loop is written for"
            )
        self.ids = [servo.id for servo in self.servos]
        self._registers = [[bus.register(i, name) for name in MEASURED] for i in self.ids]
        self._goals = [[bus.register(i, name) for name in COMMANDED] for i in self.ids]
        self._stall = [load_table(s.model.name).stall_nm for s in self.servos]

    @classmethod
    def emulated(
        cls,
        robot: Robot,
        limb: Limb,
        start: Sequence[float],
        pushes: Sequence[Push] = (),
        setup: Setup | None = None,
    ) -> "ArmServos":
        """The robot's chain in memory at 1 Mbps, with the limb's links on it, at the angles `start` (n,) in rad."""
        chain = Chain.of(worn_by(robot))
        world = World(limb, chain, pushes)
        world.place(start)
        port = MemoryPort(chain, WorldClock(chain, world))
        return cls(limb, Bus(port, protocol=1), setup or Setup(), world)

    @classmethod
    def real(cls, limb: Limb, port: str, baud: int, setup: Setup) -> "ArmServos":
        """Servos behind a serial port.

        Raises:
            PortError: it cannot be opened.
            BusError: a servo does not answer.
        """
        line = open_port(port, baud)
        try:
            return cls(limb, Bus(line, protocol=1), setup)
        except BaseException:
            line.close()
            raise

    def __enter__(self) -> "ArmServos":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            self.release()
        finally:
            self.bus.close()
        if self.unconfirmed:
            why = "interrupted" if isinstance(error, KeyboardInterrupt) else str(error or "the run is over")
            ids = ", ".join(map(str, self.unconfirmed))
            raise KinlabError(
                f"{why}; no word from servo {ids} that its torque is off: cut the power"
            ) from error

    def hold(self) -> None:
        """Set the servos up and switch the torque on, with every joint where it is; the arm comes to rest.

        Raises:
            BusError: a servo does not answer.
        """
        for i in self.ids:
            if self.bus.read(i, "status_return_level") != ANSWER_READS:
                self.bus.write(i, "status_return_level", ANSWER_READS)
        for i in self.ids:
            for name, value in self.setup.registers().items():
                self.bus.write(i, name, value)
            self.bus.write(i, "goal_position", int(self.bus.read(i, "present_position")))
            self.bus.write(i, "torque_enable", 1)
        self.bus.port.clock.wait(SETTLING)

    def release(self) -> None:
        """Switch the torque off, and note which servos did not confirm it."""
        self.unconfirmed = torque_off(self.bus, self.ids)

    def read(self, joint: int) -> tuple[float, float]:
        """Where a joint is, rad, and the torque that its servo gives, N m, by one READ.

        Raises:
            BusError: it does not answer.
        """
        servo = self.servos[joint]
        ticks = self.bus.read_block(servo.id, self._registers[joint])
        degrees = ticks["present_position"] * servo.model.deg_per_step
        angle = math.radians(servo.sign * (degrees - servo.zero_deg))
        return angle, servo.sign * self._stall[joint] * self._registers[joint][2].physical(
            ticks["present_load"]
        ) / 100

    def write(self, joint: int, angle: float, speed: float) -> None:
        """Send a joint to `angle`, rad, at `speed`, rad/s, by one WRITE; no further than its servo turns.

        Raises:
            BusError: it does not answer.
        """
        servo, (goal, moving) = self.servos[joint], self._goals[joint]
        degrees = servo.zero_deg + servo.sign * math.degrees(angle)
        ticks = round(min(max(degrees / servo.model.deg_per_step, servo.model.lowest), servo.model.highest))
        # A speed of 0 would mean: as fast as you can.
        turns = round(min(abs(speed), self.setup.speed_limit) / (moving.scale * RPM))
        self.bus.write_block(servo.id, {goal: ticks, moving: max(1, min(1023, turns))})

    def approach(self, start: Sequence[float]) -> None:
        """Go gently to `start` (n,), rad, and wait until the joints are there.

        Raises:
            KinlabError: they do not come near it.
        """
        for j, angle in enumerate(start):
            self.write(j, angle, GENTLE)
        clock = self.bus.port.clock
        deadline = clock.now() + PATIENCE
        while True:
            away = [abs(self.read(j)[0] - angle) for j, angle in enumerate(start)]
            if max(away) <= NEAR:
                return
            if clock.now() > deadline:
                worst = away.index(max(away))
                raise KinlabError(
                    f"the {self.limb.joint_names[worst]} is still {math.degrees(away[worst]):.1f} deg from the start "
                    f"after {PATIENCE:g} s"
                )
            clock.wait(0.05)
