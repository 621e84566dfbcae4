"""The arm paper's equations (2.20) to (2.37): the control that was designed, a motor's torques, the observers."""

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.recompute.equation import Equation, Quantities
from kinlab.papers.recompute.receptionist_control import (
    COUNT,
    LETTER,
    MOTOR,
    NM,
    SOFT,
    SPRING,
    of,
    pd,
    yielding,
)


def _total(s: Quantities, more: Array) -> Array:
    """(2.34), beginning with `more`."""
    return np.asarray(
        more + s["load"] + (s["J"] - s["Jn"]) * s["acceleration"] + (s["Ktn"] - s["Kt"]) * s["I"]
    )


def _disturbance(s: Quantities) -> Array:
    """What a motor of nominal inertia and torque constant would have to overcome to move as this one does."""
    return np.asarray(s["Ktn"] * s["I"] - s["Jn"] * s["acceleration"])


def _reaction(s: Quantities, current: Array) -> Array:
    """(2.37) for a rate e^(st), with the cut-off g; gravity is in the internal torque."""
    g = s["g"]
    momentum = g * s["Jn"] * s["acceleration"] / s["s"]
    known = s["Ktn"] * current + momentum - s["internal"] - s["friction"]
    return np.asarray(g / (s["s"] + g) * known - momentum)


def _filtered_reaction(s: Quantities) -> Array:
    """What is left of the motor's torque once all that is known is taken off, through a filter of first order."""
    left = _disturbance(s) - s["internal"] - s["friction"]
    return np.asarray(s["g"] / (s["s"] + s["g"]) * left)


TORQUES = (("τ_int", "internal", NM), ("τ_ext", "external", NM), ("F + D θ'", "friction", NM))
NOMINAL = "the n of K_tn is missing, on paper or by the scan: with K_t itself the change ΔK_t counts twice"

EQUATIONS = (
    Equation(
        "2.20", "θ''_ref = Kp (θ_cmd - θ_real) + Kv (θ'_cmd - θ'_real)", lambda s: pd(s, s["cmd"] - s["virtual"]),
        lambda s: s["s"] ** 2 * s["virtual"], inputs=SPRING, cause="(2.2) for an angle",
    ),
    Equation(
        "2.21", "τ_disturbance = τ_dynamic + τ_ext + (F + D θ')",
        lambda s: s["internal"] + s["external"] + s["friction"],
        lambda s: s["Kt"] * s["I"] - s["J"] * s["acceleration"], unit=NM, inputs=TORQUES,
        cause="what is missing to J θ'' = τ_motor",
    ),
    Equation("2.22", "τ_disturbance = τ_dynamic + τ_ext", lambda s: s["internal"] + s["external"],
             lambda s: s["load"] - s["friction"], unit=NM, inputs=TORQUES, cause="(2.21) without friction"),
    Equation("2.23", "τ_ext = τ_disturbance - τ_dynamic", lambda s: s["load"] - s["friction"] - s["internal"],
             of("external"), unit=NM, inputs=TORQUES, cause="without friction"),
    Equation(
        "2.24", "τ_ext = (M_env s² + D_env s + K_env) x_env", yielding, of("F"),
        "K_f τ_ext = (M_env s² + D_env s + K_env) x_env", lambda s: yielding(s) / s["Kf"],
        inputs=(*SOFT, ("x_env", "env", "")),
        cause="(2.7) has K_f there, 0.3 in Table 4.1; its loss makes every torque K_f times as large",
    ),
    Equation(
        "2.25", "τ_ext = M_env θ''_env + D_env θ'_env + K_env θ_env",
        lambda s: s["Menv"] * s["s"] ** 2 * s["env"] + s["Denv"] * s["s"] * s["env"] + s["Kenv"] * s["env"],
        yielding, inputs=SOFT, cause="(2.24) in time",
    ),
    Equation(
        "2.26", "θ''_ref = Kp (θ_cmd - θ_real - K_env θ_env) + Kv (θ'_cmd - θ'_real - D_env θ'_env) - M_env θ''_env",
        lambda s: s["Kp"] * (s["cmd"] - s["real"] - s["Kenv"] * s["env"])
        + s["Kv"] * s["s"] * (s["cmd"] - s["real"] - s["Denv"] * s["env"]) - s["Menv"] * s["s"] ** 2 * s["env"],
        lambda s: s["s"] ** 2 * s["real"],
        "θ''_ref = Kp (θ_cmd - θ_real - θ_env) + Kv (θ'_cmd - θ'_real - θ'_env) - θ''_env",
        lambda s: pd(s, s["cmd"] - s["real"] - s["env"]) - s["s"] ** 2 * s["env"],
        inputs=(*SPRING, *SOFT[1:4], ("θ_real", "real", ""), ("θ_env", "env", "")),
        cause="(2.6), from which it comes, has no K_env, D_env, M_env here; and (2.20) less (2.25), as the line before "
        "it says, has K_env θ_env without Kp. With the values of Table 4.1 θ_env counts Kp K_env = 45.6 times: "
        "3.8 by (2.6), 12 by (2.20) less (2.25)",
    ),
    Equation("2.27", "J θ'' = τ_m - τ_l", lambda s: s["Kt"] * s["I"] - s["load"], lambda s: s["J"] * s["acceleration"],
             unit=NM, inputs=MOTOR),
    Equation("2.28", "τ_l = τ_int + τ_ext + (F + D θ')", lambda s: s["internal"] + s["external"] + s["friction"],
             lambda s: s["Kt"] * s["I"] - s["J"] * s["acceleration"], unit=NM, inputs=TORQUES),
    Equation(
        "2.29", "τ_m = K_f I_a", lambda s: s["Kf"] * s["I"], lambda s: s["J"] * s["acceleration"] + s["load"],
        "τ_m = K_t I_a", lambda s: s["Kt"] * s["I"], unit=NM, inputs=(SOFT[0], *MOTOR), damaged=True,
        cause=f"{LETTER}: the sentence below it calls the constant K_t",
    ),
    Equation(
        "2.30", "J θ'' = K_f I_a - (τ_int + τ_ext + (F + D θ'))", lambda s: s["Kf"] * s["I"] - s["load"],
        lambda s: s["J"] * s["acceleration"], "J θ'' = K_t I_a - ...", lambda s: s["Kt"] * s["I"] - s["load"], unit=NM,
        inputs=(SOFT[0], *MOTOR), damaged=True, cause=f"{LETTER}: K_t, as the sentence below it says",
    ),
    Equation("2.31", "J = J_n + ΔJ", lambda s: s["Jn"] + s["dJ"], of("J"), inputs=MOTOR[2:4], cause="a definition"),
    Equation("2.32", "K = K_tn + ΔK_t", lambda s: s["Ktn"] + s["dKt"], of("Kt"), inputs=MOTOR[:2],
             cause="a definition, of K_t: the letter t is lost"),
    Equation(
        "2.33", "τ_dis = τ_l + ΔJ θ'' - ΔK_t I_a",
        lambda s: s["load"] + s["dJ"] * s["acceleration"] - s["dKt"] * s["I"], _disturbance, unit=NM, inputs=MOTOR,
    ),
    Equation(
        "2.34", "τ_dis = I_a + τ_int + τ_ext + (F + D θ') + (J - J_n) θ'' + (K_tn - K_t) I_a",
        lambda s: _total(s, s["I"]), _disturbance, "without the first I_a", lambda s: _total(s, np.zeros(COUNT)),
        unit=NM, inputs=MOTOR, cause="a current stands among torques; (2.28) put into (2.33) has none",
    ),
    Equation(
        "2.35", "J_n θ'' = K_t I_a - τ_dis", lambda s: s["Kt"] * s["I"] - _disturbance(s),
        lambda s: s["Jn"] * s["acceleration"], "J_n θ'' = K_tn I_a - τ_dis",
        lambda s: s["Ktn"] * s["I"] - (s["load"] + s["dJ"] * s["acceleration"] - s["dKt"] * s["I"]), unit=NM,
        inputs=MOTOR, cause=f"{NOMINAL}. Two lines above it, K_tn - K_t stands for K_tn + ΔK_t",
    ),
    Equation(
        "2.36", "τ_dis = K_t I_a - J_n θ''", lambda s: s["Kt"] * s["I"] - s["Jn"] * s["acceleration"],
        lambda s: s["load"] + s["dJ"] * s["acceleration"] - s["dKt"] * s["I"], "τ_dis = K_tn I_a - J_n θ''",
        _disturbance, unit=NM, inputs=MOTOR, cause=NOMINAL,
    ),
    Equation(
        "2.37", "τ_reac = g / (s + g) (K_tn J_n + g J_n θ' - τ_int - τ_g - F - D θ') - g J_n θ'",
        lambda s: _reaction(s, s["Jn"]), _filtered_reaction, "... (K_tn I_a + ...", lambda s: _reaction(s, s["I"]),
        unit=NM, inputs=(*MOTOR, TORQUES[0], TORQUES[2], ("g", "g", ""), ("s", "s", "")), damaged=True,
        cause=f"{LETTER}: J_n with the index ref is I_a, as in (2.34) to (2.36)",
    ),
)  # fmt: skip
