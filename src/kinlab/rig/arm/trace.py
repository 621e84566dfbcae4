"""The packets of one cycle of the loop, as a script that the packet sandbox reads."""

from kinlab.dynamixel import Chain, MemoryPort
from kinlab.dynamixel.chain import Clock


class TappedPort(MemoryPort):
    """An emulated wire that can be listened to.

    Attributes:
        listening: whether what passes is kept.
        heard: the time (s) when its last byte passed, what the sandbox is asked to do with it, and the bytes.
    """

    def __init__(self, chain: Chain, clock: Clock) -> None:
        super().__init__(chain, clock)
        self.listening = False
        self.heard: list[tuple[float, str, bytes]] = []

    def send(self, data: bytes) -> None:
        """Put `data` on the wire."""
        super().send(data)
        if self.listening:
            self.heard.append((self.clock.now(), "decode", data))

    def receive(self, deadline: float) -> bytes:
        """The next answer, if its last byte is here before the deadline."""
        data = super().receive(deadline)
        if self.listening and data:
            self.heard.append((self.clock.now(), "decode status", data))
        return data

    def script(self, robot: str) -> str:
        """What was heard, each packet to be taken apart by `kinlab packet`; times since the first of them.

        Args:
            robot: whose chain the sandbox is to have, so that it knows the registers' names.
        """
        lines = [f"chain {robot}"]
        for t, verb, data in self.heard:
            lines.append(f"# {(t - self.heard[0][0]) * 1e3:.3f} ms")
            lines.append(f"{verb} {data.hex(' ').upper()}")
        return "\n".join(lines) + "\n"
