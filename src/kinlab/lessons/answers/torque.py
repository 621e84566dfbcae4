"""What joints must carry: lever arms, J^T f, Newton-Euler. Lengths in mm, masses in g, torques in N m."""

from typing import SupportsFloat

import numpy as np

from kinlab.dynamics import GRAVITY, Mechanism, gravity_torque, inverse_dynamics
from kinlab.kinematics.transforms import Array
from kinlab.lessons.answers.leg import foot, lengths
from kinlab.lessons.robots import load_robot
from kinlab.robots import Limb

ARM = "receptionist-arm"


def hung(mass: float, arm: float) -> float:
    """The torque of a mass at the end of a level arm."""
    return mass / 1000 * GRAVITY * arm / 1000


def hung_without_gravity(mass: float, arm: float) -> float:
    """As `hung`, kilograms taken for newtons."""
    return mass / 1000 * arm / 1000


def share(torque: float, stall: float) -> float:
    """A torque in per cent of what a servo stalls at."""
    return 100 * torque / stall


def on_the_femur(robot: str, mass: float, standing: float, beta: float, gamma: float) -> float:
    """What the femur of one of `standing` legs carries that share the robot's mass: J^T f."""
    return _carried(robot, mass, standing, beta, gamma)[1]


def on_the_femur_alone(robot: str, mass: float, standing: float, beta: float, gamma: float) -> float:
    """As `on_the_femur`, the whole mass on one leg."""
    return on_the_femur(robot, mass, 1, beta, gamma)


def on_the_femur_from_coxa(robot: str, mass: float, standing: float, beta: float, gamma: float) -> float:
    """As `on_the_femur`, the lever arm counted from the coxa's axis."""
    return foot(robot, 0.0, beta, gamma)[0] / 1000 * mass / 1000 * GRAVITY / standing


def lever(robot: str, beta: float, gamma: float) -> float:
    """How far the foot is outside the femur's joint, mm."""
    return foot(robot, 0.0, beta, gamma)[0] - lengths(robot)["coxa"]


def on_the_coxa(robot: str, mass: float, standing: float, beta: float, gamma: float) -> str:
    """Whether the weight turns the coxa: "no" or "yes"."""
    return "no" if abs(_carried(robot, mass, standing, beta, gamma)[0]) < 1e-9 else "yes"


def _carried(robot: str, mass: float, standing: float, beta: float, gamma: float) -> list[float]:
    J = load_robot(robot).limb(None).jacobian(np.radians([0.0, beta, gamma]))
    push = np.array([0.0, 0.0, mass / 1000 * GRAVITY / standing])
    return [float(v) for v in J[:3].T @ push]


def arm() -> dict[str, float]:
    """Links of the receptionist's arm: upper and fore (mm), and their masses upper_g and fore_g."""
    limb = load_robot(ARM).limb(None)
    upper, fore = (joint for joint in limb.joints if np.linalg.norm(joint.link))
    return {
        "upper": _round(np.linalg.norm(upper.link) * 1000),
        "fore": _round(np.linalg.norm(fore.link) * 1000),
        "upper_g": _round((upper.mass or 0) * 1000),
        "fore_g": _round((fore.mass or 0) * 1000),
    }


def holding(shoulder: float, elbow: float) -> list[float]:
    """What shoulder and elbow give to hold the arm still, raised forwards by `shoulder` and bent by `elbow`."""
    return [float(v) for v in gravity_torque(Mechanism.of(_limb()), _pose(shoulder, elbow))[[0, 2]]]


def holding_with_bare_elbow(shoulder: float, elbow: float) -> list[float]:
    """As `holding`, the forearm's angle taken from the vertical and not from the upper arm."""
    return holding(shoulder, elbow - shoulder)


def holding_at_the_ends(shoulder: float, elbow: float) -> list[float]:
    """As `holding`, each mass at the end of its link instead of its middle."""
    links = arm()
    s, e = np.sin(np.radians([shoulder, shoulder + elbow]))
    fore = links["fore_g"] / 1e6 * GRAVITY * links["fore"] * e
    upper = (links["upper_g"] + links["fore_g"]) / 1e6 * GRAVITY * links["upper"] * s
    return [float(upper + fore), float(fore)]


def starting(acceleration: float) -> list[float]:
    """What shoulder and elbow give to start the stretched, hanging arm with `acceleration` rad/s2."""
    q, still = _pose(0.0, 0.0), np.zeros(3)
    torque = inverse_dynamics(Mechanism.of(_limb()), q, still, [acceleration, 0.0, 0.0])
    return [float(v) for v in torque[[0, 2]]]


def starting_at_a_fixed_elbow(acceleration: float) -> list[float]:
    """As `starting`, the forearm taken to turn about an elbow that stays where it is."""
    links = {name: value / 1000 for name, value in arm().items()}
    return [starting(acceleration)[0], links["fore_g"] * links["fore"] ** 2 / 3 * acceleration]


def starting_in_the_middle(acceleration: float) -> list[float]:
    """As `starting`, each link a point in its own middle."""
    links = {name: value / 1000 for name, value in arm().items()}
    out = links["upper"] + links["fore"] / 2
    push = links["fore_g"] * out * acceleration
    upper = links["upper_g"] * (links["upper"] / 2) ** 2 * acceleration
    return [upper + push * out, push * links["fore"] / 2]


def starting_the_forearm_alone(acceleration: float) -> list[float]:
    """As `starting`, the upper arm taken for weightless."""
    links = {name: value / 1000 for name, value in arm().items()}
    upper = links["upper_g"] * links["upper"] ** 2 / 3 * acceleration
    shoulder, elbow = starting(acceleration)
    return [shoulder - upper, elbow]


def newton_euler() -> list[str]:
    """The two walks of the method along two links: motion outwards, forces and torques inwards."""
    links = ("upper", "fore")
    return [*(f"{link}-moves" for link in links), *(f"{link}-carries" for link in reversed(links))]


def _limb() -> Limb:
    return load_robot(ARM).limb(None)


def _pose(shoulder: float, elbow: float) -> Array:
    return np.radians([shoulder, 0.0, elbow])


def _round(value: SupportsFloat) -> float:
    return round(float(value), 6)
