"""The plant: a DC motor with its gear."""

import math

import pytest

from kinlab.dynamixel.servo.motor import RPM, GearMotor
from kinlab.dynamixel.tables import load_table, models


@pytest.fixture
def motor():
    return GearMotor(load_table("AX-12A"))


def run(motor, drive, seconds, volts=12.0, step=0.001):
    for _ in range(round(seconds / step)):
        motor.step(drive, volts, step)


@pytest.mark.parametrize("model", models())
def test_full_drive_without_load_is_the_no_load_speed(model):
    motor = GearMotor(load_table(model))
    run(motor, 1.0, 2.0)
    assert motor.velocity / RPM == pytest.approx(load_table(model).no_load_rpm, rel=1e-3)


@pytest.mark.parametrize("model", models())
def test_held_fast_it_gives_stall_torque_at_stall_current(model):
    table = load_table(model)
    motor = GearMotor(table)
    motor.held = True
    run(motor, 1.0, 0.1)
    assert motor.velocity == 0.0
    assert motor.torque == pytest.approx(table.stall_nm)
    assert motor.current == pytest.approx(table.stall_a)


def test_half_the_volts_turn_it_half_as_fast_less_friction(motor):
    run(motor, 1.0, 2.0)
    full = motor.velocity
    run(motor, 1.0, 2.0, volts=6.0)
    assert 0.45 * full < motor.velocity < 0.5 * full


def test_friction_holds_it_against_a_small_push_and_stops_it_without_one(motor):
    motor.external = 0.5 * GearMotor.DRY_FRICTION * 1.5
    run(motor, 0.0, 1.0)
    assert (motor.velocity, motor.angle) == (0.0, 0.0)
    run(motor, 1.0, 0.5)
    assert motor.velocity > 1.0
    motor.external = 0.0
    run(motor, 0.0, 2.0)
    assert motor.velocity == 0.0


def test_a_push_from_outside_turns_it(motor):
    motor.external = -1.0
    run(motor, 0.0, 1.0)
    assert motor.angle < -0.1


def test_more_inertia_makes_it_slower_off_the_mark(motor):
    heavy = GearMotor(load_table("AX-12A"))
    heavy.load_inertia = 0.05
    run(motor, 1.0, 0.05)
    run(heavy, 1.0, 0.05)
    assert heavy.velocity < motor.velocity / 3


@pytest.mark.parametrize("step", [0.0005, 0.005, 0.02])
def test_one_long_step_is_as_exact_as_many_short_ones(step):
    fine, coarse = (GearMotor(load_table("AX-12A")) for _ in range(2))
    for drive in (1.0, -0.5, 0.0):
        run(fine, drive, 0.2, step=0.0001)
        run(coarse, drive, 0.2, step=step)
    assert coarse.angle == pytest.approx(fine.angle, abs=1e-6)
    assert coarse.velocity == pytest.approx(fine.velocity, abs=1e-6)


def test_it_never_yields_what_is_no_number(motor):
    for drive in (1.0, -1.0, 0.0, 1.0):
        motor.step(drive, 12.0, 1e-9)
        motor.step(drive, 0.0, 10.0)
        assert math.isfinite(motor.angle + motor.velocity + motor.torque)
