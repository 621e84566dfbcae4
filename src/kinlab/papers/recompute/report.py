"""What was found of a paper as a whole: counts, selections, and the JSON of the contract."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from kinlab.names import resolve
from kinlab.papers.recompute.finding import VERDICTS, Finding, Verdict
from kinlab.papers.recompute.paper import Coverage, Paper
from kinlab.papers.tables import PrintedTable


@dataclass(frozen=True)
class Report:
    """What recomputing a paper found.

    Attributes:
        paper: which.
        findings: all of them, in the order of the print.
        coverage: whether anything is left out.
    """

    paper: Paper
    findings: tuple[Finding, ...]
    coverage: Coverage

    def count(self, verdict: Verdict) -> int:
        """How many findings have a verdict."""
        return sum(finding.verdict == verdict for finding in self.findings)

    @property
    def damaged(self) -> int:
        """How many the scan has spoilt, which do not count against the paper."""
        return sum(finding.damaged for finding in self.findings)

    def cells(self, table: PrintedTable) -> dict[tuple[str, str], Finding]:
        """The findings for the cells of a table, by row and column."""
        return {(f.row, f.column): f for f in self.findings if f.kind == "cell" and f.table == table.number}

    def select(self, table: str | None = None, only: Verdict | None = None) -> list[Finding]:
        """The findings that concern a table, or have a verdict, or both."""
        return [
            finding
            for finding in self.findings
            if table in (None, finding.table) and only in (None, finding.verdict)
        ]


def verdict_of(name: str) -> Verdict:
    """A verdict by its name, or a unique beginning of it.

    Raises:
        UsageError: no verdict is named so.
    """
    name = resolve(name, VERDICTS, "verdict")
    return next(verdict for verdict in VERDICTS if verdict == name)


def to_json(
    reports: Iterable[Report], table: str | None = None, only: Verdict | None = None
) -> dict[str, Any]:
    """The document of the contract, with a summary besides."""
    reports = list(reports)
    return {
        "findings": [finding.to_json() for report in reports for finding in report.select(table, only)],
        "coverage": {report.paper.name: report.coverage.to_json() for report in reports},
        "summary": {
            report.paper.name: {
                **{verdict: report.count(verdict) for verdict in VERDICTS},
                "damaged": report.damaged,
            }
            for report in reports
        },
    }
