"""One request and its answers: on the wire, in time, repeated where need be."""

from collections.abc import Callable, Mapping, Sequence

from kinlab.dynamixel.bus.errors import DamagedAnswerError, NoAnswerError, RefusedError
from kinlab.dynamixel.bus.passages import Passage
from kinlab.dynamixel.chain.chain import wire_time
from kinlab.dynamixel.codec.checks import crc16
from kinlab.dynamixel.codec.instructions import ALERT, BROADCAST, STATUS, error_names
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
        return self.ask_many(packet, {packet.id: count}, subject)[packet.id]

    def ask_many(
        self, packet: Packet, sizes: Mapping[int, int], subject: str, fast: bool = False
    ) -> dict[int, Packet]:
        """The answers of several servos, given with the bytes of data that each will send.

        An answer does not say what it answers. Where a request was repeated, the answers to its other tries
        may still be on their way: they are waited for as long as the one at hand may have been late, else
        they would be taken for answers to the next request.

        Args:
            fast: they come in one packet.

        Raises:
            NoAnswerError, DamagedAnswerError, RefusedError: of the first servo that has failed.
        """
        window, clock = self._window(packet.protocol, list(sizes.values())), self.port.clock
        answers: dict[int, Packet] = {}
        received, begun = b"", clock.now()
        for repeated in range(self.retries + 1):
            asked = clock.now()
            came, received = self._exchange(packet, window, sizes, len(sizes), fast)
            answers = {answer.id: answer for answer in came}
            if answers.keys() >= sizes.keys():
                late = clock.now() - begun
                while repeated and self._hear(asked + late):
                    continue
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
        return self._exchange(Packet(2, BROADCAST, 1), window, dict.fromkeys(range(turns), 3))[0]

    def _window(self, protocol: int, counts: Sequence[int]) -> float:
        """How long the answers may take, in s: their bytes, the servos' delays, and the port's own."""
        expected = sum(STATUS_FRAME[protocol] + count for count in counts)
        return wire_time(expected, self.port.baud) + LONGEST_DELAY * len(counts) + self.port.latency

    def _exchange(
        self,
        packet: Packet,
        window: float,
        sizes: Mapping[int, int],
        count: int | None = None,
        fast: bool = False,
    ) -> tuple[list[Packet], bytes]:
        """The answers that follow an instruction until there are `count` of them, and all that came."""
        request = encode(packet)
        self._send(request)
        deadline = self.port.clock.now() + wire_time(len(request), self.port.baud) + window
        parser = StreamParser(packet.protocol)
        answers: list[Packet] = []
        received = b""
        to_skip = request if self.echo else b""
        while count is None or len(answers) < count:
            data = self._hear(deadline)
            if not data:
                break
            received += data
            if to_skip:
                if len(received) < len(to_skip):
                    continue
                data = received = received.removeprefix(to_skip)
                to_skip = b""
            for frame in parser.feed(data):
                came = split_fast(frame, sizes) if fast else [decode(frame, packet.protocol, as_status=True)]
                answers += [answer for answer in came if answers_to(answer, sizes)]
        return answers, received

    def _hear(self, deadline: float) -> bytes:
        data = self.port.receive(deadline)
        if data and self.tap:
            self.tap(Passage(self.port.clock.now(), False, data))
        return data

    def _send(self, data: bytes) -> None:
        self.port.send(data)
        if self.tap:
            self.tap(Passage(self.port.clock.now(), True, data))

    def _judge(self, answer: Packet, subject: str) -> None:
        """Note alarms; refuse an answer that says the request failed."""
        error, grave = answer.error or 0, gravity(answer)
        names = error_names(answer.protocol, error & ~grave)
        self.alarms.pop(answer.id, None)
        if names:
            self.alarms[answer.id] = names
        if grave:
            raise RefusedError(answer.id, subject, error, error_names(answer.protocol, grave))


def gravity(answer: Packet) -> int:
    """What an answer's error byte says about the request, without what it says about the servo's state."""
    return (answer.error or 0) & ~(ALERT if answer.protocol == 2 else ALARMS_1)


def answers_to(answer: Packet, sizes: Mapping[int, int]) -> bool:
    """Whether a packet can be the answer of one of those servos (id to bytes of data), or its refusal.

    A late answer to an earlier request mostly has another size. An adapter may echo the instruction.
    """
    if answer.error is None or answer.id not in sizes:
        return False
    return len(answer.params) == sizes[answer.id] or bool(gravity(answer))


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
