"""A servo's memory: the bytes of its control table, and what they mean."""

from kinlab.dynamixel.tables import ControlTable, Register


class Memory:
    """The bytes of one control table, at first as they leave the factory."""

    def __init__(self, table: ControlTable) -> None:
        self.table = table
        self.bytes = bytearray(table.size)
        self.reset("EEPROM")
        self.reset("RAM")

    def __getitem__(self, name: str) -> int:
        register = self.table.by_name[name]
        return register.decode(self.bytes[register.address : register.end])

    def __setitem__(self, name: str, value: int) -> None:
        register = self.table.by_name[name]
        self.bytes[register.address : register.end] = register.encode(value)

    def __contains__(self, name: str) -> bool:
        return name in self.table.by_name

    def reset(self, area: str, keep: frozenset[str] = frozenset()) -> None:
        """Set the registers of an area ("EEPROM", "RAM") to their initial values, but for those in `keep`."""
        for register in self.table.registers:
            if register.area == area and register.initial and register.name not in keep:
                self[register.name] = self.initial(register)

    def initial(self, register: Register) -> int:
        """The register's initial value; 0 where it is measured."""
        if register.initial.startswith("="):
            return self[register.initial[1:]]
        return int(register.initial or 0)

    def limits(self, register: Register) -> tuple[int | None, int | None]:
        """The lowest and the highest value that may be written now; None where nothing is said."""
        return self._limit(register.low), self._limit(register.high)

    def _limit(self, text: str) -> int | None:
        if not text:
            return None
        name = text.removeprefix("-")
        value = self[name] if name in self else int(name)
        return -value if text.startswith("-") else value

    def eeprom(self) -> dict[str, int]:
        """What outlives a power cycle, by name: the writable registers of the EEPROM."""
        return {r.name: self[r.name] for r in self.table.registers if r.area == "EEPROM" and r.writable}
