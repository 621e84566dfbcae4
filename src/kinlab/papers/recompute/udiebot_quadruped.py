"""Udiebot (2018), recomputed: Tables 1 to 6, equations (1) to (10)."""

from collections.abc import Iterator

import numpy as np

from kinlab.kinematics.transforms import Array, homogeneous, rotation
from kinlab.papers import udiebot_quadruped as udiebot
from kinlab.papers.recompute.equation import Equation, Quantities, check
from kinlab.papers.recompute.finding import Cause, Finding, Judge, cut, mean_line
from kinlab.papers.recompute.leg import leg_quantities
from kinlab.papers.recompute.paper import Paper, numbers
from kinlab.papers.tables import Cell, PrintedTable, printed_table

NAME = "udiebot-quadruped"
JUDGE = Judge(NAME)
AXES = ("x", "y", "z")
# The last zeros of a figure are left out in the tables: all have three decimals.
DECIMALS = 3
SEARCHES = ("4", "5", "6")


def recompute() -> Iterator[Finding]:
    """Every finding, in the order of the print."""
    for language in ("Indonesian", "English"):
        yield largest_error(f"abstract ({language}), largest error")
    yield from robot()
    yield femur()
    yield from equations()
    for number in SEARCHES:
        yield from search(printed_table(NAME, number))
    yield from conclusion()


# Equations: x outwards, y up, z sideways, as in Tables 4 to 6

Z_UP = "with z up, as in (4), and y sideways"


def _dh(s: Quantities, a: str) -> Array:
    """(2) with the quantity `a` where the length belongs."""
    c, n, ca, sa = np.cos(s["θ"]), np.sin(s["θ"]), np.cos(s["α"]), np.sin(s["α"])
    o, one = 0 * c, 1 + 0 * c
    rows = [
        [c, -n * ca, n * sa, s[a] * c],
        [n, c * ca, -c * sa, s[a] * n],
        [o, sa, ca, s["d"]],
        [o, o, o, one],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


def _dh_by_parts(s: Quantities) -> Array:
    """Turn about z, shift along z, shift along x, turn about x: what four such parameters stand for."""
    return np.array([
        homogeneous(rotation((0, 0, 1), theta), (0, 0, d)) @ homogeneous(rotation((1, 0, 0), alpha), (a, 0, 0))
        for theta, alpha, a, d in zip(s["θ"], s["α"], s["a"], s["d"], strict=True)
    ])  # fmt: skip


def _joints() -> Quantities:
    theta, alpha, a, d = np.random.default_rng(2).uniform([0.1, 0.1, 20, 5], [1.4, 1.4, 150, 60], (40, 4)).T
    return {"θ": theta, "α": alpha, "a": a, "d": d}


def _product(s: Quantities) -> Array:
    angles = np.stack([s["alpha"], s["beta"], s["gamma"]], axis=-1)
    lengths = (float(s["c"][0]), float(s["f"][0]), float(s["t"][0]))
    return np.array([udiebot.dh(q, lengths)[:3, 3] for q in angles])


def _acos(opposite: Array, one: Array, other: Array) -> Array:
    """The law of cosines: the angle between sides `one` and `other`."""
    return np.asarray(np.arccos((one**2 + other**2 - opposite**2) / (2 * one * other)))


OF_THE_MATRIX = Equation(
    "2", "H_i: column 4 with α_i cos θ_i, α_i sin θ_i, d_i", lambda s: _dh(s, "α"), _dh_by_parts,
    "H_i: column 4 with a_i cos θ_i, a_i sin θ_i, d_i", lambda s: _dh(s, "a"),
    inputs=(("θ", "θ", "deg"), ("α", "α", "deg"), ("a", "a", "mm"), ("d", "d", "mm")),
    cause="an angle stands where a length belongs; a and α look alike in a scan", damaged=True,
    entries=(
        ("cos θ", "-sin θ cos α", "sin θ sin α", "α cos θ"),
        ("sin θ", "cos θ cos α", "-cos θ sin α", "α sin θ"),
        ("0", "sin α", "cos α", "d"),
        ("0", "0", "0", "1"),
    ),
)  # fmt: skip

EQUATIONS = (
    Equation(
        "1", "H = H1 H2 H3", _product, lambda s: np.stack([s["x"], s["y"], s["z"]], axis=-1), unit="mm",
        cause="with the corrected (2): the foot of a leg built of its points",
    ),
    Equation(
        "3", "legLength = √(posX² + posY²)", lambda s: np.hypot(s["x"], s["z"]), lambda s: s["ground"],
        "legLength = √(posX² + posZ²)", lambda s: np.hypot(s["x"], s["y"]), unit="mm",
        inputs=(("posX", "x", "mm"), ("posY", "z", "mm"), ("posZ", "y", "mm")),
        reading=lambda s: np.hypot(s["x"], s["y"]), cause=f"right {Z_UP}; in Tables 4 to 6 y is up",
    ),
    Equation(
        "4", "Zlength = √(posZ² + legLength²)", lambda s: np.hypot(s["y"], s["ground"]), lambda s: s["span"],
        "Zlength = √(posY² + (legLength - coxaLength)²)", lambda s: np.hypot(s["z"], s["ground"] - s["c"]),
        unit="mm", inputs=(("posY", "z", "mm"), ("posZ", "y", "mm"), ("legLength", "ground", "mm")),
        reading=lambda s: np.hypot(s["z"], s["ground"]), reading_truth=lambda s: s["far"],
        cause=f"right {Z_UP}, for a leg without a coxa, which is how Tables 4 to 6 are computed; (5) has the coxa",
    ),
    Equation(
        "5", "θA = atan((legLength - coxaLength) / posY)",
        lambda s: np.arctan((s["ground"] - s["c"]) / s["z"]), lambda s: s["slope"],
        "θA = atan(posY / (legLength - coxaLength))", lambda s: np.arctan(s["z"] / (s["ground"] - s["c"])),
        unit="deg", inputs=(("legLength", "ground", "mm"), ("coxaLength", "c", "mm"), ("posY", "z", "mm")),
        cause="the fraction is upside down; counted from the vertical it would be off by half a turn for a foot below",
    ),
    Equation(
        "6", "J = acos((Zlength² - femur² - tibia²) / (-2 femur Zlength))",
        lambda s: np.arccos((s["span"] ** 2 - s["f"] ** 2 - s["t"] ** 2) / (-2 * s["f"] * s["span"])),
        lambda s: s["hip"], "J = acos((tibia² - femur² - Zlength²) / (-2 femur Zlength))",
        lambda s: _acos(s["t"], s["f"], s["span"]), unit="deg",
        inputs=(("femur", "f", "mm"), ("tibia", "t", "mm"), ("Zlength", "span", "mm")),
        cause="tibia and Zlength have changed places in the numerator",
    ),
    Equation(
        "7", "K = acos((femur² + tibia² - Zlength²) / (-2 femur tibia))",
        lambda s: np.arccos((s["f"] ** 2 + s["t"] ** 2 - s["span"] ** 2) / (-2 * s["f"] * s["t"])),
        lambda s: s["knee"], "K = acos((femur² + tibia² - Zlength²) / (2 femur tibia))",
        lambda s: _acos(s["span"], s["f"], s["t"]), unit="deg",
        inputs=(("femur", "f", "mm"), ("tibia", "t", "mm"), ("Zlength", "span", "mm")),
        reading=lambda s: np.pi - _acos(s["span"], s["f"], s["t"]), reading_truth=lambda s: np.pi - s["knee"],
        cause="right for the angle outside the knee, 180 - K; the -0.072 of Table 4 row 1 shows that the tables "
        "were computed with the one inside",
    ),
    Equation(
        "8", "θ1 = atan(posX, posY)", lambda s: np.arctan2(s["x"], s["z"]), lambda s: s["alpha"],
        "θ1 = atan2(posZ, posX)", lambda s: np.arctan2(s["y"], s["x"]), unit="deg",
        inputs=(("posX", "x", "mm"), ("posY", "z", "mm"), ("posZ", "y", "mm")),
        reading=lambda s: np.arctan2(s["y"], s["x"]),
        cause=f"right {Z_UP}, and with the arguments in the order of a spreadsheet, which takes x first",
    ),
    Equation(
        "9", "θ2 = J + θA", lambda s: s["hip"] + s["slope"], lambda s: s["beta"], unit="deg",
        inputs=(("J", "hip", "deg"), ("θA", "slope", "deg")), cause="with the corrected (5) and (6)",
    ),
    Equation(
        "10", "θ3 = 90 - K", lambda s: np.pi / 2 - s["knee"], lambda s: s["gamma"], "θ3 = K - 180",
        lambda s: s["knee"] - np.pi, unit="deg", inputs=(("K", "knee", "deg"),),
        reading=lambda s: np.pi / 2 - (np.pi - s["knee"]), reading_truth=lambda s: s["gamma"] + np.pi / 2,
        cause="right with the K of (7) as printed, and a servo that stands at 90 when the leg is straight; "
        "Tables 4 to 6 have no such 90",
    ),
)  # fmt: skip


def equations() -> Iterator[Finding]:
    """(1) to (10), against a leg of the lengths of Table 2."""
    coxa, femur_length, tibia = printed_table(NAME, "2").column("length").tolist()
    samples = leg_quantities(coxa, femur_length, tibia, first=(0.3, 0.4, -0.9))
    first, *rest = EQUATIONS
    yield from check(NAME, first, samples)
    yield from check(NAME, OF_THE_MATRIX, _joints())
    for equation in rest:
        yield from check(NAME, equation, samples)


# Tables


def robot() -> Iterator[Finding]:
    """Tables 1 to 3: what was built, and the joints added up."""
    each = printed_table(NAME, "3").column("DOF")
    of_a_leg = " + ".join(f"{v:g}" for v in each) + f" = {each.sum():g}"
    computed = {
        ("1", "degrees of freedom", "value"): (4 * each.sum(), f"4 legs x {each.sum():g} joints = 12"),
        ("1", "servos", "value"): (4 * each.sum(), f"4 legs x {each.sum():g} servos = 12"),
        ("3", "total", "DOF"): (4 * each.sum(), f"4 legs x {each.sum():g} joints = 12"),
        ("3", "total", "DOF per leg"): (each.sum(), of_a_leg),
    }
    for number in ("1", "2", "3"):
        for cell in printed_table(NAME, number).cells():
            own = computed.get((cell.table, cell.row, cell.column))
            yield JUDGE.measured(cell, "what the authors built") if own is None else JUDGE.cell(cell, *own)


def femur() -> Finding:
    """Which angle turns the femur: the one that gives the tables' forward kinematics."""
    fits = {}
    for k, order in (("2", ("theta2", "theta3")), ("3", ("theta3", "theta2"))):
        found = 0
        for number in SEARCHES:
            for cells in _rows(printed_table(NAME, number)):
                beta, gamma = (np.radians(cells[name].figure.value) for name in order)
                x = (
                    15
                    * (np.cos(beta) + np.cos(beta + gamma))
                    * np.cos(np.radians(cells["theta1"].figure.value))
                )
                found += cells["fk x"].figure.cuts(round(float(x), 4), DECIMALS)
        fits[k] = found
    best = max(fits, key=lambda k: fits[k])
    return JUDGE.figure(
        "section 3.1.2, number of the femur's angle", "3", float(best), "",
        f"of the 30 figures fk x, {fits['2']} follow with θ2 as the femur's angle, {fits['3']} with θ3",
        remark="femur and tibia have changed places in this sentence; (9), (10) and the tables have θ2 for the femur",
    )  # fmt: skip


def search(table: PrintedTable) -> Iterator[Finding]:
    """One of Tables 4 to 6: targets, angles, forward kinematics, errors, and their averages."""
    lengths = tuple(printed_table(NAME, "2").column("length") / 10)
    for cells in _rows(table):
        for axis in AXES:
            yield JUDGE.measured(cells[axis], "a place of the foot, chosen by the authors")
        yield from _angles(cells, lengths)
        yield from _forward(cells, lengths)
        yield from _errors(cells)
    yield from JUDGE.averages(table, REMARKS.get(table.number))
    yield from _percentages(table)


REMARKS = {
    "6": {
        "error y": "of the forward kinematics as printed it would be (0.016 - 0.424 + 0.017 + 0.017) / 10 = -0.037",
        "error x": "0.236 of row 8 is four fifths of the sum: without that row it is 0.053 / 9 = 0.006",
        "error z": "the signs cancel: the mean size is 0.072 / 10 = 0.007",
    }
}


def _rows(table: PrintedTable) -> list[dict[str, Cell]]:
    return [table.rows[row] for row in table.runs]


def _angles(cells: dict[str, Cell], lengths: tuple[float, ...]) -> Iterator[Finding]:
    """Angles: true for the leg of Table 2; the tables' with pi = 22/7, without its coxa, and cut."""
    x, y, z = (cells[axis].figure.value for axis in AXES)
    target = np.array([x, y, z])
    coxa, f, t = lengths
    own = np.degrees(udiebot.ik(target, lengths).q)
    tables = np.degrees(udiebot.tables_ik(target, lengths, frozenset(["coxa", "pi"])).q)
    ground = float(np.hypot(x, z))

    def line(c: float) -> tuple[str, str, str]:
        d = float(np.hypot(y, ground - c))
        hip = f"acos(({f:g}² + {d:.6g}² - {t:g}²) / (2 x {f:g} x {d:.6g})) + atan({y:g} / {ground - c:.4g})"
        knee = f"acos(({f:g}² + {t:g}² - {d:.6g}²) / (2 x {f:g} x {t:g}))"
        return f"atan({z:g} / {x:g})", hip, f"{knee} - 180"

    for k, (name, with_coxa, without) in enumerate(
        zip(("theta1", "theta2", "theta3"), line(coxa), line(0), strict=True)
    ):
        scaled, rest = without.removesuffix(" - 180"), " - 180" if k == 2 else ""
        cause = Cause(
            "pi = 22/7, cut after three decimals" if k == 0 else "pi = 22/7, no coxa, cut after three decimals",
            float(tables[k]), cut=True, decimals=DECIMALS,
            arithmetic=f"({scaled}) x 3.14159265 / (22/7){rest} = {tables[k]:.4f}",
        )  # fmt: skip
        yield JUDGE.cell(
            cells[name], float(own[k]), f"{with_coxa} = {own[k]:.4f}", [cause], decimals=DECIMALS
        )


def _forward(cells: dict[str, Cell], lengths: tuple[float, ...]) -> Iterator[Finding]:
    """Forward kinematics of the printed angles: on the leg of Table 2, and on the tables' without a coxa."""
    degrees = [cells[f"theta{k}"].figure.value for k in (1, 2, 3)]
    alpha, beta, gamma = np.radians(degrees)
    coxa, f, t = lengths
    a, b, both = f"{degrees[0]:g}", f"{degrees[1]:g}", f"{degrees[1] + degrees[2]:.6g}"
    reach, up = f * np.cos(beta) + t * np.cos(beta + gamma), f * np.sin(beta) + t * np.sin(beta + gamma)
    out = f"{f:g} cos {b} + {t:g} cos {both}"
    table, row = cells["x"].table, cells["x"].row
    for axis, share, turn in (("x", np.cos(alpha), f" cos {a}"), ("z", np.sin(alpha), f" sin {a}")):
        own, bare = float((coxa + reach) * share), float(reach * share)
        cause = Cause(
            "no coxa, the last of four decimals left off", round(bare, 4), cut=True, decimals=DECIMALS,
            arithmetic=f"({out}){turn} = {bare:.4f}",
        )  # fmt: skip
        yield JUDGE.cell(
            cells[f"fk {axis}"], own, f"({coxa:g} + {out}){turn} = {own:.4f}", [cause],
            UNEXPLAINED.get((table, row, axis), ""), DECIMALS,
        )  # fmt: skip
        if axis == "x":
            line = f"{f:g} sin {b} + {t:g} sin {both} = {up:.4f}"
            remark = UNEXPLAINED.get((table, row, "y"), LEFT_OUT if cells["fk y"].figure.value == 0 else "")
            causes = [cut(float(up), DECIMALS)]
            yield JUDGE.cell(cells["fk y"], float(up), line, causes, remark, DECIMALS)


LEFT_OUT = "0 is the target's y; rows 6, 9 and 10 of the same column have the computed -0.016 and -0.017"
NEIGHBOUR = (
    "with θ1 of this row and the knee of row 7, -59.31, the three figures together follow from θ2 = 30.587, "
    "which stands nowhere"
)
UNEXPLAINED = {
    ("5", "row 1", "x"): "the target's x; it belongs to an error of 0 in its row",
    **{("6", "row 8", axis): NEIGHBOUR for axis in AXES},
}


def _errors(cells: dict[str, Cell]) -> Iterator[Finding]:
    """Error: target less forward kinematics, both as printed."""
    for axis in AXES:
        wanted, reached = cells[axis].figure, cells[f"fk {axis}"].figure
        own = wanted.value - reached.value
        sign = f"({reached.text})" if reached.value < 0 else reached.text
        remark = "" if axis != "y" or round(own, 6) == cells["error y"].figure.value else OUT_OF_Y
        yield JUDGE.cell(
            cells[f"error {axis}"], own, f"{wanted.text} - {sign} = {own:.3f}", (), remark, DECIMALS
        )


OUT_OF_Y = "the column prints 0 throughout: an axis left out"


def _percentages(table: PrintedTable) -> Iterator[Finding]:
    """The row of percentages: the mean error over the mean target, which is how they come about."""
    for axis in AXES:
        cell = table.rows["percentage"][f"error {axis}"]
        errors, targets = table.column(f"error {axis}"), table.column(axis)
        error, target = float(errors.mean()), float(targets.mean())
        line = f"mean error {error:.5f} / mean target {target:g}"
        if error == 0:
            yield JUDGE.cell(cell, 0.0, f"mean error 0 {cell.unit}", remark="of no error")
        elif target == 0:
            remark = "every target is 0: a share of nothing has no value"
            yield JUDGE.cell(cell, float("nan"), f"{line} has no value", remark=remark)
        else:
            share = 100 * error / target
            causes = [Cause("without its sign", abs(share))]
            remark = ""
            if targets.min() < 0:
                size = float(np.abs(targets).mean())
                remark = (
                    f"the targets' signs cancel: of their mean size, {size:g} cm, it is "
                    f"{100 * np.abs(errors).mean() / size:.2f} %"
                )
            yield JUDGE.cell(cell, share, f"{line} = {share:.4f} %", causes, remark)


# Quoted figures


def largest_error(where: str) -> Finding:
    """The abstract's "maximum error of about 0.11 %": the largest percentage that the tables print."""
    printed = {
        f"Table {n}, {axis}": printed_table(NAME, n).rows["percentage"][f"error {axis}"].figure.value
        for n in SEARCHES
        for axis in AXES
    }
    place, largest = max(printed.items(), key=lambda item: item[1])
    return JUDGE.figure(
        where, "0.11", largest, "%", f"the largest of the nine percentages printed is {largest} % ({place})",
        remark="0.11 % is x of Table 6, the mean with row 8, 0.0289 / 26; without that row 0.0059 / 26 = 0.02 %",
        table=place[6],
    )  # fmt: skip


def conclusion() -> Iterator[Finding]:
    """The averages and percentages that the conclusion quotes."""
    for number, axis, printed, unit, percent in (
        ("4", "x", "0.006", "cm", "0.03"),
        ("5", "x", "0.006", "cm", "0.02"),
        ("5", "y", "0.017", "cm", "1.72"),
        ("6", "x", "0.029", "mm", "0.11"),
        ("6", "z", "-0.003", "cm", "0.3"),
    ):
        table = printed_table(NAME, number)
        errors, targets = table.column(f"error {axis}"), table.column(axis)
        mean = float(errors.mean())
        own, causes = mean, []
        line = f"{mean_line(errors)} cm"
        if unit == "mm":
            own, line = 10 * mean, f"{line} = {10 * mean:.3f} mm"
            causes.append(Cause("cm, the unit of the table, not mm", mean))
        where = f"conclusion, mean error on {axis} of Table {number}"
        yield JUDGE.figure(where, printed, own, unit, line, causes, table=number)
        share = 100 * mean / float(targets.mean())
        yield JUDGE.figure(
            f"{where} in percent", percent, share, "%", f"{mean:.4f} / {targets.mean():g} = {share:.4f} %",
            [Cause("without its sign", abs(share))], table=number,
        )  # fmt: skip


PAPER = Paper(
    name=NAME,
    title="Udiebot: Implementasi Inverse Kinematic pada Quadruped Robot, 2018",
    equations=numbers(1, 10),
    recompute=recompute,
)
