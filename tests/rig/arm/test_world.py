"""The links on the emulated motors: against the coupled equations of motion, integrated on their own."""

from dataclasses import replace

import numpy as np
import pytest

from kinlab.dynamics import Mechanism, gravity_torque, inverse_dynamics, mass_matrix
from kinlab.dynamixel.servo.breaking import motor_of
from kinlab.errors import UsageError
from kinlab.rig.arm import ArmServos, Push, parse_push


def test_a_limp_arm_falls_as_the_coupled_equations_say(arm_at, stay, limb):
    """Half a second with the torque off: rotors, gears and friction with the links' full mass matrix, in 0.1 ms."""
    servos = arm_at(stay)
    motors = [motor_of(servos.bus.port.chain.servo(i)) for i in servos.ids]
    mechanism = Mechanism.of(limb)
    rotor, drag, dry = motors[0]._rotor, motors[0]._drag, motors[0]._friction
    q, qd, dt, zero = stay.q[0].copy(), np.zeros(3), 1e-4, np.zeros(3)
    for _ in range(5000):
        push = -inverse_dynamics(mechanism, q, qd, zero) - drag * qd
        stuck = (np.abs(qd) < 1e-9) & (np.abs(push) <= dry)
        push = np.where(stuck, 0.0, push - dry * np.sign(np.where(qd == 0, push, qd)))
        qd = qd + dt * np.linalg.solve(mass_matrix(mechanism, q) + rotor * np.eye(3), push)
        q = q + dt * qd
    servos.bus.port.clock.wait(0.5)
    moved = np.abs(q - stay.q[0]).max()
    assert moved > 0.3
    np.testing.assert_allclose(servos.world.angles(), q, atol=0.01 * moved)


@pytest.mark.parametrize("sign", [1, -1])
def test_an_arm_that_is_held_reports_the_torque_of_its_weight(robot, stay, limb, sign):
    """Also where its servos are mounted the other way round."""
    turned = [replace(joint, servo=replace(joint.servo, sign=sign)) for joint in limb.joints]
    with ArmServos.emulated(robot, replace(limb, joints=tuple(turned)), stay.q[0].tolist()) as servos:
        servos.hold()
        servos.bus.port.clock.wait(2.0)
        found = [servos.read(j) for j in range(3)]
        held = gravity_torque(Mechanism.of(limb), [q for q, _ in found])
        # Dry friction carries what it can.
        friction = motor_of(servos.bus.port.chain.servo(2))._friction
        np.testing.assert_allclose([load for _, load in found], held, atol=friction + 0.003)


def test_the_grid_of_time_does_not_depend_on_how_one_waits(arm_at, stay):
    one, many = arm_at(stay), arm_at(stay)
    one.bus.port.clock.wait(0.3)
    for _ in range(3000):
        many.bus.port.clock.wait(0.0001)
    np.testing.assert_allclose(one.world.angles(), many.world.angles(), atol=2e-4)


def test_pushes_are_written_as_people_say_them():
    push = parse_push("t=0.5 dur=0.4 at=elbow force=0,-5,0")
    assert push == Push(0.5, 0.4, "elbow", (0.0, -5.0, 0.0))
    assert [push.acts(t) for t in (0.4, 0.5, 0.89, 0.9)] == [False, True, True, False]


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("force=0,nan,0", "must be a number"),
        ("force=0,inf,0", "finite forces"),
        ("force=0,1", "three numbers"),
        ("force=a,b,c", "must be a number"),
        ("t=-1 force=0,1,0", "begins at t >= 0"),
        ("dur=0 force=0,1,0", "lasts for dur > 0"),
        ("forc=0,1,0", "did you mean force"),
    ],
)
def test_a_push_that_cannot_be_is_refused(text, complaint):
    with pytest.raises(UsageError, match=complaint):
        parse_push(text)


def test_nobody_pushes_where_there_is_nothing(arm_at, stay):
    with pytest.raises(UsageError, match="nobody can push at 'elbo'; did you mean elbow"):
        arm_at(stay, Push(0, 1, "elbo", (0.0, 0.0, 1.0)))
