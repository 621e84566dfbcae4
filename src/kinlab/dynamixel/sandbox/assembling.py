"""Sandbox commands that put a packet together byte by byte."""

import re

from kinlab.dynamixel.codec.checks import checksum, crc16
from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.dissection import Dissection
from kinlab.dynamixel.codec.hextext import parse_hex, show_hex
from kinlab.dynamixel.sandbox.display import byte_spans, field_lines, style_of
from kinlab.dynamixel.sandbox.session import Line, Outcome, Session
from kinlab.dynamixel.sandbox.wire import right_check, taken_apart

_BYTES = re.compile(r"(0x|\\x)?[0-9a-fA-F]{1,2}([\s,]+(0x|\\x)?[0-9a-fA-F]{1,2})*")


def looks_like_bytes(text: str) -> bool:
    """Whether a line is nothing but bytes."""
    return bool(_BYTES.fullmatch(text))


def step(session: Session, rest: str) -> Outcome:
    """Assemble a packet byte by byte: show what the new bytes are, the running check, and what comes next."""
    if rest == "off":
        session.assembling = None
        return Outcome(lines=[[("dim", "the packet is dropped")]])
    so_far = session.assembling or b""
    if rest == "back":
        session.assembling = so_far[:-1]
    else:
        session.assembling = so_far + parse_hex(rest)
    return under_way(session, session.assembling, len(so_far) if rest != "back" else len(session.assembling))


def under_way(session: Session, data: bytes, known: int = 0) -> Outcome:
    """A packet that is being put together: what its bytes are, the running check, and what comes next.

    Args:
        known: how many bytes at the beginning need no words any more.
    """
    dissection = _unfinished(session, data)
    lines: list[Line] = [[("arrow", "+> "), *byte_spans(dissection)]]
    lines += field_lines(_only_from(dissection, known))
    lines += [[("bad", f"   ! {p.message} (byte {p.offset})")] for p in dissection.problems]
    if dissection.next:
        lines.append([("check", f"   {_running(dissection, data)}")])
        lines.append([("verb", f"   next: {_what_next(dissection, data)}")])
    else:
        lines.append([("good", "   the packet is whole: send, or step back")])
    return Outcome(lines=lines, data={"assembling": show_hex(data), "next": dissection.next})


def _unfinished(session: Session, data: bytes) -> Dissection:
    return dissect(data, protocol=None if len(data) > 3 else session.protocol, tables=session.table)


def _only_from(dissection: Dissection, offset: int) -> Dissection:
    fields = [part for part in dissection.fields if part.offset + len(part.data) > offset]
    return Dissection(dissection.protocol, fields=fields)


def _running(dissection: Dissection, data: bytes) -> str:
    if dissection.protocol == 2:
        return f"CRC so far: {show_hex(crc16(data).to_bytes(2, 'little'))}"
    return f"checksum so far: {checksum(data[2:]):02X}"


def _what_next(dissection: Dissection, data: bytes) -> str:
    name = dissection.next
    if name in ("checksum", "crc"):
        covered = next((f.offset for f in dissection.fields if f.name == name), len(data))
        right = right_check(data[:covered])
        return f"{name}, and it should be {show_hex(right[len(data) - covered :])}"
    if name == "header":
        return "header: FF FF begins a packet (Protocol 2.0: FF FF FD 00)"
    hints = {
        "id": "which servo (FE: all)",
        "length": "how many bytes follow",
        "instruction": "what to do (01 PING, 02 READ, 03 WRITE ...)",
        "address": "where in the control table",
        "count": "how many bytes to read",
        "data": "what to store, low byte first",
    }
    return f"{name}: {hints[name]}" if name in hints else name


def walk_through(session: Session, data: bytes) -> Outcome:
    """How a packet comes about, byte by byte, with the running check."""
    whole = taken_apart(session, data)
    lines: list[Line] = [[("arrow", "=> "), *byte_spans(whole), ("dim", "  not sent")]]
    for part in whole.fields:
        for index, byte in enumerate(part.data):
            at = part.offset + index
            running = _running(whole, data[: at + 1]) if part.name not in ("checksum", "crc") else ""
            note = part.meaning if index == 0 else ""
            lines.append(
                [
                    ("dim", f"   {at:>3}  "),
                    (style_of(part.name), f"{byte:02X}  {part.name:<12}"),
                    ("check", f" {running:<22}"),
                    ("", f" {note}"),
                ]
            )
    return Outcome(lines=lines, data={"packet": show_hex(data), **whole.as_json()})
