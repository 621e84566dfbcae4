"""Every paper, recomputed: nothing left out, every verdict computed, the totals as they are."""

import importlib
import math
import pkgutil

import pytest

import kinlab.papers.recompute as rooms
from kinlab.papers.figure import Figure
from kinlab.papers.recompute import PAPERS, VERDICTS, Cause, Judge, paper_of, recompute, to_json
from kinlab.papers.recompute.equation import check
from kinlab.papers.tables import Cell, printed_tables

REPORTS = {report.paper.name: report for report in recompute()}
# Findings by verdict: reproduced, explained, contradicted, measured. To change one takes a reason in the commit.
TOTALS = {
    "eros-humanoid": (156, 20, 31, 100),
    "receptionist-arm": (390, 45, 50, 8),
    "xl430-hexapod": (80, 14, 18, 145),
    "krsri-hexapod": (203, 1, 5, 176),
    "udiebot-quadruped": (183, 136, 13, 108),
}
FINDINGS = [finding for report in REPORTS.values() for finding in report.findings]


@pytest.mark.parametrize("name", PAPERS)
def test_every_cell_and_every_numbered_equation_has_a_finding(name):
    report = REPORTS[name]
    assert report.coverage.missing == ()
    assert report.coverage.cells == sum(1 for table in printed_tables(name) for _ in table.cells())
    assert report.coverage.equations == len(report.paper.equations)


@pytest.mark.parametrize("name", PAPERS)
def test_no_place_has_two_findings(name):
    places = [finding.where for finding in REPORTS[name].findings]
    assert len(places) == len(set(places))


@pytest.mark.parametrize("name", TOTALS)
def test_totals_are_pinned(name):
    assert tuple(REPORTS[name].count(verdict) for verdict in VERDICTS) == TOTALS[name]


def test_no_finding_lacks_its_computation():
    for finding in FINDINGS:
        if finding.verdict == "measured":
            assert finding.kind == "cell"
            assert finding.recomputed is None
            assert finding.cause
        else:
            assert finding.arithmetic, finding.where
            assert finding.recomputed is not None or "no value" in finding.arithmetic, finding.where


def test_every_figure_has_the_verdict_that_its_numbers_give():
    """Judged here once more, from the print alone."""
    for finding in FINDINGS:
        if not isinstance(finding.printed, Figure) or finding.verdict == "measured":
            continue
        own = math.nan if finding.recomputed is None else finding.recomputed
        # A figure that lost zeros at its end may also be one of fewer decimals.
        near = abs(own - finding.printed.value) <= 0.5 * 10.0**-finding.printed.decimals + 1e-9
        assert near or finding.verdict != "reproduced", finding.where
        cause = finding.explained_by
        assert (cause is not None) == (finding.verdict == "explained"), finding.where
        if cause is not None:
            decimals = len(finding.printed.text.partition(".")[2])
            if cause.cut:
                decimals = max(decimals, cause.decimals or 0)
                left = (
                    math.trunc(cause.value * 10**decimals + math.copysign(1e-6, cause.value)) / 10**decimals
                )
                assert left == pytest.approx(finding.printed.value, abs=1e-9), finding.where
            else:
                assert abs(cause.value - finding.printed.value) <= 0.5 * 10.0**-decimals + 1e-9, finding.where


def test_no_equation_is_compared_with_itself(monkeypatch):
    seen = []

    def recorded(paper, equation, *rest):
        seen.append(equation)
        return check(paper, equation, *rest)

    for found in pkgutil.iter_modules(rooms.__path__, f"{rooms.__name__}."):
        module = importlib.import_module(found.name)
        if getattr(module, "check", None) is check:
            monkeypatch.setattr(module, "check", recorded)
    recompute()
    assert len(seen) >= sum(report.coverage.equations for report in REPORTS.values())
    for equation in seen:
        assert computation(equation.value) != computation(equation.truth), equation.number


def computation(form):
    """A form's code and what it holds: alike where two forms cannot differ."""
    return form.__code__, [cell.cell_contents for cell in form.__closure__ or ()]


def test_words_that_explain_are_there_wherever_something_is_explained():
    assert all(finding.cause for finding in FINDINGS if finding.verdict == "explained")


def test_json_is_the_contract():
    found = to_json(REPORTS.values())
    keys = {"paper", "where", "printed", "recomputed", "unit", "verdict", "cause"}
    assert all(keys <= set(finding) for finding in found["findings"])
    assert {finding["verdict"] for finding in found["findings"]} <= set(VERDICTS)
    assert set(found["coverage"]) == set(PAPERS)
    for coverage in found["coverage"].values():
        assert coverage["recomputed"] == coverage["cells"] > 0


CELL = Cell("1", "test 1", "x", "mm", Figure("0.88"))


def test_the_first_cause_that_fits_is_the_reason():
    judge = Judge("ours")
    causes = [Cause("no", 0.5), Cause("yes", 0.8849), Cause("as well", 0.88)]
    finding = judge.cell(CELL, 0.9, "9 / 10", causes, "by the way")
    assert (finding.verdict, finding.cause, finding.recomputed) == ("explained", "yes; by the way", 0.9)
    refused = judge.cell(CELL, 0.9, "9 / 10", causes[:1])
    assert (refused.verdict, refused.cause) == ("contradicted", "")
    assert refused.arithmetic == "9 / 10; tried in vain: no (0.5)"
    assert judge.cell(CELL, 0.8751, "7 / 8", causes).verdict == "reproduced"
    assert judge.cell(CELL, math.nan, "0 / 0").recomputed is None


def test_a_figure_is_shown_with_the_digits_that_tell_it_from_the_print():
    judge = Judge("ours")
    half = Cell("1", "test 1", "t", "s", Figure("63"))
    assert judge.cell(half, 62.5, "1000 / 16").recomputed_text == "63"
    assert judge.cell(CELL, 8 / 9, "8 / 9").recomputed_text == "0.8889"
    assert judge.cell(half, -0.0164, "").recomputed_text == "-0.0164"
    assert judge.cell(half, 32.003, "", decimals=3).recomputed_text == "32.003"
    by_hex = judge.cell(Cell("1", "a", "hex", "", Figure("0X0C")), 12, "")
    assert by_hex.recomputed_text == "0X0C"
    explained = judge.cell(CELL, 0.7, "", [Cause("yes", 0.8812)])
    assert (explained.recomputed_text, explained.explained_text) == ("0.7", "0.8812")


def test_what_is_left_out_is_missing():
    paper = paper_of("xl430")
    findings = REPORTS["xl430-hexapod"].findings
    coverage = paper.coverage(f for f in findings if f.where not in ("Table 4 test 8 y", "equation (5)"))
    assert coverage.missing == ("Table 4 test 8 y", "equation (5)")
    assert coverage.to_json()["recomputed"] == coverage.to_json()["cells"] - 2
