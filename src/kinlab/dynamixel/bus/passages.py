"""What went over a bus, as it was heard, and packet by packet."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kinlab.dynamixel.codec.packets import HEADER
from kinlab.dynamixel.codec.stream import StreamParser


class Passage(NamedTuple):
    """Bytes that went over the wire.

    Attributes:
        at: when the last of them had passed, s on the port's clock.
        sent: whether the bus sent them, or heard them.
        data: the bytes.
    """

    at: float
    sent: bool
    data: bytes


def packets(passages: Iterable[Passage]) -> Iterator[Passage]:
    """Whole packets, each at the time when its last byte was heard; what makes no packet comes as it is.

    A real port hears answers in pieces of any size.
    """
    protocol, pending, at = 1, b"", 0.0
    for passage in passages:
        if passage.sent:
            if pending:
                yield Passage(at, False, pending)
            pending, protocol = b"", 2 if passage.data.startswith(HEADER[2]) else 1
            yield passage
            continue
        pending, at = pending + passage.data, passage.at
        frames = StreamParser(protocol).feed(pending)
        if frames and sum(map(len, frames)) == len(pending):
            yield from (Passage(at, False, frame) for frame in frames)
            pending = b""
    if pending:
        yield Passage(at, False, pending)
