"""The result of taking a packet apart: fields, what is wrong, what would come next."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.tables import ControlTable

Tables = Callable[[int], ControlTable | None]


@dataclass(frozen=True)
class Field:
    """Bytes of a packet that belong together.

    Attributes:
        value: as a number, or as hexadecimal text where the bytes are no number.
        register: the name of the register that the bytes are for, "" if for none.
    """

    name: str
    offset: int
    data: bytes
    value: int | str
    meaning: str
    register: str = ""

    def as_json(self) -> dict[str, Any]:
        """As the command line prints it."""
        known = {"register": self.register} if self.register else {}
        return {
            "name": self.name,
            "offset": self.offset,
            "bytes": show_hex(self.data),
            "value": self.value,
            "meaning": self.meaning,
            **known,
        }


@dataclass(frozen=True)
class Problem:
    """What is wrong with a packet, and where."""

    offset: int
    message: str


@dataclass
class Dissection:
    """A packet, field by field, as far as it goes.

    Attributes:
        kind: "instruction" or "status".
        next: the field that the next byte would belong to; "" if the packet is whole.
        packet: its values, None where it is damaged.
    """

    protocol: int
    kind: str = "instruction"
    id: int | None = None
    instruction: str = ""
    errors: list[str] = field(default_factory=list)
    fields: list[Field] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    next: str = ""
    packet: Packet | None = None

    @property
    def ok(self) -> bool:
        return not self.complaints

    @property
    def complaints(self) -> list[Problem]:
        """What is wrong, that the packet is unfinished included."""
        if not self.next:
            return self.problems
        end = sum(len(part.data) for part in self.fields)
        return [*self.problems, Problem(end, f"the packet ends before its {self.next} does")]

    def as_json(self) -> dict[str, Any]:
        """As the command line prints it."""
        return {
            "protocol": self.protocol,
            "ok": self.ok,
            "kind": self.kind,
            "id": self.id,
            "instruction": self.instruction,
            "errors": self.errors,
            "fields": [f.as_json() for f in self.fields],
            "problems": [{"offset": p.offset, "message": p.message} for p in self.complaints],
        }
