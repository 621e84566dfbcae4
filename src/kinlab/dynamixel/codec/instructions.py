"""The one description of what a packet holds: building, parsing and explaining it all follow this."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from kinlab.errors import UsageError

BROADCAST = 0xFE
STATUS = 0x55
CLEAR_KEY = bytes.fromhex("44584C22")
BACKUP_KEY = bytes.fromhex("4354524C")


class Slot(NamedTuple):
    """A parameter: `size` bytes; None: as many as the slot "length" before it says, else all that follow."""

    name: str
    size: int | None
    meaning: str = ""


class Instruction(NamedTuple):
    """What a packet tells a servo to do. `each` repeats to the end of the parameters."""

    name: str
    code: int
    meaning: str
    head: tuple[Slot, ...] = ()
    each: tuple[Slot, ...] = ()


class Parameters(NamedTuple):
    """Parameters by slot: those of the head, and one mapping for every repetition."""

    head: dict[str, int | bytes]
    rows: list[dict[str, int | bytes]]


def _plain(width: int) -> tuple[Instruction, ...]:
    """The instructions that both protocols have; an address or a count takes `width` bytes."""
    address, count = Slot("address", width), Slot("count", width, "how many bytes to read")
    data = Slot("data", None)
    length = Slot("length", width, "how many bytes each servo gets")
    return (
        Instruction("PING", 0x01, "ask whether the servo is there"),
        Instruction("READ", 0x02, "ask for bytes of the control table", (address, count)),
        Instruction("WRITE", 0x03, "store bytes in the control table", (address, data)),
        Instruction("REG_WRITE", 0x04, "keep a write back until ACTION", (address, data)),
        Instruction("ACTION", 0x05, "carry out what REG_WRITE kept back"),
        Instruction("REBOOT", 0x08, "restart the servo"),
        Instruction(
            "SYNC_WRITE",
            0x83,
            "store bytes at the same address of many servos",
            (address, length),
            (Slot("id", 1), data),
        ),
    )


_ZERO = Slot("zero", 1, "always 0")
_OPTION = Slot("option", 1)
BULK_ITEM_1 = (Slot("count", 1, "how many bytes to read"), Slot("id", 1), Slot("address", 1))
_ITEM_2 = (Slot("id", 1), Slot("address", 2), Slot("count", 2, "how many bytes to read"))
_SYNC_READ = (Slot("address", 2), Slot("count", 2, "how many bytes to read"))
_ONE_ANSWER = "; all answers come in one packet"

PROTOCOL_1 = (
    *_plain(1),
    Instruction("FACTORY_RESET", 0x06, "set everything back to the factory's values"),
    Instruction("BULK_READ", 0x92, "ask servos for bytes of different addresses", (_ZERO,), BULK_ITEM_1),
)

PROTOCOL_2 = (
    *_plain(2),
    Instruction("FACTORY_RESET", 0x06, "set back to the factory's values", (_OPTION,)),
    Instruction(
        "CLEAR", 0x10, "forget the turns counted so far", (_OPTION, Slot("key", 4, "against accidents"))
    ),
    Instruction(
        "CONTROL_TABLE_BACKUP",
        0x20,
        "store or restore a copy of the control table",
        (_OPTION, Slot("key", 4, "against accidents")),
    ),
    Instruction("SYNC_READ", 0x82, "ask many servos for the same bytes", _SYNC_READ, (Slot("id", 1),)),
    Instruction(
        "FAST_SYNC_READ",
        0x8A,
        "ask many servos for the same bytes" + _ONE_ANSWER,
        _SYNC_READ,
        (Slot("id", 1),),
    ),
    Instruction("BULK_READ", 0x92, "ask servos for bytes of different addresses", (), _ITEM_2),
    Instruction("FAST_BULK_READ", 0x9A, "ask servos for different bytes" + _ONE_ANSWER, (), _ITEM_2),
    Instruction(
        "BULK_WRITE",
        0x93,
        "store bytes at different addresses of servos",
        (),
        (
            Slot("id", 1),
            Slot("address", 2),
            Slot("length", 2, "how many bytes this servo gets"),
            Slot("data", None),
        ),
    ),
)

BY_NAME = {1: {i.name: i for i in PROTOCOL_1}, 2: {i.name: i for i in PROTOCOL_2}}
BY_CODE = {1: {i.code: i for i in PROTOCOL_1}, 2: {i.code: i for i in PROTOCOL_2}}

OPTIONS = {
    "FACTORY_RESET": {
        0xFF: "everything",
        0x01: "everything but the ID",
        0x02: "everything but ID and baud rate",
    },
    "CLEAR": {0x01: "the turns of the present position"},
    "CONTROL_TABLE_BACKUP": {0x01: "store", 0x02: "restore"},
}

ERROR_BITS_1 = (
    "input voltage",
    "angle limit",
    "overheating",
    "range",
    "checksum",
    "overload",
    "instruction",
)
ERRORS_2 = {
    1: "result fail",
    2: "instruction",
    3: "CRC",
    4: "data range",
    5: "data length",
    6: "data limit",
    7: "access",
}
ALERT = 0x80


def error_names(protocol: int, error: int) -> list[str]:
    """What the error byte of a status packet says, in words; empty if all is well."""
    if protocol == 1:
        return [name for bit, name in enumerate(ERROR_BITS_1) if error >> bit & 1] + (
            ["bit 7, which is always 0"] if error & 0x80 else []
        )
    names = ["alert: see hardware_error_status"] if error & ALERT else []
    number = error & 0x7F
    return names + ([ERRORS_2.get(number, f"unknown error {number}")] if number else [])


def pack(
    instruction: Instruction,
    head: Mapping[str, int | bytes] | None = None,
    rows: Sequence[Mapping[str, int | bytes]] = (),
) -> bytes:
    """Values by slot as the bytes of the parameters.

    Raises:
        UsageError: a value that does not fit into its slot.
    """
    packed = bytearray()
    for slots, values in [(instruction.head, head or {}), *((instruction.each, row) for row in rows)]:
        for slot in slots:
            value = values.get(slot.name, 0)
            if isinstance(value, bytes):
                packed += value
                continue
            size = slot.size or 1
            try:
                packed += value.to_bytes(size, "little")
            except OverflowError:
                plural = "s" if size > 1 else ""
                raise UsageError(f"{slot.name} {value} does not fit into {size} byte{plural}") from None
    return bytes(packed)


def slots(instruction: Instruction, params: bytes) -> Iterator[tuple[Slot, int, bytes]]:
    """Every parameter with its offset and bytes; the last may be cut short, what is beyond has no slot."""
    at = 0
    length: int | None = None
    row = instruction.head
    while True:
        for slot in row:
            size = slot.size if slot.size is not None else length if length is not None else len(params) - at
            part = params[at : at + size]
            yield slot, at, part
            if slot.name == "length":
                length = int.from_bytes(part, "little")
            at += size
        row = instruction.each
        if not row or at >= len(params):
            return


def unpack(instruction: Instruction, params: bytes) -> Parameters | None:
    """Parameters by slot; None where they do not fit the instruction's description."""
    head: dict[str, int | bytes] = {}
    rows: list[dict[str, int | bytes]] = []
    fields = len(instruction.head)
    values = head
    end = 0
    for index, (slot, at, part) in enumerate(slots(instruction, params)):
        if index >= fields and (index - fields) % len(instruction.each) == 0:
            values = {}
            rows.append(values)
        if slot.size is None:
            values[slot.name] = part
            length = values.get("length", head.get("length"))
            if length is not None and len(part) != length:
                return None
        elif len(part) != slot.size:
            return None
        else:
            values[slot.name] = part if slot.name == "key" else int.from_bytes(part, "little")
        end = at + len(part)
    return Parameters(head, rows) if end == len(params) else None
