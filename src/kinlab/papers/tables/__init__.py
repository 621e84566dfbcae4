"""Printed tables, as numbers: one file per table, in a folder per paper."""

import csv
from pathlib import Path


def table(paper: str, number: str) -> list[dict[str, float]]:
    """The rows of a printed table, every cell a number, by the names of its columns."""
    path = Path(__file__).parent / paper / f"table-{number}.csv"
    with path.open(encoding="utf-8", newline="") as file:
        return [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(file)]
