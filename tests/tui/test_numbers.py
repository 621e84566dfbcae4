"""Numbers as people type them."""

import math

import pytest

from kinlab.tui.numbers import NotANumberError, read, shown


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("75", "mm", 75), (" -12,5 ", "mm", -12.5), ("+.5", "mm", 0.5), ("7.", "mm", 7), ("1e2", "mm", 100),
        ("3 cm", "mm", 30), ("0.08m", "mm", 80), ("−4", "mm", -4), ("90°", "deg", 90), ("1 rad", "deg", 180 / math.pi),
        ("20 cm/s", "mm/s", 200), ("12", "", 12),
    ],
)  # fmt: skip
def test_a_number_is_read_with_comma_or_point_and_in_any_unit_of_its_quantity(text, unit, value):
    assert read(text, unit) == pytest.approx(value)


@pytest.mark.parametrize(
    ("text", "key"),
    [("", "field.empty"), ("  ", "field.empty"), ("x", "field.no_number"), ("1..2", "field.no_number"),
     ("nan", "field.no_number"), ("inf", "field.no_number"), ("1e999", "field.no_number"), ("[/]", "field.no_number"),
     ("5 deg", "field.no_unit"), ("5 feet", "field.no_unit")],
)  # fmt: skip
def test_what_is_no_number_is_refused_with_its_reason(text, key):
    with pytest.raises(NotANumberError) as refused:
        read(text, "mm")
    assert refused.value.key == key


@pytest.mark.parametrize(
    ("value", "text"), [(75.0, "75"), (-0.0001, "0"), (12.3456, "12.346"), (100.0, "100")]
)
def test_numbers_are_shown_without_zeros_that_say_nothing(value, text):
    assert shown(value) == text
