"""The papers' tables as they are printed, numbers and units only: one file per table, in a folder per paper.

A file `<paper>/table-<number>.csv` begins with a line `# ` that says what the table holds, in our words. Below it
stands the head: a column named `theta2 [deg]` holds figures (`[]` where they have no unit), a column without
brackets holds words that name the row (`test`, `leg`). A figure stands as it is printed, with a decimal point
and all its zeros; one that the scan has damaged ends in `?`; one whose unit is not that of its column has it
behind a blank (`0.03 %`); an empty cell is empty in print. A row whose name is one of `SUMMARIES` sums up those
above it and is no part of their columns.
"""

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.figure import Figure

SUMMARIES = ("average", "percentage", "total")
HERE = Path(__file__).parent


@dataclass(frozen=True)
class Cell:
    """A figure and its place.

    Attributes:
        table: the table's number.
        row, column: their names.
        unit: of the column.
        figure: what is printed.
    """

    table: str
    row: str
    column: str
    unit: str
    figure: Figure

    @property
    def where(self) -> str:
        """Such as "Table 4 row 2 theta2"."""
        return f"Table {self.table} {self.row} {self.column}"


@dataclass(frozen=True)
class PrintedTable:
    """A table of a paper.

    Attributes:
        paper, number: whose, and which.
        title: what it holds.
        units: of its columns of figures.
        rows: its cells by row and column, in the order of the print; a cell that is empty in print is not there.
    """

    paper: str
    number: str
    title: str
    units: dict[str, str]
    rows: dict[str, dict[str, Cell]]

    @property
    def runs(self) -> list[str]:
        """The names of the rows that are no summaries."""
        return [row for row in self.rows if row not in SUMMARIES]

    def column(self, name: str) -> Array:
        """The figures of a column, summaries left out, as numbers (N,)."""
        return np.array([self.rows[row][name].figure.value for row in self.runs])

    def cells(self, *columns: str) -> Iterator[Cell]:
        """Its figures, or those of some columns, row by row; summaries left out where columns are named."""
        for row in self.runs if columns else self.rows:
            for name, cell in self.rows[row].items():
                if not columns or name in columns:
                    yield cell


@cache
def printed_table(paper: str, number: str) -> PrintedTable:
    """A table from its file.

    Raises:
        ValueError: the file holds something else than tables here do; the message names the cell.
    """
    path = HERE / paper / f"table-{number}.csv"
    with path.open(encoding="utf-8", newline="") as file:
        title = file.readline().removeprefix("# ").strip()
        head, *lines = csv.reader(file)
    names, units = zip(*(_head(text) for text in head), strict=True)
    rows: dict[str, dict[str, Cell]] = {}
    for line in lines:
        words = [(name, text) for name, unit, text in zip(names, units, line, strict=True) if unit is None]
        row = " ".join(f"{name} {text}" if text.isdigit() else text for name, text in words if text)
        if row in rows:
            raise ValueError(f"{path}: two rows are named '{row}'")
        rows[row] = {}
        for name, unit, text in zip(names, units, line, strict=True):
            if unit is not None and text:
                figure, _, own_unit = text.partition(" ")
                try:
                    rows[row][name] = Cell(number, row, name, own_unit or unit, Figure.read(figure))
                except ValueError as wrong:
                    raise ValueError(f"{path}: {row} {name}: {wrong}") from None
    return PrintedTable(
        paper, number, title, {n: u for n, u in zip(names, units, strict=True) if u is not None}, rows
    )


def printed_tables(paper: str) -> list[PrintedTable]:
    """All tables of a paper, by number."""
    numbers = [path.stem.removeprefix("table-") for path in (HERE / paper).glob("table-*.csv")]
    return [printed_table(paper, n) for n in sorted(numbers, key=lambda n: [float(p) for p in n.split(".")])]


def _head(text: str) -> tuple[str, str | None]:
    """Name and unit of a column; no unit where it holds words."""
    name, bracket, unit = text.partition(" [")
    return name, unit.removesuffix("]") if bracket else None
