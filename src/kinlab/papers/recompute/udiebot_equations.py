"""Equations (1) to (10) of Udiebot's paper, in the axes of its Tables 4 to 6: x outwards, y up, z sideways."""

from collections.abc import Iterator

import numpy as np

from kinlab.kinematics.transforms import Array, homogeneous, rotation
from kinlab.papers import udiebot_quadruped as udiebot
from kinlab.papers.recompute.equation import Equation, Quantities, check
from kinlab.papers.recompute.finding import Finding
from kinlab.papers.recompute.leg import leg_quantities
from kinlab.papers.tables import printed_table

NAME = "udiebot-quadruped"
Z_UP = "with z up, as in (4), and y sideways"


def _dh(s: Quantities, a: str) -> Array:
    """(2) with the quantity `a` where the length belongs."""
    c, n, ca, sa = np.cos(s["θ"]), np.sin(s["θ"]), np.cos(s["α"]), np.sin(s["α"])
    o, one = 0 * c, 1 + 0 * c
    rows = [
        [c, -n * ca, n * sa, s[a] * c],
        [n, c * ca, -c * sa, s[a] * n],
        [o, sa, ca, s["d"]],
        [o, o, o, one],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


def _dh_by_parts(s: Quantities) -> Array:
    """Turn about z, shift along z, shift along x, turn about x: what four such parameters stand for."""
    return np.array([
        homogeneous(rotation((0, 0, 1), theta), (0, 0, d)) @ homogeneous(rotation((1, 0, 0), alpha), (a, 0, 0))
        for theta, alpha, a, d in zip(s["θ"], s["α"], s["a"], s["d"], strict=True)
    ])  # fmt: skip


def _joints() -> Quantities:
    theta, alpha, a, d = np.random.default_rng(2).uniform([0.1, 0.1, 20, 5], [1.4, 1.4, 150, 60], (40, 4)).T
    return {"θ": theta, "α": alpha, "a": a, "d": d}


def _product(s: Quantities) -> Array:
    angles = np.stack([s["alpha"], s["beta"], s["gamma"]], axis=-1)
    lengths = (float(s["c"][0]), float(s["f"][0]), float(s["t"][0]))
    return np.array([udiebot.dh(q, lengths)[:3, 3] for q in angles])


def _acos(opposite: Array, one: Array, other: Array) -> Array:
    """The law of cosines: the angle between sides `one` and `other`."""
    return np.asarray(np.arccos((one**2 + other**2 - opposite**2) / (2 * one * other)))


OF_THE_MATRIX = Equation(
    "2", "H_i: column 4 with α_i cos θ_i, α_i sin θ_i, d_i", lambda s: _dh(s, "α"), _dh_by_parts,
    "H_i: column 4 with a_i cos θ_i, a_i sin θ_i, d_i", lambda s: _dh(s, "a"),
    inputs=(("θ", "θ", "deg"), ("α", "α", "deg"), ("a", "a", "mm"), ("d", "d", "mm")),
    cause="an angle stands where a length belongs; a and α look alike in a scan", damaged=True,
    entries=(
        ("cos θ", "-sin θ cos α", "sin θ sin α", "α cos θ"),
        ("sin θ", "cos θ cos α", "-cos θ sin α", "α sin θ"),
        ("0", "sin α", "cos α", "d"),
        ("0", "0", "0", "1"),
    ),
)  # fmt: skip

EQUATIONS = (
    Equation(
        "1", "H = H1 H2 H3", _product, lambda s: np.stack([s["x"], s["y"], s["z"]], axis=-1), unit="mm",
        cause="with the corrected (2): the foot of a leg built of its points",
    ),
    Equation(
        "3", "legLength = √(posX² + posY²)", lambda s: np.hypot(s["x"], s["z"]), lambda s: s["ground"],
        "legLength = √(posX² + posZ²)", lambda s: np.hypot(s["x"], s["y"]), unit="mm",
        inputs=(("posX", "x", "mm"), ("posY", "z", "mm"), ("posZ", "y", "mm")),
        reading=lambda s: np.hypot(s["x"], s["y"]), cause=f"right {Z_UP}; in Tables 4 to 6 y is up",
    ),
    Equation(
        "4", "Zlength = √(posZ² + legLength²)", lambda s: np.hypot(s["y"], s["ground"]), lambda s: s["span"],
        "Zlength = √(posY² + (legLength - coxaLength)²)", lambda s: np.hypot(s["z"], s["ground"] - s["c"]),
        unit="mm", inputs=(("posY", "z", "mm"), ("posZ", "y", "mm"), ("legLength", "ground", "mm")),
        reading=lambda s: np.hypot(s["z"], s["ground"]), reading_truth=lambda s: s["far"],
        cause=f"right {Z_UP}, for a leg without a coxa, which is how Tables 4 to 6 are computed; (5) has the coxa",
    ),
    Equation(
        "5", "θA = atan((legLength - coxaLength) / posY)",
        lambda s: np.arctan((s["ground"] - s["c"]) / s["z"]), lambda s: s["slope"],
        "θA = atan(posY / (legLength - coxaLength))", lambda s: np.arctan(s["z"] / (s["ground"] - s["c"])),
        unit="deg", inputs=(("legLength", "ground", "mm"), ("coxaLength", "c", "mm"), ("posY", "z", "mm")),
        cause="the fraction is upside down; counted from the vertical it would be off by half a turn for a foot below",
    ),
    Equation(
        "6", "J = acos((Zlength² - femur² - tibia²) / (-2 femur Zlength))",
        lambda s: np.arccos((s["span"] ** 2 - s["f"] ** 2 - s["t"] ** 2) / (-2 * s["f"] * s["span"])),
        lambda s: s["hip"], "J = acos((tibia² - femur² - Zlength²) / (-2 femur Zlength))",
        lambda s: _acos(s["t"], s["f"], s["span"]), unit="deg",
        inputs=(("femur", "f", "mm"), ("tibia", "t", "mm"), ("Zlength", "span", "mm")),
        cause="tibia and Zlength have changed places in the numerator",
    ),
    Equation(
        "7", "K = acos((femur² + tibia² - Zlength²) / (-2 femur tibia))",
        lambda s: np.arccos((s["f"] ** 2 + s["t"] ** 2 - s["span"] ** 2) / (-2 * s["f"] * s["t"])),
        lambda s: s["knee"], "K = acos((femur² + tibia² - Zlength²) / (2 femur tibia))",
        lambda s: _acos(s["span"], s["f"], s["t"]), unit="deg",
        inputs=(("femur", "f", "mm"), ("tibia", "t", "mm"), ("Zlength", "span", "mm")),
        reading=lambda s: np.pi - _acos(s["span"], s["f"], s["t"]), reading_truth=lambda s: np.pi - s["knee"],
        cause="right for the angle outside the knee, 180 - K; the -0.072 of Table 4 row 1 shows that the tables "
        "were computed with the one inside",
    ),
    Equation(
        "8", "θ1 = atan(posX, posY)", lambda s: np.arctan2(s["x"], s["z"]), lambda s: s["alpha"],
        "θ1 = atan2(posZ, posX)", lambda s: np.arctan2(s["y"], s["x"]), unit="deg",
        inputs=(("posX", "x", "mm"), ("posY", "z", "mm"), ("posZ", "y", "mm")),
        reading=lambda s: np.arctan2(s["y"], s["x"]),
        cause=f"right {Z_UP}, and with the arguments in the order of a spreadsheet, which takes x first",
    ),
    Equation(
        "9", "θ2 = J + θA", lambda s: s["hip"] + s["slope"], lambda s: s["beta"], unit="deg",
        inputs=(("J", "hip", "deg"), ("θA", "slope", "deg")), cause="with the corrected (5) and (6)",
    ),
    Equation(
        "10", "θ3 = 90 - K", lambda s: np.pi / 2 - s["knee"], lambda s: s["gamma"], "θ3 = K - 180",
        lambda s: s["knee"] - np.pi, unit="deg", inputs=(("K", "knee", "deg"),),
        reading=lambda s: np.pi / 2 - (np.pi - s["knee"]), reading_truth=lambda s: s["gamma"] + np.pi / 2,
        cause="right with the K of (7) as printed, and a servo that stands at 90 when the leg is straight; "
        "Tables 4 to 6 have no such 90",
    ),
)  # fmt: skip


def equations() -> Iterator[Finding]:
    """(1) to (10), against a leg of the lengths of Table 2."""
    coxa, femur_length, tibia = printed_table(NAME, "2").column("length").tolist()
    samples = leg_quantities(coxa, femur_length, tibia, first=(0.3, 0.4, -0.9))
    first, *rest = EQUATIONS
    yield from check(NAME, first, samples)
    yield from check(NAME, OF_THE_MATRIX, _joints())
    for equation in rest:
        yield from check(NAME, equation, samples)
