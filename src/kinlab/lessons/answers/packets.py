"""Packets of both protocols, byte by byte. Servos are ids; AX-12A speak Protocol 1.0, XL430 2.0."""

from collections.abc import Callable, Mapping
from typing import Literal

from kinlab.dynamixel.codec.checks import POLYNOMIAL, checksum, crc16
from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.instructions import BY_NAME
from kinlab.dynamixel.codec.packets import Packet, encode, status, stuff
from kinlab.dynamixel.sandbox.requests import REQUESTS
from kinlab.dynamixel.tables import load_table
from kinlab.lessons.results import Goal, Holds

AX, XL = "AX-12A", "XL430-W250"
READING = {"ping", "read"}


def length(count: int, protocol: int) -> int:
    """What stands in the length of a WRITE of `count` bytes."""
    frame = encode(Packet(protocol, 1, BY_NAME[protocol]["WRITE"].code, bytes(count + protocol)))
    return frame[3] if protocol == 1 else int.from_bytes(frame[5:7], "little")


def length_without_address(count: int, protocol: int) -> int:
    """As `length`, the address forgotten."""
    return length(count, protocol) - protocol


def whole_length(count: int, protocol: int) -> int:
    """How long the whole packet of a WRITE of `count` bytes is."""
    return length(count, protocol) + (4 if protocol == 1 else 7)


def two_bytes(value: int) -> bytes:
    """A number in two bytes, the low one first."""
    return value.to_bytes(2, "little")


def two_bytes_high_first(value: int) -> bytes:
    """A number in two bytes, the high one first: wrong on this bus."""
    return value.to_bytes(2, "big")


def ping(servo: int, protocol: int) -> bytes:
    """The whole PING."""
    return encode(Packet(protocol, servo, BY_NAME[protocol]["PING"].code))


def ping_not_inverted(servo: int) -> bytes:
    """A PING of Protocol 1.0 with the sum for a checksum, not turned over."""
    frame = ping(servo, 1)
    return frame[:-1] + bytes((255 - frame[-1],))


def sum_with_header(servo: int) -> bytes:
    """A PING of Protocol 1.0 whose checksum counts the header in."""
    frame = ping(servo, 1)
    return frame[:-1] + bytes((checksum(frame[:-1]),))


def write_goal(servo: int, ticks: int) -> bytes:
    """WRITE Goal Position of an AX-12A, whole."""
    goal = load_table(AX).by_name["goal_position"]
    return encode(Packet(1, servo, BY_NAME[1]["WRITE"].code, bytes((goal.address,)) + goal.encode(ticks)))


def write_goal_high_first(servo: int, ticks: int) -> bytes:
    """As `write_goal`, the high byte of the goal first."""
    address = load_table(AX).by_name["goal_position"].address
    return encode(Packet(1, servo, BY_NAME[1]["WRITE"].code, bytes((address,)) + two_bytes_high_first(ticks)))


def not_symmetric(ticks: int) -> bool:
    """Whether a number's two bytes differ, so that their order matters."""
    return ticks % 256 != ticks // 256


# What can be wrong with a packet, besides its order.
DAMAGES: Mapping[str, Callable[[bytes], bytes]] = {
    "length": lambda frame: _resealed(bytes((*frame[:3], frame[3] + 1, *frame[4:]))),
    "sum": lambda frame: frame[:-1] + bytes((255 - frame[-1],)),
    "header": lambda frame: frame[:-1] + bytes((checksum(frame[:-1]),)),
}


def overheard(servo: int, ticks: int, place: int, wrong_at: int, damage: str) -> bytes:
    """The packet at a place from 1 of four that go to an AX-12A: READ, WRITE, WRITE, PING; one of them damaged."""
    table = load_table(AX).by_name
    position, led = table["present_position"], table["led"]
    frame = (
        encode(Packet(1, servo, BY_NAME[1]["READ"].code, bytes((position.address, position.size)))),
        encode(Packet(1, servo, BY_NAME[1]["WRITE"].code, bytes((led.address, 1)))),
        write_goal(servo, ticks),
        ping(servo, 1),
    )[place - 1]
    return DAMAGES[damage](frame) if place == wrong_at else frame


def account(servo: int, ticks: int, place: int, wrong_at: int, damage: str) -> dict[str, int]:
    """What that packet says of itself (length, checksum), and what is so (count, turned)."""
    frame = overheard(servo, ticks, place, wrong_at, damage)
    return {
        "length": frame[3], "count": len(frame) - 4, "checksum": frame[-1], "turned": checksum(frame[2:-1]),
    }  # fmt: skip


def refused(servo: int, ticks: int, wrong_at: int, damage: str) -> int:
    """Which of the four an AX-12A does not take."""
    return next(p for p in range(1, 5) if not dissect(overheard(servo, ticks, p, wrong_at, damage), 1).ok)


def _resealed(frame: bytes) -> bytes:
    """With the checksum that fits."""
    return frame[:-1] + bytes((checksum(frame[2:-1]),))


def complaint(servo: int, error: str) -> bytes:
    """The status packet of an AX-12A that reports one error by its name."""
    return encode(status(1, servo, ERRORS[error]))


def told(error: str) -> str:
    """The error itself: the option's key."""
    return error


ERRORS = {"voltage": 0x01, "angle": 0x02, "heat": 0x04, "checksum": 0x10, "overload": 0x20}


def drive_by_hand(servo: int, ticks: int) -> Goal:
    """Bring an AX-12A to a position with bytes alone."""
    written = f"send {write_goal(servo, ticks).hex(' ').upper()}"
    return Goal(
        f"{AX}:{servo}",
        (
            Holds(servo, "goal_position", ticks, ticks),
            Holds(servo, "present_position", ticks - 4, ticks + 4),
        ),
        (written,),
        forbidden=("build", *(verb for verb in REQUESTS if verb not in READING)),
    )


def fields_in_order() -> list[str]:
    """The fields of a packet of Protocol 2.0, from the first byte to the last."""
    return ["header", "reserved", "id", "length", "instruction", "parameters", "crc"]


def same_sum(first: int, second: int) -> str:
    """Which check notices that two bytes changed places: "crc", "both" or "neither"."""
    one, other = bytes((1, 4, 3, first, second)), bytes((1, 4, 3, second, first))
    by_sum, by_crc = checksum(one) != checksum(other), crc16(one) != crc16(other)
    return {(False, True): "crc", (True, True): "both", (False, False): "neither"}[by_sum, by_crc]


def differ(first: int, second: int) -> bool:
    """Whether two bytes are not the same."""
    return first != second


def remainder(byte: int) -> int:
    """The CRC of one byte."""
    return crc16(bytes((byte,)))


def remainder_on_the_wire(byte: int) -> bytes:
    """The same, the low byte first."""
    return two_bytes(remainder(byte))


def remainder_high_first(byte: int) -> bytes:
    """As `remainder_on_the_wire`, the high byte first."""
    return two_bytes_high_first(remainder(byte))


def remainder_too_soon(byte: int) -> bytes:
    """As `remainder_on_the_wire`, the divisor laid on when a 1 is at the left end, not when it has fallen out."""
    row = byte << 8
    for _ in range(8):
        row = row << 1 & 0xFFFF
        row ^= POLYNOMIAL if row & 0x8000 else 0
    return two_bytes(row)


def stuffed(data: str) -> bytes:
    """What goes over the wire for parameters given in hexadecimal."""
    return stuff(bytes.fromhex(data))


def unstuffed(data: str) -> bytes:
    """The parameters as they are: wrong where they hold a header."""
    return bytes.fromhex(data)


def stuffed_everywhere(data: str) -> bytes:
    """FD sent twice wherever it stands: too often."""
    return bytes.fromhex(data).replace(b"\xfd", b"\xfd\xfd")


def needs_stuffing(data: str) -> bool:
    """Whether some FD is to be doubled and another is not, so that it matters which."""
    return len({stuffed(data), unstuffed(data), stuffed_everywhere(data)}) == 3


def torque_on(servo: int) -> bytes:
    """WRITE Torque Enable of an XL430, whole."""
    return _torque_on(servo, "little")


def torque_on_high_first(servo: int) -> bytes:
    """As `torque_on`, the high byte of the address first."""
    return _torque_on(servo, "big")


def torque_on_short(servo: int) -> bytes:
    """As `torque_on`, the address in one byte as in Protocol 1.0."""
    address = load_table(XL).by_name["torque_enable"].address
    return encode(Packet(2, servo, BY_NAME[2]["WRITE"].code, bytes((address, 1))))


def _torque_on(servo: int, order: Literal["little", "big"]) -> bytes:
    address = load_table(XL).by_name["torque_enable"].address.to_bytes(2, order)
    return encode(Packet(2, servo, BY_NAME[2]["WRITE"].code, address + b"\x01"))


def move_xl430(servo: int, ticks: int) -> Goal:
    """Bring an XL430 to a position; it does nothing before it has torque."""
    return Goal(
        f"{XL}:{servo}",
        (
            Holds(servo, "torque_enable", 1, 1),
            Holds(servo, "present_position", ticks - 10, ticks + 10),
        ),
        (f"write {servo} torque_enable 1", f"write {servo} goal_position {ticks}"),
    )
