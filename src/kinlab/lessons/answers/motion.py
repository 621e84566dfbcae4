"""How fast feet move: the Jacobian of a three-joint leg. Angles in degrees, rates in deg/s, speeds in mm/s."""

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.lessons.answers.leg import foot, lengths
from kinlab.lessons.robots import load_robot


def sideways_speed(robot: str, beta: float, gamma: float, rate: float) -> float:
    """How fast the foot moves when the coxa alone turns at `rate`."""
    return float(abs(_velocity(robot, (0.0, beta, gamma), (rate, 0.0, 0.0))[1]))


def sideways_speed_in_degrees(robot: str, beta: float, gamma: float, rate: float) -> float:
    """As `sideways_speed`, degrees taken for radians."""
    return float(np.degrees(sideways_speed(robot, beta, gamma, rate)))


def sideways_speed_of_the_whole_leg(robot: str, beta: float, gamma: float, rate: float) -> float:
    """As `sideways_speed`, the leg taken for stretched out level."""
    return float(sum(lengths(robot).values()) * np.radians(rate))


def femur_velocity(robot: str, beta: float, gamma: float, rate: float) -> list[float]:
    """How fast the foot moves (outwards, upwards) when the femur alone turns at `rate`."""
    vx, _, vz = _velocity(robot, (0.0, beta, gamma), (0.0, rate, 0.0))
    return [float(vx), float(vz)]


def femur_velocity_from_coxa(robot: str, beta: float, gamma: float, rate: float) -> list[float]:
    """As `femur_velocity`, about the coxa's axis instead of the femur's joint."""
    x, _, z = foot(robot, 0.0, beta, gamma)
    w = float(np.radians(rate))
    return [-z * w, x * w]


def femur_velocity_swapped(robot: str, beta: float, gamma: float, rate: float) -> list[float]:
    """As `femur_velocity`, the two components in each other's place."""
    vx, vz = femur_velocity(robot, beta, gamma, rate)
    return [vz, vx]


def place(robot: str, beta: float, gamma: float) -> dict[str, float]:
    """Where the foot is: out (mm from the femur's joint) and up (mm over it)."""
    x, _, z = foot(robot, 0.0, beta, gamma)
    return {"out": x - lengths(robot)["coxa"], "up": z}


def determinant(robot: str, gamma: float) -> float:
    """How much area femur and tibia sweep per squared radian, f t sin(gamma), cm2."""
    J = _plane(robot, 0.0, gamma)
    return float(np.linalg.det(J) * 1e4)


def determinant_with_cosine(robot: str, gamma: float) -> float:
    """As `determinant`, a cosine in the place of the sine."""
    leg = lengths(robot)
    return float(leg["femur"] * leg["tibia"] * np.cos(np.radians(gamma)) / 100)


def knee_rate(robot: str, gamma: float, speed: float) -> float:
    """How fast the knee must turn to draw the foot towards the femur's joint at `speed`, deg/s."""
    return float(np.degrees(speed / _shortening(robot, gamma)))


def knee_rate_by_the_tibia(robot: str, gamma: float, speed: float) -> float:
    """As `knee_rate`, the foot taken to move by the tibia's length for each radian."""
    return float(np.degrees(speed / lengths(robot)["tibia"]))


def _shortening(robot: str, gamma: float) -> float:
    """By how much the line from the femur's joint to the foot shrinks per radian of the knee, mm."""
    x, _, z = foot(robot, 0.0, 0.0, gamma)
    line = np.array([x - lengths(robot)["coxa"], z])
    turned = _plane(robot, 0.0, gamma)[:, 1] * 1000
    return float(abs(line @ turned) / np.linalg.norm(line))


def lost_direction(robot: str, gamma: float) -> str:
    """Where a foot cannot go at once with femur and tibia: "none", or "along" the leg."""
    return "along" if abs(determinant(robot, gamma)) < 1e-9 else "none"


def _velocity(robot: str, angles: tuple[float, ...], rates: tuple[float, ...]) -> Array:
    J = load_robot(robot).limb(None).jacobian(np.radians(angles))
    return np.asarray(J[:3] @ np.radians(rates) * 1000)


def _plane(robot: str, beta: float, gamma: float) -> Array:
    """Rows outwards and upwards, columns femur and tibia, m/rad."""
    J = load_robot(robot).limb(None).jacobian(np.radians([0.0, beta, gamma]))
    return np.asarray(J[[0, 2], 1:])
