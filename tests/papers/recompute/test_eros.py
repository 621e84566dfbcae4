"""Findings of EROS's paper, each redone by hand."""

import math

import pytest

from kinlab.papers import eros_humanoid
from kinlab.papers.recompute import recompute
from kinlab.papers.tables import printed_table

(REPORT,) = recompute(["eros-humanoid"])
FOUND = {finding.where: finding for finding in REPORT.findings}


@pytest.mark.parametrize(
    ("where", "printed", "recomputed", "verdict"),
    [
        ("Table 1 total joints", "20", 20, "reproduced"),  # 2 + 3 + 3 + 6 + 6
        ("Table 5 RL 4 angle", "2", 4, "contradicted"),  # knee: (26) has theta4
        ("Table 6 LL 6 angle", "3", 6, "contradicted"),
        ("Table 3 RA 2 y", "0", 0, "reproduced"),
        ("section 5, stability without optimization, pedestal 1", "10", 30, "explained"),
        ("section 5, stability without optimization, pedestal 3", "30", 50, "explained"),
        ("section 5, stability without optimization, pedestal 4", "80", 90, "contradicted"),
        ("section 5, stability with optimization, pedestal 1", "70", 70, "reproduced"),
        ("section 5, stability with optimization, pedestal 4", "100", 100, "reproduced"),
        ("section 5, stability without optimization, average", "32", 32.5, "reproduced"),  # 130 / 4
        ("section 5, stability with optimization, average", "80", 80, "reproduced"),  # 320 / 4
        ("abstract, stability without optimization", "32", 50, "contradicted"),  # (30 + 30 + 50 + 90) / 4
        ("abstract, stability with optimization", "80", 80, "reproduced"),
        ("conclusion, stability without optimization", "32", 50, "contradicted"),
        ("section 5, first experiment, difference of distance", "25.67", 1540 / 60, "reproduced"),
        ("section 5, third experiment, difference of distance", "55.33", 3320 / 60, "reproduced"),
        ("section 5, first experiment, step", "8", 80, "explained"),  # cm in the table
        ("section 5, second experiment, steps with optimization", "9", 6000 / 16, "contradicted"),
        ("section 5, the table of the system with optimization", "5", 8, "contradicted"),
    ],
)
def test_figures(where, printed, recomputed, verdict):
    finding = FOUND[where]
    assert (finding.printed_text, finding.verdict) == (printed, verdict)
    assert finding.recomputed == pytest.approx(recomputed, abs=1e-9)


def test_a_walk_that_the_text_calls_stable_is_not_in_table_8():
    finding = FOUND["section 5, third experiment, with optimization"]
    assert (finding.printed, finding.recomputed, finding.verdict) == ("stable", "unstable", "contradicted")
    others = [f for f in REPORT.findings if f.kind == "claim" and f is not finding]
    assert [f.verdict for f in others] == ["reproduced"] * 5


def test_what_is_said_of_the_backward_halves_is_so():
    one, other = (printed_table("eros-humanoid", number) for number in "78")
    pedestals = [name for name in one.units if name.startswith("pedestal")]
    for row in ("backward 8", "backward 16", "backward 24"):
        assert [one.rows[row][p].figure for p in pedestals] == [other.rows[row][p].figure for p in pedestals]
    ahead = [sum(one.rows[f"forward {d}"][p].figure.value for d in range(0, 25, 4)) for p in pedestals]
    assert [10 * (count + back) for count, back in zip(ahead, (0, 0, 0, 2), strict=True)] == [10, 10, 30, 80]


def test_the_verdicts_on_the_equations():
    by_verdict = {verdict: [] for verdict in ("contradicted", "explained")}
    for finding in REPORT.findings:
        if finding.kind == "equation" and finding.verdict in by_verdict:
            by_verdict[finding.verdict].append(finding.where)
    assert by_verdict["contradicted"] == [
        f"equation ({n})" for n in (2, 3, 12, 13, 17, 23, 27, 34, 39, 43, 46, 47)
    ]
    assert by_verdict["explained"] == [f"equation ({n})" for n in (5, 7, 11, 15, 22, 25, 30, 31, 32)]


def test_the_matrices_are_judged_entry_by_entry():
    entries = [f for f in REPORT.findings if f.kind == "entry"]
    assert len(entries) == 3 * 16 + 3 * 3
    wrong = {f.where: f for f in entries if f.verdict == "contradicted"}
    assert set(wrong) == {"equation (2) entry 2,4", "equation (3) entry 2,1"}
    # d_z2 sin(theta1) sin(theta2) at 90 and 30 deg, with 80 mm: 40, not 80 sin(30) sin(30) = 20.
    assert wrong["equation (3) entry 2,1"].recomputed == pytest.approx(40)
    assert "printed 20, true 40" in wrong["equation (3) entry 2,1"].arithmetic


def test_only_the_broken_block_of_the_right_arm_is_put_down_to_the_scan():
    damaged = [f.where for f in REPORT.findings if f.damaged]
    assert damaged == ["equation (5)", *(f"equation (5) entry {e}" for e in ("1,1", "1,4", "2,4", "3,4"))]


def test_worked_lines_can_be_followed():
    # Level sole, hip pitched by 30 deg, knee bent by 60: the ankle needs 30, and not 30 + 60.
    assert "printed 90 deg, true -30 deg" in FOUND["equation (27)"].arithmetic
    # (1 - sin 0 + 90) 10 = 910, where the foot should be at its start.
    assert "printed 910 mm, true 0 mm" in FOUND["equation (39)"].arithmetic
    dP_x, dP_y, P_6z = 10.0, 30.0767, -170.574
    assert f"printed {math.hypot(dP_x, P_6z):.3f} mm" in FOUND["equation (17)"].arithmetic
    assert f"true {math.sqrt(dP_x**2 + dP_y**2 + P_6z**2):.3f} mm" in FOUND["equation (17)"].arithmetic


def test_as_printed_and_recomputed_know_the_same_misprints():
    legs = [m.equation for m in eros_humanoid.INVERSE.misprints]
    off = [n for n in map(str, range(9, 29)) if FOUND[f"equation ({n})"].verdict != "reproduced"]
    assert off == legs
    assert [m.equation for m in eros_humanoid.HEAD.misprints] == ["3"]
    # phi stands in entries 1,4 and 3,4.
    assert [m.equation for m in eros_humanoid.ARM.misprints] == ["R11", "phi"]
