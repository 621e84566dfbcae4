"""The chain: one wire, many servos. An instruction goes in; out come the answers, each with its time."""

from collections.abc import Iterable
from operator import attrgetter
from typing import NamedTuple

from kinlab.dynamixel.chain.faults import Faults
from kinlab.dynamixel.codec.checks import crc16
from kinlab.dynamixel.codec.instructions import BROADCAST, BY_CODE, STATUS, Parameters, unpack
from kinlab.dynamixel.codec.packets import HEADER, Packet, encode, status
from kinlab.dynamixel.servo import Servo, Supply, build_servos
from kinlab.errors import UsageError
from kinlab.names import suggestion

BITS_PER_BYTE = 10
RATE_TOLERANCE = 0.03
INSTANT = 1e-9  # s; less than any bit takes, more than rounding errors
PING_ANSWER = 14  # bytes; a servo waits for those of all ids below its own when everybody is asked
MANY = frozenset({"SYNC_READ", "BULK_READ", "FAST_SYNC_READ", "FAST_BULK_READ"})
EEPROM_WRITES = attrgetter("eeprom_writes")
CHANGES_NOTHING = MANY | {"READ", "PING"}


class Burst(NamedTuple):
    """Bytes on the wire, from a moment (s) on, until a moment."""

    start: float
    end: float
    data: bytes


class Chain:
    """Servos on one wire.

    Attributes:
        byte_times: answers to one instruction are as far apart as the bytes' time on the wire demands;
            without, only delays that the servos make on purpose count.
    """

    def __init__(
        self,
        servos: Iterable[Servo],
        supply: Supply,
        faults: Faults | None = None,
        byte_times: bool = True,
    ) -> None:
        self.servos = list(servos)
        self.supply = supply
        self.faults = faults or Faults()
        self.byte_times = byte_times
        self._begun = False
        self.take_census()

    @classmethod
    def of(
        cls, modules: Iterable[tuple[str, list[int]]], baud: int = 1_000_000, byte_times: bool = True
    ) -> "Chain":
        """A chain of factory-fresh modules: [("AX-12A", [1]), ("2XL430-W250", [2, 3])].

        Raises:
            UsageError: an unknown model, an id that cannot be, or one that stands twice.
        """
        supply = Supply()
        servos = [servo for model, ids in modules for servo in build_servos(model, ids, baud, supply)]
        ids = [servo.id for servo in servos]
        twice = sorted({i for i in ids if ids.count(i) > 1})
        if twice:
            raise UsageError(f"the id {twice[0]} stands twice on the chain")
        return cls(servos, supply, byte_times=byte_times)

    def take_census(self) -> None:
        """Note which ids and protocols there are, after servos or their EEPROM have changed."""
        self._by_id: dict[int, list[Servo]] = {}
        for servo in self.servos:
            self._by_id.setdefault(servo.id, []).append(servo)
        self._secondary = [servo for servo in self.servos if servo.secondary_id is not None]
        self.protocols = {servo.protocol for servo in self.servos}
        self._changes: int = sum(map(EEPROM_WRITES, self.servos))

    @property
    def eeprom_writes(self) -> int:
        """How often anything changed that outlives a power cycle."""
        return self._changes

    def servo(self, number: int) -> Servo:
        """The servo with that id.

        Raises:
            UsageError: there is none; the ids that there are, are given.
        """
        if number not in self._by_id:
            raise UsageError(
                f"no servo has the id {number}{suggestion(str(number), map(str, sorted(self._by_id)))}"
            )
        return self._by_id[number][0]

    def begin(self, now: float) -> None:
        """Switch the servos on at `now`, if they are not on yet; without, they are on since time 0."""
        if not self._begun:
            for servo in self.servos:
                servo.begin(now)
        self._begun = True

    def advance(self, now: float) -> None:
        """Let time pass for every servo."""
        for servo in self.servos:
            servo.advance(now)

    def set_volts(self, volts: float, now: float) -> None:
        """Change the supply; servos that come back from too little lose what is in their RAM."""
        self.advance(now)
        were_on = [servo for servo in self.servos if servo.powered]
        self.supply.volts = volts
        for servo in self.servos:
            if servo.powered and servo not in were_on:
                servo.power_cycle()

    def obey(self, packet: Packet, now: float, baud: int | None = None) -> list[Burst]:
        """What the wire carries after an instruction whose last byte arrived at `now`.

        Args:
            baud: the sender's speed in bps; servos set to another do not hear it. None: any will do.
        """
        instruction = BY_CODE[packet.protocol].get(packet.code)
        name = instruction.name if instruction else ""
        if packet.id != BROADCAST:
            bursts = self._single(packet, name, now, baud)
        elif instruction is None:
            bursts = []
        elif name == "PING":
            bursts = self._ping_all(packet, now, baud)
        else:
            parameters = unpack(instruction, packet.params)
            if parameters is None:
                bursts = []
            elif name in MANY:
                bursts = self._read_many(packet.protocol, name, parameters, now, baud)
            else:
                self._write_many(packet, name, parameters, now, baud)
                bursts = []
        if name not in CHANGES_NOTHING and self._changes != sum(map(EEPROM_WRITES, self.servos)):
            self.take_census()
        return bursts

    def _awake(self, servo: Servo, protocol: int, now: float, baud: int | None) -> bool:
        """Bring a servo up to `now`; whether it hears a packet of that protocol and speed."""
        servo.advance(now)
        if not servo.hears or servo.protocol != protocol:
            return False
        if baud is not None and abs(baud - servo.baud) > RATE_TOLERANCE * servo.baud:
            return False
        servo.heard()
        return True

    def _single(self, packet: Packet, name: str, now: float, baud: int | None) -> list[Burst]:
        bursts = []
        for servo in self._by_id.get(packet.id, ()):
            if self._awake(servo, packet.protocol, now, baud):
                level = servo.memory["status_return_level"]
                delay, rate = self._delay(servo), servo.baud
                error, data = servo.obey(packet)
                if level == 2 or name == "PING" or (level == 1 and name == "READ"):
                    answer = status(packet.protocol, packet.id, servo.error_byte(error), data)
                    bursts.append(self._burst(encode(answer), now + delay, rate))
        for servo in self._secondary:
            if servo.secondary_id == packet.id != servo.id and self._awake(servo, packet.protocol, now, baud):
                servo.obey(packet, by_secondary=True)
        return collide(bursts) if len(bursts) > 1 else bursts

    def _ping_all(self, packet: Packet, now: float, baud: int | None) -> list[Burst]:
        bursts = []
        for servo in sorted(self.servos, key=lambda s: s.id):
            if self._awake(servo, packet.protocol, now, baud):
                # Protocol 1.0 has no order: everybody speaks at once.
                turn = servo.id * PING_ANSWER * BITS_PER_BYTE / servo.baud if packet.protocol == 2 else 0.0
                answer = status(packet.protocol, servo.id, servo.error_byte(0), servo.identity())
                bursts.append(self._burst(encode(answer), now + self._delay(servo) + turn, servo.baud))
        return collide(bursts)

    def _read_many(
        self, protocol: int, name: str, parameters: Parameters, now: float, baud: int | None
    ) -> list[Burst]:
        """One answer after the other; each servo waits for the one before, so one that is missing ends it."""
        head, rows = parameters
        fast = name.startswith("FAST")
        bursts: list[Burst] = []
        length = 1 + sum(int(row.get("count", head.get("count", 0))) + 4 for row in rows)
        whole = HEADER[2] + bytes((BROADCAST,)) + (length & 0xFFFF).to_bytes(2, "little") + bytes((STATUS,))
        done: set[int] = set()
        for row in rows:
            number = int(row["id"])
            address, count = (int(row.get(key, head.get(key, 0))) for key in ("address", "count"))
            servo = next(iter(self._by_id.get(number, ())), None)
            if servo is None or number in done or not self._awake(servo, protocol, now, baud):
                break
            if not servo.reads_in_turn(name) or servo.memory["status_return_level"] == 0:
                break
            done.add(number)
            error, data = servo.read(address, count)
            start = (bursts[-1].end if bursts else now) + self._delay(servo)
            if fast:
                part = bytes((servo.error_byte(error), number)) + data.ljust(count, b"\0")
                whole += part
                check = crc16(whole).to_bytes(2, "little")
                whole += check
                data_out = part + check if bursts else whole
            else:
                data_out = encode(status(protocol, number, servo.error_byte(error), data))
            bursts.append(self._burst(data_out, start, servo.baud))
        if fast and bursts:
            return [Burst(bursts[0].start, bursts[-1].end, b"".join(b.data for b in bursts))]
        return bursts

    def _write_many(
        self, packet: Packet, name: str, parameters: Parameters, now: float, baud: int | None
    ) -> None:
        if name in ("SYNC_WRITE", "BULK_WRITE"):
            address = parameters.head.get("address", 0)
            for row in parameters.rows:
                for servo in self._by_id.get(int(row["id"]), ()):
                    if self._awake(servo, packet.protocol, now, baud):
                        servo.write(int(row.get("address", address)), bytes(row["data"]))
            return
        if name == "FACTORY_RESET" and (packet.protocol == 1 or parameters.head["option"] == 0xFF):
            return  # Every servo would end up with the same id: neither protocol allows it.
        for servo in list(self.servos):
            if self._awake(servo, packet.protocol, now, baud):
                servo.obey(packet)

    def _delay(self, servo: Servo) -> float:
        """s before the servo answers, with what the faults add."""
        return servo.return_delay + self.faults.delay

    def _burst(self, data: bytes, start: float, rate: int) -> Burst:
        return Burst(start, start + (wire_time(len(data), rate) if self.byte_times else 0.0), data)


def wire_time(count: int, baud: int) -> float:
    """How long `count` bytes take on the wire, in s: each is ten bits."""
    return count * BITS_PER_BYTE / baud


def collide(bursts: list[Burst]) -> list[Burst]:
    """Answers that overlap in time pull the same wire: a bit is 0 where any of them is."""
    merged: list[Burst] = []
    for burst in sorted(bursts):
        last = merged[-1] if merged else None
        if last is None or burst.start > max(last.end - INSTANT, last.start + INSTANT):
            merged.append(burst)
            continue
        byte = (last.end - last.start) / len(last.data)
        offset = min(len(last.data), round((burst.start - last.start) / byte)) if byte else 0
        size = max(len(last.data), offset + len(burst.data))
        over = last.data.ljust(size, b"\xff")
        under = (b"\xff" * offset + burst.data).ljust(size, b"\xff")
        mixed = bytes(a & b for a, b in zip(over, under, strict=True))
        merged[-1] = Burst(last.start, max(last.end, burst.end), mixed)
    return merged
