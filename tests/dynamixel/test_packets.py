"""Packets as bytes and as values: what the manuals print, and everything else."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.dynamixel.codec.checks import checksum, crc16, crc_step
from kinlab.dynamixel.codec.instructions import BROADCAST, BY_CODE, BY_NAME, error_names, pack, unpack
from kinlab.dynamixel.codec.packets import Packet, decode, encode, status, stuff, unstuff


def test_every_verified_packet_decodes_and_encodes_to_the_byte(intact):
    raw = bytes.fromhex(intact["bytes"])
    packet = decode(raw, int(intact["protocol"]), as_status=intact["kind"] == "status")
    assert encode(packet) == raw


def test_the_parameters_of_every_verified_instruction_fit_its_description(instruction):
    packet = decode(bytes.fromhex(instruction["bytes"]), int(instruction["protocol"]))
    layout = BY_CODE[packet.protocol][packet.code]
    values = unpack(layout, packet.params)
    assert values is not None
    assert pack(layout, values.head, values.rows) == packet.params


def test_the_misprints_of_the_manual_are_recognised(printed):
    if printed["check"] != "ok":
        raw = bytes.fromhex(printed["bytes"])
        assert crc16(raw[:-2]).to_bytes(2, "little").hex(" ").upper() == printed["check"][-5:]


def test_the_crc_of_the_worked_example_byte_by_byte():
    steps = []
    crc = 0
    for byte in bytes.fromhex("FFFFFD0001030001"):
        crc = crc_step(crc, byte)
        steps.append(crc)
    assert steps == [0x0202, 0x800D, 0x0C0E, 0x0E28, 0x2822, 0x22FA, 0xFACC, 0x4E19]


def test_the_check_value_of_crc16_buypass():
    assert crc16(b"123456789") == 0xFEE8


@given(st.binary())
def test_the_crc_is_the_same_in_one_go_and_step_by_step(data):
    crc = 0
    for byte in data:
        crc = crc_step(crc, byte)
    assert crc16(data) == crc


@given(st.binary())
def test_a_sum_with_its_checksum_is_full(data):
    assert (sum(data) + checksum(data)) & 0xFF == 0xFF


def test_data_that_look_like_a_header_are_stuffed():
    packet = Packet(2, 1, 3, (116).to_bytes(2, "little") + (-131073).to_bytes(4, "little", signed=True))
    assert encode(packet) == bytes.fromhex("FF FF FD 00 01 0A 00 03 74 00 FF FF FD FD FF 23 E5")
    assert decode(encode(packet), 2) == packet


@given(st.lists(st.sampled_from(b"\xff\xfd\x00"), max_size=40).map(bytes))
def test_stuffing_is_undone_to_the_byte(body):
    stuffed = stuff(body)
    assert unstuff(stuffed) == body
    assert b"\xff\xff\xfd\x00" not in stuffed


@given(st.integers(0, 253), st.integers(0, 255), st.binary(max_size=250))
def test_protocol_1_instructions_come_back_as_they_went(servo, code, params):
    packet = Packet(1, servo, code, params)
    assert decode(encode(packet), 1) == packet


@given(st.integers(0, 252), st.integers(0, 255).filter(lambda code: code != 0x55), st.binary(max_size=300))
def test_protocol_2_instructions_come_back_as_they_went(servo, code, params):
    packet = Packet(2, servo, code, params)
    assert decode(encode(packet), 2) == packet


@given(st.sampled_from([1, 2]), st.integers(0, 252), st.integers(0, 127), st.binary(max_size=250))
def test_answers_come_back_as_they_went(protocol, servo, error, data):
    answer = status(protocol, servo, error, data)
    assert decode(encode(answer), protocol, as_status=True) == answer


@pytest.mark.parametrize(
    ("protocol", "name", "head", "rows", "params"),
    [
        (1, "SYNC_WRITE", {"address": 30, "length": 2}, [{"id": 1, "data": b"\0\2"}], "1E 02 01 00 02"),
        (1, "BULK_READ", {}, [{"count": 2, "id": 1, "address": 30}], "00 02 01 1E"),
        (2, "SYNC_READ", {"address": 132, "count": 4}, [{"id": 1}, {"id": 2}], "84 00 04 00 01 02"),
        (2, "BULK_READ", {}, [{"id": 1, "address": 144, "count": 2}], "01 90 00 02 00"),
    ],
)
def test_instructions_to_many_servos_are_laid_out_row_by_row(protocol, name, head, rows, params):
    assert pack(BY_NAME[protocol][name], head, rows) == bytes.fromhex(params)


def test_parameters_that_do_not_fit_are_no_parameters():
    sync_write = BY_NAME[1]["SYNC_WRITE"]
    assert unpack(sync_write, bytes.fromhex("1E 02 01 00")) is None
    assert unpack(BY_NAME[1]["PING"], b"\1") is None
    assert unpack(BY_NAME[2]["READ"], b"\1\0") is None


def test_errors_are_bits_in_protocol_1_and_numbers_in_protocol_2():
    assert error_names(1, 0x24) == ["overheating", "overload"]
    assert error_names(2, 0x84) == ["alert: see hardware_error_status", "data range"]
    assert error_names(1, 0) == error_names(2, 0) == []


def test_all_instructions_of_the_manuals_are_there():
    assert set(BY_NAME[1]) == {
        *(
            "PING",
            "READ",
            "WRITE",
            "REG_WRITE",
            "ACTION",
            "FACTORY_RESET",
            "REBOOT",
            "SYNC_WRITE",
            "BULK_READ",
        )
    }
    assert {i.code for i in BY_NAME[2].values()} == {
        *(1, 2, 3, 4, 5, 6, 8, 0x10, 0x20, 0x82, 0x83, 0x8A, 0x92, 0x93, 0x9A)
    }
    assert BROADCAST == 0xFE
