"""Every number that the papers print, recomputed: `recompute(paper)` gives its findings.

A finding is one printed thing (a cell, a figure in the text, a numbered equation, an entry of a matrix), what the
paper's own inputs give for it, and a verdict that follows from the two:

- reproduced: they give it, at its printed precision;
- explained: they do not, and a named cause, itself computed, does;
- contradicted: they do not, and nothing tried does;
- measured: somebody measured or chose it, so that there is nothing to compute it from.

How a paper is added: put its tables into `kinlab/papers/tables/<paper>/` (the format stands there) and a module
here that ends in `PAPER = Paper(name, title, equation numbers, recompute)`; then name the module in `MODULES`.
`recompute` yields findings. For cells and quoted figures they come from a `Judge`: give it the figure, what the
paper's inputs make of it, the arithmetic in a line, and the `Cause`s to try; it finds the verdict. For equations
they come from `check(paper, Equation(...), samples)`: sample quantities over many poses from the robot's own
kinematics, give the printed form, the corrected one where they differ, and the truth, which must come from
elsewhere than the equation. A verdict is never set by hand. `Paper.coverage` says which cells and equations
have no finding yet; the tests want none.
"""

from collections.abc import Iterable
from importlib import import_module

from kinlab.names import resolve
from kinlab.papers.recompute.finding import VERDICTS, Cause, Finding, Judge, Verdict
from kinlab.papers.recompute.paper import Coverage, Paper
from kinlab.papers.recompute.report import Report, to_json, verdict_of

__all__ = [
    "PAPERS",
    "VERDICTS",
    "Cause",
    "Coverage",
    "Finding",
    "Judge",
    "Paper",
    "Report",
    "Verdict",
    "paper_of",
    "recompute",
    "to_json",
    "verdict_of",
]

MODULES = {
    "xl430-hexapod": "xl430_hexapod",
    "krsri-hexapod": "krsri_hexapod",
    "udiebot-quadruped": "udiebot_quadruped",
    "eros-humanoid": "eros_humanoid",
    "receptionist-arm": "receptionist_arm",
}
PAPERS = tuple(MODULES)


def paper_of(name: str) -> Paper:
    """A paper by its name, or a unique beginning of it.

    Raises:
        UsageError: no paper is named so.
    """
    found: Paper = import_module(f"{__name__}.{MODULES[resolve(name, MODULES, 'paper')]}").PAPER
    return found


def recompute(names: Iterable[str] = PAPERS) -> list[Report]:
    """Every finding of some papers, or of all."""
    reports = []
    for name in names:
        paper = paper_of(name)
        findings = tuple(paper.recompute())
        reports.append(Report(paper, findings, paper.coverage(findings)))
    return reports
