"""A robot on a bus: what goes out, what comes back, and the torque that is off afterwards."""

from dataclasses import replace

import numpy as np
import pytest

from kinlab.dynamixel import Bus, Chain, MemoryPort, NoAnswerError, PortError, SimulatedClock
from kinlab.errors import KinlabError, UsageError
from kinlab.rig import Rig, walk_on
from kinlab.robots import load_robot


def enabled(rig):
    return [servo.memory["torque_enable"] for servo in rig.chain.servos]


@pytest.mark.parametrize("name", ["krsri-hexapod", "xl430-hexapod"])
def test_angles_out_and_back(name):
    robot = load_robot(name)
    q = np.array([limb.ik(limb.stance).q for limb in robot.legs]).ravel()
    with Rig.open(robot) as rig:
        rig.hold()
        assert enabled(rig) == [1] * 18
        rig.approach(q)
        rig.clock.wait(1.0)
        reading = rig.read()
    off = np.degrees(np.abs(reading.q - q))
    # Half a tick of the command, and the compliance margin of a tick and a half of an AX-12A.
    assert off.max() < (1.0 if name == "krsri-hexapod" else 0.5)
    assert not reading.missing.any()
    assert np.allclose(reading.volts, 12.0, atol=0.11)
    assert (reading.amps >= rig.wiring.standby_amps).all()


@pytest.mark.parametrize("name", ["krsri-hexapod", "xl430-hexapod", "receptionist-arm"])
def test_commands_are_those_of_the_servos(name):
    with Rig.open(load_robot(name)) as rig:
        wiring = rig.wiring
        q = np.random.default_rng(1).uniform(-0.4, 0.4, (5, len(wiring.ids)))
        ticks = wiring.ticks(q)
        rows = np.zeros((*ticks.shape, 4))
        rows[..., 0] = ticks
        half = np.radians([servo.model.deg_per_step for servo in wiring.servos]) / 2
        off = wiring.measured(rows)[..., 0] - q
        # A servo counts on where the joint's angle begins a new turn.
        off -= 2 * np.pi * np.round(off / (2 * np.pi))
        assert (np.abs(off) <= half + 1e-9).all()


def test_a_servo_that_cannot_turn_that_far(krsri):
    with (
        Rig.open(krsri) as rig,
        pytest.raises(KinlabError, match=r"the coxa of R1 would .* from 0 to 300 deg"),
    ):
        rig.wiring.ticks(np.full(18, 2.7))


def test_joints_go_to_their_place_gently(krsri):
    with Rig.open(krsri) as rig:
        rig.hold()
        fastest = []
        q = rig.read().q + 0.5
        rig.approach(q, lambda done: fastest.append(np.abs(rig.read().velocity).max()))
    # The path itself does 60 deg/s; servos jerk from command to command.
    assert np.degrees(np.mean(fastest)) < 75


@pytest.mark.parametrize("trouble", [KeyboardInterrupt, ValueError, PortError])
def test_the_torque_is_off_whatever_happens(krsri, errand, trouble):
    def until_trouble(rig):
        with rig:
            for number, _ in enumerate(walk_on(rig, errand())):
                if number == 20:
                    assert enabled(rig) == [1] * 18
                    raise trouble

    rig = Rig.open(krsri)
    with pytest.raises(trouble):
        until_trouble(rig)
    assert enabled(rig) == [0] * 18
    assert rig.unconfirmed == ()


def test_a_packet_that_is_lost_does_not_keep_the_torque_on(krsri):
    with Rig.open(krsri) as rig:
        rig.hold()
        # Some bytes are lost: of the one packet to all, and of the single ones.
        rig.chain.faults.drop = 0.02
    assert enabled(rig) == [0] * 18


def test_a_servo_that_does_not_confirm_is_named(krsri):
    with Rig.open(krsri) as rig:
        rig.hold()
        rig.chain.servo(7).dead = True
    assert rig.unconfirmed == (7,)


def test_servos_that_are_not_there(krsri):
    with pytest.raises(NoAnswerError, match="servo 18"):
        Rig.open(krsri, "emu:AX-12A:1-17")
    bus = Bus(MemoryPort(Chain.of([("RX-24F", [i]) for i in range(1, 19)]), SimulatedClock()))
    with pytest.raises(KinlabError, match="should be of AX-12A, and is of RX-24F"):
        Rig(krsri, bus)


@pytest.mark.parametrize(("name", "word"), [("udiebot", "on PWM"), ("eros", "names no servos")])
def test_robots_without_a_bus(name, word):
    with pytest.raises(UsageError, match=word):
        Rig.open(load_robot(name))


def test_a_servo_that_is_gone_leaves_a_gap(krsri):
    with Rig.open(krsri) as rig:
        rig.chain.servo(7).dead = True
        assert rig.read().missing.tolist() == [i == 6 for i in range(18)]
        with pytest.raises(KinlabError, match="servo 7 does not say where it is"):
            rig.approach(np.zeros(18))


def test_the_others_of_a_sync_read_still_answer():
    with Rig.open(load_robot("xl430-hexapod")) as rig:
        rig.chain.servo(7).dead = True
        assert rig.read().missing.tolist() == [i == 6 for i in range(18)]


def test_some_limbs_alone(krsri):
    with Rig.open(krsri, limbs=krsri.legs[1:2]) as rig:
        assert rig.wiring.ids == (4, 5, 6)
        assert rig.read().q.shape == (3,)


def test_a_model_whose_standby_current_nobody_gives(krsri):
    with Rig.open(krsri) as rig:
        bare = [replace(s, model=replace(s.model, standby=None)) for s in rig.wiring.servos]
        assert replace(rig.wiring, servos=tuple(bare)).standby_amps.tolist() == [0.0] * 18
