"""The bytes of a packet: the first wrong one is named, and said what it is for."""

from collections.abc import Sequence

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.hextext import HexError, parse_hex, show_hex
from kinlab.lessons.replies import LONGEST, UnreadableError, clean, quote
from kinlab.lessons.task import Task, Verdict

# What is said of a field in words.toml, under bytes.field.
EXPLAINED = (
    "header", "id", "length", "instruction", "error", "address", "count", "data", "stuffing", "checksum", "crc",
)  # fmt: skip


def shape(task: Task) -> str:
    """Hexadecimal, in any of the usual spellings."""
    return task.say("bytes.shape")


def right(task: Task) -> str:
    """All of them."""
    return show_hex(bytes(task.answer))


def wrong(task: Task) -> Sequence[str]:
    """Each byte in turn with a bit turned over, the packet cut short, and one byte too many."""
    want = bytes(task.answer)
    damaged = [want[:i] + bytes([want[i] ^ 1]) + want[i + 1 :] for i in range(len(want))]
    return [show_hex(data) for data in (*damaged, want[:-1], want + b"\x00")]


def judge(task: Task, reply: str) -> Verdict:
    """Byte by byte, from the first."""
    text = clean(reply, 4 * LONGEST)
    try:
        got = parse_hex(text)
    except HexError as error:
        raise UnreadableError("no-bytes", text=quote(text[error.position :] or text)) from None
    if not got:
        raise UnreadableError("empty")
    want = bytes(task.answer)
    if got == want:
        return task.verdict(True, "right", count=len(want))
    for number, slip in enumerate(task.slips):
        if got == bytes(slip):
            return task.slip(number)
    if len(got) < len(want) and want.startswith(got):
        return task.verdict(
            False, "short", count=len(got), name=field_of(want, len(got)), why=_why(task, want, len(got))
        )
    if got.startswith(want):
        more = range(len(want), len(got))
        return task.verdict(False, "long", faults=more, count=len(want), more=len(more))
    at = next(i for i, (a, b) in enumerate(zip(got, want, strict=False)) if a != b)
    return task.verdict(
        False,
        "byte",
        faults=[at],
        number=at + 1,
        byte=f"{got[at]:02X}",
        name=field_of(want, at),
        why=_why(task, want, at),
    )


def field_of(packet: bytes, at: int) -> str:
    """The name of the field that a byte of a right packet belongs to; bytes that are no packet are data."""
    for part in dissect(packet).fields:
        if part.offset <= at < part.offset + len(part.data):
            return part.name if part.name != "noise" else "data"
    return "data"


def _why(task: Task, packet: bytes, at: int) -> str:
    name = field_of(packet, at)
    protocol = "2" if packet.startswith(b"\xff\xff\xfd\x00") else "1"
    if name in ("header", "length"):
        return task.say(f"bytes.field.{name}{protocol}")
    return task.say(f"bytes.field.{name}") if name in EXPLAINED else ""
