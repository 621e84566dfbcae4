"""The line under the prompt: how a command goes, or what the bytes typed so far come to."""

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.hextext import HexError, parse_hex, show_hex
from kinlab.dynamixel.sandbox import VERBS, Session
from kinlab.dynamixel.sandbox.assembling import looks_like_bytes
from kinlab.dynamixel.sandbox.wire import right_check


def toolbar(session: Session, text: str) -> str:
    """What helps with the line as it stands."""
    verb, _, rest = text.strip().partition(" ")
    if session.assembling is not None and (not verb or looks_like_bytes(text.strip())):
        return _of_bytes(session, session.assembling + parse_hex(text))
    if verb in ("send", "decode") and rest:
        try:
            return _of_bytes(session, parse_hex(rest.removeprefix("status").removesuffix("..")))
        except HexError as error:
            return str(error).splitlines()[0]
    if verb in VERBS:
        return f"{VERBS[verb].usage}   {VERBS[verb].meaning}"
    matching = [name for name in VERBS if verb and name.startswith(verb)]
    return "  ".join(matching) if matching else "Tab completes, help lists the commands, Ctrl-D leaves"


def _of_bytes(session: Session, data: bytes) -> str:
    dissection = dissect(data, tables=session.table)
    if dissection.problems:
        return dissection.problems[0].message
    if dissection.next in ("checksum", "crc"):
        return f"next: {dissection.next}, which would be {show_hex(right_check(data))}"
    if dissection.next:
        return f"{len(data)} bytes; next: {dissection.next}"
    return f"{len(data)} bytes, a whole packet"
