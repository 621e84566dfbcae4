"""The arm paper's equations (2.1) to (2.37): position and compliance control, second-order systems, observers.

Functions of time are taken as e^(st) with a real s, so that every dot is a factor of s.
"""

import numpy as np

from kinlab.control.response import SecondOrder
from kinlab.kinematics.transforms import Array
from kinlab.papers.recompute.equation import Equation, Form, Quantities

COUNT = 12


def control_samples() -> Quantities:
    """Small whole numbers; the first of each are the paper's own where it prints them (section 4.1.2, Table 4.1)."""
    rng = np.random.default_rng(11)

    def drawn(first: float, low: int = 1, high: int = 9) -> Array:
        values = rng.integers(low, high + 1, COUNT).astype(float)
        values[0] = first
        return values

    s, M, cmd, F = drawn(2), drawn(1), drawn(10), drawn(6)
    Kp, Kv = drawn(3.8), drawn(0.2)
    Kf, Kenv, Denv, Menv = drawn(0.3), drawn(12), drawn(5), drawn(1)
    Kf[0] = 0.3
    K, D = Kp * M, Kv * M
    # Force balances: M x'' = K (cmd - x) + D (cmd' - x'), and Menv e'' + Denv e' + Kenv e = Kf F.
    virtual = np.array([np.linalg.solve([[m * z * z + d * z + k]], [(k + d * z) * c])[0]
                        for m, z, d, k, c in zip(M, s, D, K, cmd, strict=True)])  # fmt: skip
    env = Kf * F / (Menv * s**2 + Denv * s + Kenv)
    Ktn, dKt, Jn, dJ = drawn(2), drawn(1, 1, 3), drawn(3), drawn(1, 1, 3)
    current, inner, outer, friction = drawn(4), drawn(1), drawn(1), drawn(1)
    load = inner + outer + friction
    return {
        "s": s, "M": M, "K": K, "D": D, "Kp": Kp, "Kv": Kv, "cmd": cmd, "virtual": virtual, "real": virtual - env,
        "env": env, "F": F, "Kf": Kf, "Kenv": Kenv, "Denv": Denv, "Menv": Menv,
        "zeta": np.array([0.5, *np.linspace(0.1, 0.9, COUNT - 1)]), "omega": drawn(2),
        "Ktn": Ktn, "dKt": dKt, "Kt": Ktn + dKt, "Jn": Jn, "dJ": dJ, "J": Jn + dJ, "I": current,
        "g": np.full(COUNT, 5.0), "internal": inner, "external": outer, "friction": friction, "load": load,
        "acceleration": ((Ktn + dKt) * current - load) / (Jn + dJ),
    }  # fmt: skip


def of(name: str) -> Form:
    return lambda s: s[name]


def _position(s: Quantities) -> Array:
    """(Kv s + Kp) / (s² + Kv s + Kp)."""
    return np.asarray((s["Kv"] * s["s"] + s["Kp"]) / (s["s"] ** 2 + s["Kv"] * s["s"] + s["Kp"]))


def pd(s: Quantities, away: Array) -> Array:
    return np.asarray((s["Kp"] + s["Kv"] * s["s"]) * away)


def yielding(s: Quantities) -> Array:
    """What the environment's mass, damper and spring need for their way."""
    return np.asarray((s["Menv"] * s["s"] ** 2 + s["Denv"] * s["s"] + s["Kenv"]) * s["env"])


def _omega_f(s: Quantities) -> Array:
    return np.sqrt(s["Kenv"] / s["Menv"])


def _zeta_f(s: Quantities) -> Array:
    return np.asarray(s["Denv"] / (2 * np.sqrt(s["Menv"] * s["Kenv"])))


def _poles(b: Array, c: Array) -> tuple[Array, Array]:
    """Size and damping of the roots of s² + b s + c, from the roots themselves."""
    roots = np.array([np.roots([1, b1, c1]) for b1, c1 in zip(b, c, strict=True)])
    size = np.sqrt(np.abs(roots.prod(axis=1)))
    return size, -roots.sum(axis=1).real / (2 * size)


def _first_peak(s: Quantities) -> tuple[Array, Array]:
    """When a step response first turns back, and by how much it is beyond 1 there, from the response itself."""
    times, heights = [], []
    for omega, zeta in zip(s["omega"], s["zeta"], strict=True):
        system = SecondOrder(float(omega), float(zeta))
        low, high = 0.6 * np.pi / omega, 1.4 * np.pi / (omega * np.sqrt(1 - zeta**2))
        for _ in range(12):
            t = np.linspace(low, high, 41)
            k = int(np.clip(system.step(t).argmax(), 1, 39))
            low, high = t[k - 1], t[k + 1]
        times.append(t[k])
        heights.append(float(system.step(t[k])) - 1)
    return np.array(times), np.array(heights)


def _rounded(value: Array, digits: int) -> Array:
    return np.round(value, digits)


def _settled(s: Quantities) -> Array:
    """When the envelope e^(-ζ ω t) is down to 2 %, in units of 1 / (ζ ω), to a whole number."""
    return _rounded(-np.log(np.full(COUNT, 0.02)), 0)


def _rises(zeta: float) -> Array:
    """From 10 to 90 % in units of 1 / ω, to one decimal."""
    t = np.linspace(0, 4, 4001)
    y = SecondOrder(1.0, zeta).step(t)
    return _rounded(np.full(COUNT, t[np.argmax(y > 0.9)] - t[np.argmax(y > 0.1)]), 1)


NM, A = "N m", "A"
SPRING = (("Kp", "Kp", ""), ("Kv", "Kv", ""), ("s", "s", ""), ("x_cmd", "cmd", ""))
SOFT = (
    ("K_f", "Kf", ""),
    ("K_env", "Kenv", ""),
    ("D_env", "Denv", ""),
    ("M_env", "Menv", ""),
    ("s", "s", ""),
)
MOTOR = (
    ("K_tn", "Ktn", ""),
    ("ΔK_t", "dKt", ""),
    ("J_n", "Jn", ""),
    ("ΔJ", "dJ", ""),
    ("I_a", "I", A),
    ("τ_l", "load", NM),
    ("θ''", "acceleration", "rad/s²"),
)
LETTER = "the scan mixes letters here"

EQUATIONS = (
    Equation(
        "2.1", "M x'' + K (x - x_cmd) + D (x' - x'_cmd) = 0",
        lambda s: s["M"] * s["s"] ** 2 * s["virtual"] + (s["K"] + s["D"] * s["s"]) * (s["virtual"] - s["cmd"]),
        lambda s: np.zeros(COUNT), inputs=SPRING, cause="the model; x is solved from its balance of forces",
    ),
    Equation(
        "2.2", "x'' = (K (x_cmd - x) + D (x'_cmd - x')) / M = Kp (x_cmd - x) + Kv (x'_cmd - x')",
        lambda s: pd(s, s["cmd"] - s["virtual"]), lambda s: s["s"] ** 2 * s["virtual"], inputs=SPRING,
        cause="Kp = K / M, Kv = D / M",
    ),
    Equation("2.3", "x = (Kv s + Kp) / (s² + Kv s + Kp) x_cmd", lambda s: _position(s) * s["cmd"], of("virtual"),
             inputs=SPRING),
    Equation("2.4", "x_real = x_virtual - x_env", lambda s: s["virtual"] - s["env"],
             lambda s: _position(s) * s["cmd"] - s["env"], inputs=SPRING, cause="a definition, used in (2.8)"),
    Equation(
        "2.5", "(s² + Kv s + Kp) x_real = (Kv s + Kp) x_cmd - (s² + Kv s + Kp) x_env",
        lambda s: (s["Kv"] * s["s"] + s["Kp"]) * s["cmd"] - (s["s"] ** 2 + s["Kv"] * s["s"] + s["Kp"]) * s["env"],
        lambda s: (s["s"] ** 2 + s["Kv"] * s["s"] + s["Kp"]) * s["real"], inputs=SPRING,
    ),
    Equation(
        "2.6", "x_real = Kp (x_cmd - x_real - x_env) + Kv (x'_cmd - x'_real - x'_env) - x''_env",
        lambda s: pd(s, s["cmd"] - s["real"] - s["env"]) - s["s"] ** 2 * s["env"], of("real"),
        "x''_real = ...", lambda s: (pd(s, s["cmd"] - s["real"] - s["env"]) - s["s"] ** 2 * s["env"]) / s["s"] ** 2,
        inputs=SPRING, damaged=True,
        cause="two dots are missing over x_real, for the right side is an acceleration; scans lose dots",
    ),
    Equation(
        "2.7", "x_env = K_f / (M_env s² + D_env s + K_env) F_ext",
        lambda s: s["Kf"] / (s["Menv"] * s["s"] ** 2 + s["Denv"] * s["s"] + s["Kenv"]) * s["F"], of("env"),
        inputs=(*SOFT, ("F_ext", "F", "")), cause="a mass, a damper and a spring that give way",
    ),
    Equation(
        "2.8", "x_real = (2.3) - 1 / (M_env s² + D_env s + K_env) K_f F_ext",
        lambda s: _position(s) * s["cmd"]
        - 1 / (s["Menv"] * s["s"] ** 2 + s["Denv"] * s["s"] + s["Kenv"]) * s["Kf"] * s["F"],
        of("real"), inputs=SOFT,
    ),
    Equation(
        "2.9", "... - (K_env / M_env) / (s² + D_env / M_env s + K_env / M_env) (K_f / K_env) F_ext",
        lambda s: _position(s) * s["cmd"]
        - s["Kenv"] / s["Menv"] / (s["s"] ** 2 + s["Denv"] / s["Menv"] * s["s"] + s["Kenv"] / s["Menv"])
        * s["Kf"] / s["Kenv"] * s["F"],
        of("real"), inputs=SOFT,
    ),
    Equation(
        "2.10",
        "x_real = (2 ζ_p ω_p s + ω_p²) / (s² + 2 ζ_p ω_p s + ω_p²) x_cmd - ω_f² / (s² + 2 ζ_f ω_f s + ω_f²) C_f F_ext",
        lambda s: _position(s) * s["cmd"] - _omega_f(s) ** 2
        / (s["s"] ** 2 + 2 * _zeta_f(s) * _omega_f(s) * s["s"] + _omega_f(s) ** 2) * s["Kf"] / s["Kenv"] * s["F"],
        of("real"), inputs=SOFT, cause="the scan has δ for ζ",
    ),
    Equation("2.11", "ω_p = √Kp", lambda s: np.sqrt(s["Kp"]), lambda s: _poles(s["Kv"], s["Kp"])[0],
             unit="rad/s", inputs=(("Kp", "Kp", ""),)),
    Equation("2.12", "ζ_p = Kv / (2 √Kp)", lambda s: s["Kv"] / (2 * np.sqrt(s["Kp"])),
             lambda s: _poles(s["Kv"], s["Kp"])[1], inputs=(("Kp", "Kp", ""), ("Kv", "Kv", ""))),
    Equation(
        "2.13", "ω_f = √(K_env / W_env)", lambda s: np.full(COUNT, np.nan),
        lambda s: _poles(s["Denv"] / s["Menv"], s["Kenv"] / s["Menv"])[0], "ω_f = √(K_env / M_env)", _omega_f,
        unit="rad/s", inputs=SOFT[1:4], damaged=True, cause=f"{LETTER}: W for M; there is no W_env",
    ),
    Equation(
        "2.14", "ζ_p = D_env / (2 √(M_env K_env))", _zeta_f, lambda s: s["Kv"] / (2 * np.sqrt(s["Kp"])),
        "ζ_f = D_env / (2 √(M_env K_env))", lambda s: s["Kv"] / (2 * np.sqrt(s["Kp"])),
        inputs=(*SOFT[1:4], ("Kp", "Kp", ""), ("Kv", "Kv", "")), reading=_zeta_f,
        reading_truth=lambda s: _poles(s["Denv"] / s["Menv"], s["Kenv"] / s["Menv"])[1],
        cause="ζ_p is that of (2.12), which is another number; meant is ζ_f of (2.10), and as that it is right",
    ),
    Equation(
        "2.15", "K_f = K_f / K_env", lambda s: s["Kf"] / s["Kenv"], of("Kf"), "C_f = K_f / K_env", of("Kf"),
        inputs=SOFT[:2], reading=lambda s: s["Kf"] / s["Kenv"],
        reading_truth=lambda s: yielding(s) / s["F"] / s["Kenv"],
        damaged=True, cause=f"{LETTER}: the C_f of (2.10) is meant",
    ),
    Equation(
        "2.16", "T_p = π / (ω_n √(1 - ζ²))",
        lambda s: _rounded(np.pi / (s["omega"] * np.sqrt(1 - s["zeta"] ** 2)), 5),
        lambda s: _rounded(_first_peak(s)[0], 5), unit="s", inputs=(("ω_n", "omega", "rad/s"), ("ζ", "zeta", "")),
        cause="against the peak of the step response itself",
    ),
    Equation(
        "2.17", "%OS = e^(ζ π / √(1 - ζ²)) × 100 %",
        lambda s: 100 * np.exp(s["zeta"] * np.pi / np.sqrt(1 - s["zeta"] ** 2)), lambda s: 100 * _first_peak(s)[1],
        "%OS = e^(-ζ π / √(1 - ζ²)) × 100 %", lambda s: 100 * np.exp(-s["zeta"] * np.pi / np.sqrt(1 - s["zeta"] ** 2)),
        unit="%", inputs=(("ζ", "zeta", ""),),
        cause="a minus is missing in the exponent, on paper or by the scan: more damping cannot overshoot more",
    ),
    Equation("2.18", "T_s = 4 / (ζ ω_n)", lambda s: np.full(COUNT, 4.0), _settled, unit="/ (ζ ω_n)",
             cause="to within 2 %: -ln 0.02 = 3.91, rounded"),
    Equation(
        "2.19", "T_r = 1.8 / ω_n", lambda s: np.full(COUNT, 1.8), lambda s: _rises(0.5), "T_r = 1.6 / ω_n at ζ = 0.5",
        lambda s: np.full(COUNT, 1.6), unit="/ ω_n", inputs=(("ζ", "zeta", ""),), reading=lambda s: np.full(COUNT, 1.8),
        reading_truth=lambda s: _rises(0.575),
        cause="a rule of thumb, without the damping: right at ζ = 0.575; from 10 to 90 % it takes 1.64 / ω_n at ζ 0.5, "
        "and 1.85 at 0.6",
    ),
)  # fmt: skip
