"""The weight that standing legs carry, as torques on their joints: for chains in memory, which have no ground.

Quasi-static: the body's weight is shared out so that forces and moments balance, the feet push straight
up, and nothing is added for accelerations. Legs that swing weigh nothing.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.dynamixel import Chain
from kinlab.dynamixel.servo.breaking import motor_of
from kinlab.gait import Motion
from kinlab.gait.stability import GRAVITY, centre_of_mass
from kinlab.kinematics.transforms import Array
from kinlab.rig.rig import Rig


def shares(feet: ArrayLike, centre: ArrayLike, down: ArrayLike) -> Array:
    """The share of the weight on each foot (..., L), 0 for feet in the air.

    Three feet leave no choice. Of all that balance on more, the shares with the least sum of squares;
    where these would have a foot pull at the ground, it carries nothing and the others make up for it.

    Args:
        feet: places (..., L, 2), metres.
        centre: of mass (..., 2), metres.
        down: which stand (..., L).
    """
    feet, down = np.asarray(feet, float), np.asarray(down, bool)
    arms = feet - np.asarray(centre, float)[..., None, :]
    rows = np.stack([np.ones(down.shape), arms[..., 0], arms[..., 1]], axis=-2) * down[..., None, :]
    # What balances: the sum is the weight, and there is no moment about the centre.
    balanced = np.linalg.pinv(rows)[..., 0]
    pushed = np.maximum(balanced, 0.0) * down
    return np.asarray(pushed / np.maximum(pushed.sum(axis=-1, keepdims=True), 1e-12))


def weight_torques(motion: Motion) -> Array:
    """What the ground exerts on the joints (..., L, n), N m: J^T f for each standing foot.

    Zero for a robot whose mass nobody gives.
    """
    walk = motion.walk
    robot = walk.robot
    centre = motion.place + centre_of_mass(robot, motion.q) @ walk.attitude.T
    force = shares(motion.level[..., :2], centre[..., :2], ~motion.swing) * (robot.mass or 0.0) * GRAVITY
    upwards = walk.attitude.T @ [0.0, 0.0, 1.0]
    torques = []
    for i, leg in enumerate(robot.legs):
        push = force[..., i, None] * (leg.mount[:3, :3].T @ upwards)
        torques.append(np.einsum("...kn,...k->...n", leg.jacobian(motion.q[..., i, :])[..., :3, :], push))
    return np.stack(torques, axis=-2)


class Ground:
    """What presses on the feet of an emulated robot."""

    def __init__(self, rig: Rig, chain: Chain) -> None:
        """Find the motors.

        Raises:
            UsageError: a servo's plant takes no force from here.
        """
        self._chain, self._clock, self._sign = chain, rig.clock, rig.wiring.sign
        self._motors = [motor_of(chain.servo(number)) for number in rig.wiring.ids]

    def press(self, torques: ArrayLike) -> None:
        """From now on exert torques (J,) on the joints, N m."""
        self._chain.advance(self._clock.now())
        for motor, torque in zip(self._motors, (self._sign * np.asarray(torques)).tolist(), strict=True):
            motor.external = torque

    def lift(self) -> None:
        """Take the weight off."""
        self.press(np.zeros(len(self._motors)))
