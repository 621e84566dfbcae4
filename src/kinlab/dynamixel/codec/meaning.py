"""What addresses and data mean to a servo of a known model, in words."""

from typing import NamedTuple

from kinlab.dynamixel.codec.instructions import OPTIONS, Instruction, Slot
from kinlab.dynamixel.tables import ControlTable


class Piece(NamedTuple):
    """Bytes of one register: how many, their value if they are the whole of it, what they mean."""

    size: int
    value: int | None
    meaning: str
    register: str


def place(table: ControlTable | None, address: int) -> str:
    """An address: "address 30: Goal Position, 2 bytes, 0.29 deg per tick"."""
    if table is None:
        return f"address {address}"
    register = table.by_byte.get(address)
    if register is None:
        return f"address {address}: {table.model} has nothing there"
    if register.address == address:
        return register.headline()
    return f"address {address}: byte {address - register.address + 1} of {register.title}"


def extent(table: ControlTable | None, address: int, count: int) -> str:
    """How many bytes are to be read, and of what."""
    if table is None:
        return f"{count} byte(s) to read"
    names = [register.name for register in table.over(address, count)]
    shown = names if len(names) <= 3 else [names[0], "...", names[-1]]
    return f"{count} byte(s) to read: {', '.join(shown) or 'nothing'}"


def pieces(table: ControlTable | None, address: int, data: bytes) -> list[Piece]:
    """Data from an address on, one piece for each register that they belong to."""
    if table is None:
        return [Piece(len(data), None, f"{len(data)} byte(s) from address {address} on", "")] if data else []
    found: list[Piece] = []
    while data:
        register = table.by_byte.get(address)
        if register is None:
            piece = Piece(1, None, f"address {address}: {table.model} has nothing there", "")
        else:
            part = data[: register.end - address]
            if len(part) == register.size:
                value = register.decode(part)
                piece = Piece(len(part), value, f"{register.title} {register.describe(value)}", register.name)
            else:
                piece = Piece(len(part), None, f"part of {register.title}", register.name)
        found.append(piece)
        data = data[piece.size :]
        address += piece.size
    return found


def option(instruction: Instruction, value: int) -> str:
    """What an option byte chooses."""
    return OPTIONS[instruction.name].get(value, "no such option")


def signature(instruction: Instruction) -> str:
    """What an instruction takes: "address, length, [id, data]..."."""

    def names(row: tuple[Slot, ...]) -> str:
        return ", ".join(slot.name for slot in row)

    parts = [names(instruction.head)] if instruction.head else []
    return ", ".join(parts + ([f"[{names(instruction.each)}]..."] if instruction.each else []))
