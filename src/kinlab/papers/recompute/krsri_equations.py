"""Equations (1) to (29) of the KRSRI robot's paper: body, leg, footstep, energy, distance."""

from collections.abc import Iterator

import numpy as np

from kinlab.gait.swing import CURVES
from kinlab.kinematics.transforms import Array, apply, homogeneous, inverse, rotation, rpy_to_rotation
from kinlab.papers import krsri_hexapod
from kinlab.papers.equations import NONE
from kinlab.papers.recompute.equation import Equation, Form, Quantities, check
from kinlab.papers.recompute.finding import Finding
from kinlab.papers.recompute.leg import COUNT, leg_quantities
from kinlab.robots.load import shipped_robots

NAME = "krsri-hexapod"


def equations() -> Iterator[Finding]:
    """All of them, each against what it must give."""
    body, step = _body(), _step()
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


# The body: a foot in the body's frame, the body turned and shifted


def _body() -> Quantities:
    """A foot, its hip and a move of the body, many times; mm and rad, z downwards from the body."""
    rng = np.random.default_rng(3)
    hip = rng.uniform([-90, 50, 0], [90, 80, 30], (COUNT, 3))
    reach = rng.uniform([-60, 60, 60], [60, 140, 110], (COUNT, 3))
    foot = hip * [1, 1, -1] + reach
    xyz = rng.uniform(-20, 20, (COUNT, 3))
    rpy = rng.uniform(-0.3, 0.3, (COUNT, 3))
    # The first: the body turns about z alone, so that a reader can follow.
    hip[0], reach[0], xyz[0], rpy[0] = (0, 60, 0), (0, 100, 90), (0, 0, 0), (0, 0, np.radians(10))
    foot[0] = hip[0] + reach[0]
    return {
        "φ": rpy[:, 0], "θ": rpy[:, 1], "ψ": rpy[:, 2],
        "tx": xyz[:, 0], "ty": xyz[:, 1], "tz": xyz[:, 2],
        "x_offset": hip[:, 0], "y_offset": hip[:, 1], "z_offset": hip[:, 2],
        "x1": foot[:, 0], "y1": foot[:, 1],
        "x": reach[:, 0], "y": reach[:, 1], "z": reach[:, 2],
        "polar": np.arctan2(foot[:, 1], foot[:, 0]), "L": np.hypot(foot[:, 0], foot[:, 1]),
        "height": reach[:, 2] - hip[:, 2],
    }  # fmt: skip


def _stack(rows: list[list[Array | float]], like: Array) -> Array:
    """Matrices (N, ...) of entries that are (N,) or one number."""
    return np.moveaxis(np.array([[entry + 0 * like for entry in row] for row in rows]), -1, 0)


def _turn(axis: str) -> Form:
    """(6) to (8) as printed."""

    def printed(s: Quantities) -> Array:
        angle = s[{"x": "φ", "y": "θ", "z": "ψ"}[axis]]
        c, n = np.cos(angle), np.sin(angle)
        rows: dict[str, list[list[Array | float]]] = {
            "x": [[1, 0, 0], [0, c, -n], [0, n, c]],
            "y": [[c, 0, n], [0, 1, 0], [-n, 0, c]],
            "z": [[c, -n, 0], [n, c, 0], [0, 0, 1]],
        }
        return _stack(rows[axis], angle)

    return printed


def _wide(form: Form) -> Form:
    """(12) to (14) as printed: the same with a fourth row and column."""

    def printed(s: Quantities) -> Array:
        matrix = np.asarray(form(s))
        wide = np.zeros((len(matrix), 4, 4))
        wide[:, :3, :3], wide[:, 3, 3] = matrix, 1
        return wide

    return printed


def _true_turn(name: str, size: int) -> Form:
    axis = {"φ": (1.0, 0.0, 0.0), "θ": (0.0, 1.0, 0.0), "ψ": (0.0, 0.0, 1.0)}[name]

    def true(s: Quantities) -> Array:
        return np.array([homogeneous(rotation(axis, a), np.zeros(3))[:size, :size] for a in s[name]])

    return true


def _entries(angle: str, axis: str, size: int) -> tuple[tuple[str, ...], ...]:
    """The texts of (6) to (8), or of (12) to (14)."""
    c, n = f"cos {angle}", f"sin {angle}"
    rows = {
        "x": (("1", "0", "0"), ("0", c, f"-{n}"), ("0", n, c)),
        "y": ((c, "0", n), ("0", "1", "0"), (f"-{n}", "0", c)),
        "z": ((c, f"-{n}", "0"), (n, c, "0"), ("0", "0", "1")),
    }[axis]
    if size == 3:
        return rows
    return (*((*row, "0") for row in rows), ("0", "0", "0", "1"))


def _turns(first: int, size: int) -> Iterator[Equation]:
    for k, (angle, axis) in enumerate((("φ", "x"), ("θ", "y"), ("ψ", "z"))):
        form = _turn(axis) if size == 3 else _wide(_turn(axis))
        yield Equation(
            str(first + k), f"R{axis}, {size} x {size}, a turn by {angle} about {axis}", form, _true_turn(angle, size),
            inputs=((angle, angle, "deg"),), entries=_entries(angle, axis, size),
        )  # fmt: skip


def _move(s: Quantities, printed: frozenset[str]) -> Array:
    """Where the foot is, seen from its own hip or the body, after (16); mm, x forwards, y left, z up."""
    return np.array([
        1e3 * krsri_hexapod.body(foot / 1e3, hip / 1e3, xyz / 1e3, rpy, printed)[0]
        for foot, hip, xyz, rpy in zip(*_upwards(s), strict=True)
    ])  # fmt: skip


def _moved(s: Quantities) -> Array:
    """Where a foot that stays on the ground is, seen from the body that has moved over it."""
    return np.array([
        apply(inverse(homogeneous(rpy_to_rotation(rpy), xyz)), foot[0])
        for foot, _, xyz, rpy in zip(*_upwards(s), strict=True)
    ])  # fmt: skip


def _upwards(s: Quantities) -> tuple[Array, Array, Array, Array]:
    """Feet and hips (N, 1, 3) with z up, moves and turns (N, 3)."""
    hips = np.stack([s["x_offset"], s["y_offset"], s["z_offset"]], axis=-1)
    reach = np.stack([s["x"], s["y"], -s["z"]], axis=-1)
    xyz = np.stack([s["tx"], s["ty"], s["tz"]], axis=-1)
    rpy = np.stack([s["φ"], s["θ"], s["ψ"]], axis=-1)
    return (hips + reach)[:, None, :], hips[:, None, :], xyz, rpy


def _product(s: Quantities) -> Array:
    x, y, z = (np.asarray(_turn(axis)(s)) for axis in "xyz")
    return np.asarray(x @ y @ z)


BODY = (
    Equation(
        "1", "x1 = cos θ L", lambda s: np.cos(s["polar"]) * s["L"], lambda s: s["x1"], unit="mm",
        inputs=(("θ", "polar", "deg"), ("L", "L", "mm")),
    ),
    Equation(
        "2", "y1 = sin θ L", lambda s: np.sin(s["polar"]) * s["L"], lambda s: s["y1"], unit="mm",
        inputs=(("θ", "polar", "deg"), ("L", "L", "mm")),
    ),
    Equation(
        "3", "x = x1 - x_offset", lambda s: s["x1"] - s["x_offset"], lambda s: s["x"], unit="mm",
        inputs=(("x1", "x1", "mm"), ("x_offset", "x_offset", "mm")), cause="the foot as its hip sees it",
    ),
    Equation(
        "4", "y = y1 - y_offset", lambda s: s["y1"] - s["y_offset"], lambda s: s["y"], unit="mm",
        inputs=(("y1", "y1", "mm"), ("y_offset", "y_offset", "mm")), cause="the foot as its hip sees it",
    ),
    Equation(
        "5", "z = height + z_offset", lambda s: s["height"] + s["z_offset"], lambda s: s["z"], unit="mm",
        inputs=(("height", "height", "mm"), ("z_offset", "z_offset", "mm")),
        cause="z counts downwards from the hip, which is z_offset above the body",
    ),
    *_turns(6, 3),
    Equation(
        "9", "Rot = Rx Ry Rz", _product, lambda s: np.array([
            rotation((1, 0, 0), a) @ rotation((0, 1, 0), b) @ rotation((0, 0, 1), c)
            for a, b, c in zip(s["φ"], s["θ"], s["ψ"], strict=True)
        ]), inputs=(("φ", "φ", "deg"), ("θ", "θ", "deg"), ("ψ", "ψ", "deg")), cause="z first",
    ),
    Equation(
        "10", "Trans = (tx, ty, tz)", lambda s: np.stack([s["tx"], s["ty"], s["tz"]], axis=-1),
        lambda s: np.array([homogeneous(np.eye(3), t)[:3, 3] for t in zip(s["tx"], s["ty"], s["tz"], strict=True)]),
        unit="mm",
    ),
    Equation(
        "11", "P = (x, y, z, 1)", lambda s: np.stack([s["x"], s["y"], s["z"], 1 + 0 * s["x"]], axis=-1),
        lambda s: np.array([
            homogeneous(np.eye(3), p)[:, 3] for p in zip(s["x"], s["y"], s["z"], strict=True)
        ]), unit="mm", cause="it already holds the 1 that (16) adds once more",
    ),
    *_turns(12, 4),
    Equation(
        "15", "Trans, 4 x 4, a shift by tx, ty, tz",
        lambda s: _stack([[1, 0, 0, s["tx"]], [0, 1, 0, s["ty"]], [0, 0, 1, s["tz"]], [0, 0, 0, 1]], s["tx"]),
        lambda s: np.array([homogeneous(np.eye(3), t) for t in zip(s["tx"], s["ty"], s["tz"], strict=True)]),
        inputs=(("tx", "tx", "mm"), ("ty", "ty", "mm"), ("tz", "tz", "mm")),
        entries=(("1", "0", "0", "tx"), ("0", "1", "0", "ty"), ("0", "0", "1", "tz"), ("0", "0", "0", "1")),
    ),
    Equation(
        "16", "T = Rot P + Trans, of P less its hip's offset",
        lambda s: _move(s, frozenset(m.equation for m in krsri_hexapod.BODY)), _moved,
        "T = Rot (P - Trans), of P from the body's centre, with Rz(-ψ), then less the offset",
        lambda s: _move(s, NONE), unit="mm",
        inputs=(("ψ", "ψ", "deg"), ("y_offset", "y_offset", "mm"), ("y", "y", "mm"), ("x = φ = θ = t", "x", "")),
        cause="every foot turns about its own hip: for ψ = 10 deg, a hip 60 mm from the centre and a foot 100 mm "
        f"beyond, the foot has to move by 2 x 160 sin 5 = {2 * 160 * np.sin(np.radians(5)):.1f} mm, and moves by "
        f"2 x 100 sin 5 = {2 * 100 * np.sin(np.radians(5)):.1f} mm; with z downwards Rz has the wrong sense, and the "
        "feet move with the body instead of against it",
    ),
)  # fmt: skip


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
