"""What helps while a line is typed: what may follow, how it will be understood, what it would send."""

import re

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.hextext import HexError, parse_hex, show_hex
from kinlab.dynamixel.codec.packets import encode
from kinlab.dynamixel.outfit import known_chains
from kinlab.dynamixel.sandbox.assembling import looks_like_bytes, under_way
from kinlab.dynamixel.sandbox.commands import VERBS
from kinlab.dynamixel.sandbox.display import packet_lines, style_of
from kinlab.dynamixel.sandbox.requests import REQUESTS, build_packet
from kinlab.dynamixel.sandbox.session import Line, Outcome, Session
from kinlab.dynamixel.sandbox.wire import right_check, taken_apart
from kinlab.dynamixel.tables import models
from kinlab.errors import UsageError

OF_BYTES = frozenset({"send", "decode", "step", "expect", "crc"})
WITH_ID = frozenset({"servo", "table", "set", "fault", "push", *REQUESTS}) - {"syncwrite", "syncread"}
WITH_REGISTER = frozenset({"read", "write", "regwrite", "table", "set"})
WORDS = {
    "fault": ("overload", "overheating", "input_voltage", "stuck", "dead", "off", "baud"),
    "trace": ("on", "off"),
    "echo": ("on", "off"),
    "power": ("on", "off"),
    "expect": ("silence", "error=", "count="),
    "step": ("back", "off", *REQUESTS),
    "build": tuple(REQUESTS),
    "help": tuple(VERBS),
}


def candidates(session: Session, text: str) -> list[tuple[str, str]]:
    """What the word at the end of `text` may become, each with a note."""
    words = text.rsplit(";", 1)[-1].lstrip().split(" ")
    possible = _possible(session, [word for word in words[:-1] if word])
    return [(found, note) for found, note in possible if found.startswith(words[-1])]


def _possible(session: Session, before: list[str]) -> list[tuple[str, str]]:
    if before and before[0] in ("build", "step", "help") and len(before) > 1:
        before = before[1:]
    if not before:
        return [(name, verb.meaning) for name, verb in VERBS.items()]
    verb, place = before[0], len(before)
    if verb in ("syncwrite", "syncread") and place == 1:
        return _registers(session, next(iter(session.ids()), 0))
    if verb == "chain" and place == 1:
        return known_chains()
    if place == 1 and verb in WITH_ID:
        ids = [(str(i), table.model if (table := session.table(i)) else "") for i in session.ids()]
        return [*ids, *((m, "") for m in models())] if verb == "table" else ids
    if place >= 2 and verb in WITH_REGISTER and before[1].isdecimal() and (place == 2 or verb == "table"):
        return _registers(session, int(before[1]))
    return [(word, "") for word in WORDS.get(verb, ())]


def _registers(session: Session, servo: int) -> list[tuple[str, str]]:
    table = session.table(servo)
    return [(r.name, f"@{r.address} {r.size}B {r.access}") for r in (table.registers if table else ())]


def coloured(session: Session, line: str) -> Line:
    """A line in the styles of its parts: a command as one, bytes by the field that they belong to."""
    code, sign, comment = line.partition("#")
    match = re.match(r"(\s*)(\S*)(.*)", code)
    assert match is not None
    blank, verb, rest = match.groups()
    after: Line = [("dim", sign + comment)]
    if session.assembling is not None and looks_like_bytes(code.strip()):
        return [*_bytes(session, code, session.assembling), *after]
    head: Line = [("", blank), ("verb" if verb in VERBS else "bad", verb)]
    if verb in OF_BYTES:
        before = session.assembling or b"" if verb == "step" else b""
        return [*head, *_bytes(session, rest, before), *after]
    return [*head, ("", rest), *after]


def _bytes(session: Session, text: str, before: bytes) -> Line:
    """Hexadecimal bytes in the styles of their fields; `before` are those that were assembled earlier."""
    spans: Line = []
    styles: dict[int, str] = {}
    words = re.findall(r"\s+|\S+", text)
    values = [_value(word) for word in words]
    data = before + b"".join(value for value in values if value)
    for part in dissect(data, tables=session.table).fields:
        styles.update(dict.fromkeys(range(part.offset, part.offset + len(part.data)), style_of(part.name)))
    at = len(before)
    for word, value in zip(words, values, strict=True):
        spans.append((styles.get(at, "") if value else "", word))
        at += len(value or b"")
    return spans


def _value(word: str) -> bytes | None:
    try:
        return parse_hex(word) if not word.isspace() else None
    except HexError:
        return None


def hint(session: Session, text: str) -> str:
    """How the command goes that a line begins with, or what the bytes typed so far come to; "" for an empty line."""
    verb, _, rest = text.strip().partition(" ")
    if session.assembling is not None and (not verb or looks_like_bytes(text.strip())):
        return _about(session, session.assembling + (_value(text) or b""))
    if verb in ("send", "decode") and rest:
        try:
            return _about(session, parse_hex(rest.removeprefix("status").removesuffix("..")))
        except HexError as error:
            return str(error).splitlines()[0]
    if verb in VERBS:
        return f"{VERBS[verb].usage}   {VERBS[verb].meaning}"
    return "  ".join(name for name in VERBS if verb and name.startswith(verb))


def _about(session: Session, data: bytes) -> str:
    dissection = dissect(data, tables=session.table)
    if dissection.problems:
        return dissection.problems[0].message
    if dissection.next in ("checksum", "crc"):
        return f"next: {dissection.next}, which would be {show_hex(right_check(data))}"
    if dissection.next:
        return f"{len(data)} bytes; next: {dissection.next}"
    return f"{len(data)} bytes, a whole packet"


def preview(session: Session, text: str) -> Outcome | None:
    """The packet that a line, as far as it is typed, would send, add to or take apart; None if there is none yet."""
    text = text.split("#", 1)[0].strip()
    verb, _, rest = text.partition(" ")
    try:
        if session.assembling is not None and (not text or looks_like_bytes(text)):
            return under_way(session, session.assembling + parse_hex(text))
        if verb == "step" and (not rest or looks_like_bytes(rest)):
            return under_way(session, (session.assembling or b"") + parse_hex(rest))
        if verb in ("send", "decode"):
            body, dots, _ = rest.removeprefix("status").partition("..")
            data = parse_hex(body)
            return under_way(session, data + right_check(data) if dots else data) if data else None
        if verb in REQUESTS:
            data = encode(build_packet(session, text.split()))
            remark = f"{len(data)} bytes, not sent yet"
            return Outcome(lines=packet_lines("=", data, remark, taken_apart(session, data), session.table))
    except UsageError:
        pass  # Not a whole command yet; running it would tell.
    return None
