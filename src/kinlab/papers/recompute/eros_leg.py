"""EROS's equations (9) to (35): the legs, as printed and corrected, against the chain of Table 5.

No length of EROS is printed; the chain here has lengths of its own in mm, thigh and shank not equal, since an
equation must hold for any.
"""

from dataclasses import replace

import numpy as np

from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array, rotation, wrap
from kinlab.papers.recompute.equation import Equation, Form, Quantities

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
THIGH, SHANK, FOOT = 110.0, 90.0, 40.0
LEG_AXES = (Z, X, Y, Y, Y, X)
LEG_LINKS = ((0, 0, 0), (0, 0, 0), (0, 0, -THIGH), (0, 0, -SHANK), (0, 0, 0), (0, 0, -FOOT))
POSES = 24
DEG, MM = "deg", "mm"


def whole_degrees(seed: int, first: tuple[int, ...], *spans: tuple[int, int]) -> Array:
    """Angles (N, n) in rad, of whole degrees, so that a reader can take them over; `first` is the first pose."""
    rng = np.random.default_rng(seed)
    whole = np.stack([rng.integers(low, high + 1, POSES) for low, high in spans], axis=-1)
    whole[0] = first
    return np.asarray(np.radians(whole.astype(float)))


def leg_samples(seed: int) -> Quantities:
    """Level soles, knees bent backwards: the angles, and every length between the joints, from the chain."""
    yaw, roll, pitch, knee = whole_degrees(
        seed, (0, 10, -30, 60), (-30, 30), (-20, 20), (-50, -5), (10, 80)
    ).T
    q = np.stack([yaw, roll, pitch, knee, -(pitch + knee), -roll], axis=-1)
    at = chain.frames(LEG_AXES, LEG_LINKS, q)[..., :3, 3]
    knee_at, ankle, tip = at[:, 3], at[:, 4], at[:, 6]
    level = np.swapaxes(rotation(Z, yaw), -1, -2)
    x, y, _ = np.moveaxis((level @ ankle[..., None])[..., 0], -1, 0)
    hip_to_ankle = np.linalg.norm(ankle, axis=-1)
    thigh = knee_at / THIGH
    shank = (ankle - knee_at) / SHANK
    along = (ankle * thigh).sum(-1)
    names = {f"theta{i + 1}": q[:, i] for i in range(6)}
    # The same poses of a leg whose shank is as long as its thigh.
    even = chain.frames(LEG_AXES, (*LEG_LINKS[:3], LEG_LINKS[2], *LEG_LINKS[4:]), q)[..., :3, 3]
    return names | {
        "heading": yaw,
        "P_x": tip[:, 0],
        "P_y": tip[:, 1],
        "P_z": tip[:, 2],
        "P_6z": ankle[:, 2],
        "R0": np.hypot(tip[:, 0], tip[:, 1]),
        "beta": np.arctan2(y, x),
        "dP_x": x,
        "dP_y": y,
        "R1": np.sqrt(hip_to_ankle**2 - x**2),
        "R2": hip_to_ankle,
        "gamma_a": np.arcsin(x / hip_to_ankle),
        "gamma_b": np.arccos(along / hip_to_ankle),
        "gamma_c": np.arccos(-(thigh * shank).sum(-1)),
        "across": np.linalg.norm(np.cross(ankle, thigh), axis=-1),
        "along": along,
        "even across": np.linalg.norm(np.cross(even[:, 4], thigh), axis=-1),
    }


def _q(name: str) -> Form:
    return lambda s: s[name]


def _gamma_c_of_the_left_leg(s: Quantities) -> Array:
    return np.arccos((THIGH**2 + SHANK**2 - s["left R2"] ** 2) / (2 * THIGH * SHANK))


OTHER_WAY = "right where this angle is counted the other way round than in Table 5"
LEG = (
    Equation("9", "θ1 = heading", _q("heading"), _q("theta1"), unit=DEG, inputs=(("heading", "heading", DEG),)),
    Equation(
        "10", "R0 = √(P_x² + P_y²)", lambda s: np.sqrt(s["P_x"] ** 2 + s["P_y"] ** 2),
        lambda s: np.hypot(s["dP_x"], s["dP_y"]), unit=MM, inputs=(("P_x", "P_x", MM), ("P_y", "P_y", MM)),
    ),
    Equation(
        "11", "β = atan(P_y / P_x) - θ1", lambda s: wrap(np.arctan(s["P_y"] / s["P_x"]) - s["theta1"]),
        _q("beta"), "β = atan2(P_y, P_x) - θ1",
        lambda s: wrap(np.arctan2(s["P_y"], s["P_x"]) - s["theta1"]), unit=DEG,
        reading=lambda s: wrap(np.arctan2(s["P_y"], s["P_x"]) - s["theta1"]),
        inputs=(("P_x", "P_x", MM), ("P_y", "P_y", MM), ("θ1", "theta1", DEG)),
        cause="right where the arctangent knows its quadrant, as atan2 does; taken as it stands it is half a turn off "
        "for a foot behind the hip",
    ),
    Equation(
        "12", "dP_y = P_y + R0 sin(β)", lambda s: s["P_y"] + s["R0"] * np.sin(s["beta"]), _q("dP_y"),
        "dP_y = R0 sin(β)", lambda s: s["R0"] * np.sin(s["beta"]), unit=MM,
        inputs=(("P_y", "P_y", MM), ("R0", "R0", MM), ("β", "beta", DEG)),
        cause="(15) and (16) need the foot's place seen from the turned hip; with heading 0 the print doubles it",
    ),
    Equation(
        "13", "dP_x = P_x - R0 cos(β)", lambda s: s["P_x"] - s["R0"] * np.cos(s["beta"]), _q("dP_x"),
        "dP_x = R0 cos(β)", lambda s: s["R0"] * np.cos(s["beta"]), unit=MM,
        inputs=(("P_x", "P_x", MM), ("R0", "R0", MM), ("β", "beta", DEG)),
        cause="with heading 0 the print is 0: no step forwards reaches the hip",
    ),
    Equation("14", "P_6z = P_z - (-d_z6)", lambda s: s["P_z"] + FOOT, _q("P_6z"), unit=MM,
        inputs=(("P_z", "P_z", MM),)),
    Equation(
        "15", "θ2 = atan(dP_y / P_6z)", lambda s: np.arctan(s["dP_y"] / s["P_6z"]), _q("theta2"),
        "θ2 = atan(dP_y / -P_6z)", lambda s: np.arctan(s["dP_y"] / -s["P_6z"]), unit=DEG,
        reading=lambda s: -np.arctan(s["dP_y"] / s["P_6z"]),
        inputs=(("dP_y", "dP_y", MM), ("P_6z", "P_6z", MM)), cause=f"P_6z is negative: {OTHER_WAY}",
    ),
    Equation(
        "16", "R1 = √(dP_y² + P_6z²)", lambda s: np.hypot(s["dP_y"], s["P_6z"]), _q("R1"), unit=MM,
        inputs=(("dP_y", "dP_y", MM), ("P_6z", "P_6z", MM)),
    ),
    Equation(
        "17", "R2 = √(dP_x² + P_6z²)", lambda s: np.hypot(s["dP_x"], s["P_6z"]), _q("R2"),
        "R2 = √(dP_x² + R1²)", lambda s: np.hypot(s["dP_x"], s["R1"]), unit=MM,
        inputs=(("dP_x", "dP_x", MM), ("dP_y", "dP_y", MM), ("P_6z", "P_6z", MM)),
        cause="R2 is the way from hip to ankle; the print leaves its part sideways out: the leg comes out too short",
    ),
    Equation(
        "18", "S_a = d_z3² + d_z4² - R2²", lambda s: THIGH**2 + SHANK**2 - s["R2"] ** 2,
        lambda s: 2 * THIGH * SHANK * np.cos(s["gamma_c"]), unit="mm²",
        inputs=(("R2", "R2", MM), ("γ_c", "gamma_c", DEG)),
        cause=f"law of cosines, here with d_z3 = {THIGH:g}, d_z4 = {SHANK:g} mm",
    ),
    Equation(
        "19", "S_b = 2 (-d_z3) (-d_z4)", lambda s: np.full_like(s["R2"], 2 * -THIGH * -SHANK),
        lambda s: (THIGH**2 + SHANK**2 - s["R2"] ** 2) / np.cos(s["gamma_c"]), unit="mm²",
    ),
    Equation(
        "20", "γ_c = acos(S_a / S_b)",
        lambda s: np.arccos((THIGH**2 + SHANK**2 - s["R2"] ** 2) / (2 * THIGH * SHANK)),
        lambda s: np.pi - s["theta4"], unit=DEG, inputs=(("R2", "R2", MM),),
    ),
    Equation(
        "21", "γ_a = atan(dP_x / R1)", lambda s: np.arctan(s["dP_x"] / s["R1"]), _q("gamma_a"), unit=DEG,
        inputs=(("dP_x", "dP_x", MM), ("R1", "R1", MM)),
    ),
    Equation(
        "22", "-d_z3 sin(γ_c)", lambda s: -THIGH * np.sin(s["gamma_c"]), lambda s: -s["across"],
        "-d_z4 sin(γ_c)", lambda s: -SHANK * np.sin(s["gamma_c"]), unit=MM,
        reading=lambda s: -THIGH * np.sin(s["gamma_c"]), reading_truth=lambda s: -s["even across"],
        inputs=(("γ_c", "gamma_c", DEG),),
        cause=f"right where the shank is as long as the thigh; here {THIGH:g} and {SHANK:g} mm",
    ),
    Equation(
        "23", "-d_z3 + (-d_z4) cos(γ_c)", lambda s: -THIGH - SHANK * np.cos(s["gamma_c"]), lambda s: -s["along"],
        "-d_z3 + d_z4 cos(γ_c)", lambda s: -THIGH + SHANK * np.cos(s["gamma_c"]), unit=MM,
        inputs=(("γ_c", "gamma_c", DEG),), cause="the cosine of θ4 = 180 - γ_c is meant, which has the other sign",
    ),
    Equation(
        "24", "γ_b = atan(S_b,a / S_b,b)", lambda s: np.arctan(-s["across"] / -s["along"]), _q("gamma_b"),
        unit=DEG, inputs=(("across", "across", MM), ("along", "along", MM)), cause="with (22) and (23) corrected",
    ),
    Equation(
        "25", "θ3 = γ_a + γ_b", lambda s: s["gamma_a"] + s["gamma_b"], _q("theta3"),
        "θ3 = -(γ_a + γ_b)", lambda s: -(s["gamma_a"] + s["gamma_b"]), unit=DEG,
        reading=lambda s: -(s["gamma_a"] + s["gamma_b"]),
        inputs=(("γ_a", "gamma_a", DEG), ("γ_b", "gamma_b", DEG)), cause=OTHER_WAY,
    ),
    Equation(
        "26", "θ4 = 180 - γ_c", lambda s: np.pi - s["gamma_c"], _q("theta4"), unit=DEG,
        inputs=(("γ_c", "gamma_c", DEG),), cause="the scan has its letters and its number wrong",
    ),
    Equation(
        "27", "θ5 = θ3 + θ4", lambda s: s["gamma_a"] + s["gamma_b"] + s["theta4"], _q("theta5"),
        "θ5 = γ_a + γ_b - θ4", lambda s: s["gamma_a"] + s["gamma_b"] - s["theta4"], unit=DEG,
        inputs=(("γ_a", "gamma_a", DEG), ("γ_b", "gamma_b", DEG), ("θ4", "theta4", DEG)),
        cause="with θ3 as (25) prints it; hip and ankle turn the sole against the knee, so that a level sole needs "
        "their difference, whichever way each is counted",
    ),
    Equation("28", "θ6 = -θ2", lambda s: -s["theta2"], _q("theta6"), unit=DEG, inputs=(("θ2", "theta2", DEG),)),
)  # fmt: skip


def _mirrored(number: str, of_the_right: str, cause: str = "") -> Equation:
    """The left leg's equation that reads as this one of the right leg's."""
    right = next(equation for equation in LEG if equation.number == of_the_right)

    def left(form: Form) -> Form:
        return lambda s: form({name.removeprefix("left "): s[name] for name in s if name.startswith("left ")})

    return replace(
        right, number=number, cause=cause, value=left(right.value), truth=left(right.truth),
        corrected_value=right.corrected_value and left(right.corrected_value),
        reading=right.reading and left(right.reading),
        inputs=tuple((f"left {symbol}", f"left {name}", unit) for symbol, name, unit in right.inputs),
    )  # fmt: skip


LEFT_LEG = (
    _mirrored("29", "9"),
    _mirrored("30", "15", f"as (15): {OTHER_WAY}"),
    Equation(
        "31", "γ_(a,b,c) of the left leg = γ_(a,b,c) of the right leg", _q("gamma_c"), _q("left gamma_c"),
        "γ_(a,b,c) of the left leg by (17) to (24), from the left foot's place", _gamma_c_of_the_left_leg, unit=DEG,
        reading=_gamma_c_of_the_left_leg, inputs=(("γ_c", "gamma_c", DEG), ("left γ_c", "left gamma_c", DEG)),
        cause="meant is the same formula with the left foot's place; as angles they are equal in even standing alone",
    ),
    _mirrored("32", "25", f"the scan has θ2 and alpha for θ3 and γ; as (25): {OTHER_WAY}"),
    _mirrored("33", "26"),
    _mirrored("34", "27", "as (27)"),
    _mirrored("35", "28"),
)  # fmt: skip
