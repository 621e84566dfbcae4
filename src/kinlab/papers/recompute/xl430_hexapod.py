"""Design of 3 DOF hexapod leg movement (SINERGI 29-1, 2025), recomputed: Tables 1 to 10, equations (1) to (7)."""

from collections.abc import Iterator

from kinlab.papers.recompute.finding import Cause, Finding, Judge
from kinlab.papers.recompute.paper import Paper, numbers
from kinlab.papers.tables import printed_table

NAME = "xl430-hexapod"
JUDGE = Judge(NAME)
AXES = ("x", "y", "z")


def recompute() -> Iterator[Finding]:
    """Every finding, in the order of the print."""
    for number, why in (("2", "a target, chosen by the authors"), ("3", "where the foot was measured to be")):
        for cell in printed_table(NAME, number).cells():
            yield JUDGE.measured(cell, why)
    yield from errors_of_the_foot()


def errors_of_the_foot() -> Iterator[Finding]:
    """Table 4: target less reached, of Tables 2 and 3, and its averages."""
    wanted, reached, table = (printed_table(NAME, number) for number in "234")
    for cell in table.cells(*AXES):
        a, b = (t.rows[cell.row][cell.column].figure.value for t in (wanted, reached))
        yield JUDGE.cell(cell, abs(a - b), f"|{a:g} - ({b:g})| = {abs(a - b):g}")
    for name, cell in table.rows["average"].items():
        column = table.column(name)
        mean, total, count = column.mean(), column.sum(), len(column)
        cut = Cause("cut after two decimals, not rounded", mean, cut=True)
        yield JUDGE.cell(cell, mean, f"{total:g} / {count} = {mean:.4f}", [cut])


PAPER = Paper(
    name=NAME,
    title="Suwoyo et al., Design of 3 DOF hexapod leg movement using inverse kinematics, SINERGI 29(1), 2025",
    equations=numbers(1, 7),
    recompute=recompute,
)
