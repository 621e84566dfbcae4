"""Design of 3 DOF hexapod leg movement (SINERGI 29-1, 2025), recomputed: Tables 1 to 10, equations (1) to (7)."""

from collections.abc import Iterator

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers import xl430_hexapod
from kinlab.papers.recompute.equation import Equation, check
from kinlab.papers.recompute.finding import Cause, Finding, Judge, cut, mean_line
from kinlab.papers.recompute.leg import leg_quantities
from kinlab.papers.recompute.paper import Paper, numbers
from kinlab.papers.tables import Cell, printed_table

NAME = "xl430-hexapod"
JUDGE = Judge(NAME)
AXES = ("x", "y", "z")
# Coxa, femur and tibia in mm, as the section on the inverse kinematics prints them.
LENGTHS = (25.0, 50.0, 70.0)


def recompute() -> Iterator[Finding]:
    """Every finding, in the order of the print."""
    yield from quoted("abstract")
    yield from equations()
    yield gait()
    yield from servo_angles()
    for number, why in (("2", "a target, chosen by the authors"), ("3", "where the foot was measured to be")):
        for cell in printed_table(NAME, number).cells():
            yield JUDGE.measured(cell, why)
    yield from errors_of_the_foot()
    yield from straight("5")
    yield from straight("6")
    yield from rotations()
    yield from quoted("conclusion")
    yield from only_in_the_conclusion()


# Equations

MOVED = "2af, the denominator of (4), stands in (5), where z belongs"

EQUATIONS = (
    Equation(
        "1", "θc = atan(y / x)", lambda s: np.arctan(s["y"] / s["x"]), lambda s: s["alpha"], unit="deg",
        inputs=(("x", "x", "mm"), ("y", "y", "mm")), cause="for every foot in front of the coxa, x > 0",
    ),
    Equation(
        "2", "x0 = √(x² + y²)", lambda s: np.sqrt(s["x"] ** 2 + s["y"] ** 2), lambda s: s["ground"], unit="mm",
        inputs=(("x", "x", "mm"), ("y", "y", "mm")),
    ),
    Equation(
        "3", "θf = θf1 + θf2", lambda s: s["hip"] + s["slope"], lambda s: s["beta"], unit="deg",
        inputs=(("θf1", "hip", "deg"), ("θf2", "slope", "deg")), cause="θf2 counts from the level, downwards negative",
    ),
    Equation(
        "4", "θf1 = acos((a² + f² - t²) / 2)",
        lambda s: np.arccos((s["span"] ** 2 + s["f"] ** 2 - s["t"] ** 2) / 2), lambda s: s["hip"],
        "θf1 = acos((a² + f² - t²) / (2af))",
        lambda s: np.arccos((s["span"] ** 2 + s["f"] ** 2 - s["t"] ** 2) / (2 * s["span"] * s["f"])),
        unit="deg", inputs=(("a", "span", "mm"), ("f", "f", "mm"), ("t", "t", "mm")), cause=MOVED, damaged=True,
    ),
    Equation(
        "4, first line", "t² = a² + f² - 2af cos θf1",
        lambda s: s["span"] ** 2 + s["f"] ** 2 - 2 * s["span"] * s["f"] * np.cos(s["hip"]),
        lambda s: s["t"] ** 2, unit="mm²", inputs=(("a", "span", "mm"), ("f", "f", "mm"), ("θf1", "hip", "deg")),
    ),
    Equation(
        "5", "θf2 = atan(2af / (x0 - c))",
        lambda s: np.arctan(2 * s["span"] * s["f"] / (s["ground"] - s["c"])), lambda s: s["slope"],
        "θf2 = atan(z / (x0 - c))", lambda s: np.arctan(s["z"] / (s["ground"] - s["c"])),
        unit="deg", inputs=(("a", "span", "mm"), ("z", "z", "mm"), ("x0", "ground", "mm")),
        cause=MOVED, damaged=True,
    ),
    Equation(
        "6", "a = √((x0 - c)² + z²)", lambda s: np.sqrt((s["ground"] - s["c"]) ** 2 + s["z"] ** 2),
        lambda s: s["span"], unit="mm", inputs=(("x0", "ground", "mm"), ("z", "z", "mm")),
    ),
    Equation(
        "7", "a² = f² + t² - 2ft cos(90 + θt)",
        lambda s: s["f"] ** 2 + s["t"] ** 2 - 2 * s["f"] * s["t"] * np.cos(s["knee"]),
        lambda s: s["span"] ** 2, unit="mm²", inputs=(("f", "f", "mm"), ("t", "t", "mm"), ("90 + θt", "knee", "deg")),
        cause="90 + θt is the knee's inside angle",
    ),
    Equation(
        "7, second line", "θt = acos((f² + t² - a²) / (2ft)) - 90",
        lambda s: np.arccos((s["f"] ** 2 + s["t"] ** 2 - s["span"] ** 2) / (2 * s["f"] * s["t"])) - np.pi / 2,
        lambda s: s["knee"] - np.pi / 2, unit="deg", inputs=(("f", "f", "mm"), ("t", "t", "mm"), ("a", "span", "mm")),
        cause="the text calls this line (8), a number that stands nowhere",
    ),
)  # fmt: skip


def equations() -> Iterator[Finding]:
    """(1) to (7), against a leg of the printed lengths; the first pose is the first row of Table 1."""
    first = xl430_hexapod.ik(np.array([0.075, 0.010, -0.046]), tuple(length / 1e3 for length in LENGTHS)).q
    samples = leg_quantities(*LENGTHS, first=(float(first[0]), float(first[1]), float(first[2])))
    for equation in EQUATIONS:
        yield from check(NAME, equation, samples)


def gait() -> Finding:
    """What the section on the gait says of the legs that swing."""
    return JUDGE.figure(
        "section Walking Gait, legs that swing in the tripod gait", "1", 6 - 3, "legs",
        "6 legs - 3 in support = 3 that swing", remark='"three legs in the support state, one leg in the swing motion"',
    )  # fmt: skip


# Tables


def servo_angles() -> Iterator[Finding]:
    """Table 1: the corrected equations, and the servos' zeros that the table itself implies."""
    table = printed_table(NAME, "1")
    for row, cells in table.rows.items():
        for axis in AXES:
            yield JUDGE.measured(cells[axis], "a place of the foot, chosen by the authors")
        place = np.array([cells[axis].figure.value for axis in AXES])
        left = row.startswith("left")
        yield from (
            _servo_angle(cells[f"theta_{joint}"], *line, left) for joint, line in _servo_lines(place, left)
        )


def _servo_lines(place: Array, left: bool) -> Iterator[tuple[str, tuple[float, str]]]:
    """For each joint its servo angle in degrees, and how it comes about."""
    x, y, z = place
    c, f, t = LENGTHS
    x0 = float(np.hypot(x, y))
    a = float(np.hypot(x0 - c, z))
    alpha, beta, gamma = np.degrees(xl430_hexapod.ik(place / 1e3, (c / 1e3, f / 1e3, t / 1e3)).q)
    sign = "+" if left else "-"
    yield "c", (90 + alpha if left else 90 - alpha, f"90 {sign} atan({y:g}/{x:g})")
    line = f"180 - acos(({a:.3f}² + {f:g}² - {t:g}²) / (2 x {a:.3f} x {f:g})) - atan({z:g} / {x0 - c:.3f})"
    yield "f", (180 - beta, line)
    inside = f"acos(({f:g}² + {t:g}² - {a:.3f}²) / (2 x {f:g} x {t:g}))"
    yield "t", (-gamma, f"180 - {inside}") if left else (180 + gamma, inside)


def _servo_angle(cell: Cell, own: float, line: str, left: bool) -> Finding:
    causes = [cut(own, cell.figure.decimals)]
    if left and cell.column == "theta_t":
        right = round(180 - own, 2)
        name = "rounded twice: 180 less the right leg's angle, which was rounded before"
        causes.append(Cause(name, 180 - right, arithmetic=f"180 - {right:.2f} = {180 - right:.2f}"))
    return JUDGE.cell(
        cell, own, f"{line} = {own:.4f}", causes, "the servo's zero is inferred from this table"
    )


def errors_of_the_foot() -> Iterator[Finding]:
    """Table 4: target less reached, of Tables 2 and 3, and its averages."""
    wanted, reached, table = (printed_table(NAME, number) for number in "234")
    for cell in table.cells(*AXES):
        a, b = (t.rows[cell.row][cell.column].figure.value for t in (wanted, reached))
        own, shown = abs(a - b), cell.figure.value
        places = " or ".join(f"{place:g}" for place in sorted({a - shown, a + shown}))
        remark = "" if own == shown else f"{shown:g} belongs to a foot at {places}"
        yield JUDGE.cell(cell, own, f"|{_signed(a)} - {_signed(b)}| = {own:g}", remark=remark)
    remarks = {
        "y": "from Tables 2 and 3 it is 14 / 9 = 1.56",
        "z": "0.78 is 7 / 9: one millimetre more than the column holds",
    }
    yield from JUDGE.averages(table, remarks)


def straight(number: str) -> Iterator[Finding]:
    """Tables 5 and 6: slides and distances are measured, the error is what is missing to 100 cm."""
    table = printed_table(NAME, number)
    for cell in table.cells():
        if cell.row == "average":
            continue
        if cell.column != "error":
            yield JUDGE.measured(cell, "measured over 100 cm")
            continue
        reached = table.rows[cell.row]["distance"].figure
        own, shown = round(100 - reached.value, 6), cell.figure.value
        remark = "" if own == shown else f"{shown:g} belongs to a distance of {100 - shown:g}"
        yield JUDGE.cell(cell, own, f"100 - {reached.text} = {own:g}", remark=remark)
    yield from JUDGE.averages(table)


def rotations() -> Iterator[Finding]:
    """Tables 7 to 10: all measured but the averages; and which of them the text takes for which turn."""
    for number in ("7", "8", "9", "10"):
        table = printed_table(NAME, number)
        for cell in table.cells():
            if cell.row != "average":
                yield JUDGE.measured(cell, "measured")
        yield from JUDGE.averages(table)
    for turn, way, angle, printed in (
        ("left", "counter-clockwise", 90, "9"),
        ("left", "counter-clockwise", 180, "10"),
        ("right", "clockwise", 90, "7"),
        ("right", "clockwise", 180, "8"),
    ):
        own, other = _tables_of(f"{angle} deg", way)
        swapped = Cause(
            "left and right have changed places in this text", float(other),
            arithmetic=f"a turn by {angle} deg the other way stands in Table {other}",
        )  # fmt: skip
        yield JUDGE.figure(
            f"section Rotation, the table of the {turn} turn of {angle} deg", printed, float(own), "",
            f"a turn to the {turn} is {way}, which is what Table {own} holds", [swapped], table=own,
            remark="captions and abstract agree with each other. Should the text compare the turns, it holds for the "
            "left one, 3 < 3.6 and 3.8 < 13.2 deg, and not for the right one",
        )  # fmt: skip


def _tables_of(angle: str, way: str) -> tuple[str, str]:
    """The numbers of the tables of a turn that way, and of the same turn the other way."""
    found = [n for n in ("7", "8", "9", "10") if printed_table(NAME, n).title.startswith(angle)]
    own, other = sorted(found, key=lambda n: printed_table(NAME, n).title != f"{angle} {way}")
    return own, other


# Quoted figures


def quoted(where: str) -> Iterator[Finding]:
    """The averages that abstract and conclusion quote, from what was measured."""
    wanted, reached = printed_table(NAME, "2"), printed_table(NAME, "3")
    for axis, printed, remark in (
        ("x", "1.56", ""),
        ("y", "0.88", "quotes Table 4, whose column y has two cells that Tables 2 and 3 contradict"),
        ("z", "0.78", "quotes Table 4, whose own column z gives 0.67 as well"),
    ):
        off = np.abs(wanted.column(axis) - reached.column(axis))
        line = f"Tables 2 and 3: {mean_line(off)}"
        yield JUDGE.figure(
            f"{where}, average error on {axis}", printed, float(off.mean()), "mm", line, remark=remark, table="4"
        )  # fmt: skip
    for number, name, printed, remark in (
        ("5", "forwards", "2.58", "the mean of Table 5's column of errors, two of which its distances contradict"),
        ("6", "backwards", "12.38", "no run of Table 6 ended more than 3.7 cm short; 12.38 stands in no table"),
    ):  # fmt: skip
        way = printed_table(NAME, number).column("distance")
        line = f"mean distance {mean_line(way)}; 100 - {way.mean():.4g} = {100 - way.mean():.4g}"
        yield JUDGE.figure(
            f"{where}, average error {name}", printed, 100 - float(way.mean()), "cm", line, remark=remark, table=number
        )  # fmt: skip
    for number, name, angle, printed in (
        ("9", "90 deg to the right", 90, "3.6"),
        ("7", "90 deg to the left", 90, "3"),
        ("10", "180 deg to the right", 180, "13.2"),
        ("8", "180 deg to the left", 180, "3.8"),
    ):
        column = printed_table(NAME, number).column("error")
        degrees = float(column.mean())
        share = 100 * degrees / angle
        remark = f'"percentage error" in words, degrees in print; of {angle} deg it is {share:.3g} %'
        yield JUDGE.figure(
            f"{where}, average error of {name}", printed, degrees, "deg", f"{mean_line(column)} deg",
            remark=remark if where == "conclusion" else "", table=number,
        )  # fmt: skip


def only_in_the_conclusion() -> Iterator[Finding]:
    """How far and to which side the body slides."""
    for number, name, printed in (("5", "forwards", "4.3"), ("6", "backwards", "16.12")):
        column = printed_table(NAME, number).column("side leg")
        line = mean_line(column)
        yield JUDGE.figure(
            f"conclusion, average slide {name}", printed, float(column.mean()), "cm", line, table=number
        )
    concluded, told = "to the left", "to the right"
    yield JUDGE.claim(
        "conclusion, side to which the robot slides forwards", concluded, f"{told}, by the section itself",
        concluded == told,
        f"section Forward and Backward: always {told}; conclusion: {concluded}; Table 5 has no signs", table="5",
    )  # fmt: skip


def _signed(value: float) -> str:
    return f"({value:g})" if value < 0 else f"{value:g}"


PAPER = Paper(
    name=NAME,
    title="Design of 3 DOF hexapod leg movement using inverse kinematics, SINERGI 29(1), 2025",
    equations=numbers(1, 7),
    recompute=recompute,
)
