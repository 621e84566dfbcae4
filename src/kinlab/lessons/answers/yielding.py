"""The virtual mass, damper and spring that yields to a hand: receptionist-arm (2.7). Torques in kgf cm."""

import numpy as np

from kinlab.control import SecondOrder, low_pass
from kinlab.rig.arm.loop import TABLE_4_1

CYCLE_MS = 16.0


def printed() -> dict[str, float]:
    """The paper's own set, Table 4.1: kf, kenv, denv, menv."""
    return {name: float(value) for name, value in TABLE_4_1._asdict().items()}


def steady(kf: float, kenv: float, torque: float) -> float:
    """How far a joint gives way to a torque that stays, degrees."""
    return float(np.degrees(kf * torque / kenv))


def steady_turned_over(kf: float, kenv: float, torque: float) -> float:
    """As `steady`, spring and gain in each other's place."""
    return float(np.degrees(kenv * torque / kf))


def gain_for(angle: float, torque: float, kenv: float) -> float:
    """The Kf with which a torque moves the joint by `angle` degrees."""
    return float(np.radians(angle)) * kenv / torque


def gain_for_degrees(angle: float, torque: float, kenv: float) -> float:
    """As `gain_for`, degrees taken for radians."""
    return angle * kenv / torque


def damping(kenv: float, denv: float, menv: float) -> float:
    """The damping ratio, (2.14)."""
    return SecondOrder.of_environment(kenv, denv, menv).zeta


def times(value: int, factor: int) -> int:
    """A multiple of a spring, a damper or a mass."""
    return value * factor


def from_swinging_to_creeping(
    kenv: float, denv: float, menv: float, stiffer: float, stronger: float, heavier: float
) -> list[str]:
    """Four arms by their damping ratio, least first: as it is, and with another spring, damper or mass."""
    arms = {
        "base": damping(kenv, denv, menv),
        "spring": damping(stiffer, denv, menv),
        "damper": damping(kenv, stronger, menv),
        "mass": damping(kenv, denv, heavier),
    }
    return sorted(arms, key=lambda name: arms[name])


def swings(kenv: float, denv: float, menv: float) -> str:
    """What the arm does when the hand lets go: "swings" or "creeps"."""
    return "swings" if SecondOrder.of_environment(kenv, denv, menv).oscillates else "creeps"


def clear(kenv: float, denv: float, menv: float) -> bool:
    """Whether the answer is far enough from the border between swinging and creeping."""
    return abs(damping(kenv, denv, menv) - 1) > 0.15


def cycles(alpha: float, share: float) -> float:
    """After how many cycles the filtered torque has come to `share` per cent of a torque that begins and stays.

    Raises:
        ValueError: it never does, or not within a lesson's time.
    """
    if not (0.001 <= alpha <= 1 and share < 100):
        raise ValueError("a filter comes to less than 100 %, and alpha is a number from 0.001 to 1")
    value, count = np.zeros(()), 0
    while value < share / 100:
        value, count = low_pass(value, 1.0, alpha), count + 1
    return float(count)


def delay(alpha: float, share: float) -> float:
    """The same in milliseconds."""
    return cycles(alpha, share) * CYCLE_MS


def delay_in_a_line(alpha: float, share: float) -> float:
    """As `delay`, each cycle taken to add the same."""
    return float(np.ceil(share / 100 / alpha)) * CYCLE_MS
