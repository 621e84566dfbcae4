"""A paper as a whole: its tables, the numbers of its equations, and whether every one of them was recomputed."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from kinlab.names import resolve
from kinlab.papers.recompute.finding import Finding
from kinlab.papers.tables import PrintedTable, printed_tables


@dataclass(frozen=True)
class Coverage:
    """How much of what a paper prints has a finding.

    Attributes:
        cells, equations: numeric cells of its tables, and numbered equations.
        missing: the places of those without a finding.
    """

    cells: int
    equations: int
    missing: tuple[str, ...]

    def to_json(self) -> dict[str, int]:
        """`cells` counts all that must have a finding, `recomputed` what has one."""
        whole = self.cells + self.equations
        return {
            "cells": whole,
            "recomputed": whole - len(self.missing),
            "table_cells": self.cells,
            "equations": self.equations,
        }


@dataclass(frozen=True)
class Paper:
    """A paper.

    Attributes:
        name: as its folder of tables.
        title: authors and year.
        equations: the numbers of all numbered equations.
        recompute: yields every finding.
    """

    name: str
    title: str
    equations: tuple[str, ...]
    recompute: Callable[[], Iterable[Finding]]

    @property
    def tables(self) -> list[PrintedTable]:
        """As printed."""
        return printed_tables(self.name)

    def table(self, number: str) -> PrintedTable:
        """The table of a number.

        Raises:
            UsageError: the paper has none of this number.
        """
        tables = {table.number: table for table in self.tables}
        return tables[resolve(number, tables, f"table of {self.name}")]

    def coverage(self, findings: Iterable[Finding]) -> Coverage:
        """Which cells and equations `findings` leave out."""
        found = {finding.where for finding in findings}
        cells = [cell.where for table in self.tables for cell in table.cells()]
        equations = [f"equation ({number})" for number in self.equations]
        missing = tuple(where for where in (*cells, *equations) if where not in found)
        return Coverage(len(cells), len(equations), missing)


def numbers(first: int, last: int) -> tuple[str, ...]:
    """The numbers of equations from first to last."""
    return tuple(str(n) for n in range(first, last + 1))
