"""Bytes as people type and paste them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.dynamixel.codec.hextext import HexError, parse_hex, show_hex


@pytest.mark.parametrize(
    "text",
    [
        "FF FF 01 0A",
        "ff,ff,01,0a",
        "0xFF, 0xff, 0x01, 0x0A",
        r"\xff\xff\x01\x0a",
        "FFFF010A",
        "0xFFFF010A",
        "FF:FF:01:0A",
        "[0xFF, 0xFF, 1, A]",
        "FF FF 1 A",
        "  FF\tFF\n01 0A  ",
        r"b'\xff\xff\x01\x0a'".removeprefix("b"),
    ],
)
def test_every_usual_spelling_is_understood(text):
    assert parse_hex(text) == b"\xff\xff\x01\x0a"


@pytest.mark.parametrize(
    ("text", "position"),
    [("FF GG", 3), ("FFF", 2), ("FF 0x", 5), ("01 0xZZ", 5), (r"\xff\xq1", 6), ("hello", 0)],
)
def test_nonsense_is_refused_at_its_position(text, position):
    with pytest.raises(HexError) as refused:
        parse_hex(text)
    assert refused.value.position == position
    assert f"position {position + 1}" in str(refused.value)
    assert refused.value.exit_code == 2


@given(st.binary())
def test_what_is_shown_can_be_typed(data):
    assert parse_hex(show_hex(data)) == data


@given(st.text())
def test_no_text_does_more_than_be_refused(text):
    refused = None
    try:
        parse_hex(text)
    except HexError as error:
        refused = error
    assert refused is None or 0 <= refused.position <= len(text)
