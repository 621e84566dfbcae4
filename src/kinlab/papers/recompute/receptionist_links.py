"""The arm paper's equations (3.23) to (3.36): forces and moments on two links, in the paper's own terms.

By the text F21 is the force of link 2 on link 1, and F12 = -F21 that of link 1 on link 2; x points along gravity.
Two motions are looked at: driven by servos in a vertical plane, theta0 = 0, and hanging free in it.
"""

import numpy as np

from kinlab.dynamics import GRAVITY, Mechanism, forward_dynamics, inverse_dynamics
from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array
from kinlab.papers.receptionist_torques import AXES
from kinlab.papers.recompute.equation import Equation, Form, Quantities

L1, L2, M1, M2 = 0.185, 0.25, 0.176, 0.190
COUNT = 8
X, Y, Z = 0, 1, 2
RODS = Mechanism(
    axes=AXES,
    links=np.outer((0.0, L1, L2), (1.0, 0, 0)),
    mass=np.array([0.0, M1, M2]),
    centres=np.outer((0.0, L1, L2), (0.5, 0, 0)),
    inertia=np.array(
        [np.diag([0.0, 1, 1]) * m * length**2 / 12 for m, length in ((0, 0), (M1, L1), (M2, L2))]
    ),
    slides=(False,) * 3,
    gravity=np.array([GRAVITY, 0, 0]),
)


def link_samples() -> Quantities:
    """Both motions, and one about y alone; the first sample of each is at rest, link 1 level, link 2 straight on."""
    rng = np.random.default_rng(41)
    q, qd, qdd = rng.uniform(-1, 1, (3, COUNT, 3))
    for motion in (q, qd, qdd):
        motion[:, 1] = 0
    q[0], qd[0], qdd[0] = (np.pi / 2, 0, 0), 0, 0
    fall = forward_dynamics(RODS, q, qd, np.zeros((COUNT, 3)))
    fall[:, 1] = 0
    over = np.zeros((3, COUNT, 3))
    over[:, :, 1] = rng.uniform(-1, 1, (3, COUNT))
    over[:, 0] = [(0, np.pi / 2, 0), (0, 0, 0), (0, 0, 0)]
    free = {f"free {name}": values for name, values in _forces(q, qd, fall).items()}
    swing = {f"over {name}": values for name, values in _forces(*over).items()}
    return {**_forces(q, qd, qdd), **free, **swing}


def _forces(q: Array, qd: Array, qdd: Array) -> dict[str, Array]:
    """Places, accelerations and forces (N, 3), and the servos' torques (N,), in SI units."""
    (B, aB), (C2, a2) = (_moving(end, q, qd, qdd) for end in (0.0, L2 / 2))
    C1, a1 = B / 2, aB / 2
    G1, G2 = (m * np.array([GRAVITY, 0, 0]) for m in (M1, M2))
    F12 = M2 * a2 - G2
    torque = inverse_dynamics(RODS, q, qd, qdd)
    return {
        "B": B, "C1": C1, "C2": C2, "a1": a1, "a2": a2, "F12": F12, "F21": -F12, "a1x": a1[:, X], "a2x": a2[:, X],
        "F01": M1 * a1 + M2 * a2 - G1 - G2, "G1": np.broadcast_to(G1, B.shape), "G2": np.broadcast_to(G2, B.shape),
        "x_C1": C1[:, X], "y_C1": C1[:, Y], "z_C1": C1[:, Z], "x_B": B[:, X], "y_B": B[:, Y], "z_B": B[:, Z],
        "x_C2": C2[:, X], "y_C2": C2[:, Y], "z_C2": C2[:, Z],
        "F01x": M1 * a1[:, X] + M2 * a2[:, X] - G1[X] - G2[X],
        "F21x": -F12[:, X], "F21y": -F12[:, Y], "F21z": -F12[:, Z],
        "pitch": torque[:, 0], "roll": torque[:, 1], "elbow": torque[:, 2],
        "theta1''": qdd[:, 0], "theta0''": qdd[:, 1], "theta2''": qdd[:, 2],
    }  # fmt: skip


def _moving(length: float, q: Array, qd: Array, qdd: Array) -> tuple[Array, Array]:
    """A point on link 2, `length` from B: its place and acceleration, (N, 3)."""
    links = np.array([[0, 0, 0], [L1, 0, 0], [length, 0, 0]])
    bend = np.einsum("...ijk,...j,...k->...i", chain.position_hessian(AXES, links, q), qd, qd)
    linear = chain.jacobian(AXES, links, q)[..., :3, :]
    return chain.fk(AXES, links, q)[..., :3, 3], (linear @ qdd[..., None])[..., 0] + bend


def _of(name: str) -> Form:
    return lambda s: s[name]


def _about_a(s: Quantities, kind: str = "") -> Array:
    """r_AC1 × G1 + r_AB × F21."""
    return np.asarray(np.cross(s[f"{kind}C1"], s[f"{kind}G1"]) + np.cross(s[f"{kind}B"], s[f"{kind}F21"]))


def _about_c1(s: Quantities, kind: str = "") -> Array:
    """r_C1A × F01 + r_C1B × F21."""
    C1, B = s[f"{kind}C1"], s[f"{kind}B"]
    return np.cross(-C1, s[f"{kind}F01"]) + np.cross(B - C1, s[f"{kind}F21"])


def _about_c2(s: Quantities, force: str, kind: str = "") -> Array:
    """(r_B - r_C2) × the force at B."""
    return np.cross(s[f"{kind}B"] - s[f"{kind}C2"], s[f"{kind}{force}"])


def _bearing(s: Quantities) -> Array:
    """What link 2 exerts on link 1 about y through the elbow's bearing, swinging about y."""
    return -(M2 * L2**2 / 12 * s["over theta0''"] - _about_c2(s, "F12", "over ")[:, Y])


def _minor(a: Array, b: Array, axis: int) -> Array:
    """A determinant with the unit vectors in its first row, expanded: the factor of one of them, (N,)."""
    i, j = [k for k in range(3) if k != axis]
    return np.asarray((-1) ** axis * (a[:, i] * b[:, j] - a[:, j] * b[:, i]))


def _determinants(axis: int, kind: str) -> Form:
    return lambda s: (
        _minor(s[f"{kind}C1"], s[f"{kind}G1"], axis) + _minor(s[f"{kind}B"], s[f"{kind}F21"], axis)
    )


def _sum_3_28(s: Quantities, sign: float = 1.0) -> Array:
    """m1 g z_C1 + F21z x_B - F21x z_B, of `sign` F21."""
    reaction = s["over F21z"] * s["over x_B"] - s["over F21x"] * s["over z_B"]
    return np.asarray(M1 * GRAVITY * s["over z_C1"] + sign * reaction)


def _sum_3_31(s: Quantities, gravity: float) -> Array:
    """`gravity` m1 g y_C1 + F21y x_B - F21x y_B."""
    return np.asarray(gravity * M1 * GRAVITY * s["y_C1"] + s["F21y"] * s["x_B"] - s["F21x"] * s["y_B"])


def _sum_3_36(s: Quantities, axis: str) -> Array:
    return np.asarray(s["F21y"] * (s["x_B"] - s["x_C2"]) - s["F21x"] * (s[f"{axis}_B"] - s[f"{axis}_C2"]))


I1C, I1A, I2C = M1 * L1**2 / 12, M1 * L1**2 / 3, M2 * L2**2 / 12
NM = "N m"
REACTION = (("F21x", "F21x", "N"), ("F21y", "F21y", "N"))
AT_B = (("x_B", "x_B", "m"), ("y_B", "y_B", "m"))
FREE = "right for links that hang free, of which the derivation seems to come; here servos turn them"
HERE = f"m1 g = {M1 * GRAVITY:.3f} N"

EQUATIONS = (
    Equation("3.23", "m1 a_C1 = F01 + F21 + G1", lambda s: s["F01"] + s["F21"] + s["G1"], lambda s: M1 * s["a1"],
             unit="N", cause="F01 from the balance of the whole arm"),
    Equation(
        "3.24", "I_C1 α1 = r_C1 × F01 + r_C1B × F21", lambda s: _about_c1(s)[:, Z], lambda s: I1C * s["theta1''"],
        "... + torque of servo 2 - torque of servo 3", lambda s: _about_c1(s)[:, Z] + s["pitch"] - s["elbow"], unit=NM,
        inputs=(("F01x", "F01x", "N"), *REACTION, *AT_B), reading=lambda s: _about_c1(s, "free ")[:, Z],
        reading_truth=lambda s: I1C * s["free theta1''"], cause=f"{FREE}. About z",
    ),
    Equation("3.25", "F01 = F01x i + F01y j + F01z k, and F21 alike",
             lambda s: sum(s["F21"][:, [i]] * np.eye(3)[i] for i in range(3)), _of("F21"), unit="N"),
    Equation(
        "3.26", "I_A α1 = r_AC1 × G1 + r_AB × F21, servo 1, about y", lambda s: _about_a(s, "over ")[:, Y],
        lambda s: I1A * s["over theta0''"], "... + torque of servo 1 + the moment in the elbow's bearing",
        lambda s: _about_a(s, "over ")[:, Y] + s["over roll"] + _bearing(s), unit=NM,
        inputs=(("F21x", "over F21x", "N"), ("z_C1", "over z_C1", "m"), ("z_B", "over z_B", "m")),
        cause="the elbow turns about z alone, so that about y its bearing carries a moment, and the servo itself is "
        f"missing: at rest the left side is 0, the right side is not. {HERE}",
    ),
    Equation("3.27", "the determinants of (3.26)", _determinants(Y, "over "), lambda s: _about_a(s, "over ")[:, Y],
             unit=NM, cause="as the products of (3.26); I_A = m1 L1² / 3 is that of a rod about its end"),
    Equation(
        "3.28", "m1 g z_C1 + F21z x_B - F21x z_B", _sum_3_28, _determinants(Y, "over "),
        "m1 g z_C1 - F21z x_B + F21x z_B", lambda s: _sum_3_28(s, -1), unit=NM,
        inputs=(("F21x", "over F21x", "N"), ("F21z", "over F21z", "N"), ("z_C1", "over z_C1", "m"),
                ("x_B", "over x_B", "m"), ("z_B", "over z_B", "m")),
        reading=lambda s: _sum_3_28(s, -1),
        cause=f"the middle one of the three has a minus: j (z_B F21x - x_B F21z). Right with the force on link 2 for "
        f"F21, as (3.34) has it. {HERE}",
    ),
    Equation(
        "3.29", "I_A α1 = r_AC1 × G1 + r_AB × F21, servo 2, about z", lambda s: _about_a(s)[:, Z],
        lambda s: I1A * s["theta1''"], "... + torque of servo 2 - torque of servo 3",
        lambda s: _about_a(s)[:, Z] + s["pitch"] - s["elbow"], unit=NM,
        inputs=(*REACTION, *AT_B), reading=lambda s: _about_a(s, "free ")[:, Z],
        reading_truth=lambda s: I1A * s["free theta1''"], cause=f"{FREE}. {HERE}",
    ),
    Equation("3.30", "the determinants of (3.29)", _determinants(Z, ""), lambda s: _about_a(s)[:, Z], unit=NM,
             cause="as the products of (3.29)"),
    Equation(
        "3.31", "m1 g y_C1 + F21y x_B - F21x y_B", lambda s: _sum_3_31(s, 1), _determinants(Z, ""),
        "-m1 g y_C1 + F21y x_B - F21x y_B", lambda s: _sum_3_31(s, -1), unit=NM,
        inputs=(*REACTION, ("y_C1", "y_C1", "m"), *AT_B),
        cause="the determinant of (x_C1, y_C1, z_C1) and (m1 g, 0, 0) is -m1 g y_C1. With (3.34)'s F21 the sum is the "
        f"opposite of what (3.28) is: the torque that holds link 1, but for what servo 3 leaves on it. {HERE}",
    ),
    Equation(
        "3.32", "m1 a_C1 = F01 + F21 + G1, for link 2", lambda s: (s["F01"] + s["F21"] + s["G1"])[:, X],
        lambda s: M2 * s["a2"][:, X], "m2 a_C2 = F12 + G2", lambda s: (s["F12"] + s["G2"])[:, X], unit="N",
        inputs=(("x''_C1", "a1x", "m/s²"), ("x''_C2", "a2x", "m/s²")),
        cause=f"(3.23), of link 1, again: m1 = {M1}, m2 = {M2} kg. Along x",
    ),
    Equation(
        "3.33", "I_C1 α1 = r_C1 × F01 + r_C1B × F21, for link 2", lambda s: _about_c1(s)[:, Z],
        lambda s: I2C * (s["theta1''"] + s["theta2''"]), "I_C2 α2 = r_C2B × F12 + torque of servo 3",
        lambda s: _about_c2(s, "F12")[:, Z] + s["elbow"], unit=NM, inputs=(*REACTION, *AT_B),
        cause="(3.24), of link 1, again",
    ),
    Equation(
        "3.34", "m2 x''_C2 = F21x + m2 g", lambda s: (s["F21"] + s["G2"])[:, X], lambda s: M2 * s["a2"][:, X],
        "m2 x''_C2 = F12x + m2 g", lambda s: (s["F12"] + s["G2"])[:, X], unit="N", inputs=(("F21x", "F21x", "N"),),
        reading=lambda s: (-s["F21"] + s["G2"])[:, X],
        cause="by the sentence above it F12 = -F21 acts on link 2. Right with F21 for the force on link 2; (3.23) to "
        "(3.33) need the other one",
    ),
    Equation(
        "3.35", "m2 L2² / 3 θ2''", lambda s: M2 * L2**2 / 3 * s["free theta2''"],
        lambda s: _about_c2(s, "F12", "free ")[:, Z], "m2 L2² / 12 (θ1'' + θ2'')",
        lambda s: I2C * (s["free theta1''"] + s["free theta2''"]), unit=NM,
        inputs=(("θ1''", "free theta1''", "rad/s²"), ("θ2''", "free theta2''", "rad/s²")),
        cause="the moment is taken about C2, where a rod has m L² / 12; / 3 is for its end. And link 2 turns with θ1 "
        "as well. Against (r_B - r_C2) × F of links that hang free",
    ),
    Equation(
        "3.36", "F21y (x_B - x_C2) - F21x (z_B - z_C2)", lambda s: _sum_3_36(s, "z"),
        lambda s: _about_c2(s, "F21")[:, Z],
        "F21y (x_B - x_C2) - F21x (y_B - y_C2)", lambda s: _sum_3_36(s, "y"), unit=NM,
        inputs=(*REACTION, *AT_B, ("x_C2", "x_C2", "m"), ("y_C2", "y_C2", "m"),
                ("z_B", "z_B", "m"), ("z_C2", "z_C2", "m")),
        cause="z for y: a moment about z has no z in it. In the experiments' plane the print loses all of gravity",
    ),
)  # fmt: skip
