"""The bus client: requests by register name, in ticks or degrees, and their answers."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from types import TracebackType
from typing import NamedTuple

from kinlab.dynamixel.bus.conversation import Conversation
from kinlab.dynamixel.bus.errors import DamagedAnswerError, NoAnswerError
from kinlab.dynamixel.bus.passages import Passage
from kinlab.dynamixel.codec.instructions import (
    BACKUP_KEY,
    BROADCAST,
    BY_NAME,
    CLEAR_KEY,
    pack,
)
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.ports import Port, open_port
from kinlab.dynamixel.quantity import from_ticks, to_ticks
from kinlab.dynamixel.tables import ControlTable, Register, table_of_number
from kinlab.errors import UsageError


class Found(NamedTuple):
    """A servo that answered a ping."""

    id: int
    protocol: int
    number: int
    firmware: int

    @property
    def table(self) -> ControlTable | None:
        """Its control table; None where KinLab has none for its model."""
        return table_of_number(self.number)

    @property
    def model(self) -> str:
        """Its model's name, or number."""
        return self.table.model if self.table else f"model {self.number}"


class Bus:
    """Servos behind a port.

    with Bus("/dev/ttyUSB0", baud=57600) as bus:
        bus.write(1, "torque_enable", 1)
        bus.write(1, "goal_position", "90deg")
        bus.read(1, "present_position", "deg")

    """

    def __init__(
        self,
        port: Port | str,
        baud: int = 1_000_000,
        protocol: int | None = None,
        retries: int = 2,
        echo: bool = False,
    ) -> None:
        """Open the bus.

        Args:
            port: a port, or the name of one (see `open_port`).
            protocol: 1 or 2; None: found out, servo by servo.
            retries: how often a request without an intact answer is repeated.
            echo: the adapter hears what it sends.

        Raises:
            PortError: the port cannot be opened.
        """
        self.port = open_port(port, baud) if isinstance(port, str) else port
        self._talk = Conversation(self.port, retries, echo)
        self._protocols = (protocol,) if protocol else (2, 1)
        self._known: dict[int, Found] = {}
        self._taciturn: set[int] = set()  # servos that answer no orders

    def __enter__(self) -> "Bus":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    @property
    def alarms(self) -> dict[int, list[str]]:
        """Of each servo, what its last answer said about its state ("overload"); absent if all is well."""
        return self._talk.alarms

    @property
    def tap(self) -> Callable[[Passage], None] | None:
        """Told of all that goes over the wire; set it to listen."""
        return self._talk.tap

    @tap.setter
    def tap(self, tell: Callable[[Passage], None] | None) -> None:
        self._talk.tap = tell

    def close(self) -> None:
        """Let go of the port."""
        self.port.close()

    # Finding servos.

    def ping(self, servo: int) -> Found:
        """Ask one servo whether it is there.

        Raises:
            NoAnswerError: it is not.
        """
        for protocol in self._protocols:
            try:
                answer = self._talk.ask(Packet(protocol, servo, 1), "PING", 3 if protocol == 2 else 0)
            except NoAnswerError:
                if protocol == self._protocols[-1]:
                    raise
                continue
            if protocol == 2:
                found = Found(servo, 2, int.from_bytes(answer.params[:2], "little"), answer.params[2])
            else:
                found = self._identity(servo)
            self._known[servo] = found
            return found
        raise NoAnswerError(servo, "PING")

    def scan(self, ids: Iterable[int] = range(254)) -> list[Found]:
        """All servos that answer, in order of id. Protocol 2.0 is asked once, Protocol 1.0 id by id."""
        wanted = list(ids)
        found: dict[int, Found] = {}
        if 2 in self._protocols:
            for packet in self._talk.ping_all(max(wanted, default=0) + 1):
                if packet.id in wanted:
                    number = int.from_bytes(packet.params[:2], "little")
                    found[packet.id] = Found(packet.id, 2, number, packet.params[2])
        if 1 in self._protocols:
            once = Conversation(self.port, retries=0, echo=self._talk.echo)
            for servo in wanted:
                if servo not in found:
                    try:
                        once.ask(Packet(1, servo, 1), "PING", 0)
                        found[servo] = self._identity(servo)
                    except (NoAnswerError, DamagedAnswerError):
                        continue
        self._known.update(found)
        return [found[servo] for servo in sorted(found)]

    def known(self, servo: int) -> Found:
        """What a servo is; it is asked the first time."""
        return self._known.get(servo) or self.ping(servo)

    def known_ids(self) -> list[int]:
        """The ids of the servos that have been found so far."""
        return sorted(self._known)

    def register(self, servo: int, name: str) -> Register:
        """A servo's register by name or address.

        Raises:
            UsageError: it has none of that name, or its model has no table.
        """
        table = self.known(servo).table
        if table is None:
            raise UsageError(
                f"servo {servo} is of {self.known(servo).model}, for which there is no control table"
            )
        return table.find(name)

    # One servo.

    def read(self, servo: int, name: str, unit: str | None = None) -> int | float:
        """A register's value: in ticks, or in `unit` ("deg", "rad", "rpm", "%", "V", "degC")."""
        register = self.register(servo, name)
        data = self._read_bytes(
            self.known(servo).protocol, servo, register.address, register.size, register.name
        )
        return from_ticks(register.decode(data), register, unit)

    def read_block(self, servo: int, registers: Sequence[Register]) -> dict[str, int]:
        """Several registers in one request, by name, in ticks; whatever stands between them is read as well."""
        first, count = _span(registers)
        data = self._read_bytes(self.known(servo).protocol, servo, first, count, registers[0].name)
        return _unpacked(data, registers)

    def write(self, servo: int, name: str, value: int | float | str, unit: str | None = None) -> None:
        """Set a register: to ticks, to an amount in `unit`, or as in "90deg"."""
        self._write("WRITE", servo, name, value, unit)

    def write_block(self, servo: int, values: Mapping[Register, int]) -> None:
        """Set registers that stand side by side, in ticks, in one request.

        Raises:
            UsageError: they have a gap between them.
        """
        inside = sorted(values, key=lambda register: register.address)
        if any(a.end != b.address for a, b in pairwise(inside)):
            raise UsageError(f"{inside[0].name} to {inside[-1].name} are not side by side")
        data = b"".join(register.encode(values[register]) for register in inside)
        self._command("WRITE", servo, {"address": inside[0].address, "data": data}, inside[0].name)

    def reg_write(self, servo: int, name: str, value: int | float | str, unit: str | None = None) -> None:
        """Like `write`, but carried out at the next `action`."""
        self._write("REG_WRITE", servo, name, value, unit)

    def action(self) -> None:
        """Let all servos carry out what `reg_write` left with them."""
        for protocol in {known.protocol for known in self._known.values()} or set(self._protocols):
            self._talk.tell(Packet(protocol, BROADCAST, 5))

    def reboot(self, servo: int) -> None:
        """Restart a servo; it is deaf for a moment."""
        self._command("REBOOT", servo, {})

    def factory_reset(self, servo: int, keep: str = "id") -> None:
        """Set a servo back to the factory's values.

        Args:
            keep: "nothing", "id", or "id and baud rate". Protocol 1.0 always keeps nothing.
        """
        option = {"nothing": 0xFF, "id": 1, "id and baud rate": 2}.get(keep)
        if option is None:
            raise UsageError(f"a factory reset keeps 'nothing', 'id' or 'id and baud rate', not '{keep}'")
        self._command("FACTORY_RESET", servo, {"option": option})
        self._known.clear()

    def clear(self, servo: int) -> None:
        """Forget the turns that a servo has counted."""
        self._command("CLEAR", servo, {"option": 1, "key": CLEAR_KEY})

    def backup(self, servo: int, restore: bool = False) -> None:
        """Store a copy of a servo's control table, or go back to it."""
        self._command("CONTROL_TABLE_BACKUP", servo, {"option": 2 if restore else 1, "key": BACKUP_KEY})

    # Many servos.

    def sync_read(
        self, name: str, servos: Sequence[int], unit: str | None = None, fast: bool = False
    ) -> dict[int, int | float]:
        """The same register of many servos in one request."""
        register = self._common(servos, name)
        head = {"address": register.address, "count": register.size}
        wanted = dict.fromkeys(servos, register)
        rows = [{"id": servo} for servo in servos]
        return self._read_many("FAST_SYNC_READ" if fast else "SYNC_READ", wanted, head, rows, unit)

    def sync_read_block(
        self, servos: Sequence[int], registers: Sequence[Register]
    ) -> dict[int, dict[str, int]]:
        """Like `read_block`, of many servos in one request."""
        first, count = _span(registers)
        head, rows = {"address": first, "count": count}, [{"id": servo} for servo in servos]
        packet = self._packet(self._protocol_of(servos), BROADCAST, "SYNC_READ", head, rows)
        answers = self._talk.ask_many(packet, dict.fromkeys(servos, count), registers[0].name, False)
        return {servo: _unpacked(answers[servo].params, registers) for servo in servos}

    def bulk_read(
        self, names: Mapping[int, str], unit: str | None = None, fast: bool = False
    ) -> dict[int, int | float]:
        """One register of each servo, another one for each if need be, in one request."""
        wanted = {servo: self.register(servo, name) for servo, name in names.items()}
        rows = [{"id": s, "address": r.address, "count": r.size} for s, r in wanted.items()]
        return self._read_many("FAST_BULK_READ" if fast else "BULK_READ", wanted, {}, rows, unit)

    def sync_write(self, name: str, values: Mapping[int, int | float | str], unit: str | None = None) -> None:
        """Set the same register of many servos at once; nobody answers."""
        register = self._common(list(values), name)
        rows: list[dict[str, int | bytes]] = [
            {"id": servo, "data": register.encode(to_ticks(value, register, unit))}
            for servo, value in values.items()
        ]
        head = {"address": register.address, "length": register.size}
        self._tell(self._protocol_of(values), "SYNC_WRITE", head, rows)

    def bulk_write(
        self, values: Mapping[int, tuple[str, int | float | str]], unit: str | None = None
    ) -> None:
        """Set one register of each servo at once; nobody answers."""
        rows: list[dict[str, int | bytes]] = []
        for servo, (name, value) in values.items():
            register = self.register(servo, name)
            data = register.encode(to_ticks(value, register, unit))
            rows.append({"id": servo, "address": register.address, "length": register.size, "data": data})
        self._tell(self._protocol_of(values), "BULK_WRITE", {}, rows)

    # Packets.

    def _protocol_of(self, servos: Iterable[int]) -> int:
        protocols = {self.known(servo).protocol for servo in servos}
        if len(protocols) != 1:
            raise UsageError("servos of different protocols cannot be asked in one packet")
        return protocols.pop()

    def _common(self, servos: Sequence[int], name: str) -> Register:
        registers = {(r.address, r.size): r for r in (self.register(servo, name) for servo in servos)}
        if len(registers) != 1:
            raise UsageError(
                f"{name} does not stand at one address in all these servos; use bulk_read or bulk_write"
            )
        return next(iter(registers.values()))

    def _packet(
        self,
        protocol: int,
        servo: int,
        name: str,
        head: Mapping[str, int | bytes],
        rows: Sequence[Mapping[str, int | bytes]] = (),
    ) -> Packet:
        instruction = BY_NAME[protocol].get(name)
        if instruction is None:
            raise UsageError(f"Protocol {protocol}.0 has no {name}")
        return Packet(protocol, servo, instruction.code, pack(instruction, head, rows))

    def _tell(
        self,
        protocol: int,
        name: str,
        head: Mapping[str, int | bytes],
        rows: Sequence[Mapping[str, int | bytes]],
    ) -> None:
        self._talk.tell(self._packet(protocol, BROADCAST, name, head, rows))

    def _command(
        self, name: str, servo: int, head: Mapping[str, int | bytes], subject: str | None = None
    ) -> None:
        """Give an order; a servo whose Status Return Level says so does not answer it."""
        packet = self._packet(self.known(servo).protocol, servo, name, head)
        if servo in self._taciturn:
            self._talk.tell(packet)
            return
        try:
            self._talk.ask(packet, subject or name, 0)
        except NoAnswerError:
            if self.read(servo, "status_return_level") == 2:
                raise
            self._taciturn.add(servo)

    def _write(
        self, instruction: str, servo: int, name: str, value: int | float | str, unit: str | None
    ) -> None:
        register = self.register(servo, name)
        if not register.writable:
            raise UsageError(f"{register.name} can only be read")
        data = register.encode(to_ticks(value, register, unit))
        head: dict[str, int | bytes] = {"address": register.address, "data": data}
        self._command(instruction, servo, head, register.name)
        if register.name in ("id", "protocol_type", "status_return_level"):
            self._known.clear()
            self._taciturn.clear()

    def _read_bytes(self, protocol: int, servo: int, address: int, count: int, subject: str) -> bytes:
        packet = self._packet(protocol, servo, "READ", {"address": address, "count": count})
        return self._talk.ask(packet, subject, count).params

    def _identity(self, servo: int) -> Found:
        """What a servo of Protocol 1.0 is: its answer to a ping does not say it."""
        data = self._read_bytes(1, servo, 0, 3, "model_number")
        return Found(servo, 1, int.from_bytes(data[:2], "little"), data[2])

    def _read_many(
        self,
        name: str,
        wanted: Mapping[int, Register],
        head: Mapping[str, int | bytes],
        rows: Sequence[Mapping[str, int | bytes]],
        unit: str | None,
    ) -> dict[int, int | float]:
        packet = self._packet(self._protocol_of(wanted), BROADCAST, name, head, rows)
        sizes = {servo: register.size for servo, register in wanted.items()}
        subject = next(iter(wanted.values())).name
        answers = self._talk.ask_many(packet, sizes, subject, name.startswith("FAST"))
        return {s: from_ticks(r.decode(answers[s].params), r, unit) for s, r in wanted.items()}


def _span(registers: Sequence[Register]) -> tuple[int, int]:
    """The address and the number of the bytes that hold all of `registers`."""
    first = min(register.address for register in registers)
    return first, max(register.end for register in registers) - first


def _unpacked(data: bytes, registers: Sequence[Register]) -> dict[str, int]:
    """The values of `registers`, by name, in the bytes of their span."""
    first, _ = _span(registers)
    return {r.name: r.decode(data[r.address - first : r.end - first]) for r in registers}
