"""Packets of both protocols, byte by byte. Servos are ids; AX-12A speak Protocol 1.0, XL430 2.0."""

from kinlab.dynamixel.codec.checks import checksum, crc16
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
