"""A chain in this program's memory as a port."""

import heapq

from kinlab.dynamixel.chain import Chain, Clock, Receiver
from kinlab.dynamixel.chain.chain import Burst, wire_time


class MemoryPort:
    """The near end of an emulated wire. With a simulated clock, waiting costs no time."""

    latency = 0.001

    def __init__(self, chain: Chain, clock: Clock, baud: int = 1_000_000) -> None:
        self.name = "emulated chain"
        self.baud = baud
        self.clock = clock
        self.chain = chain
        self._receiver = Receiver(chain)
        chain.begin(clock.now())
        self._arriving: list[Burst] = []

    def send(self, data: bytes) -> None:
        """Forget what came in unread, and put `data` on the wire; it takes its time there."""
        now = self.clock.now()
        self._arriving = [burst for burst in self._arriving if burst.end > now]
        heapq.heapify(self._arriving)
        self.clock.wait(wire_time(len(data), self.baud))
        for burst in self._receiver.feed(data, self.clock.now(), self.baud):
            heapq.heappush(self._arriving, burst)

    def receive(self, deadline: float) -> bytes:
        """The next answer, if its last byte is here before the deadline."""
        now = self.clock.now()
        if self._arriving and self._arriving[0].end <= max(deadline, now):
            burst = heapq.heappop(self._arriving)
            self.clock.wait(burst.end - now)
            return burst.data
        self.clock.wait(deadline - now)
        return b""

    def close(self) -> None:
        """Nothing to let go of."""
