"""Control tables as data."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.dynamixel.quantity import from_ticks, to_ticks
from kinlab.dynamixel.tables import load_table, models, table_of_number
from kinlab.errors import UsageError


@pytest.mark.parametrize("model", models())
def test_registers_stand_in_order_and_do_not_overlap(model):
    registers = load_table(model).registers
    assert all(a.end <= b.address for a, b in pairwise(registers))
    assert len({register.name for register in registers}) == len(registers)


@pytest.mark.parametrize(
    ("model", "number", "protocol", "size", "count"),
    [
        ("AX-12A", 12, 1, 50, 37),
        ("RX-24F", 24, 1, 50, 37),
        ("XL430-W250-T", 1060, 2, 662, 163),
        ("2XL430-W250-T", 1090, 2, 662, 161),
    ],
)
def test_the_four_models(model, number, protocol, size, count):
    table = load_table(model)
    assert (table.number, table.protocol, table.size, len(table.registers)) == (number, protocol, size, count)
    assert table_of_number(number) is table


@pytest.mark.parametrize(
    ("model", "name", "address", "size", "access", "area", "initial", "scale", "unit"),
    [
        ("AX-12A", "goal_position", 30, 2, "RW", "RAM", "", 300 / 1024, "deg"),
        ("RX-24F", "temperature_limit", 11, 1, "RW", "EEPROM", "80", 1, "degC"),
        ("RX-24F", "baud_rate", 4, 1, "RW", "EEPROM", "34", 1, ""),
        ("XL430", "goal_position", 116, 4, "RW", "RAM", "", 360 / 4096, "deg"),
        ("XL430", "velocity_limit", 44, 4, "RW", "EEPROM", "265", 0.229, "rpm"),
        ("2XL430", "velocity_limit", 44, 4, "RW", "EEPROM", "250", 0.229, "rpm"),
        ("XL430", "indirect_address_29", 578, 2, "RW", "RAM", "634", 1, ""),
        ("XL430", "indirect_data_56", 661, 1, "RW", "RAM", "0", 1, ""),
    ],
)
def test_single_registers(model, name, address, size, access, area, initial, scale, unit):
    register = load_table(model).find(name)
    assert (register.address, register.size, register.access, register.area) == (address, size, access, area)
    assert (register.initial, register.unit) == (initial, unit)
    assert register.scale == pytest.approx(scale)


def test_registers_are_found_by_name_beginning_and_address():
    table = load_table("AX-12A")
    assert table.find("goal_position") is table.find("goal") is table.find("@30") is table.find("31")


def test_unknown_names_are_answered_with_the_nearest():
    with pytest.raises(UsageError, match="did you mean goal_position"):
        load_table("AX-12A").find("goal_positon")
    with pytest.raises(UsageError, match="RX-24F"):
        load_table("RX-42F")
    with pytest.raises(UsageError, match="nothing at address 99"):
        load_table("AX-12A").find("@99")


@given(st.integers(-1000, 1000))
def test_signed_values_survive_the_wire(value):
    for model, name in (("AX-12A", "present_load"), ("XL430", "present_load"), ("XL430", "goal_velocity")):
        register = load_table(model).find(name)
        assert register.decode(register.encode(value)) == value


def test_bit_10_is_the_direction_of_ax_speeds_and_loads():
    load = load_table("AX-12A").find("present_load")
    assert load.encode(-5) == (0x405).to_bytes(2, "little")
    assert load.decode((0x400).to_bytes(2, "little")) == 0


@pytest.mark.parametrize(
    ("model", "register", "text", "ticks"),
    [
        ("AX-12A", "goal_position", "150deg", 512),
        ("XL430", "goal_position", "180deg", 2048),
        ("XL430", "goal_position", "-90deg", -1024),
        ("XL430", "goal_position", "3.14159265rad", 2048),
        ("XL430", "goal_position", "1rev", 4096),
        ("XL430", "goal_velocity", "22.9rpm", 100),
        ("XL430", "goal_velocity", "137.4deg/s", 100),
        ("AX-12A", "return_delay_time", "0.5ms", 250),
        ("AX-12A", "max_voltage_limit", "14V", 140),
        ("AX-12A", "goal_position", "0x200", 512),
        ("AX-12A", "goal_position", "0b11", 3),
    ],
)
def test_amounts_become_ticks(model, register, text, ticks):
    assert to_ticks(text, load_table(model).find(register)) == ticks


@given(st.integers(0, 4095), st.sampled_from(["deg", "rad", "rev"]))
def test_ticks_to_a_unit_and_back(ticks, unit):
    goal = load_table("XL430").find("goal_position")
    assert to_ticks(from_ticks(ticks, goal, unit), goal, unit) == ticks


@pytest.mark.parametrize("text", ["ninety", "", "90parsec", "1.5", "nan", "1e999deg", "deg"])
def test_what_is_no_amount_is_refused(text):
    with pytest.raises(UsageError):
        to_ticks(text, load_table("AX-12A").find("goal_position"))


def test_a_register_without_a_unit_takes_none():
    with pytest.raises(UsageError, match="has no unit"):
        to_ticks("5deg", load_table("AX-12A").find("led"))
