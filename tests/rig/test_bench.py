"""A limb on its emulated servos: what goes out, what comes back, and how far off the tip is."""

import numpy as np
import pytest

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.errors import KinlabError
from kinlab.rig.bench import LimbBench, bench_of
from kinlab.robots import load_robot


@pytest.fixture(params=["xl430-hexapod", "krsri-hexapod", "receptionist-arm"])
def bench(request):
    robot = load_robot(request.param)
    return LimbBench(robot, robot.limb())


def test_the_sync_write_holds_the_ticks_of_every_joint(bench):
    q = bench.limb.limits.mean(axis=0) + 0.2
    arrival = bench.go(q)
    packet = dissect(arrival.sent, arrival.protocol)
    assert packet.ok
    assert packet.instruction == "SYNC_WRITE"
    for joint, tick in zip(bench.limb.joints, arrival.ticks, strict=True):
        assert tick == joint.servo.command(q[bench.limb.joints.index(joint)])
        size = 4 if arrival.protocol == 2 else 2
        assert bytes((joint.servo.id,)) + int(tick).to_bytes(size, "little") in arrival.sent


def test_the_limb_arrives_within_a_few_ticks(bench):
    q = bench.limb.limits.mean(axis=0) + 0.3
    arrival = bench.go(q)
    assert arrival.answered
    assert np.abs(arrival.reported - arrival.ticks).max() <= 6
    np.testing.assert_allclose(arrival.tip, bench.limb.fk(arrival.q)[:3, 3])
    assert arrival.error_m(bench.limb.fk(q)[:3, 3]) < 5e-3
    assert 0 < arrival.seconds < 3


def test_a_pose_that_is_held_already_takes_no_time(bench):
    q = bench.limb.limits.mean(axis=0)
    bench.go(q)
    assert bench.go(q).seconds < 0.2


def test_without_power_nobody_answers_and_with_it_everybody_does_again(bench):
    bench.power(False)
    assert not bench.powered
    assert not bench.go(bench.limb.limits.mean(axis=0)).answered
    bench.power(True)
    assert bench.go(bench.limb.limits.mean(axis=0)).answered


def test_a_servo_is_never_sent_beyond_its_range():
    robot = load_robot("krsri-hexapod")
    with pytest.raises(KinlabError, match="turns from 0 to 300 deg"):
        LimbBench(robot, robot.limb()).go(np.radians([170.0, 0.0, 0.0]))


@pytest.mark.parametrize(("robot", "reason"), [("udiebot", "PWM"), ("eros", "names no servos")])
def test_where_there_is_no_bus_the_reason_is_given(robot, reason):
    machine = load_robot(robot)
    bench, why = bench_of(machine, machine.limb())
    assert bench is None
    assert reason in why
