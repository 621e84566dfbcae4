"""EROS's equations (1) to (8): the head and the arms, as printed and corrected, against the chains of Tables 2 to 4.

No length of EROS is printed; the chains here have lengths of their own in mm, since an equation must hold for any.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array, homogeneous, rotation
from kinlab.papers import eros_humanoid
from kinlab.papers.recompute.equation import Equation, Form, Quantities
from kinlab.papers.recompute.eros_leg import whole_degrees

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
HEAD_LENGTHS, ARM_LENGTHS = (30.0, 80.0), (20.0, 70.0, 150.0)
SHOULDER = 90.0
DEG = "deg"


def _steps(axes: ArrayLike, links: ArrayLike, q: Array) -> Array:
    """The product of one transform for each row of a table, (N, 4, 4)."""
    T: Array = np.broadcast_to(np.eye(4), (len(q), 4, 4))
    for axis, link, angle in zip(np.asarray(axes), np.asarray(links, float), q.T, strict=True):
        R = rotation(axis, angle)
        T = np.asarray(T @ homogeneous(R, R @ link))
    return T


def _position(T: ArrayLike) -> Array:
    """The positions of poses, as columns (N, 3, 1)."""
    return np.asarray(T)[:, :3, 3:]


def _matrix(*rows: tuple[ArrayLike, ...]) -> Array:
    """Rows of entries, each a number or (N,), as matrices (N, n, m)."""
    entries = np.broadcast_arrays(*(entry for row in rows for entry in row))
    return np.moveaxis(np.array(entries), 0, -1).reshape(-1, len(rows), len(rows[0]))


# Head


def head_samples() -> Quantities:
    """Pan and tilt, and the pose that the chain of Table 2 has."""
    q = whole_degrees(1, (90, 30), (-60, 60), (-60, 60))
    T = chain.fk((Z, Y), np.outer(HEAD_LENGTHS, Z), q)
    return {"theta1": q[:, 0], "theta2": q[:, 1], "q": q, "T": T}


def _head(sideways: str) -> Form:
    """(2) entry by entry; `sideways` is the angle whose sine makes up P_y."""

    def form(s: Quantities) -> Array:
        (c1, c2), (s1, s2) = np.cos(s["q"]).T, np.sin(s["q"]).T
        d1, d2 = HEAD_LENGTHS
        return _matrix(
            (c1 * c2, -s1, c1 * s2, d2 * c1 * s2),
            (c2 * s1, c1, s1 * s2, d2 * np.sin(s[sideways]) * s2),
            (-s2, 0, c2, d1 + d2 * c2),
            (0, 0, 0, 1),
        )

    return form


ANGLES_12 = (("θ1", "theta1", DEG), ("θ2", "theta2", DEG))
P_Y = "d_z2 sin(θ2) sin(θ2)"
HEAD_CAUSE = "entry 2,4: θ2 for θ1; beside it 2,3 has both. Here d_z1 = 30, d_z2 = 80 mm"
HEAD_POSITION = (("d_z2 cos(θ1) sin(θ2)",), (P_Y,), ("d_z1 + d_z2 cos(θ2)",))
HEAD = (
    Equation(
        "1", "T_02 = T_01 T_12", lambda s: _steps((Z, Y), np.outer(HEAD_LENGTHS, Z), s["q"]), lambda s: s["T"],
        cause="each T is a row of Table 2: rotation, then translation",
    ),
    Equation(
        "2", "the matrix multiplied out", _head("theta2"), lambda s: s["T"], "entry 2,4 with sin(θ1)",
        _head("theta1"), inputs=ANGLES_12, cause=HEAD_CAUSE,
        entries=(
            ("cos(θ1) cos(θ2)", "-sin(θ1)", "cos(θ1) sin(θ2)", *HEAD_POSITION[0]),
            ("cos(θ2) sin(θ1)", "cos(θ1)", "sin(θ1) sin(θ2)", *HEAD_POSITION[1]),
            ("-sin(θ2)", "0", "cos(θ2)", *HEAD_POSITION[2]),
            ("0", "0", "0", "1"),
        ),
    ),
    Equation(
        "3", "P = the last column of (2)", lambda s: _position(_head("theta2")(s)), lambda s: _position(s["T"]),
        "P_y = d_z2 sin(θ1) sin(θ2)", lambda s: _position(_head("theta1")(s)), unit="mm", inputs=ANGLES_12,
        cause=HEAD_CAUSE.replace("entry 2,4", "P_y"), entries=HEAD_POSITION,
    ),
)  # fmt: skip


# Arms


def arm_samples() -> Quantities:
    """The arm's angles, and the poses that the chains of Tables 3 and 4 have."""
    q = whole_degrees(2, (90, 0, 0), (-60, 60), (-60, 60), (-60, 60))
    shoulder = np.array([0, SHOULDER, 0])
    links = np.outer(ARM_LENGTHS, (0, 0, -1))
    right, left = (chain.fk((Y, X, Y), links + np.outer((side, 0, 0), shoulder), q) for side in (1, -1))
    names = {f"theta{i + 1}": q[:, i] for i in range(3)}
    return names | {"q": q, "T": right, "left T": left}


def _arm(side: int, *printed: str) -> Form:
    """(5) entry by entry, with the shoulder's d_y1 in entry 2,4, or without it."""
    inner, place = frozenset(printed) - {"R24"}, 0 if "R24" in printed else side * SHOULDER

    def form(s: Quantities) -> Array:
        T = np.array([eros_humanoid.arm(q, ARM_LENGTHS, inner) for q in s["q"]])
        T[:, 1, 3] += place
        return T

    return form


def _product_of_table(side: int) -> Form:
    links = np.outer(ARM_LENGTHS, (0.0, 0, -1)) + np.outer((side * SHOULDER, 0, 0), Y)
    return lambda s: _steps((Y, X, Y), links, s["q"])


ANGLES_123 = tuple((f"θ{i}", f"theta{i}", DEG) for i in (1, 2, 3))
LETTERS = "Here d_z1 = 20, d_z2 = 70, d_z3 = 150, d_y1 = 90 mm"
C, S = (tuple(f"{f}(θ{i})" for i in range(4)) for f in ("cos", "sin"))
ARM_POSITION = (
    f"-d_z1 {S[1]} - {S[1]} φ - d_z3 {C[1]} {S[3]}",
    f"d_1 + d_z2 {S[2]} + d_z3 {C[3]} {S[2]}",
    f"d_z3 {S[1]} {S[3]} - {C[1]} φ - d_z1 {C[1]}",
)
ARM_ENTRIES = (
    (f"{C[1]} {C[3]} - {C[2]} {S[1]}", f"{S[1]} {S[2]}", f"{C[1]} {S[3]} + {C[3]} {C[2]} {S[1]}", ARM_POSITION[0]),
    (f"{S[2]} {S[3]}", C[2], f"-{C[3]} {S[2]}", ARM_POSITION[1]),
    (f"-{C[3]} {S[1]} - {C[1]} {C[2]} {S[3]}", f"{C[1]} {S[2]}", f"{C[1]} {C[2]} {C[3]} - {S[1]} {S[3]}",
     ARM_POSITION[2]),
    ("0", "0", "0", "1"),
)  # fmt: skip
SAME_AS_RIGHT = tuple(tuple(f"R_RA,{i}{j}" for j in range(1, 5)) for i in range(1, 4))
ARMS = (
    Equation(
        "4", "T_03 = T_01 T_12 T_23", _product_of_table(1), lambda s: s["T"], cause="each T is a row of Table 3"
    ),
    Equation(
        "5", "the matrix multiplied out", _arm(1, "R11", "phi", "R24"), lambda s: s["T"],
        "R11 = cos(θ1) cos(θ3) - cos(θ2) sin(θ1) sin(θ3); R24 with d_y1; "
        "φ = d_z2 cos(θ2) + d_z3 cos(θ2) cos(θ3)", _arm(1),
        inputs=ANGLES_123, damaged=True,
        cause="the scan has broken this block: it repeats lines, reads z as 2, and mixes φ with the line before. "
        f"What it leaves of R11, R24 and φ is not true of Table 3; all the rest is. {LETTERS}", entries=ARM_ENTRIES,
    ),
    Equation(
        "6", "P = (R14, R24, R34)", lambda s: _position(_arm(1)(s)), lambda s: _position(s["T"]), unit="mm",
        cause="with (5) corrected; in Table 3 and here right is +y", entries=(("R14",), ("R24",), ("R34",)),
    ),
    Equation(
        "7", "the right arm's matrix, with R24 = -d_x1 + d_z2 sin(θ2) + d_z3 cos(θ3) sin(θ2)",
        _arm(-1, "R24"), lambda s: s["left T"], "R24 = -d_y1 + ...", _arm(-1), inputs=ANGLES_123, reading=_arm(-1),
        cause=f"d_x1 stands for what Table 4 calls d_y1, in its column y; its column x has 0. {LETTERS}",
        entries=(SAME_AS_RIGHT[0], (*SAME_AS_RIGHT[1][:3], "-d_x1 + ..."), SAME_AS_RIGHT[2], ("0", "0", "0", "1")),
    ),
    Equation(
        "8", "P = (R14, R24, R34)", lambda s: _position(_arm(-1)(s)), lambda s: _position(s["left T"]), unit="mm",
        cause="with (7) corrected; the sentence before it says right for left", entries=(("R14",), ("R24",), ("R34",)),
    ),
)  # fmt: skip
