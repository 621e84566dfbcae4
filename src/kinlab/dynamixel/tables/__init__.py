"""Control tables: what each address of a servo means. The tables are the CSV files beside this module."""

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path

from kinlab.errors import UsageError
from kinlab.names import resolve

HERE = Path(__file__).parent
BIT10 = 0x400


@dataclass(frozen=True)
class Register:
    """One item of a control table.

    Attributes:
        name: as people type it ("goal_position"); `title` as the manual prints it.
        initial: a number, a reference to another register ("=max_torque"), or "" (measured at power-on).
        low, high: limits of what may be written: a number, a reference ("-pwm_limit"), or "" (none).
        scale, unit: one tick is `scale` `unit`s; unit "" where ticks are all there is.
        encoding: "plain" (unsigned), "two" (two's complement) or "bit10" (magnitude, bit 10 set: clockwise).
        values: what single values or bits are called, as (number, name).
    """

    address: int
    size: int
    title: str
    access: str
    area: str
    initial: str
    low: str
    high: str
    scale: float
    unit: str
    encoding: str
    values: tuple[tuple[int, str], ...]
    is_bits: bool
    meaning: str

    @cached_property
    def name(self) -> str:
        return re.sub(r"[^a-z0-9]+", "_", self.title.casefold()).strip("_")

    @property
    def end(self) -> int:
        return self.address + self.size

    @property
    def writable(self) -> bool:
        return self.access == "RW"

    def decode(self, data: bytes | bytearray) -> int:
        """The value in `data` (little endian), with its sign."""
        value = int.from_bytes(data, "little", signed=self.encoding == "two")
        if self.encoding == "bit10":
            return -(value & (BIT10 - 1)) if value & BIT10 else value & (BIT10 - 1)
        return value

    def encode(self, value: int) -> bytes:
        """`value` as the bytes on the wire.

        Raises:
            UsageError: it does not fit into the register's bytes.
        """
        if self.encoding == "bit10" and value < 0:
            value = BIT10 | -value
        try:
            return value.to_bytes(self.size, "little", signed=value < 0 and self.encoding == "two")
        except OverflowError:
            raise UsageError(f"{value} does not fit into {self.name} ({self.size} byte(s))") from None

    def physical(self, value: int) -> float:
        """Ticks in the register's unit (deg, rpm, %, V, degC, us, ms, rev/min2)."""
        return value * self.scale

    def ticks(self, amount: float) -> int:
        """An amount in the register's unit as the nearest number of ticks."""
        return round(amount / self.scale)

    def describe(self, value: int) -> str:
        """`value` as people read it: "512 = 150.15 deg", "36 = overheating, overload"."""
        if self.is_bits:
            names = [name for bit, name in self.values if value >> bit & 1]
            return f"{value} = {', '.join(names) or 'none'}"
        for number, name in self.values:
            if number == value:
                return f"{value} = {name}"
        return f"{value} = {self.physical(value):.5g} {self.unit}" if self.unit else str(value)

    def as_json(self) -> dict[str, object]:
        """As the command line prints it; limits and initial values as in the table."""
        return {
            "address": self.address,
            "size": self.size,
            "name": self.name,
            "title": self.title,
            "access": self.access,
            "area": self.area,
            "initial": self.initial,
            "min": self.low,
            "max": self.high,
            "scale": self.scale,
            "unit": self.unit,
            "meaning": self.meaning,
        }

    def headline(self) -> str:
        """The item in one line: "address 30: Goal Position, 2 bytes, 0.29 deg per tick"."""
        size = f"{self.size} byte{'s' if self.size > 1 else ''}"
        per_tick = f", {self.scale:.2g} {self.unit} per tick" if self.unit else ""
        return f"address {self.address}: {self.title}, {size}{per_tick}"


@dataclass(frozen=True)
class ControlTable:
    """A model's data sheet figures and its registers, in order of address."""

    model: str
    number: int
    protocol: int
    axes: int
    fast_reads: bool
    backup: bool
    no_load_rpm: float
    stall_nm: float
    stall_a: float
    rated_v: float
    gear_ratio: float
    step_deg: float
    lowest_v: float
    registers: tuple[Register, ...]

    @cached_property
    def by_name(self) -> dict[str, Register]:
        return {register.name: register for register in self.registers}

    @cached_property
    def by_byte(self) -> dict[int, Register]:
        """The register that each address belongs to; undocumented addresses are absent."""
        return {a: register for register in self.registers for a in range(register.address, register.end)}

    @property
    def size(self) -> int:
        return self.registers[-1].end

    def find(self, name: str) -> Register:
        """The register called `name`, or standing at an address: "goal_position", "goal_pos", "@30", "30".

        Raises:
            UsageError: there is none; the nearest names are given.
        """
        number = name.removeprefix("@")
        if number.isdigit() or number.casefold().startswith("0x"):
            try:
                return self.by_byte[int(number, 0)]
            except (KeyError, ValueError):
                raise UsageError(f"{self.model} has nothing at address {number}") from None
        return self.by_name[resolve(name.replace("-", "_").replace(" ", "_"), self.by_name, "register")]

    def over(self, address: int, count: int) -> Iterator[Register]:
        """The registers that have a byte in the `count` bytes from `address`."""
        return (r for r in self.registers if r.address < address + count and r.end > address)


def models() -> list[str]:
    """The models that have a table."""
    return list(_figures())


def load_table(model: str) -> ControlTable:
    """The table of `model` ("RX-24F", "xl430").

    Raises:
        UsageError: no such model; the nearest names are given.
    """
    return _load(resolve(model, models(), "servo model"))


def table_of_number(number: int) -> ControlTable | None:
    """The table of the model that reports `number` as its Model Number, None if it has none."""
    for model, figures in _figures().items():
        if int(figures["number"]) == number:
            return _load(model)
    return None


def _rows(name: str) -> list[dict[str, str]]:
    with (HERE / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@cache
def _figures() -> dict[str, dict[str, str]]:
    return {row["model"]: row for row in _rows("models")}


@cache
def _load(model: str) -> ControlTable:
    figures = _figures()[model]
    registers = [register for row in _rows(model) for register in _expand(_register(row))]
    return ControlTable(
        model=model,
        number=int(figures["number"]),
        protocol=int(figures["protocol"]),
        axes=int(figures["axes"]),
        fast_reads=figures["fast_reads"] == "yes",
        backup=figures["backup"] == "yes",
        registers=tuple(registers),
        **{
            key: float(figures[key])
            for key in (
                "no_load_rpm",
                "stall_nm",
                "stall_a",
                "rated_v",
                "gear_ratio",
                "step_deg",
                "lowest_v",
            )
        },
    )


def _register(row: dict[str, str]) -> Register:
    names = row["values"].removeprefix("bits: ")
    pairs = [entry.strip().split(" ", 1) for entry in names.split(";")] if names else []
    return Register(
        address=int(row["address"]),
        size=int(row["size"]),
        title=row["name"],
        access=row["access"],
        area=row["area"],
        initial=row["initial"],
        low=row["min"],
        high=row["max"],
        scale=float(row["scale"] or 1),
        unit=row["unit"],
        encoding=row["encoding"],
        values=tuple((int(number), name) for number, name in pairs),
        is_bits=names != row["values"],
        meaning=row["meaning"],
    )


def _expand(register: Register) -> Iterator[Register]:
    """A row that stands for many ("Indirect Address 1..28") as that many registers."""
    span = re.search(r"(\d+)\.\.(\d+)$", register.title)
    if span is None:
        yield register
        return
    first, last = int(span[1]), int(span[2])
    for step in range(last - first + 1):
        initial = register.initial
        if initial.endswith(".."):
            initial = str(int(initial[:-2]) + step)
        yield replace(
            register,
            title=f"{register.title[: span.start()]}{first + step}",
            address=register.address + step * register.size,
            initial=initial,
        )
