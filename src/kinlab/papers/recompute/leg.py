"""A leg of three joints in many poses, measured off its own points: what the papers' leg equations must give."""

import numpy as np

from kinlab.kinematics.transforms import Array

COUNT = 40


def leg_quantities(
    coxa: float, femur: float, tibia: float, first: tuple[float, float, float]
) -> dict[str, Array]:
    """Quantities (N,) of a leg, in the unit of its lengths, and rad; knee up, the foot farther out than the coxa.

    Args:
        first: joint angles (alpha, beta, gamma) of the first pose; the others are drawn at random.

    Returns:
        c, f, t: the lengths.
        x, y, z: the foot, z up, x outwards.
        alpha, beta, gamma: the joint angles.
        ground: horizontal distance of the foot from the first joint.
        far: distance of the foot from the first joint.
        span: distance of the foot from the end of the coxa.
        slope: how much the line from there to the foot rises.
        hip: the angle between that line and the femur.
        knee: the inside angle of the knee.
    """
    rng = np.random.default_rng(7)
    drawn = rng.uniform([-0.9, -0.4, -2.2], [0.9, 0.6, -0.6], (COUNT * 4, 3))
    q = np.vstack([first, drawn])
    ends = _points(coxa, femur, tibia, q)
    beyond = np.hypot(ends[2][:, 0], ends[2][:, 1]) > coxa * 1.01
    q = q[beyond][:COUNT]
    shoulder, knee, foot = _points(coxa, femur, tibia, q)
    line, thigh, shank = foot - shoulder, knee - shoulder, foot - knee
    flat = np.hypot(line[:, 0], line[:, 1])
    one = np.ones(len(q))
    return {
        "c": coxa * one, "f": femur * one, "t": tibia * one,
        "x": foot[:, 0], "y": foot[:, 1], "z": foot[:, 2],
        "alpha": q[:, 0], "beta": q[:, 1], "gamma": q[:, 2],
        "ground": np.linalg.norm(foot[:, :2], axis=1),
        "far": np.linalg.norm(foot, axis=1),
        "span": np.linalg.norm(line, axis=1),
        "slope": np.arctan2(line[:, 2], flat),
        "hip": _between(thigh, line),
        "knee": _between(-thigh, shank),
    }  # fmt: skip


def _points(coxa: float, femur: float, tibia: float, q: Array) -> tuple[Array, Array, Array]:
    """Coxa's end, knee and foot (N, 3)."""
    alpha, beta, gamma = q.T
    out = np.stack([np.cos(alpha), np.sin(alpha), 0 * alpha], axis=-1)
    up = np.array([0.0, 0.0, 1.0])
    shoulder = coxa * out
    knee = shoulder + femur * (np.cos(beta)[:, None] * out + np.sin(beta)[:, None] * up)
    total = beta + gamma
    foot = knee + tibia * (np.cos(total)[:, None] * out + np.sin(total)[:, None] * up)
    return shoulder, knee, foot


def _between(a: Array, b: Array) -> Array:
    """The angles (N,) between vectors (N, 3)."""
    return np.asarray(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.sum(a * b, axis=1)))
