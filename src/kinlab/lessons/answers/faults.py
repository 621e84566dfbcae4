"""Buses that do not answer, and what is the matter with them: servos on emulated wires."""

from kinlab.dynamixel.codec.instructions import BY_NAME
from kinlab.dynamixel.codec.packets import Packet, encode
from kinlab.dynamixel.sandbox import Session, execute
from kinlab.dynamixel.sandbox.requests import REQUESTS
from kinlab.dynamixel.tables import load_table
from kinlab.lessons.results import Goal, Holds

AX = "AX-12A"
XL = "XL430-W250"
# What is done to a servo before it is asked.
CAUSES = {
    "echo": ("echo on",),
    "voltage": ("power 5.5", "wait 0.1"),
    "heat": ("fault {servo} overheating",),
    "silence": ("power off",),
}


def heard(cause: str, servo: int) -> str:
    """The bytes that come back when the servo's lamp is read, or "-" for none."""
    return _ask(cause, servo).last.received.hex(" ").upper() or "-"


def sent(cause: str, servo: int) -> bytes:
    """The bytes of the question."""
    return _ask(cause, servo).last.sent


def _ask(cause: str, servo: int) -> Session:
    session = Session(f"{AX}:{servo}")
    for line in CAUSES[cause]:
        execute(session, line.format(servo=servo))
    execute(session, f"read {servo} led")
    return session


def told(cause: str) -> str:
    """The cause itself: the option's key."""
    return cause


def other_speed(servo: int, speed: int) -> Goal:
    """A servo that was set to another speed, by somebody; its lamp is to be lit."""
    return Goal(
        f"{AX}:{servo}",
        (Holds(servo, "led", 1, 1),),
        (f"baud {speed}", f"write {servo} led 1"),
        setup=(f"fault {servo} baud {speed}",),
        as_real=True,
    )


def unknown_id(servo: int) -> Goal:
    """A servo whose id nobody remembers; its lamp is to be lit."""
    return Goal(f"{AX}:{servo}", (Holds(servo, "led", 1, 1),), ("scan", f"write {servo} led 1"), as_real=True)


def other_protocol(servo: int) -> Goal:
    """A servo that passes for an AX-12A and is an XL430; its lamp is to be lit, with bytes alone."""
    lamp = load_table(XL).by_name["led"]
    data = lamp.address.to_bytes(2, "little") + lamp.encode(1)
    packet = encode(Packet(2, servo, BY_NAME[2]["WRITE"].code, data))
    return Goal(
        f"{XL}:{servo}",
        (Holds(servo, "led", 1, 1),),
        (f"send {packet.hex(' ').upper()}",),
        # Every other verb finds out by itself which protocol a servo speaks.
        forbidden=("build", "scan", "table", *REQUESTS),
        as_real=True,
    )


def wire(first: int, step: int) -> list[int]:
    """The ids of six servos in the order in which the cable runs through them."""
    return [1 + (first + step * place) % 7 for place in range(6)]


def break_between(first: int, step: int, intact: int) -> Goal:
    """A cable that is broken behind the servo at place `intact`; the lamp of the last before it is to be lit alone."""
    chain = wire(first, step)
    last = last_reached(first, step, intact)
    return Goal(
        f"{AX}:{','.join(map(str, sorted(chain)))}",
        tuple(Holds(servo, "led", int(servo == last), int(servo == last)) for servo in chain),
        ("scan", f"write {last} led 1"),
        setup=tuple(f"fault {servo} dead" for servo in chain[intact:]),
        as_real=True,
    )


def last_reached(first: int, step: int, intact: int) -> int:
    """The last servo before the break."""
    return wire(first, step)[intact - 1]


def telling(first: int, step: int, intact: int) -> bool:
    """Whether the last servo before the break is another than the last that a scan lists."""
    return last_reached(first, step, intact) != max(wire(first, step)[:intact])
