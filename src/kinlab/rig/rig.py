"""A robot on a bus: angles go out, what the servos report comes back."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from types import TracebackType

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamixel import Bus, BusError, Chain, MemoryPort, Port, SimulatedClock, open_port
from kinlab.dynamixel.chain import Clock
from kinlab.dynamixel.outfit import worn_by
from kinlab.dynamixel.tables import Register
from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array
from kinlab.rig.release import torque_off
from kinlab.rig.wiring import Wiring
from kinlab.robots import Limb, Robot

# A joint goes to where it is wanted no faster than this (rad/s), by a path of this many points a second.
GENTLE = np.radians(60)
GENTLE_RATE = 50.0


@dataclass(frozen=True, eq=False)
class Reading:
    """What the servos of J joints reported; NaN where no answer came.

    Attributes:
        at: when each was asked (J,), s on the bus's clock.
        q, velocity: of the joints (J,), rad and rad/s.
        load: share of the stall torque, in the joint's direction (J,).
        volts: at the servo (J,).
        amps: from the supply, estimated (J,), see `Rig.read`.
    """

    at: Array
    q: Array
    velocity: Array
    load: Array
    volts: Array
    amps: Array

    @property
    def missing(self) -> Array:
        """Which did not answer (J,)."""
        return np.isnan(self.q)


class Rig:
    """A robot's limbs on a bus. Whatever happens inside its `with`, the torque is off afterwards.

    with Rig.open(load_robot("krsri-hexapod")) as rig:
        rig.hold()
        rig.command(q)
        rig.read().q

    Attributes:
        bus: that its servos are on.
        wiring: which servo moves which joint.
        unconfirmed: servos that did not confirm that their torque is off.
    """

    def __init__(self, robot: Robot, bus: Bus, limbs: Sequence[Limb] | None = None) -> None:
        """Find the servos.

        Args:
            limbs: those to move; default its legs, or all where it has none.

        Raises:
            UsageError: its servos are not on a bus.
            KinlabError: a servo does not answer, or is of another model.
        """
        self.bus = bus
        self.wiring = Wiring.of(robot, limbs or robot.legs or tuple(robot.limbs.values()))
        self.unconfirmed: tuple[int, ...] = ()
        for number, table in zip(self.wiring.ids, self.wiring.tables, strict=True):
            found = bus.known(number)
            if found.model != table.model:
                raise KinlabError(
                    f"servo {number} of {robot.name} should be of {table.model}, and is of {found.model}"
                )

    @classmethod
    def open(
        cls,
        robot: Robot,
        port: str | None = None,
        baud: int = 1_000_000,
        limbs: Sequence[Limb] | None = None,
        clock: Clock | None = None,
    ) -> "Rig":
        """The robot on a port; None: on an emulated chain in memory, in simulated time or by `clock`.

        Raises:
            UsageError: its servos are not on a bus.
            PortError: the port cannot be opened.
            KinlabError: a servo does not answer, or is of another model.
        """
        modules = worn_by(robot)
        line: Port
        if port is None:
            line = MemoryPort(Chain.of(modules, baud), clock or SimulatedClock(), baud)
        else:
            line = open_port(port, baud, clock)
        try:
            protocols = {servo.model.protocol for servo in robot.servos}
            bus = Bus(line, protocol=int(float(protocols.pop())) if len(protocols) == 1 else None)
            return cls(robot, bus, limbs)
        except BaseException:
            line.close()
            raise

    def __enter__(self) -> "Rig":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            self.release()
        finally:
            self.bus.close()

    @property
    def clock(self) -> Clock:
        """The bus's own time."""
        return self.bus.port.clock

    @property
    def chain(self) -> Chain | None:
        """The emulated chain behind the port; None where the servos are out of this program's reach."""
        port = self.bus.port
        return port.chain if isinstance(port, MemoryPort) else None

    def hold(self) -> None:
        """Switch the torque on, with every joint where it is.

        Raises:
            BusError: a servo does not answer.
        """
        for number in self.wiring.ids:
            self.bus.write(number, "goal_position", int(self.bus.read(number, "present_position")))
            self.bus.write(number, "torque_enable", 1)

    def release(self) -> None:
        """Switch the torque off, and note which servos did not confirm it."""
        self.unconfirmed = torque_off(self.bus, self.wiring.ids)

    def command(self, ticks: ArrayLike) -> None:
        """Send the joints to position commands (J,), see `Wiring.ticks`: one sync write for all."""
        goals = [int(tick) for tick in np.asarray(ticks).tolist()]
        self.bus.sync_write("goal_position", dict(zip(self.wiring.ids, goals, strict=True)))

    def read(self) -> Reading:
        """Ask all servos for position, velocity, load and voltage.

        One sync read where the protocol has it, else one read for each; a servo that does not answer
        leaves NaN. No servo of these series reports its current. What the supply gives is estimated: the
        standby current, and the motor's current (load times stall current) for the share of the time
        that the bridge must be on to drive it, which is load plus speed over no-load speed.
        """
        servos, at, ticks = self.wiring.ids, np.full(len(self.wiring.ids), self.clock.now()), {}
        if self.bus.known(servos[0]).protocol == 2:
            with suppress(BusError):
                ticks = self.bus.sync_read_block(servos, self._registers(0))
        for j, number in enumerate(servos):
            if number not in ticks:
                at[j] = self.clock.now()
                with suppress(BusError):
                    ticks[number] = self.bus.read_block(number, self._registers(j))
        nothing = (np.nan,) * 4
        rows = [
            [ticks[number][name] for name in names] if number in ticks else nothing
            for number, names in zip(servos, self.wiring.registers, strict=True)
        ]
        q, velocity, load, volts = self.wiring.measured(rows).T
        on = load + velocity / self.wiring.fastest
        amps = self.wiring.standby_amps + np.maximum(load * on, 0.0) * self.wiring.stall_amps
        return Reading(at, q, velocity, load, volts, amps)

    def approach(self, q: ArrayLike, tell: Callable[[float], None] = lambda done: None) -> None:
        """Go gently from where the joints are to `q` (J,), rad, and settle.

        Args:
            tell: called with the share of the way that is done.

        Raises:
            KinlabError: a servo does not answer, or cannot turn that far.
        """
        start = self.read()
        if start.missing.any():
            lost = self.wiring.ids[int(np.argmax(start.missing))]
            raise KinlabError(f"servo {lost} does not say where it is")
        way = np.asarray(q, float) - start.q
        # The middle of the way is half again as fast as its mean.
        steps = int(1.5 * np.abs(way).max() / GENTLE * GENTLE_RATE) + 1
        share = np.arange(1, steps + 1) / steps
        path = self.wiring.ticks(start.q + (share**2 * (3 - 2 * share))[:, None] * way)
        for done, ticks in zip(share.tolist(), path, strict=True):
            self.command(ticks)
            self.clock.wait(1 / GENTLE_RATE)
            tell(done)

    def _registers(self, joint: int) -> list[Register]:
        table = self.wiring.tables[joint]
        return [table.by_name[name] for name in self.wiring.registers[joint]]
