"""EROS's equations (36) to (48): quarter circles of a step, the heel strike, the landing in areas."""

from collections.abc import Callable

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.recompute.equation import Equation, Form, Quantities

DEG, MM = "deg", "mm"


def step_samples(leg: Quantities) -> Quantities:
    """Points of reference in mm, the angle T in degrees, heights of both feet, and a leg's angles."""
    rng = np.random.default_rng(7)
    count = len(leg["theta1"])
    whole = {name: rng.integers(-50, 51, count).astype(float) for name in ("PP_i", "PP_i+1", "Z", "Z other")}
    dS = np.where(whole["PP_i+1"] == whole["PP_i"], 1.0, whole["PP_i+1"] - whole["PP_i"])
    T = rng.choice([0.0, 30, 45, 60, 90], count)
    # The plainest places come first: where a way begins, both feet level.
    whole["PP_i"][0], dS[0], T[0], whole["Z other"][0] = 0.0, 10.0, 0.0, whole["Z"][0]
    return {
        **whole,
        "PP_i+1": whole["PP_i"] + dS,
        "dS": dS,
        "T": T,
        "C": rng.integers(1, 10, count).astype(float),
        "dS_H": whole["Z"] - whole["Z other"],
        "n": rng.integers(2, 9, count).astype(float),
        "theta4": np.degrees(leg["theta4"]),
        "theta5": np.degrees(leg["theta5"]),
    }


def _first_of_equal_areas(s: Quantities) -> Array:
    ways = zip(s["dS"], s["n"], strict=True)
    return np.array([np.linspace(0, way, int(n) + 1)[1] for way, n in ways])


def _sin(T: Array) -> Array:
    return np.sin(np.radians(T))


def _on_circle(done: Callable[[Quantities], Array]) -> Form:
    """The point that has done this share of its way."""
    return lambda s: s["PP_i"] + s["dS"] * done(s)


def _difference(number: str, leg: str) -> Equation:
    return Equation(
        number, "dS = PP_(i+1) - PP_i", lambda s: s["PP_i+1"] - s["PP_i"], lambda s: s["dS"], unit=MM,
        inputs=(("PP_i", "PP_i", MM), ("PP_i+1", "PP_i+1", MM)),
        cause=f"the {leg} leg's way from one point of reference to the next",
    )  # fmt: skip


def _along(number: str) -> Equation:
    return Equation(
        number, "X = (-cos(T) + 1) dS + PP_i", lambda s: (-np.cos(np.radians(s["T"])) + 1) * s["dS"] + s["PP_i"],
        _on_circle(lambda s: 1 - np.sqrt(1 - _sin(s["T"]) ** 2)), unit=MM, inputs=POINTS,
        cause="with (38) it draws a quarter circle; on the way down, with (39) corrected, X and Z do the same share "
        "of their ways at every T, which is a straight line: X would need the 90 degrees as well",
    )  # fmt: skip


def _up(number: str) -> Equation:
    return Equation(
        number, "(Y, Z) = sin(T) dS + PP_i, steps 2 and 4", lambda s: _sin(s["T"]) * s["dS"] + s["PP_i"],
        _on_circle(lambda s: np.sqrt(1 - np.cos(np.radians(s["T"])) ** 2)), unit=MM, inputs=POINTS,
    )  # fmt: skip


def _down(number: str) -> Equation:
    return Equation(
        number, "(Y, Z) = (1 - sin(T) + 90) dS + PP_i, steps 1 and 3",
        lambda s: (1 - _sin(s["T"]) + 90) * s["dS"] + s["PP_i"],
        _on_circle(lambda s: 1 - np.sqrt(1 - _sin(s["T"]) ** 2)), "(Y, Z) = (1 - sin(T + 90)) dS + PP_i",
        lambda s: (1 - _sin(s["T"] + 90)) * s["dS"] + s["PP_i"], unit=MM, inputs=POINTS,
        cause="the sine's bracket closes too early: at T = 0 the foot should be at PP_i, at 90 degrees at PP_(i+1)",
    )  # fmt: skip


def _height(number: str, when: str) -> Equation:
    return Equation(
        number, "dS_H = Z - Z of the other foot", lambda s: s["Z"] - s["Z other"],
        lambda s: -np.diff(np.stack([s["Z"], s["Z other"]]), axis=0)[0], unit=MM,
        inputs=(("Z", "Z", MM), ("Z other", "Z other", MM)),
        cause=f"how much higher one foot is than the other at the {when}",
    )  # fmt: skip


def _strike(number: str, when: str, cause: str) -> Equation:
    return Equation(
        number, f"θ_H = dS_H / C + θ4, at the {when}", lambda s: s["dS_H"] / s["C"] + s["theta4"],
        lambda s: s["theta5"] + s["dS_H"] / s["C"], "θ_H = dS_H / C + θ5",
        lambda s: s["dS_H"] / s["C"] + s["theta5"], unit="degrees",
        inputs=(("dS_H", "dS_H", MM), ("C", "C", "mm per degree"), ("θ4", "theta4", "degrees"),
                ("θ5", "theta5", "degrees")), cause=cause,
    )  # fmt: skip


POINTS = (("T", "T", "degrees"), ("dS", "dS", MM), ("PP_i", "PP_i", MM))
ANKLE = (
    "θ_H is the ankle's angle, θ4 the knee's: with both feet level, dS_H = 0, the ankle must keep the θ5 "
    "that holds the sole level"
)
STEPS = (
    _difference("36", "left"),
    _along("37"),
    _up("38"),
    _down("39"),
    _difference("40", "right"),
    _along("41"),
    _up("42"),
    _down("43"),
    _height("44", "push-off"),
    _height("45", "collision"),
    _strike("46", "push-off", ANKLE),
    _strike(
        "47", "collision", f"{ANKLE}; dS_H stands without the prime that (45) gives it, so that (45) is never used"
    ),
    Equation(
        "48", "T_n = dS / n", lambda s: s["dS"] / s["n"],
        _first_of_equal_areas,
        unit=MM, inputs=(("dS", "dS", MM), ("n", "n", "")),
        cause="the length of one of n areas; the text calls it their number. The law with a logarithm that follows "
        "in the paper is not in the text at hand",
    ),
)  # fmt: skip
