"""Serial ports, ptys and TCP servers through pyserial: the one place that imports it."""

import re
import time
from contextlib import suppress

import serial

from kinlab.dynamixel.chain import Clock, RealClock
from kinlab.dynamixel.ports import PortError
from kinlab.guests import refuse_to_guests

# A port that goes away shows in many ways: pyserial passes most of them on as they are.
GONE: tuple[type[Exception], ...] = (serial.SerialException, OSError, TypeError)
with suppress(ImportError):
    import termios  # There is none where there are no Unix terminals.

    GONE += (termios.error,)
UNFIT: tuple[type[Exception], ...] = (*GONE, ValueError)


class SerialPort:
    """A real line, or what looks like one."""

    # A USB adapter hands its bytes over every 16 ms unless told otherwise.
    latency = 0.02

    def __init__(self, name: str, baud: int) -> None:
        refuse_to_guests(f"the port {name}")
        self.name = name
        self.clock: Clock = RealClock()
        self._speed = baud
        url = f"socket://{name}" if re.fullmatch(r"[\w.-]+:\d+", name) else name
        try:
            self._line = serial.serial_for_url(url, baudrate=baud, timeout=0, exclusive=True)
        except UNFIT as error:
            raise PortError(f"cannot open the port {name}: {_cause(error)}") from None

    @property
    def baud(self) -> int:
        return self._speed

    @baud.setter
    def baud(self, bps: int) -> None:
        try:
            self._line.baudrate = bps
        except UNFIT as error:
            raise PortError(f"the port {self.name} cannot run at {bps} bps: {_cause(error)}") from None
        self._speed = bps

    def send(self, data: bytes) -> None:
        """Forget what came in unread, and send."""
        try:
            self._line.reset_input_buffer()
            self._line.write(data)
        except GONE as error:
            raise self._gone(error) from None

    def receive(self, deadline: float) -> bytes:
        """The next bytes; none if the deadline passes."""
        left = deadline - time.monotonic()
        try:
            self._line.timeout = max(0.0, left)
            first: bytes = self._line.read(1)
            if not first:
                return b""
            self._line.timeout = 0
            rest: bytes = self._line.read(4096)
        except GONE as error:
            raise self._gone(error) from None
        return first + rest

    def close(self) -> None:
        """Let go of the line."""
        self._line.close()

    def _gone(self, error: Exception) -> PortError:
        return PortError(f"the port {self.name} is gone: {_cause(error)}")


def _cause(error: Exception) -> str:
    """The reason without pyserial's wrapping."""
    text = str(error)
    for sign, words in (
        ("No such file", "there is no such device"),
        ("Permission denied", "you are not allowed to use it"),
        ("lock", "another program has it"),
        ("refused", "nothing listens there"),
        ("Input/output error", "it was unplugged, or the chain behind it ended"),
    ):
        if sign in text:
            return words
    return text
