"""A packet taken apart: each byte in one field, each field with its meaning."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.lint import warnings
from kinlab.dynamixel.codec.packets import Packet, decode, encode
from kinlab.dynamixel.tables import load_table

AX, X = load_table("AX-12A"), load_table("XL430")


def ax(servo):
    return AX


def x(servo):
    return X


def tables_of(row):
    return ax if row["protocol"] == "1" else x


def test_every_byte_belongs_to_one_field(printed):
    row = printed
    raw = bytes.fromhex(row["bytes"])
    found = dissect(raw, status=True if row["kind"] != "inst" else None, tables=tables_of(row))
    assert b"".join(part.data for part in found.fields) == raw
    assert [part.offset for part in found.fields] == [
        sum(len(part.data) for part in found.fields[:n]) for n in range(len(found.fields))
    ]
    assert found.ok == (row["check"] == "ok")


def test_an_intact_packet_comes_with_its_values(intact):
    raw, is_status = bytes.fromhex(intact["bytes"]), intact["kind"] == "status"
    found = dissect(raw, status=True if is_status else None)
    assert found.packet == decode(raw, int(intact["protocol"]), is_status)


def test_the_meaning_knows_the_control_table():
    found = dissect(bytes.fromhex("FF FF 01 05 03 1E 52 02 84"), tables=ax)
    meanings = {part.name: part.meaning for part in found.fields}
    assert meanings["address"] == "address 30: Goal Position, 2 bytes, 0.29 deg per tick"
    assert meanings["data"] == "Goal Position 594 = 174.02 deg"
    assert meanings["checksum"] == "~(01+05+03+1E+52+02) = 84"


def test_the_contract_of_the_command_line():
    document = dissect(bytes.fromhex("FF FF 01 05 03 1E 52 02 84"), tables=ax).as_json()
    assert document["protocol"] == 1
    assert document["ok"] is True
    assert (document["kind"], document["id"], document["instruction"]) == ("instruction", 1, "WRITE")
    assert document["errors"] == document["problems"] == []
    last = document["fields"][-1]
    assert (last["name"], last["offset"], last["bytes"], last["value"]) == ("checksum", 8, "84", 132)


@pytest.mark.parametrize(
    ("raw", "offset", "word"),
    [
        ("FF FF 01 05 03 1E 52 02 85", 8, "checksum"),
        ("FF FF 01 01 03", 3, "length"),
        ("AA BB", 0, "header"),
        ("00 FF FF 01 02 01 FB", 0, "before the header"),
        ("FF FF 01 02 01 FB 00", 6, "follow"),
        ("FF FF 01 02 77 85", 4, "no instruction"),
        ("FF FF 01 05 03 1E", 6, "ends before"),
        ("FF FF FD 00 01 03 00 01 19 4F", 8, "crc"),
    ],
)
def test_what_is_wrong_is_said_with_its_place(raw, offset, word):
    found = dissect(bytes.fromhex(raw), status=False)
    assert not found.ok
    assert any(p.offset == offset and word in p.message for p in found.complaints), found.complaints


def test_stuffing_is_a_field_of_its_own():
    raw = bytes.fromhex("FF FF FD 00 01 0A 00 03 74 00 FF FF FD FD FF 23 E5")
    found = dissect(raw, tables=x)
    assert [part.name for part in found.fields][-4:] == ["data", "stuffing", "data", "crc"]
    assert found.fields[-4].value == -131073


def test_an_answer_is_explained_by_its_request():
    request = Packet(1, 1, 2, b"\x24\x02")
    found = dissect(bytes.fromhex("FF FF 01 04 00 00 02 F8"), status=True, tables=ax, request=request)
    assert found.fields[-2].meaning == "Present Position 512 = 150 deg"


def test_a_fast_answer_is_explained_servo_by_servo():
    request = decode(bytes.fromhex("FF FF FD 00 FE 0A 00 8A 84 00 04 00 03 07 04 20 F2"), 2)
    raw = bytes.fromhex(
        "FF FF FD 00 FE 19 00 55 00 03 A6 00 00 00 84 08 00 07 1F 08 00 00 16 CA 00 04 FF 03 00 00 D1 9E"
    )
    found = dissect(raw, tables=x, request=request, status=True)
    assert [part.value for part in found.fields if part.register == "present_position"] == [166, 2079, 1023]
    assert [part.value for part in found.fields if part.name == "id"][1:] == [3, 7, 4]
    assert found.ok


@pytest.mark.parametrize("size", range(16))
def test_an_unfinished_packet_says_what_comes_next(size):
    raw = bytes.fromhex("FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89")[:size]
    expected = (
        ["header"] * 4
        + ["id"]
        + ["length"] * 2
        + ["instruction"]
        + ["address"] * 2
        + ["data"] * 4
        + ["crc"] * 2
    )
    found = dissect(raw, protocol=2, tables=x)
    assert found.next == expected[size]
    assert not found.problems


@given(st.binary(max_size=60), st.sampled_from([None, True, False]))
def test_any_bytes_can_be_taken_apart(raw, status):
    found = dissect(raw, status=status, tables=ax)
    assert b"".join(part.data for part in found.fields) == raw


@given(st.integers(0, 252), st.sampled_from([2, 3, 4, 0x82, 0x83, 0x92, 0x93, 0x9A]), st.binary(max_size=40))
def test_any_parameters_can_be_taken_apart(servo, code, params):
    for protocol in (1, 2):
        raw = encode(Packet(protocol, servo, code, params))
        assert b"".join(part.data for part in dissect(raw, protocol, tables=ax).fields) == raw


class TestPointlessPackets:
    def test_a_write_to_a_read_only_register_is_pointed_out(self):
        packet = decode(bytes.fromhex("FF FF 01 04 03 24 02 D1"), 1)
        assert warnings(packet, ax) == [
            "present_position can only be read; did you mean READ (02)? Then the checksum is D2"
        ]

    @pytest.mark.parametrize(
        ("packet", "word"),
        [
            (Packet(1, 1, 3, b"\x1e\xff\x0f"), "0 to 1023"),
            (Packet(1, 1, 2, b"\x30\x10"), "ends at address"),
            (Packet(1, 1, 2, b"\x24\x00"), "no bytes"),
            (Packet(1, 1, 0x83, b"\x1e\x02\x01\x00\x02"), "must be FE"),
            (Packet(1, 254, 2, b"\x24\x02"), "nobody answers"),
            (Packet(2, 1, 1), "Protocol 1.0"),
            (Packet(1, 1, 1, b"\x00"), "do not fit"),
        ],
    )
    def test_other_things_that_lead_nowhere(self, packet, word):
        assert any(word in text for text in warnings(packet, ax))

    def test_a_sound_packet_is_not_criticised(self):
        assert warnings(Packet(1, 1, 3, b"\x1e\x00\x02"), ax) == []
