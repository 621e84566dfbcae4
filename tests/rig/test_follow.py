"""Following a path: time, energy, tracking, and what goes wrong on the way."""

from dataclasses import replace

import numpy as np
import pytest

from kinlab.rig import Path, Record, Rig, Throttle, follow, walk_on
from kinlab.rig.follow import SECONDS


def standing(rig, seconds):
    """A path that stays where the joints are, without weight."""
    q = np.tile(rig.read().q, (2, 1))
    return Path(seconds, seconds, q, rig.wiring.ticks(q), np.zeros_like(q))


def test_idle_costs_idle_power_times_time(krsri):
    with Rig.open(krsri) as rig:
        rig.hold()
        record = Record(rig.wiring, list(follow(rig, standing(rig, 4.0), 50)))
    power = 18 * 0.050 * 12.0
    assert record.t[-1] == pytest.approx(4.0)
    assert record.joules[-1] == pytest.approx(power * 4.0)
    assert record.idle_joules == pytest.approx(power * 4.0)
    assert record.errors.max() < 1e-12


def test_energy_is_the_sum_of_v_i_dt(errand, walked):
    record = walked(errand())
    dt = np.diff(record.t)
    assert record.joules[-1] == pytest.approx(((record.volts * record.amps)[1:].sum(axis=1) * dt).sum())
    assert record.idle_joules < record.joules[-1] < record.motor_joules
    assert record.samples[-1].energy == record.joules[-1] / SECONDS


@pytest.mark.parametrize("gait", ["tripod", "wave"])
def test_the_estimated_energy_is_what_the_emulated_bridges_take(krsri, errand, gait):
    """Of the emulated motors the truth is known: the drive's share of the time at the motor's current."""
    job = errand(gait, 40, 100)
    with Rig.open(krsri) as rig:
        true, before, samples = 0.0, None, []
        standby = float(rig.wiring.standby_amps.sum())
        for sample in walk_on(rig, job):
            samples.append(sample)
            servos = rig.chain.servos
            amps = standby + sum(max(0.0, abs(s.drive) * s.plant.current) for s in servos)
            true += 12.0 * amps * (0.0 if before is None else sample.t - before)
            before = sample.t
    assert samples[-1].joules == pytest.approx(true, rel=0.05)


def test_tracking_error_grows_with_speed(errand, walked):
    slow, fast = (walked(errand("wave", speed, 60)).errors.mean() for speed in (10, 40))
    assert fast > 1.1 * slow


def test_weight_bends_the_legs(krsri, errand, walked):
    light = walked(errand(robot=replace(krsri, mass=None)))
    heavy = walked(errand())
    assert heavy.errors.mean() > 2 * light.errors.mean()
    assert heavy.joules[-1] > light.joules[-1]


def test_a_stuck_servo_shows_in_its_foot(errand, walked):
    def stick(rig):
        rig.chain.servo(5).plant.held = True

    good, bad = walked(errand()), walked(errand(), stick)
    ratio = bad.errors.max(axis=0) / good.errors.max(axis=0)
    assert ratio[1] > 2
    assert ratio[[0, 2, 3, 4, 5]] == pytest.approx(1, abs=0.2)


def test_an_alarm_is_kept(errand, walked):
    record = walked(errand(), lambda rig: rig.chain.servo(9).forced.add("overheating"))
    assert record.alarms == {9: ["overheating"]}


def test_lost_answers_are_counted_and_cost_what_was_last_known(krsri, errand):
    with Rig.open(krsri) as rig:
        samples = []
        for sample in walk_on(rig, errand()):
            samples.append(sample)
            rig.chain.servo(4).dead = 40 <= len(samples) < 50
    record = Record(rig.wiring, samples)
    assert record.lost == {4: 10}
    assert np.isnan(record.errors[45, 1])
    assert np.isfinite(record.errors[45, 0])
    assert (record.watts[40:50, 3] == record.watts[39, 3]).all()


def test_dropped_bytes_are_asked_for_again(errand, walked):
    def disturb(rig):
        rig.chain.faults.drop = 0.0005

    record = walked(errand(), disturb)
    assert sum(record.lost.values()) < 5
    assert record.errors[np.isfinite(record.errors)].mean() < 0.01


def test_a_slow_bus_loses_ticks_and_no_time(krsri, errand):
    with Rig.open(krsri, baud=57600) as rig:
        record = Record(rig.wiring, list(walk_on(rig, errand(speed=40, rate=200))))
    assert record.t[-1] == pytest.approx(errand().walk.duration, abs=0.1)
    assert len(record.t) / record.t[-1] < 50
    assert np.allclose(record.way[:-1], record.t[:-1])


def test_the_tempo_stretches_the_walk(krsri, errand):
    job = errand()
    throttle = Throttle(job)
    throttle.change(-10)
    with Rig.open(krsri) as rig:
        record = Record(rig.wiring, list(walk_on(rig, job, lambda: throttle.tempo)))
    assert throttle.tempo == pytest.approx(0.5)
    assert record.t[-1] == pytest.approx(2 * job.walk.duration, rel=0.02)


def test_nobody_goes_faster_than_the_servos(errand):
    throttle = Throttle(errand("wave", 40))
    throttle.change(100)
    assert throttle.tempo == pytest.approx(44.8 / 40, rel=0.01)
    throttle.change(-100)
    assert throttle.tempo == 0.0


def test_every_walk_of_the_same_order_is_the_same(errand, walked):
    one, other = walked(errand()), walked(errand())
    assert (one.q == other.q).all()
    assert one.joules[-1] == other.joules[-1]
