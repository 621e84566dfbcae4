"""One request and its answers: on the wire, in time, repeated where need be."""

from collections.abc import Callable, Mapping, Sequence

from kinlab.dynamixel.bus.errors import DamagedAnswerError, NoAnswerError, RefusedError
from kinlab.dynamixel.bus.passages import Passage
from kinlab.dynamixel.chain.chain import wire_time
from kinlab.dynamixel.codec.checks import crc16
from kinlab.dynamixel.codec.instructions import ALERT, STATUS, error_names
from kinlab.dynamixel.codec.packets import Packet, decode, encode
from kinlab.dynamixel.codec.stream import StreamParser
from kinlab.dynamixel.ports import Port

LONGEST_DELAY = 254 * 2e-6
LONGEST_SLOT = 0.003  # s that a servo may take for each id below its own when all are pinged
ALARMS_1 = 0b100101  # input voltage, overheating, overload: a state, not the fate of the request
STATUS_FRAME = {1: 6, 2: 11}  # bytes of an answer without data
PING_FRAME = 14


class Conversation:
    """Requests and answers on one port.

    Attributes:
        retries: how often a request without an intact answer is repeated.
        echo: the adapter hears what it sends.
        alarms: of each servo, what its last answer said about its state; absent if all is well.
        tap: told of all that passes.
    """

    def __init__(self, port: Port, retries: int, echo: bool) -> None:
        self.port = port
        self.retries = retries
        self.echo = echo
        self.alarms: dict[int, list[str]] = {}
        self.tap: Callable[[Passage], None] | None = None

    def tell(self, packet: Packet) -> None:
        """Send what nobody answers."""
        self._send(encode(packet))

    def ask(self, packet: Packet, subject: str, count: int) -> Packet:
        """The answer, with `count` bytes of data, of one servo.

        Raises:
            NoAnswerError, DamagedAnswerError, RefusedError: naming the servo and `subject`.
        """
        received = b""
        for _ in range(self.retries + 1):
            frames, received = self._exchange(packet, self._window(packet.protocol, [count]), 1)
            for frame in frames:
                answer = decode(frame, packet.protocol, as_status=True)
                if answer.error is not None and answer.id == packet.id:
                    self._judge(answer, subject)
                    return answer
        raise (
            DamagedAnswerError(packet.id, subject, received)
            if received
            else NoAnswerError(packet.id, subject)
        )

    def ask_many(
        self, packet: Packet, sizes: Mapping[int, int], subject: str, fast: bool
    ) -> dict[int, Packet]:
        """The answers of several servos, given with the bytes of data that each will send.

        Args:
            fast: they come in one packet.

        Raises:
            NoAnswerError, DamagedAnswerError, RefusedError: of the first servo that has failed.
        """
        window = self._window(packet.protocol, list(sizes.values()))
        answers: dict[int, Packet] = {}
        received = b""
        for _ in range(self.retries + 1):
            frames, received = self._exchange(packet, window, 1 if fast else len(sizes))
            if fast:
                answers = {part.id: part for frame in frames for part in split_fast(frame, sizes)}
            else:
                answers = {answer.id: answer for answer in (decode(f, packet.protocol, True) for f in frames)}
            if answers.keys() >= sizes.keys():
                break
        for servo in sizes:
            if servo not in answers:
                raise (
                    DamagedAnswerError(servo, subject, received)
                    if received
                    else NoAnswerError(servo, subject)
                )
            self._judge(answers[servo], subject)
        return answers

    def ping_all(self, turns: int) -> list[Packet]:
        """The answers to a Protocol 2.0 ping to all, of ids below `turns`."""
        window = wire_time(PING_FRAME * turns, self.port.baud) + LONGEST_SLOT * turns
        frames, _ = self._exchange(Packet(2, 0xFE, 1), window, None)
        return [packet for packet in (decode(frame, 2) for frame in frames) if packet.error is not None]

    def _window(self, protocol: int, counts: Sequence[int]) -> float:
        """How long the answers may take, in s: their bytes, the servos' delays, and the port's own."""
        expected = sum(STATUS_FRAME[protocol] + count for count in counts)
        return wire_time(expected, self.port.baud) + LONGEST_DELAY * len(counts) + self.port.latency

    def _exchange(self, packet: Packet, window: float, count: int | None) -> tuple[list[bytes], bytes]:
        """The intact packets that follow an instruction until there are `count` of them, and all that came."""
        request = encode(packet)
        self._send(request)
        deadline = self.port.clock.now() + wire_time(len(request), self.port.baud) + window
        parser = StreamParser(packet.protocol)
        frames: list[bytes] = []
        received = b""
        to_skip = request if self.echo else b""
        while count is None or len(frames) < count:
            data = self.port.receive(deadline)
            if not data:
                break
            if self.tap:
                self.tap(Passage(self.port.clock.now(), False, data))
            received += data
            if to_skip:
                if len(received) < len(to_skip):
                    continue
                data = received = received.removeprefix(to_skip)
                to_skip = b""
            # Where an adapter echoes unasked, the instruction itself comes back first.
            frames += [f for f in parser.feed(data) if packet.protocol == 1 or f != request]
        return frames, received

    def _send(self, data: bytes) -> None:
        self.port.send(data)
        if self.tap:
            self.tap(Passage(self.port.clock.now(), True, data))

    def _judge(self, answer: Packet, subject: str) -> None:
        """Note alarms; refuse an answer that says the request failed."""
        error = answer.error or 0
        state = ALERT if answer.protocol == 2 else ALARMS_1
        names = error_names(answer.protocol, error & state)
        self.alarms.pop(answer.id, None)
        if names:
            self.alarms[answer.id] = names
        if error & ~state:
            raise RefusedError(answer.id, subject, error, error_names(answer.protocol, error & ~state))


def split_fast(frame: bytes, sizes: Mapping[int, int]) -> list[Packet]:
    """The answers of the servos (id to bytes of data) that a fast read has put into one packet.

    Each part is error, id, data and a CRC over all that came before it; the first that is wrong ends the list.
    """
    parts: list[Packet] = []
    at = 8
    while at + 1 < len(frame) and frame[at + 1] in sizes:
        end = at + 2 + sizes[frame[at + 1]]
        if crc16(frame[:end]) != int.from_bytes(frame[end : end + 2], "little"):
            break
        parts.append(Packet(2, frame[at + 1], STATUS, frame[at + 2 : end], frame[at]))
        at = end + 2
    return parts
