"""Replies as students type them."""

import math

import pytest

from kinlab.lessons.replies import Quantity, UnreadableError, clean, factor, numbers, quote


@pytest.mark.parametrize(
    ("typed", "value", "unit"),
    [
        ("12.5", 12.5, ""),
        ("12,5", 12.5, ""),
        (" -20 ", -20.0, ""),
        ("−20", -20.0, ""),
        ("–20", -20.0, ""),
        ("+.5", 0.5, ""),
        (",5", 0.5, ""),
        ("12.5°", 12.5, "deg"),
        ("12,5 º", 12.5, "deg"),
        ("30 derajat", 30.0, "deg"),
        ("0.2rad", 0.2, "rad"),
        ("12.5cm", 12.5, "cm"),
        ("12.5 CM", 12.5, "cm"),
        ("r = 12,5 mm", 12.5, "mm"),
        ("jawaban: 3", 3.0, ""),
        ("1.234,5", 1234.5, ""),
        ("1,234.5", 1234.5, ""),
        ("1e-3 m", 0.001, "m"),
        ("5/6", 5 / 6, ""),
        ("0.3 N m", 0.3, "Nm"),
        ("0.3 N·m", 0.3, "Nm"),
        ("3 kgf.cm", 3.0, "kgfcm"),
        ("57600 bps", 57600.0, "bps"),
        ("512 ticks", 512.0, "tick"),
        ("50 %", 50.0, "%"),
        ("\x1b[A12\x00", 12.0, ""),
        ("12\r\n", 12.0, ""),
        ("(12)", 12.0, ""),
        ("12.", 12.0, ""),
        ('"12,5"', 12.5, ""),
        ("0x1F", 31.0, ""),
        ("-0XA", -10.0, ""),
        ("3 newtons", 3.0, "N"),
        ("0.3 Newton meter", 0.3, "Nm"),
        ("12,5 sentimeter", 12.5, "cm"),
        ("30 derajat/detik", 30.0, "deg/s"),
        ("30 deg/sec", 30.0, "deg/s"),
        ("2 MBit/s", 2.0, "Mbps"),
    ],
)
def test_a_number_is_read_in_every_usual_spelling(typed: str, value: float, unit: str) -> None:
    [found] = numbers(typed, 1)
    assert found.value == pytest.approx(value)
    assert found.unit == unit


@pytest.mark.parametrize(
    "typed",
    [
        "1 -2.5 3",
        "1,-2.5,3",
        "1; -2,5; 3",
        "1, -2,5, 3",
        "(1, -2.5, 3)",
        "[1 −2,5 3]",
        "x=1 y=-2.5 z=3",
        "1\n-2.5\n3",
    ],
)
def test_several_numbers_are_told_apart(typed: str) -> None:
    assert [q.value for q in numbers(typed, 3)] == [1.0, -2.5, 3.0]


def test_one_unit_stands_for_all() -> None:
    assert numbers("1 2 3 cm", 3) == [Quantity(v, "cm") for v in (1.0, 2.0, 3.0)]
    assert numbers("1 cm 2 mm", 2) == [Quantity(1.0, "cm"), Quantity(2.0, "mm")]


@pytest.mark.parametrize(
    ("typed", "count", "code"),
    [
        ("", 1, "empty"),
        (" \t\n", 1, "empty"),
        ("\x00\x07", 1, "empty"),
        ("x" * 5000, 1, "too-long"),
        ("nan", 1, "no-number"),
        ("inf", 1, "no-number"),
        ("1e999", 1, "no-number"),
        ("twelve", 1, "no-number"),
        ("12 apples", 1, "unit-unknown"),
        ("12 deg/apple", 1, "unit-unknown"),
        ("12 ks", 1, "unit-unknown"),
        ("0xGG", 1, "unit-unknown"),
        ("0x123456789", 1, "unit-unknown"),
        ("1 2", 1, "count"),
        ("1 2", 3, "count"),
        ("1/0", 1, "no-number"),
        ("__import__('os')", 1, "no-number"),
    ],
)
def test_what_is_no_reply_says_why(typed: str, count: int, code: str) -> None:
    with pytest.raises(UnreadableError) as refused:
        numbers(typed, count)
    assert refused.value.code == code


def test_hundreds_of_replies_of_noise_end_in_numbers_or_in_a_reason() -> None:
    alphabet = "0123456789.,;-+e/= mrad°\x00\x1b[(xyz−٣½"
    for i in range(2000):
        typed = "".join(alphabet[(i * 7919 + j * 104729) % 9973 % len(alphabet)] for j in range(i % 40))
        try:
            found = numbers(typed, 1 + i % 3)
        except UnreadableError:
            continue
        assert all(math.isfinite(q.value) for q in found)


def test_what_is_quoted_is_short_and_obeyed_by_no_terminal() -> None:
    assert quote("a\x1b[31mb\n" + "c" * 100) == "a [31mb " + "c" * 31 + "…"
    assert clean("a\x1b[31mb") == "ab"


def test_units_of_one_kind_turn_into_each_other() -> None:
    assert factor("cm", "mm") == pytest.approx(10)
    assert factor("rpm", "deg/s") == pytest.approx(6)
    assert factor("mm", "s") is None
