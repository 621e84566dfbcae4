"""The arm paper's appendix: the derivatives of the second link's x, written out for angles w t."""

import numpy as np

from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array
from kinlab.papers.receptionist_torques import AXES
from kinlab.papers.recompute.equation import Equation, Quantities
from kinlab.papers.recompute.receptionist_kinematics import LENGTHS, LINKS
from kinlab.papers.recompute.receptionist_newton import Motion, rate


def rate_samples() -> Quantities:
    """Constant rates in rad/s at a time in s; in the first sample only theta1 turns."""
    rng = np.random.default_rng(51)
    t, w = rng.uniform(0, 1, 8), rng.uniform(-1, 1, (8, 3))
    t[0], w[0] = 0.0, (0, 1, 0)
    return {"t": t, "w0": w[:, 0], "w1": w[:, 1], "w2": w[:, 2], "a": np.zeros((8, 3))}


def _x_c2(s: Quantities, times: int) -> Array:
    """x of (3.13), differentiated `times` times, in cm and s."""

    def x(k: int) -> float:
        rates = np.array([s["w1"][k], s["w0"][k], s["w2"][k]])
        f: Motion = lambda t: np.asarray(chain.fk(AXES, LINKS, rates * t)[0, 3])  # noqa: E731
        for _ in range(times):
            f = rate(f)
        return float(f(float(s["t"][k])))

    return np.array([x(k) for k in range(len(s["t"]))])


def _dot1(s: Quantities) -> Array:
    """The printed velocity."""
    (w0, w1, w2), L1, L2 = (s["w0"], s["w1"], s["w2"]), *LENGTHS
    (c0, c1, c2), (s0, s1, s2) = (tuple(f(s["t"] * w) for w in (w0, w1, w2)) for f in (np.cos, np.sin))
    inner = w1 * c1 * s2 + w2 * c2 * s1 + w0 * c1 * c2 * s0 + w1 * c0 * c2 * s1 + w2 * c0 * c1 * s2
    return np.asarray(-L2 * inner - L1 * w0 * c1 * s0 - L1 * w1 * c0 * s1)


def _dot2(s: Quantities) -> Array:
    """The printed acceleration."""
    t, (w0, w1, w2), (a0, a1, a2) = s["t"], (s["w0"], s["w1"], s["w2"]), s["a"].T
    L1, L2 = LENGTHS
    (c0, c1, c2), (s0, s1, s2) = (tuple(f(t * w) for w in (w0, w1, w2)) for f in (np.cos, np.sin))
    first = L2 * t * (a1 * c2 * s0 * s1 - a0 * c0 * c1 * c2 + a2 * c1 * s0 * s2)
    first = first - L1 * a0 * t * c0 * c1 + L1 * a1 * t * s0 * s1
    inner = a1 * c1 * s2 + a2 * c2 * s1 + a0 * c1 * c2 * s0 + a1 * c0 * c2 * s1 + a2 * c0 * c1 * s2
    inner = inner + t * (a1 * w2 + a2 * w1) * c1 * c2 - t * (a1 * w1 + a2 * w2) * s1 * s2
    inner = (
        inner
        + t * (a1 * w1 + a2 * w2) * c0 * c1 * c2
        - a0 * t * w1 * c2 * s0 * s1
        - a0 * t * w2 * c1 * s0 * s2
    )
    inner = inner - t * (a1 * w2 + a2 * w1) * c0 * s1 * s2
    last = -L1 * a0 * c1 * s0 - L1 * a1 * c0 * s1 - L1 * a1 * t * w1 * c0 * c1 + L1 * a0 * t * w1 * s0 * s1
    return np.asarray(w0 * first - L2 * inner + last)


def _with_squares(s: Quantities) -> Array:
    """What constant rates leave of the acceleration: second derivatives of x times the rates."""
    w = np.stack([s["w1"], s["w0"], s["w2"]], axis=-1)
    H = chain.position_hessian(AXES, LINKS, w * s["t"][:, None])
    return np.asarray(_dot2(s) + np.einsum("nij,ni,nj->n", H[:, 0], w, w))


RATES = (("t", "t", "s"), ("w0", "w0", "rad/s"), ("w1", "w1", "rad/s"), ("w2", "w2", "rad/s"))
EQUATIONS = (
    Equation("xc2_dot1", "the derivative of x_c2, written out", _dot1, lambda s: _x_c2(s, 1), unit="cm/s", inputs=RATES,
             cause="for angles w t at constant rates"),
    Equation(
        "xc2_dot2", "the second derivative of x_c2, written out", _dot2, lambda s: _x_c2(s, 2),
        "the same, with the terms in w0², w0 w1, w1² and so on", _with_squares, unit="cm/s²", inputs=RATES,
        cause="every printed term has a0, a1 or a2 as a factor, so that an arm at constant rates would not accelerate; "
        "cos(t w) was differentiated by w alone, not by t. The differences that the program takes instead are right, "
        "and therefore not the same",
    ),
)  # fmt: skip
