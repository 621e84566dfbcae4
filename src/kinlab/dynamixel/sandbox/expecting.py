"""The sandbox command that turns a script into a test."""

from kinlab.dynamixel.codec.hextext import parse_hex, show_hex
from kinlab.dynamixel.codec.instructions import error_names
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.quantity import to_ticks
from kinlab.dynamixel.sandbox.session import Exchange, ExpectationError, Outcome, Session
from kinlab.dynamixel.sandbox.wire import taken_apart
from kinlab.errors import UsageError


def expect(session: Session, rest: str) -> Outcome:
    """Fail unless the last exchange brought that."""
    exchange = session.last
    packets = exchange.packets()
    if rest == "silence":
        _demand(not exchange.answers, "silence", show_hex(exchange.received))
    elif "=" in rest:
        name, _, wanted = rest.partition("=")
        _expect_value(session, exchange, packets, name.strip(), wanted.strip())
    else:
        _expect_bytes(exchange, rest)
    return Outcome(lines=[[("good", f"as expected: {rest}")]])


def _demand(holds: bool, wanted: str, got: str) -> None:
    if not holds:
        raise ExpectationError(f"expected {wanted}, got {got or 'silence'}")


def _expect_bytes(exchange: Exchange, rest: str) -> None:
    words = rest.replace(",", " ").split()
    if not words:
        raise UsageError("usage: expect BYTES|silence|error=E|REGISTER=VALUE|count=N")
    pattern = [None if word == "??" else parse_hex(word) for word in words]
    got = exchange.received
    size = sum(1 if part is None else len(part) for part in pattern)
    fits, at = len(got) == size, 0
    for part in pattern:
        width = 1 if part is None else len(part)
        fits = fits and (part is None or got[at : at + width] == part)
        at += width
    _demand(fits, rest, show_hex(got))


def _expect_value(
    session: Session, exchange: Exchange, packets: list[Packet], name: str, wanted: str
) -> None:
    if name == "count":
        _demand(str(len(packets)) == wanted, f"{wanted} answer(s)", str(len(packets)))
        return
    _demand(bool(packets), f"{name}={wanted}", show_hex(exchange.received))
    if name == "error":
        names = [text for p in packets for text in error_names(p.protocol, p.error or 0)]
        right = wanted in names or wanted in {str(p.error) for p in packets}
        _demand(right, f"error {wanted}", ", ".join(names) or "no error")
        return
    target, _, allowance = wanted.partition("+-")
    for _, data in exchange.answers:
        for part in taken_apart(session, data, exchange.request).fields:
            if part.register == name and isinstance(part.value, int):
                servo = packets[0].id
                table = session.table(servo)
                if table is None:
                    continue
                register = table.find(name)
                off = abs(part.value - to_ticks(target, register))
                allowed = abs(to_ticks(allowance, register)) if allowance else 0
                _demand(off <= allowed, f"{name}={wanted}", register.describe(part.value))
                return
    raise ExpectationError(f"expected {name}={wanted}, but the answer holds no {name}")
