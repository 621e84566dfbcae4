"""Sandbox commands about bytes: send, decode, step, expect."""

from kinlab.dynamixel.codec.checks import checksum, crc16, crc_step
from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.dissection import Dissection
from kinlab.dynamixel.codec.hextext import parse_hex, show_hex
from kinlab.dynamixel.codec.packets import HEADER, Packet
from kinlab.dynamixel.sandbox.display import packet_lines
from kinlab.dynamixel.sandbox.session import Exchange, Line, Outcome, Session
from kinlab.errors import UsageError


def talk(session: Session, data: bytes) -> Outcome:
    """Send bytes and show what went over the wire."""
    exchange = session.exchange(data)
    answers = exchange.packets()
    due = session.answers_due(exchange)
    # Everybody may answer a ping to all; nobody must.
    ok = len(answers) >= due if due < 254 else bool(answers)
    lines = exchange_lines(session, exchange) if session.traced else []
    lines += result_lines(session, exchange, answers)
    return Outcome(ok, lines, {"exchange": exchange_json(session, exchange)})


def taken_apart(session: Session, data: bytes, request: Packet | None = None) -> Dissection:
    """An instruction, or the answer to `request`."""
    protocol = request.protocol if request else None
    return dissect(data, protocol, True if request else None, session.table, request)


def exchange_lines(session: Session, exchange: Exchange) -> list[Line]:
    """What was sent and what came back, one under the other."""
    baud = session.port.baud
    sent = f"{len(exchange.sent)} bytes, {wire_us(len(exchange.sent), baud)} at {speed(baud)}"
    lines = packet_lines("->", exchange.sent, sent, taken_apart(session, exchange.sent), session.table)
    for when, data in exchange.answers:
        remark = f"{len(data)} bytes, here after {when * 1e6:.0f} us"
        lines += packet_lines("<-", data, remark, taken_apart(session, data, exchange.request), session.table)
    if not exchange.answers:
        lines += [[("arrow", "<- "), ("dim", "silence")]]
    return lines


def wire_us(count: int, baud: int) -> str:
    """The time that bytes take."""
    return f"{count * 10 / baud * 1e6:.0f} us"


def speed(baud: int) -> str:
    """A speed as people write it."""
    return f"{baud / 1e6:g} Mbps" if baud >= 1_000_000 else f"{baud} bps"


def exchange_json(session: Session, exchange: Exchange) -> dict[str, object]:
    """An exchange for programs."""
    return {
        "time_s": exchange.time,
        "sent": {"bytes": show_hex(exchange.sent), **taken_apart(session, exchange.sent).as_json()},
        "answers": [
            {
                "after_s": when,
                "bytes": show_hex(data),
                **taken_apart(session, data, exchange.request).as_json(),
            }
            for when, data in exchange.answers
        ],
    }


def result_lines(session: Session, exchange: Exchange, answers: list[Packet]) -> list[Line]:
    """The upshot, in a line for each servo that answered."""
    lines: list[Line] = []
    for _, data in exchange.answers:
        dissection = taken_apart(session, data, exchange.request)
        values = [f.meaning for f in dissection.fields if f.name == "data"]
        if dissection.ok and dissection.id is not None:
            errors = f": {', '.join(dissection.errors)}" if dissection.errors else ""
            style = "bad" if dissection.errors else "good"
            lines.append(
                [(style, f"servo {dissection.id}{errors or ': ok'}"), ("", f"  {'; '.join(values)}")]
            )
    if not answers and session.answers_due(exchange):
        lines.append([("bad", "no intact answer"), ("", _why_silent(session, exchange))])
    return lines


def _why_silent(session: Session, exchange: Exchange) -> str:
    """The likely reason, where the emulated chain gives one away."""
    request, chain = exchange.request, session.chain
    if request is None or chain is None or exchange.answers:
        return ""
    servo = next((s for s in chain.servos if s.id == request.id), None)
    if servo is None:
        return f": there is no servo {request.id}"
    if not servo.powered:
        return ": the supply is off"
    if servo.protocol != request.protocol:
        return f": servo {servo.id} speaks Protocol {servo.protocol}.0"
    if abs(servo.baud - session.port.baud) > 0.03 * servo.baud:
        return f": servo {servo.id} is set to {servo.baud} bps, you speak at {session.port.baud}"
    return ""


def send(session: Session, rest: str) -> Outcome:
    """Send bytes as they are; without any, those that `step` has assembled."""
    if not rest:
        if not session.assembling:
            raise UsageError("usage: send BYTES")
        data, session.assembling = session.assembling, None
        return talk(session, data)
    body, dots, _ = rest.partition("..")
    data = parse_hex(body)
    if not data:
        raise UsageError("there are no bytes to send")
    return talk(session, data + right_check(data) if dots else data)


def right_check(data: bytes) -> bytes:
    """The checksum or CRC that belongs at the end of these bytes."""
    if data.startswith(HEADER[2]):
        return crc16(data).to_bytes(2, "little")
    return bytes((checksum(data[2:]),))


def decode_bytes(session: Session, rest: str) -> Outcome:
    """Take a packet apart."""
    first, _, others = rest.partition(" ")
    status = first == "status"
    data = parse_hex(others if status else rest)
    dissection = dissect(data, status=True if status else None, tables=session.table)
    lines = packet_lines("=", data, f"{len(data)} bytes", dissection, session.table)
    other = dissect(data, status=True, tables=session.table)
    if dissection.protocol == 1 and dissection.kind == "instruction" and dissection.ok and other.errors:
        note = f"   ? as an answer it would mean: {', '.join(other.errors)} (decode status ...)"
        lines.append([("odd", note)])
    return Outcome(dissection.ok, lines, dissection.as_json())


def crc_steps(text: str) -> Outcome:
    """Checksum and CRC of bytes, as they grow. The header of Protocol 1.0 does not count for its checksum."""
    data = parse_hex(text)
    lines: list[Line] = [[("dim", "byte   sum   checksum   CRC-16")]]
    plain = data[:2] == HEADER[1] and data[:4] != HEADER[2]
    crc = 0
    for count, byte in enumerate(data, 1):
        crc = crc_step(crc, byte)
        total = sum(data[2:count] if plain else data[:count])
        lines.append([("data", f"  {byte:02X} {total:5X}   {~total & 0xFF:8X}   {crc:04X}")])
    right = checksum(data[2:] if plain else data)
    lines.append(
        [("", f"Protocol 1.0 ends with {right:02X}" + (" (the header does not count)" if plain else ""))]
    )
    lines.append([("", f"Protocol 2.0 ends with {show_hex(crc.to_bytes(2, 'little'))}, low byte first")])
    return Outcome(
        lines=lines, data={"checksum": right, "crc": crc, "crc_bytes": show_hex(crc.to_bytes(2, "little"))}
    )


def scan(session: Session, rest: str) -> Outcome:
    """Find all servos."""
    found = session.scan()
    lines: list[Line] = [
        [("id", f"{f.id:>4}"), ("", f"  {f.model:<14} Protocol {f.protocol}.0  firmware {f.firmware}")]
        for f in found
    ]
    rows = [{"id": f.id, "model": f.model, "protocol": f.protocol, "firmware": f.firmware} for f in found]
    return Outcome(bool(found), lines or [[("bad", "nobody answers")]], {"servos": rows})


def trace(session: Session, rest: str) -> Outcome:
    """Show packets or not."""
    if rest not in ("on", "off"):
        raise UsageError("usage: trace on|off")
    session.traced = rest == "on"
    return Outcome()
