"""Where a bus can be: a serial port or pty, a TCP server, or a chain in this program's memory."""

from typing import Protocol

from kinlab.dynamixel.chain import Clock
from kinlab.errors import KinlabError


class PortError(KinlabError):
    """A port is missing, busy, or gone in the middle of a transfer."""


class Port(Protocol):
    """A way to a bus.

    Attributes:
        name: for messages.
        baud: speed of the line, bps.
        latency: s that an answer may be late because of what lies between the program and the wire.
        clock: what deadlines are measured with.
    """

    name: str
    baud: int
    latency: float
    clock: Clock

    def send(self, data: bytes) -> None:
        """Forget what came in unread, and put `data` on the wire."""

    def receive(self, deadline: float) -> bytes:
        """The next bytes; none if the deadline, on the port's clock, passes without any."""

    def close(self) -> None:
        """Let go of the port."""


def open_port(name: str, baud: int = 1_000_000, clock: Clock | None = None) -> Port:
    """The port called `name`.

    Args:
        clock: for a chain in memory; None: a simulated one, for which waiting takes no time.
        name: a device ("/dev/ttyUSB0", "./ttyDXL", "COM3"), a TCP server ("localhost:5000"), or
            "emu:" and a robot or servos ("emu:krsri-hexapod", "emu:AX-12A:1,AX-12A:2") for a chain in memory.

    Raises:
        PortError: it is missing or busy.
        UsageError: nothing can be called that.
    """
    if name.startswith("emu:"):
        from kinlab.dynamixel.chain import SimulatedClock
        from kinlab.dynamixel.outfit import chain_of
        from kinlab.dynamixel.ports.memory import MemoryPort

        return MemoryPort(chain_of(name.removeprefix("emu:"), baud), clock or SimulatedClock(), baud)
    from kinlab.dynamixel.ports.serialport import SerialPort

    return SerialPort(name, baud)
