"""Packets that are well formed and yet pointless: what a servo would make of them, said beforehand."""

from kinlab.dynamixel.codec.checks import checksum
from kinlab.dynamixel.codec.dissection import Tables
from kinlab.dynamixel.codec.instructions import BROADCAST, BY_CODE, unpack
from kinlab.dynamixel.codec.packets import Packet, encode
from kinlab.dynamixel.tables import ControlTable

ONLY_BROADCAST = frozenset(
    {"SYNC_WRITE", "SYNC_READ", "FAST_SYNC_READ", "BULK_READ", "FAST_BULK_READ", "BULK_WRITE"}
)


def warnings(packet: Packet, tables: Tables) -> list[str]:
    """What is odd about an instruction packet, a sentence each.

    Args:
        tables: the control table of the servo with an id, None where there is no such servo.
    """
    instruction = BY_CODE[packet.protocol].get(packet.code)
    if instruction is None or packet.error is not None:
        return []
    values = unpack(instruction, packet.params)
    if values is None:
        return [f"the parameters do not fit {instruction.name}"]
    if packet.id == BROADCAST:
        return ["nobody answers a READ to all servos"] if instruction.name == "READ" else []
    found = []
    if instruction.name in ONLY_BROADCAST:
        found.append(f"{instruction.name} goes to all servos: its id must be FE")
    table = tables(packet.id)
    if table is None:
        return [*found, f"there is no servo {packet.id} here"]
    if table.protocol != packet.protocol:
        found.append(f"servo {packet.id} ({table.model}) speaks Protocol {table.protocol}.0")
    address = values.head.get("address")
    if instruction.name in ("WRITE", "REG_WRITE") and isinstance(address, int):
        found += _write_warnings(packet, table, address, bytes(values.head["data"]))
    elif instruction.name == "READ" and isinstance(address, int):
        found += _read_warnings(table, address, int(values.head["count"]))
    return found


def _read_warnings(table: ControlTable, address: int, count: int) -> list[str]:
    if count == 0:
        return ["it asks for no bytes"]
    if address + count > table.size:
        return [f"the table of {table.model} ends at address {table.size - 1}"]
    return []


def _write_warnings(packet: Packet, table: ControlTable, address: int, data: bytes) -> list[str]:
    if not data:
        return ["it writes no bytes"]
    registers = list(table.over(address, len(data)))
    if not registers:
        return [f"{table.model} has nothing at address {address}"]
    found = []
    locked = [r for r in registers if not r.writable]
    if len(locked) == len(registers):
        found.append(f"{locked[0].name} can only be read; {_as_read(packet)}")
    for register in registers:
        if not register.writable or address > register.address or address + len(data) < register.end:
            continue
        value = register.decode(data[register.address - address : register.end - address])
        for limit, over in ((register.low, False), (register.high, True)):
            if limit.lstrip("-").isdigit() and (value > int(limit) if over else value < int(limit)):
                found.append(f"{register.name} goes from {register.low} to {register.high}, not to {value}")
    return found


def _as_read(packet: Packet) -> str:
    """What the packet would be with READ in the place of WRITE."""
    meant = encode(Packet(packet.protocol, packet.id, 0x02, packet.params))
    if packet.protocol == 1:
        return f"did you mean READ (02)? Then the checksum is {checksum(meant[2:-1]):02X}"
    return f"did you mean READ (02)? Then the CRC is {meant[-2:].hex(' ').upper()}"
