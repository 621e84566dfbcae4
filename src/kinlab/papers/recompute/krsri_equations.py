"""All equations of the KRSRI robot's paper; here (17) to (29): the leg, the footstep, energy, distance."""

from collections.abc import Iterator

import numpy as np

from kinlab.gait.swing import CURVES
from kinlab.kinematics.transforms import Array
from kinlab.papers.recompute.equation import Equation, Quantities, check
from kinlab.papers.recompute.finding import Finding
from kinlab.papers.recompute.krsri_body import BODY, body_samples
from kinlab.papers.recompute.leg import COUNT, leg_quantities
from kinlab.robots.load import shipped_robots

NAME = "krsri-hexapod"


def equations() -> Iterator[Finding]:
    """All of them, each against what it must give."""
    body, step = body_samples(), _step()
    limb = shipped_robots()[NAME].limbs["R1"]
    coxa, femur, tibia = (1e3 * np.linalg.norm(limb.links, axis=1)).tolist()
    leg = leg_quantities(coxa, femur, tibia, first=(0.2, 0.5, -1.2))
    leg["down"] = -leg["z"]
    for equation in BODY:
        yield from check(NAME, equation, body)
    for equation in LEG:
        yield from check(NAME, equation, leg)
    for equation in STEP:
        yield from check(NAME, equation, step)


# The leg: x outwards, z downwards; L1 is the horizontal distance, L2 that from the coxa's end


LEG = (
    Equation(
        "17", "α = atan(y / x)", lambda s: np.arctan(s["y"] / s["x"]), lambda s: s["alpha"], unit="deg",
        inputs=(("x", "x", "mm"), ("y", "y", "mm")), cause="for every foot in front of the coxa, x > 0",
    ),
    Equation(
        "18", "L1 = √(x² + y²)", lambda s: np.sqrt(s["x"] ** 2 + s["y"] ** 2), lambda s: s["ground"], unit="mm",
        inputs=(("x", "x", "mm"), ("y", "y", "mm")),
    ),
    Equation(
        "19", "L2 = √((L1 - cx)² + y²)", lambda s: np.hypot(s["ground"] - s["c"], s["y"]), lambda s: s["span"],
        "L2 = √((L1 - cx)² + z²)", lambda s: np.hypot(s["ground"] - s["c"], s["z"]), unit="mm",
        inputs=(("L1", "ground", "mm"), ("cx", "c", "mm"), ("y", "y", "mm"), ("z", "down", "mm")),
        cause="y is in L1 already; the height belongs here",
    ),
    Equation(
        "20", "β2 = acos((√fm + √L2 - √L1) / (2 fm L2))",
        lambda s: np.arccos((np.sqrt(s["f"]) + np.sqrt(s["span"]) - np.sqrt(s["ground"])) / (2 * s["f"] * s["span"])),
        lambda s: s["hip"], "β2 = acos((fm² + L2² - tb²) / (2 fm L2))",
        lambda s: np.arccos((s["f"] ** 2 + s["span"] ** 2 - s["t"] ** 2) / (2 * s["f"] * s["span"])), unit="deg",
        inputs=(("fm", "f", "mm"), ("L2", "span", "mm"), ("L1", "ground", "mm"), ("tb", "t", "mm")),
        cause="roots stand where squares belong, and L1 where the tibia's length does",
    ),
    Equation(
        "21", "β1 = acos(z / L2)", lambda s: np.arccos(s["down"] / s["span"]), lambda s: np.pi / 2 + s["slope"],
        unit="deg", inputs=(("z", "down", "mm"), ("L2", "span", "mm")),
        cause="counted from straight down, with z downwards, for every foot farther out than the coxa",
    ),
    Equation(
        "22", "β = β1 + β2", lambda s: np.pi / 2 + s["slope"] + s["hip"], lambda s: s["beta"] + np.pi / 2, unit="deg",
        inputs=(("β2", "hip", "deg"), ("β1 - 90", "slope", "deg")), cause="with the corrected (20)",
    ),
    Equation(
        "23", "γ = acos((√fm + √L1 - √L2) / (2 fm L1))",
        lambda s: np.arccos((np.sqrt(s["f"]) + np.sqrt(s["ground"]) - np.sqrt(s["span"])) / (2 * s["f"] * s["ground"])),
        lambda s: s["knee"], "γ = acos((fm² + tb² - L2²) / (2 fm tb))",
        lambda s: np.arccos((s["f"] ** 2 + s["t"] ** 2 - s["span"] ** 2) / (2 * s["f"] * s["t"])), unit="deg",
        inputs=(("fm", "f", "mm"), ("L1", "ground", "mm"), ("L2", "span", "mm"), ("tb", "t", "mm")),
        cause="roots stand where squares belong, and L1 where the tibia's length does: γ comes out near 90 deg, "
        "wherever the foot is",
    ),
)  # fmt: skip


# Footstep, energy, distance


def _step() -> Quantities:
    rng = np.random.default_rng(4)
    t, lift = rng.uniform(0, 1, COUNT), rng.uniform(20, 60, COUNT)
    t[0], lift[0] = 0.5, 40
    first, last = rng.uniform(-40, 40, (2, COUNT))
    speed, duration = rng.uniform(10, 40, COUNT), rng.uniform(25, 100, COUNT)
    current, voltage = rng.uniform(0.5, 2, COUNT), rng.uniform(11, 12.6, COUNT)
    error_x, error_y = rng.uniform(0, 15, (2, COUNT))
    # The first in figures that a reader can follow.
    first[0], last[0], speed[0], duration[0], current[0], voltage[0] = -30, 30, 10, 100, 1, 12
    error_x[0], error_y[0] = 10, 8
    return {
        "t": t, "z_max": lift, "x_1": first, "x_2": last, "K": speed, "W": duration, "J": speed * duration,
        "I": current, "V": voltage,
        "L1": 100 + 0 * t, "error x": error_x, "error y": error_y,
    }  # fmt: skip


def _summed(s: Quantities) -> Array:
    """(28) in a thousand slices of a constant current and voltage."""
    slices = 1000
    dt = s["W"] / slices
    return np.asarray(np.sum([s["I"] * s["V"] * dt / 3600] * slices, axis=0))


STEP = (
    *(
        Equation(
            number, f"{axis} = {axis}1 + t ({axis}2 - {axis}1)", lambda s: s["x_1"] + s["t"] * (s["x_2"] - s["x_1"]),
            lambda s: np.array([
                np.interp(t, [0, 1], ends) for t, *ends in zip(s["t"], s["x_1"], s["x_2"], strict=True)
            ]),
            unit="mm", inputs=(("t", "t", ""), (f"{axis}1", "x_1", "mm"), (f"{axis}2", "x_2", "mm")),
        )
        for number, axis in (("24", "x"), ("25", "y"))
    ),
    Equation(
        "26", "z = z_max + sin(π t)", lambda s: s["z_max"] + np.sin(np.pi * s["t"]),
        lambda s: s["z_max"] * CURVES["line-sine"].height.value(s["t"]), "z = z_max sin(π t)",
        lambda s: s["z_max"] * np.sin(np.pi * s["t"]), unit="mm", inputs=(("z_max", "z_max", "mm"), ("t", "t", "")),
        cause="a plus for a times: as printed the foot is z_max above the ground at both ends, and 1 mm higher midway",
    ),
    Equation(
        "27", "W = J / K", lambda s: s["J"] / s["K"], lambda s: s["W"], unit="s",
        inputs=(("J", "J", "mm"), ("K", "K", "mm/s")),
    ),
    Equation(
        "28", "E = Σ I V dt / 3600", _summed, lambda s: s["I"] * s["V"] * (s["W"] / 3600), unit="Wh",
        inputs=(("I", "I", "A"), ("V", "V", "V"), ("t", "W", "s")), cause="power times hours",
    ),
    Equation(
        "29", "L = √((L1 - error y)² + error x²)",
        lambda s: np.sqrt((s["L1"] - s["error y"]) ** 2 + s["error x"] ** 2),
        lambda s: np.linalg.norm(np.stack([s["error x"], s["L1"] - s["error y"]]), axis=0), unit="cm",
        inputs=(("L1", "L1", "cm"), ("error x", "error x", "cm"), ("error y", "error y", "cm")),
        cause="the straight line from the start to where the robot stopped",
    ),
)  # fmt: skip
