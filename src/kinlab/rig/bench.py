"""One limb's servos on an emulated chain: a pose goes out as a sync write, what the servos report comes back."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamixel import Bus, Chain, MemoryPort, SimulatedClock
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.outfit import worn_by
from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array
from kinlab.rig.rig import Rig
from kinlab.robots import Limb, Robot
from kinlab.units import shown_mm

NOMINAL_VOLTS = 12.0
# The servos are asked this often (s) until they report the same place twice, or for so long at most.
LOOK = 0.05
PATIENCE = 4.0


@dataclass(frozen=True, eq=False)
class Arrival:
    """What came of sending n servos to a pose.

    Attributes:
        protocol: of the chain.
        sent: the sync write, byte by byte.
        ticks: commanded (n,).
        reported: the positions (n,) that the servos report when they stand, ticks; NaN without an answer.
        q: the same as joint angles (n,), rad.
        tip: where that is (3,), limb frame, metres.
        seconds: from the command until they stood.
    """

    protocol: int
    sent: bytes
    ticks: Array
    reported: Array
    q: Array
    tip: Array
    seconds: float

    @property
    def answered(self) -> bool:
        """Whether every servo did."""
        return bool(np.isfinite(self.q).all())

    def error_m(self, target: ArrayLike) -> float:
        """The distance of the tip from `target` (3,), limb frame, metres."""
        return float(np.linalg.norm(self.tip - np.asarray(target)))

    def to_json(self, target: ArrayLike) -> dict[str, Any]:
        """The bytes, the positions reported, and how far from `target` (3,), limb frame, metres, the tip stands."""
        return {
            "protocol": self.protocol,
            "sync_write": show_hex(self.sent),
            "reported_ticks": [None if math.isnan(tick) else round(tick) for tick in self.reported.tolist()],
            "tip_mm": shown_mm(self.tip) if self.answered else None,
            "error_mm": self.error_m(target) * 1000 if self.answered else None,
            "seconds": self.seconds,
        }


class _Line(MemoryPort):
    """An emulated wire that remembers what went over it last."""

    sent = b""

    def send(self, data: bytes) -> None:
        self.sent = data
        super().send(data)


class LimbBench:
    """A limb in the air, its servos switched on; nothing pulls at it but their own friction."""

    def __init__(self, robot: Robot, limb: Limb) -> None:
        """Build the robot's chain and switch the limb's servos on.

        Raises:
            UsageError: the limb's servos are not on a bus.
        """
        self.limb = limb
        self.port = _Line(Chain.of(worn_by(robot)), SimulatedClock())
        protocol = int(float(limb.joints[0].servo.model.protocol)) if limb.joints[0].servo else None
        self.rig = Rig(robot, Bus(self.port, protocol=protocol), [limb])
        self.protocol = protocol or 1
        self.rig.hold()

    @property
    def powered(self) -> bool:
        """Whether the chain has its supply."""
        return self.port.chain.supply.volts > 0

    def power(self, on: bool) -> None:
        """Give the chain its supply, or take it away; servos that come back hold where they are."""
        self.port.chain.set_volts(NOMINAL_VOLTS if on else 0.0, self.port.clock.now())
        if on:
            self.rig.hold()

    def go(self, q: ArrayLike) -> Arrival:
        """Send the limb to `q` (n,), rad, and wait until it stands.

        Raises:
            KinlabError: a servo cannot turn that far.
        """
        ticks = self.rig.wiring.ticks(q)
        clock = self.port.clock
        began = clock.now()
        self.rig.command(ticks)
        sent = self.port.sent
        before = np.full(len(ticks), np.nan)
        while True:
            reading = self.rig.read()
            if (
                reading.missing.all()
                or np.array_equal(reading.q, before, equal_nan=True)
                or clock.now() - began > PATIENCE
            ):
                break
            before = reading.q
            clock.wait(LOOK)
        reported = np.array(
            [
                float(servo.command(angle))
                for servo, angle in zip(self.rig.wiring.servos, reading.q, strict=True)
            ]
        )
        tip = self.limb.fk(reading.q)[:3, 3]
        return Arrival(self.protocol, sent, ticks, reported, reading.q, tip, clock.now() - began)


def bench_of(robot: Robot, limb: Limb) -> tuple[LimbBench | None, str]:
    """The limb's bench, and why there is none; empty where there is one."""
    try:
        return LimbBench(robot, limb), ""
    except KinlabError as error:
        return None, str(error)
