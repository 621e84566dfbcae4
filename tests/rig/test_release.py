"""Torque off, whatever is in the way."""

import pytest

from kinlab.dynamixel import Bus, Chain, MemoryPort, SimulatedClock
from kinlab.rig.release import torque_off


@pytest.fixture
def bus():
    return Bus(MemoryPort(Chain.of([("AX-12A", [1]), ("AX-12A", [2]), ("RX-24F", [3])]), SimulatedClock()))


def torque(bus):
    return [servo.memory["torque_enable"] for servo in bus.port.chain.servos]


@pytest.mark.parametrize("level", [1, 2])
def test_servos_let_go_also_those_that_answer_reads_alone(bus, level):
    for servo in (1, 2, 3):
        bus.write(servo, "status_return_level", level)
        bus.write(servo, "torque_enable", 1)
    assert torque_off(bus, [1, 2, 3]) == ()
    assert torque(bus) == [0, 0, 0]


def test_a_second_interrupt_does_not_keep_the_torque_on(bus):
    for servo in (1, 2, 3):
        bus.write(servo, "torque_enable", 1)
    send, told = bus.port.send, []

    def interrupted(data):
        told.append(data)
        if len(told) == 1:
            raise KeyboardInterrupt
        send(data)

    bus.port.send = interrupted
    assert torque_off(bus, [1, 2, 3]) == ()
    assert torque(bus) == [0, 0, 0]


def test_a_servo_that_does_not_say_so_is_named(bus):
    bus.scan([1, 2, 3])
    bus.port.chain.servo(2).dead = True
    assert torque_off(bus, [1, 2, 3]) == (2,)
