"""Whole packets out of a stream of bytes that may be cut anywhere, noisy, or wrong."""

from kinlab.dynamixel.codec.checks import crc16
from kinlab.dynamixel.codec.packets import HEADER

LONGEST = 2048


class StreamParser:
    """Yields every intact packet of one protocol in the bytes fed to it.

    A candidate that turns out wrong costs only its first byte: the search goes on right behind it,
    so a good packet that follows, or stands inside, a bad one is found.
    """

    def __init__(self, protocol: int) -> None:
        self.protocol = protocol
        self._buffer = b""
        self._scan = self._scan_1 if protocol == 1 else self._scan_2

    @property
    def pending(self) -> bool:
        """Whether the beginning of a packet waits for its end."""
        return bool(self._buffer)

    def feed(self, data: bytes) -> list[bytes]:
        """The packets that `data` completes, each as its bytes, check included."""
        self._buffer = self._buffer + data if self._buffer else bytes(data)
        frames: list[bytes] = []
        kept = self._scan(frames)
        self._buffer = self._buffer[kept:]
        return frames

    def abandon(self) -> list[bytes]:
        """Give up the unfinished packet, as a servo does after a pause; the packets found inside it."""
        frames: list[bytes] = []
        while self._buffer:
            self._buffer = self._buffer[1:]
            kept = self._scan(frames)
            self._buffer = self._buffer[kept:]
        return frames

    def _scan_1(self, frames: list[bytes]) -> int:
        """Append the whole packets of the buffer; how many of its bytes are done with."""
        buffer, at, end = self._buffer, 0, len(self._buffer)
        while True:
            start = buffer.find(b"\xff\xff", at)
            if start < 0:
                start = end - 1 if buffer.endswith(b"\xff") else end
                return max(start, at)
            # FF where the ID should be is one more header byte.
            while start + 2 < end and buffer[start + 2] == 0xFF:
                start += 1
            at = start
            if at + 4 > end:
                return at
            length = buffer[at + 3]
            stop = at + 4 + length
            if length >= 2:
                if stop > end:
                    return at
                if sum(buffer[at + 2 : stop]) & 0xFF == 0xFF:
                    frames.append(buffer[at:stop])
                    at = stop
                    continue
            at += 1

    def _scan_2(self, frames: list[bytes]) -> int:
        """Append the whole packets of the buffer; how many of its bytes are done with."""
        buffer, at, end = self._buffer, 0, len(self._buffer)
        header = HEADER[2]
        while True:
            if not buffer.startswith(header, at):
                start = buffer.find(header, at)
                if start < 0:
                    start = max(at, end - 3)
                    while start < end and not header.startswith(buffer[start:]):
                        start += 1
                    return start
                at = start
            if at + 7 > end:
                return at
            length = buffer[at + 5] | buffer[at + 6] << 8
            if 3 <= length <= LONGEST:
                stop = at + 7 + length
                if stop > end:
                    return at
                if crc16(buffer[at : stop - 2]) == buffer[stop - 2] | buffer[stop - 1] << 8:
                    frames.append(buffer[at:stop])
                    at = stop
                    continue
            at += 1
