"""How safely a robot stands: support polygons and their margins. Millimetres and degrees."""

from functools import cache

import numpy as np

from kinlab.gait import least_margins, plan, wave_margin
from kinlab.gait.support import energy_margin, margins
from kinlab.lessons.robots import find_gait, load_robot

TRIPOD = ("L1", "R2", "L3")


def feet(robot: str, back: float) -> dict[str, list[float]]:
    """Where the feet of one tripod are, in the body's frame, when they have gone back by `back`; x and y."""
    one = load_robot(robot)
    places = dict(zip((leg.name for leg in one.legs), one.standing_feet * 1000, strict=True))
    return {name: [float(places[name][0]) - back, float(places[name][1])] for name in TRIPOD}


def static(robot: str, back: float) -> float:
    """The distance from the centre of mass, over the body's middle, to the nearest edge."""
    return float(margins(_feet(robot, back), np.zeros(2)).static)


def to_the_foot(robot: str, back: float) -> float:
    """As `static`, to the nearest foot and not to the nearest edge."""
    return float(np.hypot(*_feet(robot, back).T).min())


def along(robot: str, back: float) -> float:
    """As `static`, straight ahead or behind."""
    return float(margins(_feet(robot, back), np.zeros(2)).longitudinal)


def holding(robot: str) -> str:
    """Which three legs hold the robot by themselves: those of one "side", those in "front", or a "tripod"."""
    one = load_robot(robot)
    places = dict(zip((leg.name for leg in one.legs), one.standing_feet[:, :2], strict=True))
    sets = {"side": ("L1", "L2", "L3"), "front": ("L1", "R1", "L2"), "tripod": TRIPOD}
    return max(
        sets,
        key=lambda name: float(margins(np.array([places[leg] for leg in sets[name]]), np.zeros(2)).static),
    )


def formula(pairs: int, beta: float, pitch: float, stroke: float) -> float:
    """The least longitudinal margin of a wave gait: S = (n/2 - 1) P + (1 - 3/(4 beta)) R."""
    return wave_margin(pairs, beta, pitch, stroke)


def formula_with_feet(pairs: int, beta: float, pitch: float, stroke: float) -> float:
    """As `formula`, legs counted in the place of pairs."""
    return wave_margin(2 * pairs, beta, pitch, stroke)


def formula_plus(pairs: int, beta: float, pitch: float, stroke: float) -> float:
    """As `formula`, the sign of its second term turned round."""
    return 2 * (pairs / 2 - 1) * pitch - wave_margin(pairs, beta, pitch, stroke)


def least(robot: str, gait: str) -> dict[str, float]:
    """The smallest margins of a gait at KinLab's usual stroke, and that stroke."""
    return _least(robot, gait)


def steadier(robot: str, one: str, other: str) -> str:
    """Which of two gaits has the larger least margin."""
    return max((one, other), key=lambda gait: _least(robot, gait)["static"])


def energy(distance: float, height: float) -> float:
    """How far the centre of mass rises before the robot tips over an edge."""
    return float(energy_margin(distance, height))


def energy_whole(distance: float, height: float) -> float:
    """As `energy`, the height over the ground and not the rise."""
    return float(np.hypot(distance, height))


def _feet(robot: str, back: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    return np.array(list(feet(robot, back).values()))


@cache
def _least(robot: str, gait: str) -> dict[str, float]:
    one = load_robot(robot)
    walk = plan(one, find_gait(one, gait))
    return {
        "static": min(phase.static for phase in least_margins(walk)) * 1000,
        "stroke": walk.stroke * 1000,
    }
