"""The six-joint leg: hip yaw z, roll x, pitch y; knee y; ankle pitch y, roll x; links along -z.

Three axes meet in the hip, two in the ankle, so that position and attitude of the sole decide all
six angles, up to eight times: knee (2), ankle roll (2), hip roll (2). The derivation follows the
decoupling of Kajita, Hirukawa, Harada and Yokoi, Introduction to Humanoid Robotics (2014), 2.5.2.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.leg import BOUNDARY
from kinlab.kinematics.transforms import Array, rotation, wrap

X, Y = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
NAMES = tuple(
    f"knee-{knee}{'' if ankle == 'in' else ', ankle over'}{'' if hip == 'in' else ', hip over'}"
    for knee in ("forwards", "backwards")
    for ankle in ("in", "over")
    for hip in ("in", "over")
)


def humanoid_leg_ik(pose: ArrayLike, thigh: float, shank: float, foot: float) -> tuple[Array, Array]:
    """All poses of the leg that give the sole the `pose` (..., 4, 4), in the frame of the hip.

    Args:
        pose: of the sole, metres.
        thigh, shank, foot: lengths of the links below hip, knee and ankle, metres.

    Returns:
        Angles (..., 8, 6) in rad, in the order of NAMES and NaN where unreachable, and the
        reachability (...). Where the ankle lies on the axis of its roll joint, or the hip roll is
        +-90 deg, one angle is free and taken as 0.
    """
    pose = np.asarray(pose, float)
    R, p = pose[..., :3, :3], pose[..., :3, 3]
    # The hip, seen from the ankle in the axes of the sole.
    hip = -(np.swapaxes(R, -1, -2) @ p[..., None])[..., 0]
    hip[..., 2] -= foot
    d2 = np.sum(hip * hip, axis=-1)
    stretch, fold = (thigh + shank) ** 2 - d2, d2 - (thigh - shank) ** 2
    slack = 2 * BOUNDARY
    reachable = (stretch >= -slack * (thigh + shank)) & (fold >= -slack * abs(thigh - shank))
    bend = 2 * np.arctan2(np.sqrt(np.maximum(stretch, 0)), np.sqrt(np.maximum(fold, 0)))
    lateral = np.hypot(hip[..., 1], hip[..., 2])
    solutions = []
    for knee in (bend, -bend):
        # w: the hip seen from the ankle when the ankle is straight.
        w_angle = np.arctan2(-thigh * np.sin(knee), shank + thigh * np.cos(knee))
        for over in (False, True):
            sign = -1.0 if over else 1.0
            roll = np.arctan2(sign * hip[..., 1], sign * hip[..., 2])
            pitch = wrap(w_angle - np.arctan2(hip[..., 0], sign * lateral))
            ankle = rotation(Y, knee + pitch) @ rotation(X, roll)
            A = R @ np.swapaxes(ankle, -1, -2)
            for hip_over in (False, True):
                solutions.append(_assemble(A, knee, pitch, roll, hip_over))
    q = np.stack(solutions, axis=-2)
    q[~reachable] = np.nan
    return q, reachable


def _assemble(A: Array, knee: Array, pitch: Array, roll: Array, over: bool) -> Array:
    """The hip's three angles from A = Rz(yaw) Rx(roll) Ry(pitch), joined to those of knee and ankle."""
    sign = -1.0 if over else 1.0
    gimbal = np.hypot(A[..., 0, 1], A[..., 1, 1]) < 1e-12
    yaw = np.where(gimbal, 0.0, np.arctan2(-sign * A[..., 0, 1], sign * A[..., 1, 1]))
    # The other two from A with this very yaw taken out: near hip roll 90 deg the yaw is ill-determined,
    # and only angles that belong together give the attitude back.
    sine, cosine = np.sin(yaw), np.cos(yaw)
    hip_roll = np.arctan2(A[..., 2, 1], cosine * A[..., 1, 1] - sine * A[..., 0, 1])
    hip_pitch = np.arctan2(
        cosine * A[..., 0, 2] + sine * A[..., 1, 2], cosine * A[..., 0, 0] + sine * A[..., 1, 0]
    )
    return np.stack([yaw, hip_roll, hip_pitch, np.broadcast_to(knee, yaw.shape), pitch, roll], axis=-1)
