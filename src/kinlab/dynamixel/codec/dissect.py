"""A packet taken apart: each byte belongs to one field, and each field says what it is for."""

from dataclasses import replace

from kinlab.dynamixel.codec.checks import checksum, crc16
from kinlab.dynamixel.codec.dissection import Dissection, Field, Problem, Tables
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.instructions import (
    BROADCAST,
    BULK_ITEM_1,
    BY_CODE,
    STATUS,
    Instruction,
    error_names,
    slots,
    unpack,
)
from kinlab.dynamixel.codec.meaning import extent, option, pieces, place, signature
from kinlab.dynamixel.codec.packets import HEADER, STUFFED, Packet, unstuff
from kinlab.dynamixel.tables import ControlTable

STUFFING = "FF FF FD would look like a header, so FD is sent twice"


def dissect(
    data: bytes,
    protocol: int | None = None,
    status: bool | None = None,
    tables: Tables = lambda servo: None,
    request: Packet | None = None,
) -> Dissection:
    """Take one packet apart.

    Args:
        data: its bytes, whole, damaged or unfinished.
        protocol: 1 or 2; None: as the header says.
        status: whether it is an answer, which Protocol 1.0 does not say; None: only if it is no instruction.
        tables: the control table of the servo with an id.
        request: the instruction that it answers, which says what its data are.
    """
    if protocol is None:
        at = data.find(HEADER[1])
        protocol = 2 if at >= 0 and HEADER[2].startswith(data[at : at + 4]) and len(data) > at + 2 else 1
    return _Dissector(data, protocol, status, tables, request).run()


class _Dissector:
    """Walks through the bytes once, giving each to a field."""

    def __init__(
        self, data: bytes, protocol: int, status: bool | None, tables: Tables, request: Packet | None
    ) -> None:
        self.data = data
        self.at = 0
        self.status = status
        self.tables = tables
        self.request = request
        self.result = Dissection(protocol)

    def run(self) -> Dissection:
        result = self.result
        start = self._find_header()
        if start is None:
            return result
        header = HEADER[result.protocol]
        if self._take("header", len(header), "a packet begins") is None or not self._id():
            return result
        length = self._length()
        if length is None:
            return result
        end = self.at + length - result.protocol
        raw = self.data[self.at : end]
        complete = len(raw) == length - result.protocol
        whole = complete and self._check_is_right(start, end)
        self._content(raw, complete)
        if complete:
            self._check(start, end)
        if whole and not result.problems:
            result.packet = self._packet(unstuff(raw) if result.protocol == 2 else raw)
        if self.at < len(self.data):
            over = len(self.data) - self.at
            self._problem(self.at, f"{over} byte(s) follow the packet's end")
            self._take("surplus", over, "after the packet's end")
        return result

    # The frame.

    def _find_header(self) -> int | None:
        """Where the header begins; what stands before it is noise."""
        header = HEADER[self.result.protocol]
        if not self.data:
            self.result.next = "header"
            return None
        start = self.data.find(header)
        if start < 0:
            # What may become a header yet counts as one; anything else is no packet.
            start = next((i for i in range(len(self.data)) if header.startswith(self.data[i:])), -1)
        if start < 0:
            self._problem(0, f"there is no header {show_hex(header)}")
            self._take("noise", len(self.data), "belongs to no packet")
            return None
        while self.result.protocol == 1 and self.data[start + 2 : start + 3] == b"\xff":
            start += 1
        if start:
            self._problem(0, f"{start} byte(s) before the header belong to no packet")
            self._take("noise", start, "belongs to no packet")
        return start

    def _id(self) -> bool:
        taken = self._take("id", 1)
        if taken is None:
            return False
        self.result.id = servo = taken[0]
        self._explain("all servos (broadcast)" if servo == BROADCAST else f"servo {servo}")
        if servo == 0xFF or (servo == 0xFD and self.result.protocol == 2):
            self._problem(self.at - 1, f"{servo} cannot be an id")
        return True

    def _length(self) -> int | None:
        protocol = self.result.protocol
        taken = self._take("length", protocol)
        if taken is None:
            return None
        length = int.from_bytes(taken, "little")
        least = 1 + protocol
        check = "checksum" if protocol == 1 else "CRC"
        self._explain(
            f"{length} byte(s) follow: instruction, {length - least} byte(s) of parameters, {check}"
        )
        if length >= least:
            return length
        self._explain(f"{length} byte(s) follow, which is too few")
        self._problem(self.at - protocol, f"the length must be at least {least}, but is {length}")
        if self.at < len(self.data):
            self._take("surplus", len(self.data) - self.at, "cannot be placed without a length")
        return None

    def _right_check(self, start: int, end: int) -> bytes:
        covered = self.data[start:end]
        if self.result.protocol == 1:
            return bytes((checksum(covered[2:]),))
        return crc16(covered).to_bytes(2, "little")

    def _check_is_right(self, start: int, end: int) -> bool:
        return self.data[end : end + self.result.protocol] == self._right_check(start, end)

    def _check(self, start: int, end: int) -> None:
        protocol = self.result.protocol
        right, covered = self._right_check(start, end), self.data[start:end]
        name = "checksum" if protocol == 1 else "crc"
        taken = self._take(name, protocol)
        if protocol == 1:
            terms = [f"{byte:02X}" for byte in covered[2:]]
            terms = terms if len(terms) <= 8 else [*terms[:5], "...", terms[-1]]
            sum_up = f"~({'+'.join(terms)}) = {show_hex(right)}"
        else:
            sum_up = f"CRC-16 of the {len(covered)} bytes before it, low byte first = {show_hex(right)}"
        if taken is None:
            return
        self._explain(sum_up if taken == right else f"wrong: {sum_up}")
        if taken != right:
            self._problem(
                self.at - protocol,
                f"the {name} is {show_hex(taken)}, but the bytes before it give {show_hex(right)}",
            )

    def _packet(self, body: bytes) -> Packet:
        result = self.result
        assert result.id is not None
        if result.kind == "instruction":
            return Packet(result.protocol, result.id, body[0], body[1:])
        skip = result.protocol
        return Packet(result.protocol, result.id, STATUS, body[skip:], body[skip - 1])

    # What the frame holds.

    def _content(self, raw: bytes, complete: bool) -> None:
        """Instruction or error, and parameters."""
        result = self.result
        self.extra = [
            i + 3 for i in range(len(raw)) if result.protocol == 2 and raw.startswith(STUFFED + b"\xfd", i)
        ]
        self.base = self.at
        body = bytes(byte for i, byte in enumerate(raw) if i not in self.extra)
        if not body:
            result.next = "instruction"
            return
        known = BY_CODE[result.protocol].get(body[0])
        if result.protocol == 2:
            is_status = body[0] == STATUS
        else:
            is_status = self.status if self.status is not None else not self._fits(known, body[1:], complete)
        if is_status:
            self._status(body)
        else:
            result.instruction = known.name if known else f"0x{body[0]:02X}"
            self._emit(
                "instruction",
                body,
                0,
                1,
                f"{known.name}: {known.meaning}" if known else "no such instruction",
            )
            if known is None:
                self._problem(
                    self.base, f"{result.instruction} is no instruction of Protocol {result.protocol}.0"
                )
                self._emit("data", body, 1, len(body), "parameters of an unknown instruction")
            else:
                self._parameters(known, body, complete)
        if not complete:
            result.next = result.next or "parameters"

    def _fits(self, known: Instruction | None, params: bytes, complete: bool) -> bool:
        """Whether a Protocol 1.0 packet can be an instruction."""
        if known is None:
            return not complete and not params
        return not complete or unpack(known, params) is not None or self.result.id == BROADCAST

    def _status(self, body: bytes) -> None:
        result = self.result
        result.kind, result.instruction = "status", "STATUS"
        at = 0
        if result.protocol == 2:
            self._emit("instruction", body, 0, 1, "STATUS: an answer")
            at = 1
        if len(body) == at:
            result.next = "error"
            return
        if result.id == BROADCAST and result.protocol == 2 and self.request:
            self._fast_answers(body)
            return
        result.errors = error_names(result.protocol, body[at])
        self._emit("error", body, at, at + 1, ", ".join(result.errors) or "no error")
        if len(body) > at + 1:
            self._answer_data(body, at + 1)

    def _answer_data(self, body: bytes, at: int) -> None:
        request, servo = self.request, self.result.id
        name, where = "", None
        if request and request.error is None:
            instruction = BY_CODE[request.protocol].get(request.code)
            values = unpack(instruction, request.params) if instruction else None
            if instruction and values:
                name = instruction.name
                rows = [row for row in values.rows if row.get("id") == servo]
                where = (rows[0] if rows else {}).get("address", values.head.get("address"))
        if name == "PING" and len(body) == at + 3:
            number = int.from_bytes(body[at : at + 2], "little")
            self._emit("data", body, at, at + 2, f"model number {number}", number)
            self._emit("data", body, at + 2, at + 3, f"firmware version {body[at + 2]}", body[at + 2])
        elif isinstance(where, int) and servo is not None:
            self._registers(servo, where, body, at, len(body))
        else:
            self._emit("data", body, at, len(body), f"{len(body) - at} byte(s) of data")

    def _fast_answers(self, body: bytes) -> None:
        """Answers that share a packet: error, id, data, CRC (that of the last one is the packet's own)."""
        request, at = self.request, 1
        instruction = BY_CODE[2].get(request.code) if request else None
        values = unpack(instruction, request.params) if request and instruction else None
        for row in values.rows if values else ():
            if at + 2 > len(body) or values is None:
                break
            count = int(row.get("count", values.head.get("count", 0)))
            where = int(row.get("address", values.head.get("address", 0)))
            errors = error_names(2, body[at])
            self.result.errors += errors
            self._emit("error", body, at, at + 1, ", ".join(errors) or "no error")
            self._emit("id", body, at + 1, at + 2, f"servo {body[at + 1]}")
            self._registers(body[at + 1], where, body, at + 2, min(len(body), at + 2 + count))
            at += 2 + count
            self._emit("crc", body, at, min(len(body), at + 2), "CRC-16 of all before it")
            at += 2
        if at < len(body):
            self._emit("data", body, at, len(body), f"{len(body) - at} byte(s) of data")

    def _parameters(self, known: Instruction, body: bytes, complete: bool) -> None:
        values = unpack(known, body[1:])
        servo = self.result.id
        if servo == BROADCAST and values and values.rows:
            servo = int(values.rows[0].get("id", BROADCAST))
        where = 0
        for slot, at, part in slots(known, body[1:]):
            begin, end = 1 + at, 1 + at + len(part)
            if not complete and (slot.size is None or len(part) < slot.size):
                self.result.next = self.result.next or slot.name
            number = int.from_bytes(part, "little")
            if slot.name == "data":
                self._registers(servo, where, body, begin, end)
                continue
            meaning = slot.meaning
            if slot.name == "address":
                where = number
                meaning = place(self._table(servo), number)
            elif slot.name == "id":
                servo = number
                meaning = f"servo {number}"
            elif slot.name == "count":
                # The Protocol 1.0 BULK_READ names the servo and the address only behind the count.
                meaning = extent(self._table(servo) if known.each != BULK_ITEM_1 else None, where, number)
            elif slot.name == "option":
                meaning = option(known, number)
            self._emit(slot.name, body, begin, end, meaning)
        used = max((1 + at + len(part) for _, at, part in slots(known, body[1:])), default=1)
        if used < len(body):
            self._problem(self.base + used, f"{known.name} takes no more parameters")
            self._emit("surplus", body, used, len(body), f"{known.name} has no use for it")
        elif complete and values is None:
            self._problem(self.base + len(body), f"{known.name} takes more parameters: {signature(known)}")

    def _table(self, servo: int | None) -> ControlTable | None:
        return None if servo is None else self.tables(servo)

    def _registers(self, servo: int | None, address: int, body: bytes, begin: int, end: int) -> None:
        """Data, one field for each register that they belong to."""
        for piece in pieces(self._table(servo), address, body[begin:end]):
            self._emit("data", body, begin, begin + piece.size, piece.meaning, piece.value, piece.register)
            begin += piece.size

    # Giving bytes to fields.

    def _take(self, name: str, size: int, meaning: str = "") -> bytes | None:
        """The next bytes as a field; None if they are not all there yet."""
        part = self.data[self.at : self.at + size]
        if part:
            number = name in ("id", "length", "checksum", "crc")
            value = int.from_bytes(part, "little") if number else show_hex(part)
            self.result.fields.append(Field(name, self.at, part, value, meaning))
            self.at += len(part)
        if len(part) < size:
            self.result.next = name
            return None
        return part

    def _explain(self, meaning: str) -> None:
        self.result.fields[-1] = replace(self.result.fields[-1], meaning=meaning)

    def _emit(
        self,
        name: str,
        body: bytes,
        begin: int,
        end: int,
        meaning: str,
        value: int | None = None,
        register: str = "",
    ) -> None:
        """Bytes of the body (without stuffing) as a field, with stuffing bytes as fields between its parts."""
        while begin < end:
            size = 1
            while begin + size < end and self.at + size - self.base not in self.extra:
                size += 1
            part = body[begin : begin + size]
            number = int.from_bytes(part, "little") if size in (1, 2, 4) else show_hex(part)
            shown = number if value is None else value
            self.result.fields.append(Field(name, self.at, part, shown, meaning, register))
            self.at += size
            begin += size
            if self.at - self.base in self.extra:
                self.result.fields.append(
                    Field(
                        "stuffing",
                        self.at,
                        b"\xfd",
                        0xFD,
                        "FF FF FD would look like a header, so FD is sent twice",
                    )
                )
                self.at += 1

    def _problem(self, offset: int, message: str) -> None:
        self.result.problems.append(Problem(offset, message))
