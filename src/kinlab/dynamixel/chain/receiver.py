"""The chain's ear at one link: bytes as they come in, answers as they go out."""

from kinlab.dynamixel.chain.chain import Burst, Chain
from kinlab.dynamixel.codec.packets import decode
from kinlab.dynamixel.codec.stream import StreamParser

GAP = 0.1  # s without a byte after which a servo forgets an unfinished packet (Protocol 1.0)
BREATH = 0.005  # s after which a whole packet is taken as such, even where an unfinished one might go on


class Receiver:
    """Turns the bytes of one client into instructions to the chain.

    Every client has one of its own, so that the halves of packets of one do not end in another's.
    """

    def __init__(self, chain: Chain) -> None:
        self.chain = chain
        self._parsers = {1: StreamParser(1), 2: StreamParser(2)}
        self._last = 0.0

    @property
    def pending(self) -> bool:
        """Whether an unfinished packet waits for its end."""
        return any(parser.pending for parser in self._parsers.values())

    def feed(self, data: bytes, now: float, baud: int | None = None) -> list[Burst]:
        """What the wire carries after these bytes, the last of which arrived at `now` (s)."""
        faults = self.chain.faults
        arrived = faults.pass_on(data)
        bursts = [Burst(now, now, data)] if faults.echo else []
        pause = now - self._last
        self._last = now
        for protocol in tuple(self.chain.protocols):
            parser = self._parsers[protocol]
            frames: list[bytes] = []
            if parser.pending and (pause > GAP or (pause > BREATH and StreamParser(protocol).feed(arrived))):
                frames = parser.abandon()
            frames += parser.feed(arrived)
            bursts += self._obey(frames, protocol, now, baud)
        return bursts

    def overdue(self, now: float) -> bool:
        """Whether an unfinished packet has waited for too long."""
        return self.pending and now - self._last > GAP

    def abandon(self, now: float, baud: int | None = None) -> list[Burst]:
        """Give up an unfinished packet; what the instructions found inside it bring."""
        bursts = []
        for protocol, parser in self._parsers.items():
            bursts += self._obey(parser.abandon(), protocol, now, baud)
        return bursts

    def _obey(self, frames: list[bytes], protocol: int, now: float, baud: int | None) -> list[Burst]:
        bursts: list[Burst] = []
        for frame in frames:
            packet = decode(frame, protocol)
            if packet.error is not None:
                continue  # Somebody else's answer.
            # The second instruction of one chunk is answered after the first.
            heard = max(now, bursts[-1].end) if bursts else now
            bursts += self.chain.obey(packet, heard, baud)
        faults = self.chain.faults
        if faults.drop or faults.flip or faults.noise:
            return [burst._replace(data=faults.pass_on(burst.data)) for burst in bursts]
        return bursts
