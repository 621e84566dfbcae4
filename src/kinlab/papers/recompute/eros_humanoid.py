"""Walking trajectory optimization for EROS (EMITTER, 2018), recomputed: Tables 1 to 8, equations (1) to (48)."""

from collections.abc import Iterator

import numpy as np

from kinlab.kinematics import chain
from kinlab.kinematics.transforms import Array
from kinlab.papers import eros_humanoid as printed
from kinlab.papers.recompute.equation import check
from kinlab.papers.recompute.eros_chains import ARMS, HEAD, arm_samples, head_samples
from kinlab.papers.recompute.eros_leg import LEFT_LEG, LEG, leg_samples
from kinlab.papers.recompute.eros_steps import STEPS, step_samples
from kinlab.papers.recompute.finding import Cause, Finding, Judge
from kinlab.papers.recompute.paper import Paper, numbers
from kinlab.papers.tables import PrintedTable, printed_table

NAME = "eros-humanoid"
JUDGE = Judge(NAME)
PEDESTALS = ("pedestal 1", "pedestal 2", "pedestal 3", "pedestal 4")
# By table: the joints' axes, and the translations that are letters, in mm; of any length, for none is printed.
HEAD_CHAIN = (((0, 0, 1), (0, 1, 0)), ((0, 0, 30), (0, 0, 80)))
ARM_CHAIN = (((0, 1, 0), (1, 0, 0), (0, 1, 0)), ((0, 0, -20), (0, 0, -70), (0, 0, -150)))
LEG_CHAIN = (
    ((0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 1, 0), (0, 1, 0), (1, 0, 0)),
    ((0, 0, 0), (0, 0, 0), (0, 0, -110), (0, 0, -90), (0, 0, 0), (0, 0, -40)),
)
COPIED = (
    "the backward halves of Tables 7 and 8 are the same in every cell: should one be a copy of the other, walks "
    "backwards of which 0, 0, 0 and 2 stood would give all four percentages"
)
CHAINS = {"2": HEAD_CHAIN, "3": ARM_CHAIN, "4": ARM_CHAIN, "5": LEG_CHAIN, "6": LEG_CHAIN}


def recompute() -> Iterator[Finding]:
    """Every finding, in the order of the print."""
    yield from degrees_of_freedom()
    for number in CHAINS:
        yield from joints(printed_table(NAME, number))
    yield from equations()
    yield from experiments()
    yield from stability()


def degrees_of_freedom() -> Iterator[Finding]:
    """Table 1, by the joints that Tables 2 to 6 list, and what section 4.1 says of it."""
    table = printed_table(NAME, "1")
    counts = {row: len(printed_table(NAME, str(2 + i)).rows) for i, row in enumerate(table.runs)}
    for row, count in counts.items():
        number = 2 + list(counts).index(row)
        yield JUDGE.cell(table.rows[row]["joints"], count, f"Table {number} has {count} rows")
    total = int(table.column("joints").sum())
    terms = " + ".join(f"{value:g}" for value in table.column("joints"))
    yield JUDGE.cell(table.rows["total"]["joints"], total, f"{terms} = {total}")
    for where, text, rows in (
        ("section 4.1, legs", "12", ("right leg", "left leg")),
        ("section 4.1, arms", "6", ("right arm", "left arm")),
        ("section 4.1, head", "2", ("head",)),
    ):
        own = [table.rows[row]["joints"].figure.value for row in rows]
        yield JUDGE.figure(
            where, text, sum(own), "", f"{' + '.join(f'{v:g}' for v in own)} = {sum(own):g}", table="1"
        )


def joints(table: PrintedTable) -> Iterator[Finding]:
    """Tables 2 to 6: each row's angle has the row's number; each zero is what the paper's equations leave for it."""
    axes, letters = (np.array(part, float) for part in CHAINS[table.number])
    q, tip = _poses(table.number, letters)
    R = chain.frames(axes, np.zeros_like(letters), q)[:, 1:, :3, :3]
    left = tip - np.einsum("nkij,kj->ni", R, letters)
    zeros = [cell for cell in table.cells() if cell.column != "angle"]
    rows = list(table.rows)
    columns = np.stack([R[:, rows.index(c.row), :, "xyz".index(c.column)].ravel() for c in zeros], axis=-1)
    found = np.linalg.lstsq(columns, left.ravel(), rcond=None)[0]
    own = dict(zip(((c.row, c.column) for c in zeros), found.tolist(), strict=True))
    for number, row in enumerate(rows, 1):
        for column, cell in table.rows[row].items():
            if column == "angle":
                slip = number != cell.figure.value
                remark = f"an earlier row's number; the equations have angle {number} here" if slip else ""
                yield JUDGE.cell(cell, number, f"row {number} of the table is joint {number}", remark=remark)
            else:
                value = round(own[row, column], 6) + 0.0
                said = (
                    f"the equations' position needs {value:g} mm here, besides the lengths that are letters"
                )
                yield JUDGE.cell(cell, value, f"{said}, over {len(q)} poses")


def _poses(number: str, letters: Array) -> tuple[Array, Array]:
    """Angles (N, n) and the tip (N, 3), mm, that belong together by the paper's equations, corrected."""
    rng = np.random.default_rng(int(number))
    if number in "56":
        tips = np.column_stack([rng.uniform(10, 60, (24, 2)), rng.uniform(-200, -150, 24)])
        lengths = tuple(-letters[[2, 3, 5], 2])
        headings = rng.uniform(-0.5, 0.5, 24).tolist()
        angles = [printed.ik(tip, lengths, heading=h).q for tip, h in zip(tips, headings, strict=True)]
        return np.array(angles), tips
    pose = printed.head if number == "2" else printed.arm
    q = rng.uniform(-1, 1, (24, len(letters)))
    lengths = tuple(np.abs(letters[:, 2]).tolist())
    return q, np.array([pose(angles, lengths)[:3, 3] for angles in q])


def equations() -> Iterator[Finding]:
    """A finding for each equation and for each entry of the symbolic matrices."""
    right, left = leg_samples(5), leg_samples(6)
    both = {**right, **{f"left {name}": values for name, values in left.items()}}
    for samples, listed in (
        (head_samples(), HEAD),
        (arm_samples(), ARMS),
        (right, LEG),
        (both, LEFT_LEG),
        (step_samples(right), STEPS),
    ):
        for equation in listed:
            yield from check(NAME, equation, samples)


def experiments() -> Iterator[Finding]:
    """Section 5: three walks, their steps and distances, and what Tables 7 and 8 have for them."""
    whole = 6000
    for ordinal, step, fell, steps, share in (
        ("first", 8, 4460, 6, "25.67"),
        ("second", 16, 3570, 5, "40.5"),
        ("third", 24, 2680, 4, "55.33"),
    ):
        where = f"section 5, {ordinal} experiment"
        tabled = printed_table(NAME, "7").rows[f"forward {step}"]["distance"].figure.value
        yield JUDGE.figure(
            f"{where}, step", str(step), tabled * 10, "mm",
            f"Table 7, forward {step}: {tabled:g} cm = {tabled * 10:g} mm",
            [Cause("one of the two has the wrong unit: mm in the text, cm in the head of Tables 7 and 8", tabled,
                   arithmetic=f"its number with mm for cm: {tabled:g}")], table="7",
        )  # fmt: skip
        lost = (whole - fell) / whole * 100
        worked = f"({whole} - {fell}) / {whole} = {lost:.3f} %"
        yield JUDGE.figure(f"{where}, difference of distance", share, lost, "%", worked)
        for how, count, way in (("without", steps, fell), ("with", 9, whole)):
            yield JUDGE.figure(
                f"{where}, steps {how} optimization", str(count), way / step, "",
                f"{way} mm / {step} mm = {way / step:g}; with a step of {step} cm {way / step / 10:g}",
                [Cause("a step in cm", way / step / 10)],
                remark="4460 / 5 = 892, 3570 / 4 = 892.5, 2680 / 3 = 893: some other length than the step is counted",
            )  # fmt: skip
        for how, number, stood in (("without", "7", False), ("with", "8", True)):
            stable = printed_table(NAME, number).rows[f"forward {step}"]["pedestal 1"].figure.value == 1
            said, found = ("stable" if it else "unstable" for it in (stood, stable))
            yield JUDGE.claim(
                f"{where}, {how} optimization", said, found, stood == stable,
                f"Table {number}, forward {step}, pedestal 1: {found}",
                remark=f"forward {step} of the tables is read as this experiment", table=number,
            )  # fmt: skip


def stability() -> Iterator[Finding]:
    """Tables 7 and 8, the percentages that section 5 makes of them, their averages, abstract and conclusion."""
    share = {}
    for number, how, texts, text in (
        ("7", "without", ("10", "10", "30", "80"), "32"),
        ("8", "with", ("70", "70", "80", "100"), "80"),
    ):
        table = printed_table(NAME, number)
        for cell in table.cells("distance"):
            yield JUDGE.measured(cell, "chosen by the authors")
        for cell in table.cells(*PEDESTALS):
            yield JUDGE.measured(cell, "observed: is the robot stable?")
        forwards = [row for row in table.runs if row.startswith("forward")]
        counts, percent = [], []
        for pedestal, printed_text in zip(PEDESTALS, texts, strict=True):
            stood, runs = int(table.column(pedestal).sum()), len(table.runs)
            ahead = int(sum(table.rows[row][pedestal].figure.value for row in forwards))
            counts.append(stood)
            percent.append(100 * stood / runs)
            alone = Cause(
                "the stable walks backwards were left out, and all ten walks divided by",
                100 * ahead / runs,
                arithmetic=f"{ahead} of them forwards: {ahead} / {runs} = {100 * ahead / runs:g} %",
            )
            yield JUDGE.figure(
                f"section 5, stability {how} optimization, {pedestal}", printed_text, percent[-1], "%",
                f"{stood} of {runs} rows are stable: {stood} / {runs} = {percent[-1]:g} %", [alone], table=number,
                remark=COPIED if number == "7" else "",
            )  # fmt: skip
        quoted = [float(t) for t in texts]
        mean = sum(quoted) / len(quoted)
        yield JUDGE.figure(
            f"section 5, stability {how} optimization, average", text, mean, "%",
            f"({' + '.join(texts)}) / {len(quoted)} = {mean:g}", [Cause("cut, not rounded", mean, cut=True)],
            table=number,
        )  # fmt: skip
        share[number] = sum(percent) / len(percent), " + ".join(f"{p:g}" for p in percent)
    for place in ("abstract", "conclusion"):
        for number, how, text in (("7", "without", "32"), ("8", "with", "80")):
            own, terms = share[number]
            yield JUDGE.figure(
                f"{place}, stability {how} optimization", text, own, "%",
                f"by the rows of Table {number} ({terms}) / {len(PEDESTALS)} = {own:g} %", table=number,
                remark="the average of the printed percentages, of which those without optimization are not "
                "what Table 7 counts" if number == "7" else "",
            )  # fmt: skip
    yield JUDGE.figure(
        "section 5, the table of the system with optimization", "5", 8, "",
        "the sentence before it names Table 8, and Table 5 holds joints", table="8",
        remark="the caption of Table 8 says without for with as well",
    )  # fmt: skip


PAPER = Paper(
    name=NAME,
    title="Dimas Pristovani R. et al., Walking trajectory optimization algorithm for robot humanoid on synthetic "
    "grass, EMITTER, 2018",
    equations=numbers(1, 48),
    recompute=recompute,
)
