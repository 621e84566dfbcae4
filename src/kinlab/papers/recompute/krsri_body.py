"""Equations (1) to (16) of the KRSRI robot's paper: a foot in the body's frame, the body turned and shifted."""

from collections.abc import Iterator

import numpy as np

from kinlab.kinematics.transforms import Array, apply, homogeneous, inverse, rotation, rpy_to_rotation
from kinlab.papers import krsri_hexapod
from kinlab.papers.equations import NONE
from kinlab.papers.recompute.equation import Equation, Form, Quantities
from kinlab.papers.recompute.leg import COUNT


def body_samples() -> Quantities:
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
