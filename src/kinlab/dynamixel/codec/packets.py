"""A packet as values, and as the bytes on the wire."""

from dataclasses import dataclass

from kinlab.dynamixel.codec.checks import checksum, crc16
from kinlab.dynamixel.codec.instructions import BY_CODE, STATUS

HEADER = {1: b"\xff\xff", 2: b"\xff\xff\xfd\x00"}
STUFFED = b"\xff\xff\xfd"


@dataclass(frozen=True, slots=True)
class Packet:
    """An instruction packet, or (where `error` is a number) a status packet.

    Attributes:
        code: the instruction; STATUS for a status packet.
        params: the parameters, not stuffed; for a status packet the data after the error byte.
    """

    protocol: int
    id: int
    code: int
    params: bytes = b""
    error: int | None = None

    @property
    def name(self) -> str:
        """The instruction's name, "STATUS", or the bare code where it is no instruction."""
        if self.error is not None:
            return "STATUS"
        known = BY_CODE[self.protocol].get(self.code)
        return known.name if known else f"0x{self.code:02X}"


def status(protocol: int, servo: int, error: int = 0, data: bytes = b"") -> Packet:
    """A servo's answer."""
    return Packet(protocol, servo, STATUS, data, error)


def encode(packet: Packet) -> bytes:
    """The packet's bytes, with length, stuffing (Protocol 2.0) and check."""
    if packet.protocol == 1:
        code = packet.code if packet.error is None else packet.error
        body = bytes((packet.id, len(packet.params) + 2, code)) + packet.params
        return HEADER[1] + body + bytes((checksum(body),))
    error = b"" if packet.error is None else bytes((packet.error,))
    body = stuff(bytes((packet.code,)) + error + packet.params)
    frame = HEADER[2] + bytes((packet.id,)) + (len(body) + 2).to_bytes(2, "little") + body
    return frame + crc16(frame).to_bytes(2, "little")


def decode(frame: bytes, protocol: int, as_status: bool = False) -> Packet:
    """The values of a whole, intact packet, such as the stream parser yields.

    Protocol 1.0 does not say whether a packet is an instruction or an answer: `as_status` does.
    """
    if protocol == 1:
        if as_status:
            return Packet(1, frame[2], STATUS, frame[5:-1], frame[4])
        return Packet(1, frame[2], frame[4], frame[5:-1])
    body = unstuff(frame[7:-2])
    if body[0] == STATUS:
        return Packet(2, frame[4], STATUS, body[2:], body[1] if len(body) > 1 else 0)
    return Packet(2, frame[4], body[0], body[1:])


def stuff(body: bytes) -> bytes:
    """FF FF FD inside a packet would look like a header: FD is sent twice there."""
    return body.replace(STUFFED, STUFFED + b"\xfd")


def unstuff(body: bytes) -> bytes:
    """The opposite of `stuff`. FF FF FD that was sent without stuffing stays as it is."""
    return body.replace(STUFFED + b"\xfd", STUFFED)
