"""Sandbox commands about the emulated chain: look into servos, break them, feed them, let time pass."""

import math
from collections.abc import Callable

from kinlab.dynamixel.quantity import to_ticks
from kinlab.dynamixel.sandbox.display import table_lines
from kinlab.dynamixel.sandbox.requests import one_id, unknown
from kinlab.dynamixel.sandbox.session import Line, Outcome, Session
from kinlab.dynamixel.servo import MOST_VOLTS, Servo
from kinlab.dynamixel.servo.breaking import break_servo, motor_of
from kinlab.dynamixel.tables import ControlTable, load_table
from kinlab.errors import UsageError

LONGEST_WAIT = 86_400.0


def _said(text: str) -> Outcome:
    return Outcome(lines=[[("good", text)]])


def _number(text: str, usage: str, low: float = 0.0, high: float = math.inf) -> float:
    try:
        value = float(text)
    except ValueError:
        raise UsageError(f"usage: {usage}") from None
    if not low <= value <= high:
        raise UsageError(f"{text} is not from {low:g} to {high:g}; usage: {usage}")
    return value


def _servo(session: Session, text: str) -> Servo:
    chain = session.emulated
    servo = chain.servo(one_id(text))
    servo.advance(session.port.clock.now())
    return servo


def table(session: Session, rest: str) -> Outcome:
    """Show a control table, or registers of it."""
    words = rest.split()
    if not words:
        raise UsageError("usage: table ID|MODEL [REGISTER...]")
    found: ControlTable | None = session.table(int(words[0])) if words[0].isdecimal() else None
    if found is None:
        if words[0].isdecimal():
            raise UsageError(unknown(session, int(words[0])))
        found = load_table(words[0])
    registers = [found.find(name) for name in words[1:]] or list(found.registers)
    return Outcome(lines=table_lines(found, registers), data={"model": found.model})


def servo(session: Session, rest: str) -> Outcome:
    """Look inside a servo."""
    found = _servo(session, rest)
    found.measure()
    plant = found.plant
    state = {
        "model": found.table.model,
        "protocol": found.protocol,
        "baud": found.baud,
        "powered": found.powered,
        "angle_deg": round(math.degrees(plant.angle), 3),
        "speed_rpm": round(plant.velocity * 30 / math.pi, 3),
        "torque_nm": round(plant.torque, 4),
        "current_a": round(plant.current, 4),
        "drive_percent": round(found.drive * 100, 2),
        "volts": round(found.volts, 2),
        "temperature_degc": round(found.health.temperature, 1),
        "alarms": sorted(found.alarms()),
    }
    lines: list[Line] = [[("dim", f"{name:<18}"), ("", str(value))] for name, value in state.items()]
    shown = [r for r in found.table.registers if r.area == "RAM" and "indirect" not in r.name and r.size <= 4]
    lines += [[("data", f"{r.name:<26}"), ("", r.describe(found.memory[r.name]))] for r in shown]
    return Outcome(lines=lines, data={"servo": {"id": found.id, **state}})


def poke(session: Session, rest: str) -> Outcome:
    """Change a register behind the firmware's back."""
    words = rest.split()
    if len(words) != 3:
        raise UsageError("usage: set ID REGISTER VALUE")
    found = _servo(session, words[0])
    register = found.table.find(words[1])
    value = to_ticks(words[2], register)
    found.commit([(register, register.address, register.encode(value))])
    session.emulated.take_census()
    return _said(f"{register.name} of servo {words[0]} is {register.describe(value)}")


def fault(session: Session, rest: str) -> Outcome:
    """Break a servo, or mend it."""
    words = rest.split()
    if len(words) < 2:
        raise UsageError("usage: fault ID ALARM|stuck|dead|off|baud N")
    found = _servo(session, words[0])
    return _said(f"servo {found.id}: {break_servo(found, ' '.join(words[1:]))}")


def push(session: Session, rest: str) -> Outcome:
    """Turn at the horn from outside."""
    words = rest.split()
    if len(words) != 2:
        raise UsageError("usage: push ID NM")
    found = _servo(session, words[0])
    motor_of(found).external = _number(words[1], "push ID NM", -1000.0, 1000.0)
    return _said(f"servo {found.id}: {words[1]} N m from outside")


def wire_fault(name: str) -> Callable[[Session, str], Outcome]:
    """The command that sets one chance of the wire's faults."""

    def run(session: Session, rest: str) -> Outcome:
        usage = f"{name} CHANCE [seed=N]"
        words = rest.split() or [""]
        faults = session.emulated.faults
        setattr(faults, name, _number(words[0], usage, 0.0, 1.0))
        for word in words[1:]:
            seed = word.removeprefix("seed=")
            if seed == word or not seed.isdecimal():
                raise UsageError(f"usage: {usage}")
            faults.reseed(int(seed))
        return _said(f"{name}: {words[0]} of the bytes (seed {faults.seed})")

    return run


def delay(session: Session, rest: str) -> Outcome:
    """Make answers late."""
    session.emulated.faults.delay = _number(rest, "delay MS", 0.0, 10_000.0) / 1000
    return _said(f"answers are {rest} ms late")


def echo(session: Session, rest: str) -> Outcome:
    """Let what is sent come back."""
    if rest not in ("on", "off"):
        raise UsageError("usage: echo on|off")
    session.emulated.faults.echo = rest == "on"
    return _said(f"echo {rest}")


def power(session: Session, rest: str) -> Outcome:
    """Change the supply."""
    volts = {"off": 0.0, "on": 12.0}.get(rest)
    if volts is None:
        volts = _number(rest, "power on|off|VOLTS", 0.0, MOST_VOLTS)
    session.emulated.set_volts(volts, session.port.clock.now())
    return _said(f"the supply gives {volts:g} V")


def baud(session: Session, rest: str) -> Outcome:
    """Change one's own speed."""
    session.port.baud = int(_number(rest, "baud BPS", 300, 10_000_000))
    return _said(f"you speak at {session.port.baud} bps")


def protocol(session: Session, rest: str) -> Outcome:
    """Choose what to speak to the unknown."""
    if rest not in ("1", "2"):
        raise UsageError("usage: protocol 1|2")
    session.protocol = int(rest)
    return _said(f"Protocol {rest}.0 where nothing else is known")


def chain(session: Session, rest: str) -> Outcome:
    """Go on with another chain."""
    if not rest:
        raise UsageError("usage: chain ROBOT|MODEL:ID,...")
    session.use_chain(rest.replace(" ", ""), session.port.baud)
    return _said(f"servos: {', '.join(map(str, session.ids()))}")


def wait(session: Session, rest: str) -> Outcome:
    """Let time pass."""
    session.port.clock.wait(_number(rest, "wait SECONDS", 0.0, LONGEST_WAIT))
    return Outcome()
