"""The arm paper's equations (2.38) to (2.50): Newton and Euler on one link, and from link to link.

The truth is a link's motion itself: rotations and places as functions of time, differentiated by differences.
"""

from collections.abc import Callable

import numpy as np

from kinlab.kinematics.transforms import Array, rotation
from kinlab.papers.recompute.equation import Equation, Form, Quantities

COUNT = 6
Z = np.array([0.0, 0.0, 1.0])
X = np.array([1.0, 0.0, 0.0])
# First derivative by nine points, of eighth order: far below what two forms may differ by, taken twice as well.
OFFSETS = np.array([1, 2, 3, 4])
WEIGHTS = np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280])
STEP = 0.02

Motion = Callable[[float], Array]


def rate(f: Motion) -> Motion:
    """The derivative in time."""

    def differences(t: float) -> Array:
        ahead = [w * (f(t + k * STEP) - f(t - k * STEP)) for k, w in zip(OFFSETS, WEIGHTS, strict=True)]
        return np.asarray(sum(ahead) / STEP)

    return differences


def newton_samples() -> Quantities:
    """Motions at time 0: a turning frame, a joint in it, a point that slides along it, a mass."""
    cases = [_case(k) for k in range(COUNT)]
    return {name: np.array([case[name] for case in cases]) for name in cases[0]}


def _case(k: int) -> dict[str, Array]:
    rng = np.random.default_rng(20 + k)
    w = np.array([1.0, 2.0, 2.0]) if k == 0 else rng.integers(-2, 3, 3) + np.array([0.0, 0.0, 0.5])
    speed = np.linalg.norm(w)
    axis = w / speed
    c = rng.uniform(-1, 1, 8) if k else np.zeros(8)
    mass, M = 1.0 + k, np.diag([1.0, 2.0, 3.0])
    arm = np.array([1.0, 0.0, 0.0]) if k == 0 else rng.uniform(-1, 1, 3)
    v0, dv = np.array([1.0, 0.0, 0.0]), rng.uniform(-1, 1, 3) * bool(k)

    def frame(t: float) -> Array:
        return rotation(axis, speed * t + c[0] * t * t / 2)

    def origin(t: float) -> Array:
        return np.asarray(c[1:4] * np.sin(t) + c[4:7] * t * t)

    def turned(t: float) -> Array:
        return frame(t) @ rotation(Z, (0.0 if k == 0 else 0.7) + 1.5 * t + c[7] * t * t)

    def fixed(t: float) -> Array:
        return frame(t) @ rotation(Z, 0.7)

    def slid(t: float) -> float:
        return float(0.5 + 0.8 * t + c[6] * t * t)

    def local(t: float) -> Array:
        return np.asarray(arm + np.array([0.4, -0.3, 0.2]) * np.sin(2 * t))

    def spin(R: Motion) -> Motion:
        return lambda t: _axial(R(t).T @ rate(R)(t))

    def linear(place: Motion) -> Array:
        return np.asarray(rate(rate(place))(0.0))

    R0, R1, joint = frame(0.0), turned(0.0), turned(0.0).T @ frame(0.0)
    w0, w1, dw0, dw1 = spin(frame)(0.0), spin(turned)(0.0), rate(spin(frame))(0.0), rate(spin(turned))(0.0)
    return {
        "m": np.array(mass), "M": M, "v": v0, "dv": dv, "arm": arm, "joint": joint,
        "w": w0, "dw": dw0, "w1": w1, "dw1": dw1,
        "w_x": w0[0], "w_y": w0[1], "w_z": w0[2], "p_x": arm[0], "p_y": arm[1], "p_z": arm[2],
        "qd": np.array(1.5), "qdd": np.array(2 * c[7]),
        "fixed": fixed(0.0).T @ R0, "fixed w": spin(fixed)(0.0), "fixed dw": rate(spin(fixed))(0.0),
        "force": R0.T @ rate(lambda t: frame(t) @ (mass * (v0 + dv * t)))(0.0),
        "moment": R0.T @ rate(lambda t: frame(t) @ M @ spin(frame)(t))(0.0),
        "moment1": R1.T @ rate(lambda t: turned(t) @ M @ spin(turned)(t))(0.0),
        "dv_origin": R0.T @ linear(origin), "rotation": R0, "d_origin": linear(origin),
        "local": local(0.0), "local rate": rate(local)(0.0), "local bend": linear(local),
        "point": linear(lambda t: frame(t) @ local(t) + origin(t)),
        "next": R1.T @ linear(lambda t: frame(t) @ arm + origin(t)),
        "slid": np.array(slid(0.0)), "slid rate": np.array(0.8), "slid bend": np.array(2 * c[6]),
        "slid point": R0.T @ linear(lambda t: frame(t) @ (slid(t) * X) + origin(t)),
        "centre": R1.T @ linear(lambda t: turned(t) @ arm + frame(t) @ arm + origin(t)),
    }  # fmt: skip


def _axial(W: Array) -> Array:
    return np.array([W[2, 1] - W[1, 2], W[0, 2] - W[2, 0], W[1, 0] - W[0, 1]]) / 2


def _turn(R: Array, v: Array) -> Array:
    return np.asarray((R @ v[..., None])[..., 0])


def _twice(w: Array, p: Array) -> Array:
    return np.cross(w, np.cross(w, p))


def _euler(s: Quantities, last: Array) -> Array:
    """M ω' + ω × last."""
    return np.asarray(_turn(s["M"], s["dw"]) + np.cross(s["w"], last))


def _z(form: Form) -> Form:
    return lambda s: np.asarray(form(s))[:, 2]


def _of(name: str) -> Form:
    return lambda s: s[name]


def _revolute(s: Quantities, sign: float) -> Array:
    """(2.46), with that sign before ω × ω × p."""
    inside = s["dv_origin"] + np.cross(s["dw"], s["arm"]) + sign * _twice(s["w"], s["arm"])
    return _turn(s["joint"], inside)


def _prismatic(s: Quantities) -> Array:
    along, faster, bend = (s[name][:, None] * X for name in ("slid", "slid rate", "slid bend"))
    turning = 2 * np.cross(s["w"], faster) + np.cross(s["dw"], along) + _twice(s["w"], along)
    return np.asarray(s["dv_origin"] + bend + turning)


def _point(s: Quantities) -> Array:
    R, w, dw = s["rotation"], _turn(s["rotation"], s["w"]), _turn(s["rotation"], s["dw"])
    p, v, a = (_turn(R, s[name]) for name in ("local", "local rate", "local bend"))
    return np.asarray(
        a + np.cross(w, v) + np.cross(dw, p) + np.cross(w, v) + np.cross(w, np.cross(w, p)) + s["d_origin"]
    )


def _centre(s: Quantities, of_origin: Array) -> Array:
    return np.cross(s["dw1"], s["arm"]) + _twice(s["w1"], s["arm"]) + of_origin


def _next_spin(s: Quantities) -> Array:
    return np.asarray(_turn(s["joint"], s["w"]) + s["qd"][:, None] * Z)


def _next_turning(s: Quantities) -> Array:
    turned, own = _turn(s["joint"], s["w"]), s["qd"][:, None] * Z
    return np.asarray(_turn(s["joint"], s["dw"]) + np.cross(turned, own) + s["qdd"][:, None] * Z)


EITHER = "on paper or by the scan"
SPIN = tuple((f"ω_{a}", f"w_{a}", "rad/s") for a in "xyz")
BODY = "M = diag(1, 2, 3) kg m², v = (1, 0, 0) m/s; the moment about z"
ARM = tuple((f"p_{a}", f"p_{a}", "m") for a in "xyz")

EQUATIONS = (
    Equation("2.38", "F = d/dt [R m v] = R (m v' + ω × m v)",
             lambda s: s["m"][:, None] * (s["dv"] + np.cross(s["w"], s["v"])), _of("force"), unit="N",
             cause="in the link's frame"),
    Equation(
        "2.39", "N = d/dt [R M ω] = R (M ω' + ω × M v)", _z(lambda s: _euler(s, _turn(s["M"], s["v"]))),
        _z(_of("moment")), "N = R (M ω' + ω × M ω)", _z(lambda s: _euler(s, _turn(s["M"], s["w"]))), unit="N m",
        inputs=SPIN, cause=f"v for ω, {EITHER}; (2.50) has it right. {BODY}",
    ),
    Equation(
        "2.40", "(F, N) = (m v' + ω × m v, M ω' + ω')", _z(lambda s: _turn(s["M"], s["dw"]) + s["dw"]),
        _z(_of("moment")),
        "N = M ω' + ω × M ω", _z(lambda s: _euler(s, _turn(s["M"], s["w"]))), unit="N m", inputs=SPIN,
        cause=f"of ω × M ω only ω' is left, {EITHER}: an acceleration among moments; (2.50) has it right. {BODY}",
    ),
    Equation("2.41", "ω_i+1 = R ω_i + θ' z, revolute", _next_spin, _of("w1"), unit="rad/s"),
    Equation("2.42", "ω_i+1 = R ω_i, prismatic", lambda s: _turn(s["fixed"], s["w"]), _of("fixed w"),
             unit="rad/s", cause="a joint that does not turn"),
    Equation("2.43", "ω'_i+1 = R ω'_i + R ω_i × θ' z + θ'' z, revolute", _next_turning, _of("dw1"), unit="rad/s²"),
    Equation("2.44", "ω'_i+1 = R ω'_i, prismatic", lambda s: _turn(s["fixed"], s["dw"]), _of("fixed dw"),
             unit="rad/s²", cause="a joint that does not turn"),
    Equation("2.45", "v'_Q = R p'' + ω × R p' + ω' × R p + ω × R p' + ω × ω × R p + v'_1", _point, _of("point"),
             unit="m/s²"),
    Equation(
        "2.46", "v'_i+1 = R (v'_i + ω' × p - ω × ω × p), revolute", lambda s: _revolute(s, -1)[:, 0],
        lambda s: s["next"][:, 0], "v'_i+1 = R (v'_i + ω' × p + ω × ω × p)", lambda s: _revolute(s, 1)[:, 0],
        unit="m/s²", inputs=(*SPIN, *ARM),
        cause=f"minus for plus, {EITHER}: the end of a turning link accelerates inwards; (2.45), (2.47) and (2.48) "
        "have the plus. Its x, with v'_i = 0, ω' = 0",
    ),
    Equation("2.47", "v'_i+1 = R (v'_i + d'' x + 2 ω × d' x + ω' × d x + ω × ω × d x), prismatic", _prismatic,
             _of("slid point"), unit="m/s²", cause="in the frame before it"),
    Equation(
        "2.48", "v'_cm = ω' × p_cm + ω × ω × p_cm + v'_i+1, the last in frame i",
        lambda s: _centre(s, _turn(np.swapaxes(s["joint"], -1, -2), s["next"])), _of("centre"),
        "the last in frame i+1", lambda s: _centre(s, s["next"]), unit="m/s²",
        cause=f"the index i for i+1, which all other terms have, {EITHER}; the text calls this acceleration a velocity",
    ),
    Equation("2.49", "F = m v'_cm", lambda s: s["m"][:, None] * s["centre"],
             lambda s: s["m"][:, None] * _centre(s, s["next"]), unit="N"),
    Equation("2.50", "N = M ω' + ω × M ω",
             lambda s: _turn(s["M"], s["dw1"]) + np.cross(s["w1"], _turn(s["M"], s["w1"])),
             _of("moment1"), unit="N m"),
)  # fmt: skip
