"""The control loop on the emulated bus: it follows, yields, counts what goes wrong, and always lets go."""

import numpy as np
import pytest

from kinlab.control import Environment, PositionGains
from kinlab.dynamixel import Faults
from kinlab.errors import KinlabError, UsageError
from kinlab.rig.arm import Push, RunawayError, Settings, Setup, run

FIRM = Settings("position", gains=PositionGains(20, 8))
HOLD = Settings("position", gains=PositionGains(0, 0))  # the reference stays where it began
PUSH = Push(0.3, 1.0, "hand", (-3.0, 0.0, 0.0))


def test_two_runs_are_the_same_to_the_last_bit(arm_at, line):
    records = []
    for _ in range(2):
        with arm_at(line, PUSH) as servos:
            servos.hold()
            records.append(run(servos, line, Settings("compliance")))
    for name, column in records[0].columns().items():
        np.testing.assert_array_equal(column, records[1].columns()[name])


def test_every_cycle_fits_and_takes_the_bytes_time_on_the_wire(arm_at, line):
    with arm_at(line) as servos:
        servos.hold()
        record = run(servos, line, FIRM)
    assert record.overruns == 0
    np.testing.assert_allclose(np.diff(record.t), 0.016, atol=1e-12)
    # A READ is 8 bytes out and 12 back, half a millisecond later; a WRITE of 11 bytes is not answered.
    np.testing.assert_allclose(record.busy, 3 * (20e-5 + 5e-4 + 11e-5), atol=1e-9)


def test_what_does_not_fit_into_the_cycle_is_reported(arm_at, line):
    with arm_at(line) as servos:
        servos.hold()
        record = run(servos, line, Settings("position", dt=0.002))
    assert record.overruns == len(line.q)
    assert np.diff(record.t).min() > 0.002


def test_a_cycle_that_takes_longer_delays_the_next_and_hurries_none(arm_at, line):
    with arm_at(line) as servos:
        servos.hold()
        clock = servos.bus.port.clock
        record = run(servos, line, FIRM, lambda k, record: clock.wait(0.1 if k == 5 else 0.0))
    gaps = np.diff(record.t)
    assert gaps[5] > 0.1
    np.testing.assert_allclose(np.delete(gaps, 5), 0.016, atol=1e-9)


def test_the_arm_yields_with_compliance_and_not_without(arm_at, stay):
    away = {}
    for law in ("position", "compliance"):
        with arm_at(stay, PUSH, setup=Setup(slope=32)) as servos:
            servos.hold()
            record = run(
                servos, stay, Settings(law, gains=FIRM.gains, environment=Environment(0.05, 1, 0.5, 0.02))
            )
        away[law] = np.degrees(np.abs(record.error[30:80]).max())
    assert away["compliance"] > 2 * away["position"]


def test_the_observer_finds_the_force_of_the_hand(arm_at, stay):
    with arm_at(stay, PUSH, setup=Setup(slope=32)) as servos:
        servos.hold()
        record = run(servos, stay, HOLD)
    pushed = (record.t > 1.1) & (record.t < 1.28)
    applied = -record.torques["pushed"][pushed].mean(axis=0)
    assert np.abs(applied).max() > 0.5
    # Dry friction in each gear, 0.052 N m, hides as much of any force; the slow filter lags besides.
    for estimate, unknown in (("reaction", 0.06), ("external", 0.1)):
        np.testing.assert_allclose(record.torques[estimate][pushed].mean(axis=0), applied, atol=unknown)


def drive(servos, track, settings, before=lambda servos: None, tell=None):
    with servos:
        servos.hold()
        before(servos)
        run(servos, track, settings, tell)


def test_gains_that_diverge_stop_the_loop_with_the_time_and_the_joint(arm_at, stay):
    servos = arm_at(stay)
    with pytest.raises(
        RunawayError, match=r"ran away at \d\.\d+ s: the reference of (shoulder|elbow)"
    ) as caught:
        drive(servos, stay, Settings("position", gains=PositionGains(4000, 0)))
    assert 0 < caught.value.time < 2
    assert caught.value.joint in servos.limb.joint_names
    assert all(servos.bus.read(i, "torque_enable") == 0 for i in servos.ids)


def test_a_bus_that_loses_packets_is_held_and_counted(arm_at, line):
    with arm_at(line) as servos:
        servos.hold()
        servos.bus.port.chain.faults = Faults(drop=0.03, seed=3)
        record = run(servos, line, FIRM)
        servos.bus.port.chain.faults = Faults()
    assert record.missed.any()
    assert record.missed.sum() == sum(record.causes.values())
    assert np.degrees(np.abs(record.error).max()) < 30


def test_a_servo_that_falls_silent_stops_the_loop_and_the_others_let_go(arm_at, line):
    servos = arm_at(line)

    def die(servos):
        servos.bus.port.chain.servo(6).dead = True

    with pytest.raises(
        KinlabError, match=r"has not answered for 10 cycles.*no word from servo 6 .*: cut the power"
    ):
        drive(servos, line, FIRM, before=die)
    assert servos.unconfirmed == (6,)
    assert [servos.bus.read(i, "torque_enable") for i in (2, 4)] == [0, 0]


def test_an_interrupt_leaves_the_torque_off(arm_at, line):
    servos = arm_at(line)

    def interrupt(k, record):
        if k == 20:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        drive(servos, line, FIRM, tell=interrupt)
    assert [servos.bus.read(i, "torque_enable") for i in servos.ids] == [0, 0, 0]
    assert servos.unconfirmed == ()


def test_limits_of_torque_and_speed_are_kept(arm_at, stay):
    with arm_at(stay, setup=Setup(torque_limit=0.1, speed_limit=0.5)) as servos:
        servos.hold()
        assert servos.bus.read(2, "torque_limit") == 102
        record = run(servos, stay, HOLD)
        servos.write(2, 0.0, 9.0)
        assert 0.45 < servos.bus.read(6, "moving_speed", "rad/s") < 0.55
        # No speed at all is written as the slowest: to the servo, 0 would mean as fast as it can.
        servos.write(2, 0.0, 0.0)
        assert servos.bus.read(6, "moving_speed") == 1
    # A tenth of the stall torque, and what the turning gear adds as a brake.
    assert np.abs(record.torques["load"]).max() < 0.5


@pytest.mark.parametrize(
    "wrong", [{"law": "positon"}, {"alpha": 0.0}, {"dt": 0.0}, {"gains": PositionGains(np.nan, 0)}]
)
def test_settings_that_cannot_be_are_refused(wrong):
    with pytest.raises(UsageError):
        Settings(**wrong)


@pytest.mark.parametrize(
    "wrong", [{"slope": 300}, {"torque_limit": 0.0}, {"torque_limit": 2.0}, {"speed_limit": 0.0}]
)
def test_a_setup_that_cannot_be_is_refused(wrong):
    with pytest.raises(UsageError):
        Setup(**wrong)
