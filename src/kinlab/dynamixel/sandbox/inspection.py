"""What there is to see of an emulated chain without a word on the wire: registers, faults, traffic."""

from dataclasses import dataclass
from typing import NamedTuple

from kinlab.dynamixel.codec.dissection import Dissection
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.sandbox.display import byte_spans
from kinlab.dynamixel.sandbox.session import Exchange, Line, Session
from kinlab.dynamixel.sandbox.wire import taken_apart
from kinlab.dynamixel.servo import Servo
from kinlab.dynamixel.servo.motor import GearMotor
from kinlab.dynamixel.tables import Register

CHANCE = 0.05  # of a fault at each byte, where only "some" is asked for
LATE_MS = 20
ALARMS = ("overload", "overheating")


@dataclass(frozen=True)
class Holding:
    """A register and what it holds now."""

    register: Register
    ticks: int

    @property
    def text(self) -> str:
        """The value as people read it."""
        return self.register.describe(self.ticks)


def holdings(session: Session, servo: int) -> list[Holding]:
    """What every register of a servo holds at this moment, those left out that only point to others.

    Raises:
        UsageError: there is no such servo, or this is a real bus.
    """
    found = session.emulated.servo(servo)
    found.advance(session.port.clock.now())
    found.measure()
    shown = (r for r in found.table.registers if "indirect" not in r.name)
    return [Holding(register, found.memory[register.name]) for register in shown]


def elapse(session: Session, seconds: float) -> None:
    """Let the chain's time pass, as it does between two lines when somebody looks on."""
    if session.chain is not None:
        session.port.clock.wait(seconds)


def silence(session: Session) -> str:
    """Why nobody on an emulated chain can answer: "unpowered", "dead"; "" where somebody can."""
    powered = [servo for servo in session.chain.servos if servo.powered] if session.chain else []
    if session.chain is None or not all(servo.dead for servo in powered):
        return ""
    return "dead" if powered else "unpowered"


def revival(session: Session) -> list[str]:
    """The lines after which a chain that had fallen silent answers again."""
    chain = session.emulated
    lines = [] if all(servo.powered for servo in chain.servos) else ["power on"]
    return lines + [f"fault {servo.id} off" for servo in chain.servos if servo.dead]


class Fault(NamedTuple):
    """Something that can go wrong.

    Attributes:
        name: what it is called in the sandbox ("drop", "overload").
        on: whether it does, at present.
        line: what to say to the sandbox to turn this over.
        detail: how much of it there is, as text.
    """

    name: str
    on: bool
    line: str
    detail: str = ""


def faults(session: Session, servo: int) -> list[Fault]:
    """What can go wrong on the wire, with the supply, and in one of the servos."""
    chain = session.emulated
    wire = chain.faults
    found = []
    for name in ("drop", "flip", "noise"):
        chance = getattr(wire, name)
        found.append(Fault(name, chance > 0, f"{name} {0 if chance else CHANCE:g}", f"{chance:.0%}"))
    late = wire.delay * 1000
    found.append(Fault("delay", late > 0, f"delay {0 if late else LATE_MS}", f"{late:g} ms"))
    found.append(Fault("echo", wire.echo, f"echo {'off' if wire.echo else 'on'}"))
    volts = chain.supply.volts
    found.append(Fault("power", volts <= 0, f"power {'on' if volts <= 0 else 'off'}", f"{volts:g} V"))
    return found + _servo_faults(chain.servo(servo))


def _servo_faults(servo: Servo) -> list[Fault]:
    held = isinstance(servo.plant, GearMotor) and servo.plant.held
    states = {**{name: name in servo.forced for name in ALARMS}, "stuck": held, "dead": servo.dead}
    # There is one word that mends a servo, and it mends all of it.
    return [Fault(name, on, f"fault {servo.id} {'off' if on else name}") for name, on in states.items()]


def traffic(session: Session, exchange: Exchange) -> list[Line]:
    """An exchange as it went over the wire, a line for each packet: when, which way, what it says, its bytes."""
    sent = taken_apart(session, exchange.sent)
    lines = [_packet_line(exchange.time, "->", exchange.sent, sent)]
    for after, data in exchange.answers:
        answer = taken_apart(session, data, exchange.request)
        lines.append(_packet_line(exchange.time + after, "<-", data, answer))
    if not exchange.answers:
        lines.append([("dim", f"{'':>8} "), ("arrow", "<- "), ("dim", "silence")])
    return lines


def _packet_line(time: float, arrow: str, data: bytes, packet: Dissection) -> Line:
    spans = byte_spans(packet) if packet.fields else [("", show_hex(data))]
    who = "all" if packet.id == 254 else packet.id
    said = f"{packet.instruction} {who}" if packet.ok else "damaged"
    return [
        ("dim", f"{time:8.3f} "),
        ("arrow", f"{arrow} "),
        ("" if packet.ok else "bad", f"{said:<10} "),
        *spans,
    ]
