"""Udiebot (2018), recomputed: Tables 1 to 6, and the figures that are quoted of them."""

from collections.abc import Iterator, Mapping

import numpy as np

from kinlab.papers import udiebot_quadruped as udiebot
from kinlab.papers.recompute.finding import Cause, Finding, Judge, mean_line
from kinlab.papers.recompute.paper import Paper, numbers
from kinlab.papers.recompute.udiebot_equations import equations
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


# Tables


def robot() -> Iterator[Finding]:
    """Tables 1 to 3: what was built, and the joints added up."""
    each, servos = (printed_table(NAME, "3").column(name) for name in ("DOF", "servos"))
    of_a_leg = " + ".join(f"{v:g}" for v in each) + f" = {each.sum():g}"
    legs = printed_table(NAME, "1").rows["legs"]["value"].figure.value
    whole = legs * each.sum()
    computed = {
        ("1", "degrees of freedom", "value"): (whole, f"{legs:g} legs x {each.sum():g} joints = {whole:g}"),
        ("1", "servos", "value"): (
            legs * servos.sum(), f"{legs:g} legs x {servos.sum():g} servos = {legs * servos.sum():g}"
        ),
        ("3", "total", "legs"): (legs, f"Table 1: {legs:g} legs"),
        ("3", "total", "DOF"): (whole, f"{legs:g} legs x {each.sum():g} joints = {whole:g}"),
        ("3", "total", "DOF per leg"): (each.sum(), of_a_leg),
    }  # fmt: skip
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
    before: dict[str, Cell] = {}
    for cells in _rows(table):
        for axis in AXES:
            yield JUDGE.measured(cells[axis], "a place of the foot, chosen by the authors")
        yield from _angles(cells, lengths)
        copied = (table.number, cells["x"].row) == COPIED
        yield from _forward(cells, lengths, _copied(cells, before, lengths) if copied else {})
        before = cells
        yield from _errors(cells, _left_out(table))
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


def _forward(
    cells: dict[str, Cell], lengths: tuple[float, ...], slips: Mapping[str, Cause]
) -> Iterator[Finding]:
    """Forward kinematics of the printed angles: on the leg of Table 2, and on the tables' without a coxa.

    Args:
        cells: of a row.
        lengths: coxa, femur and tibia, cm.
        slips: a cause that this row alone has, by axis.
    """
    degrees = _degrees(cells)
    alpha, beta, gamma = np.radians(degrees)
    coxa, f, t = lengths
    a, b, both = f"{degrees[0]:g}", f"{degrees[1]:g}", f"{degrees[1] + degrees[2]:.6g}"
    reach, up = f * np.cos(beta) + t * np.cos(beta + gamma), f * np.sin(beta) + t * np.sin(beta + gamma)
    out = f"{f:g} cos {b} + {t:g} cos {both}"
    slip = {axis: [slips[axis]] if axis in slips else [] for axis in AXES}
    for axis, share, turn in (("x", np.cos(alpha), f" cos {a}"), ("z", np.sin(alpha), f" sin {a}")):
        own, bare = float((coxa + reach) * share), float(reach * share)
        cause = _shortened("no coxa", bare, f"({out}){turn} = {bare:.4f}")
        remark = UNEXPLAINED.get((cells["x"].table, cells["x"].row, axis), "")
        yield JUDGE.cell(
            cells[f"fk {axis}"], own, f"({coxa:g} + {out}){turn} = {own:.4f}", [cause, *slip[axis]], remark, DECIMALS
        )  # fmt: skip
        if axis == "x":
            line = f"{f:g} sin {b} + {t:g} sin {both} = {up:.4f}"
            remark = LEFT_OUT if cells["fk y"].figure.value == 0 else ""
            causes = [_shortened("", float(up)), *slip["y"]]
            yield JUDGE.cell(cells["fk y"], float(up), line, causes, remark, DECIMALS)


def _shortened(name: str, value: float, arithmetic: str = "") -> Cause:
    """How the tables print a place: with the last of four decimals left off."""
    said = ", ".join(filter(None, (name, "the last of four decimals left off")))
    return Cause(said, round(value, 4), cut=True, decimals=DECIMALS, arithmetic=arithmetic)


def _copied(
    cells: dict[str, Cell], before: dict[str, Cell], lengths: tuple[float, ...]
) -> Mapping[str, Cause]:
    """Where the foot is with the knee of the row before, by axis."""
    a, b, _ = _degrees(cells)
    both = b + _degrees(before)[2]
    alpha, beta, gamma = np.radians([a, b, both])
    _, f, t = lengths
    reach, up = float(f * np.cos(beta) + t * np.cos(gamma)), float(f * np.sin(beta) + t * np.sin(gamma))
    out, aloft = (f"{f:g} {s} {b:g} + {t:g} {s} {both:.6g}" for s in ("cos", "sin"))
    x, z = float(reach * np.cos(alpha)), float(reach * np.sin(alpha))
    slip = "θ3 of the row before"
    return {
        "x": _shortened(f"no coxa, {slip}", x, f"({out}) cos {a:g} = {x:.4f}"),
        "y": _shortened(f"{slip}, without its sign", abs(up), f"{aloft} = {up:.4f}"),
        "z": _shortened(f"no coxa, {slip}", z, f"({out}) sin {a:g} = {z:.4f}"),
    }


def _degrees(cells: dict[str, Cell]) -> list[float]:
    return [cells[f"theta{k}"].figure.value for k in (1, 2, 3)]


LEFT_OUT = "0 is the target's y; rows 6, 9 and 10 of the same column have the computed -0.016 and -0.017"
UNEXPLAINED = {("5", "row 1", "x"): "the target's x; it belongs to an error of 0 in its row"}
# Its forward kinematics was given the knee of the row before.
COPIED = ("6", "row 8")


def _left_out(table: PrintedTable) -> list[str]:
    """The axes whose errors are printed as 0 in every row, although the feet are off."""
    off = {axis: table.column(axis) - table.column(f"fk {axis}") for axis in AXES}
    return [axis for axis in AXES if not table.column(f"error {axis}").any() and off[axis].any()]


def _errors(cells: dict[str, Cell], left_out: list[str]) -> Iterator[Finding]:
    """Error: target less forward kinematics, both as printed; 0 on an axis that was left out."""
    for axis in AXES:
        wanted, reached = cells[axis].figure, cells[f"fk {axis}"].figure
        own = wanted.value - reached.value
        sign = f"({reached.text})" if reached.value < 0 else reached.text
        causes = [Cause(f"{axis} left out: the column prints 0 throughout", 0.0)] if axis in left_out else []
        yield JUDGE.cell(
            cells[f"error {axis}"], own, f"{wanted.text} - {sign} = {own:.3f}", causes, decimals=DECIMALS
        )


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
