"""The arm paper's equations (3.8) to (3.22): forward kinematics, the Jacobian and its inverse, the iteration."""

import numpy as np

from kinlab.kinematics import chain
from kinlab.kinematics.shoulder_arm import shoulder_arm_ik
from kinlab.kinematics.transforms import Array, homogeneous, rotation, wrap
from kinlab.papers import receptionist_arm as printed
from kinlab.papers.receptionist_torques import AXES
from kinlab.papers.recompute.equation import Equation, Form, Quantities

# cm, as the appendix has them. The joints are theta1, theta0, theta2; the paper's Jacobian has theta2 before theta0.
LENGTHS = (18.5, 25.0)
LINKS = np.outer((0.0, *LENGTHS), (1.0, 0, 0))
PAPERS_ORDER = [0, 2, 1]
COUNT = 24
DEG, CM = "deg", "cm"


def arm_samples() -> Quantities:
    """Poses with a bent elbow, of whole degrees, and what the chain gives for them."""
    rng = np.random.default_rng(31)
    spans = ((-60, 60), (-40, 40), (30, 120))
    whole = np.stack([rng.integers(low, high + 1, COUNT) for low, high in spans], axis=-1)
    whole[0] = 30, 60, 30
    q = np.radians(whole.astype(float))
    T = chain.fk(AXES, LINKS, q)
    J = chain.jacobian(AXES, LINKS, q)[:, :3, PAPERS_ORDER]
    step = np.radians(rng.uniform(-3, 3, (COUNT, 3)))
    return {
        "q": q, "theta1": q[:, 0], "theta0": q[:, 1], "theta2": q[:, 2], "T": T, "x": T[:, :3, 3], "J": J,
        "step": step, "dX": _times(J, step), "rough": np.linalg.inv(J) * 1.02, "any J": _any(J, rng),
    }  # fmt: skip


def _any(J: Array, rng: np.random.Generator) -> Array:
    """The first Jacobian, and matrices none of whose entries is always 0, as J31 is; each has an inverse."""
    others = rng.integers(-5, 6, J.shape) + 20.0 * np.eye(3)
    return np.concatenate([J[:1], others[1:]])


def _times(J: Array, v: Array) -> Array:
    return np.asarray((J @ v[..., None])[..., 0])


def _of(name: str) -> Form:
    return lambda s: s[name]


def _column(points: Array) -> Array:
    """Points (N, 3) as columns with a 1 below, (N, 4, 1)."""
    return np.concatenate([points, np.ones((len(points), 1))], axis=1)[..., None]


def _product(s: Quantities, *misprints: str) -> Array:
    return np.array([printed.product(q, (0.0, *LENGTHS), frozenset(misprints)) for q in s["q"]])


def _multiplied(s: Quantities, *misprints: str) -> Array:
    return np.array([printed.multiplied(q, (0.0, *LENGTHS), frozenset(misprints)) for q in s["q"]])


def _place(s: Quantities) -> Array:
    return np.array([printed.position(q, LENGTHS) for q in s["q"]])


def _jacobian(s: Quantities) -> Array:
    return np.array([printed.jacobian(q, LENGTHS) for q in s["q"]])


def _inverse(s: Quantities, *misprints: str) -> Array:
    return np.array([printed.inverse_jacobian(J, frozenset(misprints)) for J in s["any J"]])


def _determinant(s: Quantities) -> Array:
    (a, b, c), (d, e, f), (g, h, i) = np.moveaxis(s["any J"], 0, -1)
    return np.asarray(a * (e * i - h * f) - b * (d * i - g * f) + c * (d * h - g * e))


def _back(s: Quantities) -> Array:
    """The angles that bring the hand to its place, of all poses the nearest to those it came from."""
    found, _ = shoulder_arm_ik(s["x"], *LENGTHS)
    nearest = np.linalg.norm(wrap(found - s["q"][:, None]), axis=-1).argmin(axis=1)
    return np.asarray(found[np.arange(COUNT), nearest])


def _arrived(s: Quantities) -> Array:
    """Where steps 1 to 7 lead from the angles beside those of the target: x after seven rounds."""
    angles = s["q"] + s["step"][:, PAPERS_ORDER]
    for _ in range(7):
        away = s["x"] - chain.fk(AXES, LINKS, angles)[:, :3, 3]
        J = chain.jacobian(AXES, LINKS, angles)[:, :3]
        angles = angles + _times(np.linalg.inv(J), away)
    return angles


def _factors(s: Quantities) -> list[Array]:
    """What the five matrices of (3.9) stand for."""
    moves = [homogeneous(np.eye(3), [length, 0, 0]) for length in LENGTHS]
    turns = [homogeneous(rotation(AXES[i], s["q"][:, i]), np.zeros(3)) for i in range(3)]
    return [turns[0], turns[1], moves[0], turns[2], moves[1]]


def _factor(number: int) -> Form:
    """What one of the five makes of the point (1, 2, 3) cm, (N, 3)."""
    return lambda s: np.broadcast_to((_factors(s)[number] @ [1.0, 2, 3, 1])[..., :3], (COUNT, 3))


def _printed_factor(number: int) -> Form:
    """The same of the matrix entry by entry as printed, its last row left out."""

    def form(s: Quantities) -> Array:
        (c1, c0, c2), (s1, s0, s2) = np.cos(s["q"]).T, np.sin(s["q"]).T
        L1, L2 = LENGTHS
        rows = (
            ((c1, -s1, 0, 0), (s1, c1, 0, 0), (0, 0, 1, 0)),
            ((c0, 0, s0, 0), (0, 1, 0, 0), (-s0, 0, c0, 0)),
            ((0, 0, 0, L1), (0, 1, 0, 0), (0, 0, 1, 0)),
            ((c2, -s2, 0, 0), (s2, c2, 0, 0), (0, 0, 1, 0)),
            ((0, 0, 0, L2), (0, 1, 0, 0), (0, 0, 1, 0)),
        )[number]
        return np.stack([np.zeros(COUNT) + a * 1 + b * 2 + c * 3 + d for a, b, c, d in rows], axis=-1)

    return form


def _in_turn(s: Quantities) -> Array:
    T: Array = np.eye(4)
    for factor in _factors(s):
        T = np.asarray(T @ factor)
    return T


ANGLES = (("θ1", "theta1", DEG), ("θ0", "theta0", DEG), ("θ2", "theta2", DEG))
POSITION = (
    "L1 c0 c1 - L2 (s1 s2 - c0 c1 c2)",
    "L2 (c1 s2 + c0 c2 s1) + L1 c0 s1",
    "-L1 s0 - L2 c2 s0",
)
HERE = "c0 is cos(θ0); here L1 = 18.5, L2 = 25 cm"
COLUMN = (*((text,) for text in POSITION), ("1",))
ZERO = "0 for 1 in the first place of both translations, on paper or by the scan: what lies along x before it is lost"

EQUATIONS = (
    Equation(
        "3.8", "T = T_w0 T_01 T_12 T_23 T_34", _in_turn, _of("T"),
        cause="turns about z, about y, along x by L1, about z, along x by L2",
    ),
    Equation(
        "3.9", "T = Rz(θ1) Ry(θ0) Tx(L1) Rz(θ2) Tx(L2), as five matrices", lambda s: _product(s, "3.9")[:, :3, 3],
        _of("x"), "1 in the first place of both translations", lambda s: _product(s)[:, :3, 3], unit=CM, inputs=ANGLES,
        cause=f"{ZERO}. Here the hand's place with L1 = 18.5, L2 = 25 cm",
    ),
    *(
        Equation(
            f"3.9, matrix {i + 1}", text, _printed_factor(i), _factor(i), corrected, _factor(i),
            cause=f"{ZERO if corrected else 'as it should be'}. Here of the point (1, 2, 3) cm",
        )
        for i, (text, corrected) in enumerate((
            ("Rz(θ1)", ""), ("Ry(θ0)", ""), ("Tx(L1), beginning with 0", "beginning with 1"),
            ("Rz(θ2)", ""), ("Tx(L2), beginning with 0", "beginning with 1"),
        ))
    ),
    Equation(
        "3.9, multiplied out", "T as one matrix", lambda s: _multiplied(s, "order", "R32"), _of("T"),
        "the attitude Rz(θ1) Ry(θ0) Rz(θ2)", _multiplied, inputs=ANGLES,
        cause="the position is right; the attitude is that of the shoulder's axes in the other order, "
        f"Ry(θ0) Rz(θ1 + θ2), and in that order 3,2 should end in c2 s0 s1. {HERE}",
        entries=(
            ("c0 c1 c2 - c0 s1 s2", "-c0 c1 s2 - c0 s1 c2", "s0", POSITION[0]),
            ("c1 s2 + c2 s1", "c1 c2 - s1 s2", "0", POSITION[1]),
            ("s0 s1 s2 - c1 c2 s0", "c1 s0 s2 + c0 s0 s1", "c0", POSITION[2]),
            ("0", "0", "0", "1"),
        ),
    ),
    Equation("3.10", "K_w = T K_g", lambda s: s["T"] @ [0.0, 0, 0, 1], lambda s: _column(s["x"])[..., 0],
             cause="the origin of the hand's frame, seen from the shoulder's"),
    Equation("3.11", "(x_w, y_w, z_w, 1) = T (x_g, y_g, z_g, 1)", lambda s: s["T"] @ [1.0, 2, 3, 1],
             lambda s: _column(s["x"] + _times(s["T"][:, :3, :3], np.array([1.0, 2, 3])))[..., 0],
             cause="(3.10) with its entries, here for a point (1, 2, 3) cm of the hand's frame"),
    Equation("3.12", "K_w = the last column of T", lambda s: _column(_place(s)), lambda s: _column(s["x"]), unit=CM,
             inputs=ANGLES, cause=HERE, entries=COLUMN),
    Equation("3.13", "(3.12) with cos and sin written out", lambda s: _column(_place(s)), lambda s: _column(s["x"]),
             unit=CM, inputs=ANGLES, cause=HERE, entries=COLUMN),
    Equation("3.14", "x = f(θ)", _place, _of("x"), unit=CM, cause="f is (3.13)"),
    Equation("3.15", "θ = f^-1(x)", _back, _of("q"), cause="of the poses that reach x, the one that it came from"),
    Equation("3.16", "dX = J(θ) dθ", lambda s: _times(_jacobian(s), s["step"]), _of("dX"), unit=CM,
             cause="with the printed J"),
    Equation(
        "3.17", "J_ij = ∂f_i / ∂f_j", lambda s: np.ones(COUNT), lambda s: s["J"][:, 0, 0],
        "J_ij = ∂f_i / ∂θ_j", lambda s: _jacobian(s)[:, 0, 0], inputs=ANGLES,
        cause="∂f_i / ∂f_j is 1 or 0; here J_11, which is -y_w. On paper or by the scan f stands for θ; the entries "
        "that follow are derivatives by θ1, θ2, θ0, in this order",
    ),
    Equation(
        "3.17, entries", "J", _jacobian, _of("J"), unit=CM, inputs=ANGLES, cause=HERE,
        entries=(
            ("-L1 c0 s1 - L2 (c1 s2 + c0 s1 c2)", "-L2 (s1 c2 + c0 c1 s2)", "-L1 s0 c1 - L2 s0 c1 c2"),
            ("L2 (-s1 s2 + c0 c2 c1) + L1 c0 c1", "L2 (c1 c2 - c0 s2 s1)", "-L2 s0 c2 s1 - L1 s0 s1"),
            ("0", "L2 s2 s0", "-L1 c0 - L2 c2 c0"),
        ),
    ),
    Equation("3.18", "dθ = J^-1 dX", lambda s: _times(_inverse(s), _times(s["any J"], s["step"])), _of("step"),
             cause="with the printed J^-1, J_inv32 corrected"),
    Equation(
        "3.19", "J^+ = J^T (J J^T)^-1",
        lambda s: np.swapaxes(s["J"][:, :2], 1, 2) @ np.linalg.inv(s["J"][:, :2] @ np.swapaxes(s["J"][:, :2], 1, 2)),
        lambda s: np.linalg.pinv(s["J"][:, :2]), cause="here of the two rows for x and y",
    ),
    Equation("3.20", "J^-1 = adj(J) / det(J)", _inverse, lambda s: np.linalg.inv(s["any J"]),
             cause="with J_inv32 corrected"),
    Equation("3.20, determinant", "det = J11 (J22 J33 - J32 J23) - J12 (J21 J33 - J31 J23) + J13 (J21 J32 - J31 J22)",
             _determinant, lambda s: np.linalg.det(s["any J"]), unit="cm³"),
    Equation(
        "3.20, entries", "J^-1", lambda s: _inverse(s, "J_inv32"), lambda s: np.linalg.inv(s["any J"]),
        "J_inv32 = -(J11 J32 - J31 J12) / det", _inverse, inputs=ANGLES,
        cause=f"J31 for J32; as J31 is 0, the print makes J_inv32 0, which is right where θ0 = 0. {HERE}",
        entries=(
            ("(J22 J33 - J32 J23) / det", "-(J12 J33 - J32 J13) / det", "(J12 J23 - J22 J13) / det"),
            ("-(J21 J33 - J31 J23) / det", "(J11 J33 - J31 J13) / det", "-(J11 J23 - J21 J13) / det"),
            ("(J21 J32 - J31 J22) / det", "-(J11 J31 - J31 J12) / det", "(J11 J22 - J21 J12) / det"),
        ),
    ),
    Equation(
        "3.21", "error = |(I - J J^-1) dX|",
        lambda s: np.linalg.norm(_times(np.eye(3) - s["J"] @ s["rough"], s["dX"]), axis=-1),
        lambda s: 0.02 * np.linalg.norm(s["dX"], axis=-1), unit=CM, cause="for an inverse that is 2 % too large",
    ),
    Equation("3.22", "θ = θ + J^-1 dX", _arrived, _of("q"),
             cause="seven rounds, from up to 3 degrees beside the target"),
)  # fmt: skip
