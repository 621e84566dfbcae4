"""The arm paper's Tables 2.1 to 2.10 and 4.1, by the RX-24F's control table, the codec and the ATmega128's sheet."""

from collections.abc import Iterator

from kinlab.dynamixel.codec.instructions import BY_CODE
from kinlab.dynamixel.tables import BIT10, load_table
from kinlab.papers.recompute.finding import Cause, Finding, Judge
from kinlab.papers.tables import Cell, printed_table

NAME = "receptionist-arm"
JUDGE = Judge(NAME)
SERVO = load_table("RX-24F")
CLOCK = 2_000_000
# Where the AX-12's manual of 2006-06-14, section 3-4, differs from the RX-24F, by address.
AX_12_OF_2006 = {0: 12, 4: 1, 11: 85, 17: 4, 18: 4, 26: 0, 27: 0}
# The same manual where the RX-24F's sheet says nothing: of the reserved bytes and of the moving speed.
AX_12_ALONE = {10: 0, 19: 0, 32: 0, 33: 0, 45: 0}
# From bit 7 to bit 0: ATmega128 data sheet, USART registers.
UCSRB = ("RXCIE", "TXCIE", "UDRIE", "RXEN", "TXEN", "UCSZ2", "RXB8", "TXB8")
UCSRA = ("RXC", "TXC", "UDRE", "FE", "DOR", "PE", "U2X", "MPCM")
CODES = {
    "PING": "PING", "READ DATA": "READ", "WRITE DATA": "WRITE", "REG WRITE": "REG_WRITE", "ACTION": "ACTION",
    "RESET": "FACTORY_RESET", "SYNC WRITE": "SYNC_WRITE",
}  # fmt: skip


def tables() -> Iterator[Finding]:
    """Table by table."""
    yield from control_table()
    yield from baud_rates()
    yield from return_levels()
    yield from slopes()
    yield from load_bits()
    yield from instructions()
    yield from usart()
    for cell in printed_table(NAME, "4.1").cells():
        yield JUDGE.measured(cell, "found by trial: what worked well enough")


def _hex(cell: Cell, value: float, remark: str = "") -> Finding:
    return JUDGE.cell(cell, value, f"{value:g} = {int(value):#04x}", remark=remark)


def control_table() -> Iterator[Finding]:
    """Table 2.1, by the servo's own table, address by address."""
    for address, cells in enumerate(printed_table(NAME, "2.1").rows.values()):
        register = SERVO.by_byte[address]
        byte = address - register.address
        for column, cell in cells.items():
            if column == "decimal":
                line = f"{address} items stand before it, each of one byte"
                yield JUDGE.cell(cell, address, line, remark=_name_of(address))
            elif column == "hex":
                yield _hex(cell, address)
            elif column == "initial" and address in AX_12_ALONE:
                own = AX_12_ALONE[address]
                line = f"AX-12, in its manual of 2006: {own}; the RX-24F's sheet has nothing"
                yield JUDGE.cell(cell, own, line)
            elif column == "initial":
                whole = int(register.initial)
                own = whole >> 8 * byte & 0xFF
                yield JUDGE.cell(
                    cell, own, f"RX-24F, {register.title}: {whole}, byte {byte}: {own}", _of_ax_12(address)
                )
            elif column == "initial hex":
                remark = "the scan or the print has 1X for 0X" if cell.figure.damaged else ""
                yield _hex(cell, cells["initial"].figure.value, remark)
            else:
                source = SERVO.find("present_position" if register.name == "goal_position" else "max_torque")
                own = source.address + byte
                yield JUDGE.cell(cell, own, f"{register.title} begins as {source.title}, address {own}")


def _name_of(address: int) -> str:
    named_twice = "the item is called CCW Compliance Margin, as at 27; it is the CCW Compliance Slope"
    return named_twice if address == SERVO.find("ccw_compliance_slope").address else ""


def _of_ax_12(address: int) -> list[Cause]:
    if address not in AX_12_OF_2006:
        return []
    value = AX_12_OF_2006[address]
    return [
        Cause("the initial value of the AX-12, in its manual of 2006", value, arithmetic=f"AX-12: {value}")
    ]


def baud_rates() -> Iterator[Finding]:
    """Table 2.2: 2000000 / (value + 1), and how far that is from the usual rate."""
    rows = list(printed_table(NAME, "2.2").rows.values())
    errors, lines = [], []
    for cells in rows:
        goal, value = cells["goal"].figure.value, cells["address 4"].figure.value
        speed = CLOCK / (value + 1)
        errors.append((goal - speed) / goal * 100)
        lines.append(f"({goal:.0f} - {speed:.2f}) / {goal:.0f} = {errors[-1]:.3f} %")
    below = [
        [Cause("the error of the row below", error, arithmetic=line)]
        for error, line in zip(errors[1:], lines[1:], strict=True)
    ]
    for cells, error, line, slip in zip(rows, errors, lines, [*below, []], strict=True):
        goal, value = cells["goal"].figure.value, cells["address 4"].figure.value
        speed = CLOCK / (value + 1)
        nearest = round(CLOCK / goal) - 1
        yield JUDGE.cell(cells["address 4"], nearest, f"{CLOCK} / {goal:.0f} - 1 = {CLOCK / goal - 1:.2f}")
        yield _hex(cells["hex"], value)
        yield JUDGE.cell(cells["set"], speed, f"{CLOCK} / ({value:.0f} + 1) = {speed:.2f}")
        yield JUDGE.measured(cells["goal"], "a usual rate, chosen")
        yield JUDGE.cell(cells["error"], error, line, slip)


def return_levels() -> Iterator[Finding]:
    """Table 2.3."""
    told = {"nothing is answered": "PING only", "READ DATA is answered": "READ", "all is answered": "all"}
    levels = SERVO.find("status_return_level").values
    for row, cells in printed_table(NAME, "2.3").rows.items():
        number, meaning = next((n, text) for n, text in levels if text.endswith(told[row]))
        remark = "PING is answered at every level" if "PING only" in meaning else ""
        yield JUDGE.cell(
            cells["address 16"], number, f"RX-24F, Status Return Level {number}: {meaning}", remark=remark
        )


def slopes() -> Iterator[Finding]:
    """Table 2.4: each step begins at twice the value at which the last one began."""
    highest = int(SERVO.find("cw_compliance_slope").high)
    for step, cells in enumerate(printed_table(NAME, "2.4").rows.values(), 1):
        begins = 0 if step == 1 else 2**step
        ends = min(2 ** (step + 1) - 1, highest)
        own = {"number": step, "from": begins, "to": ends, "representative": 2**step}
        lines = {
            "number": f"step {step} of seven",
            "from": f"2^{step} = {2**step}" if step > 1 else "the lowest value",
            "to": f"2^{step + 1} - 1 = {2 ** (step + 1) - 1}, at most {highest}",
            "representative": f"2^{step} = {2**step}",
        }
        for column, cell in cells.items():
            decimal = column.removesuffix(" hex")
            if column != decimal:
                yield _hex(cell, cells[decimal].figure.value)
            else:
                remark = "3 belongs to no step of the table" if (step, column) == (1, "to") else ""
                yield JUDGE.cell(cell, own[column], lines[column], remark=remark)


def load_bits() -> Iterator[Finding]:
    """Table 2.5: ten bits of load, one of direction, and zeros in a register of sixteen."""
    register = SERVO.find("present_load")
    direction = BIT10.bit_length() - 1
    rows = printed_table(NAME, "2.5").rows
    places = {row: direction - k for k, row in enumerate(list(rows)[1:])}
    for row, cells in rows.items():
        kind = row.partition(" ")[0]
        own = places.get(row, 8 * register.size - 1)
        line = {
            "zero": f"{register.size} bytes = {8 * register.size} bits, the highest is {8 * register.size - 1}",
            "direction": f"RX-24F: {BIT10} = 2^{direction} is the direction",
            "load": f"RX-24F: loads go to {BIT10 - 1} = 2^{direction} - 1, that is bits {direction - 1} to 0",
        }[kind]
        yield JUDGE.cell(cells["bit"], own, line)
        if "down to" in cells:
            yield JUDGE.cell(cells["down to"], direction + 1, f"the bits above the direction's, {direction}")
            yield JUDGE.cell(
                cells["value"], int(register.high) >> 11, f"{register.high} / 2^11 = 0, the rest left off"
            )


def instructions() -> Iterator[Finding]:
    """Table 2.6, by the codec."""
    by_name = {instruction.name: instruction.code for instruction in BY_CODE[1].values()}
    above = 0.0
    for row, cells in printed_table(NAME, "2.6").rows.items():
        code = by_name[CODES[row]]
        causes = [
            Cause("the value of the row above", above, arithmetic=f"above it {above:g}"),
            Cause("counted on from the row above", above + 1, arithmetic=f"{above:g} + 1 = {above + 1:g}"),
        ]
        yield JUDGE.cell(cells["value"], code, f"Protocol 1.0: {CODES[row]} is {code:#04x} = {code}", causes)
        above = cells["value"].figure.value


def usart() -> Iterator[Finding]:
    """Tables 2.7 to 2.10."""
    for number, bits in (("2.7", UCSRB), ("2.9", UCSRA)):
        for row, cells in printed_table(NAME, number).rows.items():
            place = bits.index(row)
            yield JUDGE.cell(
                cells["bit"], 7 - place, f"ATmega128: {place} bits stand above it, 7 - {place} = {7 - place}"
            )
    for row, cells in printed_table(NAME, "2.8").rows.items():
        for column, cell in cells.items():
            if column == "frame":
                yield JUDGE.cell(cell, 8 + 1, "ATmega128: 8 data bits and this one make 9")
            else:
                inverted = row == "UDRIE"
                remark = (
                    "Table 2.10 says that UDRE is 1 when the register is empty: that is when it interrupts"
                )
                line = (
                    "ATmega128: the interrupt comes while UDRE is 1"
                    if inverted
                    else "ATmega128: 1 switches it on"
                )
                yield JUDGE.cell(cell, 1, line, remark=remark if inverted else "")
    for cell in printed_table(NAME, "2.10").cells():
        yield JUDGE.cell(cell, 1, f"ATmega128: {cell.row} is set to 1 when that is so")
