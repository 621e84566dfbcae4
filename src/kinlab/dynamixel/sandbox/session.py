"""What a sandbox remembers between two lines: the chain, the last exchange, the packet being assembled."""

from collections import deque
from dataclasses import dataclass, field
from typing import Any

from kinlab.dynamixel.bus import Bus, BusError, Found
from kinlab.dynamixel.bus.conversation import LONGEST_SLOT
from kinlab.dynamixel.chain import Chain, SimulatedClock
from kinlab.dynamixel.chain.chain import MANY, wire_time
from kinlab.dynamixel.codec.instructions import BROADCAST, BY_CODE, unpack
from kinlab.dynamixel.codec.packets import Packet, decode
from kinlab.dynamixel.codec.stream import StreamParser
from kinlab.dynamixel.outfit import chain_of
from kinlab.dynamixel.ports import Port
from kinlab.dynamixel.ports.memory import MemoryPort
from kinlab.dynamixel.tables import ControlTable
from kinlab.errors import KinlabError, UsageError

DEFAULT_CHAIN = "AX-12A:1,2,XL430-W250:3"
PATIENCE = 0.05  # s to wait for an answer that ought to come
SILENCE = 0.005  # s to listen where none is due
REMEMBERED = 200

Span = tuple[str, str]  # style, text
Line = list[Span]


class ExpectationError(KinlabError):
    """What a script expected did not happen."""


@dataclass
class Outcome:
    """What a line led to.

    Attributes:
        ok: False where an answer was due and none, or a damaged one, came.
        lines: to show; each is a list of (style, text).
        data: the same for programs.
    """

    ok: bool = True
    lines: list[Line] = field(default_factory=list)
    data: dict[str, Any] = field(default_factory=dict)

    @property
    def text(self) -> str:
        """The lines without styles."""
        return "\n".join("".join(text for _, text in line).rstrip() for line in self.lines)


@dataclass
class Exchange:
    """Bytes that went out, and those that came back.

    Attributes:
        time: s on the port's clock, when the first byte went out.
        request: the instruction, None where the bytes are none.
        answers: when the last byte of each was here (s after the request began), and its bytes.
    """

    sent: bytes
    time: float
    request: Packet | None
    answers: list[tuple[float, bytes]] = field(default_factory=list)

    @property
    def received(self) -> bytes:
        return b"".join(data for _, data in self.answers)

    def packets(self) -> list[Packet]:
        """The intact answers."""
        protocol = self.request.protocol if self.request else 1
        frames = StreamParser(protocol).feed(self.received)
        return [decode(frame, protocol, as_status=True) for frame in frames]


class Session:
    """A sandbox on an emulated chain or, given a port, on a real bus.

    Attributes:
        chain: the emulated chain; None on a real bus.
        protocol: what is spoken to ids that nothing is known of.
        assembling: the packet that `step` puts together; None if it does not.
        traced: whether packets are shown.
        history: the lines so far, those that failed left out.
    """

    def __init__(self, chain: str | None = None, port: Port | None = None, baud: int = 1_000_000) -> None:
        """Set up.

        Args:
            chain: a robot or servos ("krsri-hexapod", "AX-12A:1,RX-24F:2"); None: a small mixed chain.
            port: a real bus, in the place of a chain.
        """
        self.history: list[str] = []
        self.exchanges: deque[Exchange] = deque(maxlen=REMEMBERED)
        self.assembling: bytes | None = None
        self.traced = True
        self.loading = 0
        self.protocol = 1
        self.chain: Chain | None = None
        if port is None:
            self.use_chain(chain or DEFAULT_CHAIN, baud)
        else:
            self._use(port)

    def use_chain(self, text: str, baud: int) -> None:
        """Go on with a new chain."""
        chain = chain_of(text, baud)
        self.chain = chain
        self.chain_text = text
        self.protocol = chain.servos[0].protocol
        self._use(MemoryPort(chain, SimulatedClock(), baud))

    def _use(self, port: Port) -> None:
        self.port = port
        self.bus = Bus(port)
        self._missing: set[int] = set()  # real servos that did not answer, until the next scan

    @property
    def last(self) -> Exchange:
        """The latest exchange.

        Raises:
            UsageError: nothing has been sent yet.
        """
        if not self.exchanges:
            raise UsageError("nothing has been sent yet")
        return self.exchanges[-1]

    @property
    def emulated(self) -> Chain:
        """The chain.

        Raises:
            UsageError: this is a real bus.
        """
        if self.chain is None:
            raise UsageError("this needs an emulated chain; the session is on a real bus")
        return self.chain

    def ids(self) -> list[int]:
        """The ids that are known."""
        if self.chain is not None:
            return sorted({servo.id for servo in self.chain.servos})
        return sorted(self.bus.known_ids())

    def table(self, servo: int) -> ControlTable | None:
        """The control table of the servo with an id; None if there is none. A real servo is asked, once."""
        if self.chain is not None:
            return next((s.table for s in self.chain.servos if s.id == servo), None)
        if servo == BROADCAST or servo in self._missing:
            return None
        try:
            return self.bus.known(servo).table
        except BusError:
            self._missing.add(servo)
            return None

    def protocol_of(self, servo: int) -> int:
        """What a servo speaks; a real one is asked once."""
        if self.chain is not None:
            return next((s.protocol for s in self.chain.servos if s.id == servo), self.protocol)
        table = self.table(servo)
        return self.bus.known(servo).protocol if table else self.protocol

    def scan(self) -> list[Found]:
        """All servos that answer."""
        self._missing.clear()
        return self.bus.scan()

    def exchange(self, data: bytes) -> Exchange:
        """Send bytes as they are, and listen for as long as an answer may take."""
        request = as_instruction(data)
        count, window = self._due(request)
        exchange = Exchange(data, self.port.clock.now(), request)
        self.exchanges.append(exchange)
        self.port.send(data)
        deadline = exchange.time + wire_time(len(data), self.port.baud) + window
        parser = StreamParser(request.protocol if request else self.protocol)
        came = 0
        while came < count or count == 0:
            piece = self.port.receive(deadline)
            if not piece:
                break
            exchange.answers.append((self.port.clock.now() - exchange.time, piece))
            came += sum(frame != data for frame in parser.feed(piece))  # An echo is no answer.
        return exchange

    def answers_due(self, exchange: Exchange) -> int:
        """How many answers an exchange should have brought."""
        return self._due(exchange.request)[0]

    def _due(self, request: Packet | None) -> tuple[int, float]:
        """How many answers an instruction calls for, and how long they may take in all, in s."""
        slack = self.port.latency
        if request is None:
            return 0, SILENCE + slack
        if request.id != BROADCAST:
            return 1, PATIENCE + slack
        instruction = BY_CODE[request.protocol].get(request.code)
        name = instruction.name if instruction else ""
        if name == "PING":
            everyone = wire_time(14 * 253, self.port.baud) + 253 * LONGEST_SLOT
            return 254, everyone if self.chain is None else wire_time(14 * 254, self.port.baud) + PATIENCE
        values = unpack(instruction, request.params) if instruction else None
        if name in MANY and values:
            count = 1 if name.startswith("FAST") else len(values.rows)
            return count, PATIENCE + wire_time(4096, self.port.baud) + slack
        return 0, SILENCE + slack


def as_instruction(data: bytes) -> Packet | None:
    """The one instruction that bytes are, intact and without anything around it; else None."""
    for protocol in (2, 1):
        if StreamParser(protocol).feed(data) == [data]:
            packet = decode(data, protocol)
            return packet if packet.error is None else None
    return None
