"""Lines such as `write 1 goal_position 90deg` as instruction packets."""

from collections.abc import Callable
from typing import NamedTuple, Protocol

from kinlab.dynamixel.codec.instructions import BACKUP_KEY, BROADCAST, BY_NAME, CLEAR_KEY, pack
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.outfit import parse_ids
from kinlab.dynamixel.quantity import to_ticks
from kinlab.dynamixel.tables import ControlTable, Register
from kinlab.errors import UsageError
from kinlab.names import suggestion

Row = dict[str, int | bytes]


class Directory(Protocol):
    """What one must know of the servos to write packets for them."""

    def ids(self) -> list[int]:
        """The ids that are known."""

    def table(self, servo: int) -> ControlTable | None:
        """The control table of the servo with an id; a real one is asked if need be."""

    def protocol_of(self, servo: int) -> int:
        """What it speaks."""


class OneModel:
    """A directory in which every id is a servo of one model."""

    def __init__(self, table: ControlTable) -> None:
        self._table = table

    def ids(self) -> list[int]:
        return [1]

    def table(self, servo: int) -> ControlTable | None:
        return self._table

    def protocol_of(self, servo: int) -> int:
        return self._table.protocol


class Place(NamedTuple):
    """Where bytes stand: an address, how many, and the register if one is known."""

    address: int
    size: int
    register: Register | None


class Request(NamedTuple):
    """A verb that sends an instruction."""

    usage: str
    meaning: str
    build: Callable[[Directory, list[str]], Packet]


def build_packet(servos: Directory, words: list[str]) -> Packet:
    """The instruction that a line stands for.

    Raises:
        UsageError: no such verb, servo, register or value.
    """
    if not words or words[0] not in REQUESTS:
        name = words[0] if words else ""
        raise UsageError(f"'{name}' sends no packet{suggestion(name, REQUESTS)}")
    request = REQUESTS[words[0]]
    if "..." not in request.usage and len(words) > len(request.usage.split()):
        raise UsageError(f"a word too many; usage: {request.usage}")
    try:
        return request.build(servos, words[1:])
    except IndexError:
        raise UsageError(f"usage: {request.usage}") from None


def one_id(text: str) -> int:
    """An id, or "all"."""
    if text in ("all", "broadcast"):
        return BROADCAST
    if text.isdecimal() and int(text) <= BROADCAST:
        return int(text)
    raise UsageError(f"'{text}' is no id; ids are numbers from 0 to 253, or all")


def table_of(servos: Directory, servo: int) -> ControlTable | None:
    """The table of a servo; for all of them, that of the first."""
    return servos.table(next(iter(servos.ids()), servo) if servo == BROADCAST else servo)


def unknown(servos: Directory, servo: int) -> str:
    """That a servo is not known, and which are."""
    known = ", ".join(map(str, servos.ids()))
    return f"no servo {servo} is known ({f'there are: {known}' if known else 'none has answered yet'})"


def place_of(servos: Directory, servo: int, text: str) -> Place:
    """A register by name, or bytes by address: goal_position, @30, @30:4."""
    table = table_of(servos, servo)
    if text.startswith("@"):
        at, _, size = text[1:].partition(":")
        try:
            address = int(at, 0)
            register = table.by_byte.get(address) if table else None
            if size:
                return Place(address, int(size, 0), None)
        except ValueError:
            raise UsageError(f"'{text}' is no address; write @30 or @30:4") from None
        if register and register.address == address:
            return Place(address, register.size, register)
        return Place(address, 1, None)
    if table is None:
        raise UsageError(f"{unknown(servos, servo)}, so '{text}' has no address; use @ADDRESS")
    register = table.find(text)
    return Place(register.address, register.size, register)


def value_bytes(place: Place, text: str) -> bytes:
    """A value as the bytes that stand at a place."""
    if place.register:
        return place.register.encode(to_ticks(text, place.register))
    try:
        return int(text, 0).to_bytes(place.size, "little")
    except (ValueError, OverflowError):
        raise UsageError(f"'{text}' does not fit into {place.size} byte(s)") from None


def _packet(
    servos: Directory, servo: int, name: str, head: Row | None = None, rows: list[Row] | None = None
) -> Packet:
    protocol = servos.protocol_of(servo)
    if servo == BROADCAST and rows:
        protocol = servos.protocol_of(int(rows[0]["id"]))
    instruction = BY_NAME[protocol].get(name)
    if instruction is None:
        raise UsageError(f"Protocol {protocol}.0 has no {name}")
    return Packet(protocol, servo, instruction.code, pack(instruction, head, rows or []))


def _plain(name: str) -> Callable[[Directory, list[str]], Packet]:
    """An instruction that takes an id and nothing else."""

    def build(servos: Directory, words: list[str]) -> Packet:
        return _packet(servos, one_id(words[0]), name)

    return build


def _action(servos: Directory, words: list[str]) -> Packet:
    return _packet(servos, one_id(words[0]) if words else BROADCAST, "ACTION")


def _read(servos: Directory, words: list[str]) -> Packet:
    servo = one_id(words[0])
    place = place_of(servos, servo, words[1])
    count = int(words[2]) if len(words) > 2 and words[2].isdecimal() else place.size
    return _packet(servos, servo, "READ", {"address": place.address, "count": count})


def _writing(name: str) -> Callable[[Directory, list[str]], Packet]:
    def build(servos: Directory, words: list[str]) -> Packet:
        servo = one_id(words[0])
        place = place_of(servos, servo, words[1])
        data = value_bytes(place, "".join(words[2:]) or words[2])
        return _packet(servos, servo, name, {"address": place.address, "data": data})

    return build


def _reset(servos: Directory, words: list[str]) -> Packet:
    servo = one_id(words[0])
    kept = words[1] if len(words) > 1 else "id"
    option = {"nothing": 0xFF, "id": 1, "id+baud": 2}.get(kept)
    if option is None:
        raise UsageError(f"a reset keeps nothing, id, or id+baud, not '{kept}'")
    return _packet(servos, servo, "FACTORY_RESET", {"option": option})


def _clear(servos: Directory, words: list[str]) -> Packet:
    return _packet(servos, one_id(words[0]), "CLEAR", {"option": 1, "key": CLEAR_KEY})


def _backup(servos: Directory, words: list[str]) -> Packet:
    option = {"store": 1, "restore": 2}.get(words[1] if len(words) > 1 else "store")
    if option is None:
        raise UsageError(f"a backup is to store or to restore, not '{words[1]}'")
    return _packet(servos, one_id(words[0]), "CONTROL_TABLE_BACKUP", {"option": option, "key": BACKUP_KEY})


def _assignment(text: str) -> tuple[str, str]:
    left, sign, right = text.partition("=")
    if not sign or not right:
        raise UsageError(f"'{text}' sets nothing; write ID=VALUE")
    return left, right


def _sync_write(servos: Directory, words: list[str]) -> Packet:
    pairs = [(one_id(left), right) for left, right in map(_assignment, words[1:])]
    place = place_of(servos, pairs[0][0], words[0])
    rows: list[Row] = [{"id": servo, "data": value_bytes(place, value)} for servo, value in pairs]
    return _packet(servos, BROADCAST, "SYNC_WRITE", {"address": place.address, "length": place.size}, rows)


def _sync_read(servos: Directory, words: list[str]) -> Packet:
    fast = words[-1] == "fast"
    ids = [i for word in words[1 : len(words) - fast] for i in parse_ids(word)]
    place = place_of(servos, ids[0], words[0])
    head: Row = {"address": place.address, "count": place.size}
    return _packet(
        servos, BROADCAST, "FAST_SYNC_READ" if fast else "SYNC_READ", head, [{"id": i} for i in ids]
    )


def _bulk_read(servos: Directory, words: list[str]) -> Packet:
    fast = words[-1] == "fast"
    rows: list[Row] = []
    for word in words[: len(words) - fast]:
        number, _, name = word.partition(":")
        place = place_of(servos, one_id(number), name)
        rows.append({"id": one_id(number), "address": place.address, "count": place.size})
    if not rows:
        raise IndexError
    return _packet(servos, BROADCAST, "FAST_BULK_READ" if fast else "BULK_READ", {}, rows)


def _bulk_write(servos: Directory, words: list[str]) -> Packet:
    rows: list[Row] = []
    for word in words:
        left, value = _assignment(word)
        number, _, name = left.partition(":")
        place = place_of(servos, one_id(number), name)
        data = value_bytes(place, value)
        rows.append({"id": one_id(number), "address": place.address, "length": place.size, "data": data})
    if not rows:
        raise IndexError
    return _packet(servos, BROADCAST, "BULK_WRITE", {}, rows)


REQUESTS = {
    "ping": Request("ping ID", "ask whether a servo is there (all: who is there)", _plain("PING")),
    "read": Request("read ID REGISTER [COUNT]", "read a register, or @ADDRESS[:SIZE]", _read),
    "write": Request(
        "write ID REGISTER VALUE", "set a register: 512, 0x200, 90deg, 60rpm", _writing("WRITE")
    ),
    "regwrite": Request("regwrite ID REGISTER VALUE", "set it when action comes", _writing("REG_WRITE")),
    "action": Request("action [ID]", "carry out what regwrite left", _action),
    "syncwrite": Request(
        "syncwrite REGISTER ID=VALUE...", "set a register of many servos at once", _sync_write
    ),
    "syncread": Request(
        "syncread REGISTER ID... [fast]", "read a register of many servos at once", _sync_read
    ),
    "bulkread": Request("bulkread ID:REGISTER... [fast]", "read different registers at once", _bulk_read),
    "bulkwrite": Request("bulkwrite ID:REGISTER=VALUE...", "set different registers at once", _bulk_write),
    "reset": Request(
        "reset ID [nothing|id|id+baud]", "back to the factory's values but for what is kept", _reset
    ),
    "reboot": Request("reboot ID", "restart a servo", _plain("REBOOT")),
    "clear": Request("clear ID", "forget the turns that were counted", _clear),
    "backup": Request("backup ID [restore]", "store a copy of the control table, or go back to it", _backup),
}
