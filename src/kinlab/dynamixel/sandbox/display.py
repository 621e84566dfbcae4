"""Packets as lines to read: bytes, fields, what is wrong, what is odd."""

from kinlab.dynamixel.codec.dissection import Dissection, Tables
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.lint import warnings
from kinlab.dynamixel.sandbox.session import Line, Span
from kinlab.dynamixel.tables import ControlTable, Register

STYLES = {
    "header": "header",
    "id": "id",
    "length": "length",
    "count": "length",
    "instruction": "instruction",
    "error": "instruction",
    "address": "address",
    "checksum": "check",
    "crc": "check",
    "noise": "bad",
    "surplus": "bad",
}


def style_of(name: str) -> str:
    """The style of a field."""
    return STYLES.get(name, "data")


def byte_spans(dissection: Dissection) -> list[Span]:
    """The bytes in a row, each in the style of its field."""
    spans: list[Span] = []
    for part in dissection.fields:
        spans += [(style_of(part.name), show_hex(part.data)), ("", " ")]
    return spans


def packet_lines(arrow: str, data: bytes, remark: str, dissection: Dissection, tables: Tables) -> list[Line]:
    """A packet with its fields under it, and what is wrong or odd about it."""
    lines: list[Line] = [[("arrow", f"{arrow} "), *byte_spans(dissection), ("dim", f"  {remark}")]]
    if not data:
        lines = [[("arrow", f"{arrow} "), ("dim", remark)]]
    lines += field_lines(dissection)
    lines += [[("bad", f"   ! {p.message} (byte {p.offset})")] for p in dissection.complaints]
    if dissection.packet and dissection.kind == "instruction":
        lines += [[("odd", f"   ? {text}")] for text in warnings(dissection.packet, tables)]
    return lines


def field_lines(dissection: Dissection) -> list[Line]:
    """One line for each field."""
    lines: list[Line] = []
    for part in dissection.fields:
        style = style_of(part.name)
        lines.append(
            [
                ("dim", f"   {part.offset:>3}  "),
                (style, f"{show_hex(part.data):<12} "),
                (style, f"{part.name:<12} "),
                ("", part.meaning),
            ]
        )
    return lines


def table_lines(table: ControlTable, registers: list[Register]) -> list[Line]:
    """Registers of a control table, one line each; those that differ only in a number stand together."""
    head = (
        f"{'addr':>4} {'size':>4}  {'name':<26} {'access':<6} {'area':<6} {'initial':>8} {'range':>22}  unit"
    )
    lines: list[Line] = [
        [("dim", f"{table.model}: model number {table.number}, Protocol {table.protocol}.0")],
        [("dim", head)],
    ]
    for register in registers:
        if (
            register.name.startswith("indirect")
            and len(registers) > 8
            and not register.name.endswith(("_1", "_29"))
        ):
            continue
        span = f"{register.low} .. {register.high}" if register.low or register.high else ""
        unit = f"{register.scale:.4g} {register.unit}" if register.unit else ""
        more = " ..." if register.name.startswith("indirect") and len(registers) > 8 else ""
        lines.append(
            [
                ("address", f"{register.address:>4} {register.size:>4}  "),
                ("data", f"{register.name + more:<26} "),
                (
                    "",
                    f"{register.access:<6} {register.area:<6} {register.initial or '-':>8} {span:>22}  {unit:<14} ",
                ),
                ("dim", register.meaning),
            ]
        )
    return lines
