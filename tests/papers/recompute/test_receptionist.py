"""Findings of the arm paper, each redone by hand."""

import math
import re

import numpy as np
import pytest

from kinlab.papers import receptionist_torques
from kinlab.papers.recompute import recompute
from kinlab.papers.recompute.receptionist_newton import rate

(REPORT,) = recompute(["receptionist-arm"])
FOUND = {finding.where: finding for finding in REPORT.findings}


@pytest.mark.parametrize(
    ("where", "printed", "recomputed", "verdict"),
    [
        ("Table 2.1 address 0 initial", "12", 24, "explained"),  # the AX-12's
        ("Table 2.1 address 4 initial", "1", 34, "explained"),
        ("Table 2.1 address 9 initial", "3", 3, "reproduced"),  # 1023 = 3 * 256 + 255
        ("Table 2.1 address 10 initial", "0", 0, "reproduced"),  # reserved: the RX-24F's sheet has nothing
        ("Table 2.1 address 11 initial", "85", 80, "explained"),
        ("Table 2.1 address 17 initial", "4", 36, "explained"),
        ("Table 2.1 address 34 copied from", "14", 14, "reproduced"),
        ("Table 2.1 address 45 hex", "0X2D", 45, "reproduced"),
        ("Table 2.2 value 16 set", "117647.1", 2e6 / 17, "reproduced"),
        ("Table 2.2 value 16 error", "-2.124", (115200 - 2e6 / 17) / 1152, "reproduced"),
        ("Table 2.2 value 34 error", "-0.160", (57600 - 2e6 / 35) / 576, "explained"),  # the row below
        ("Table 2.2 value 51 error", "-0.160", (38400 - 2e6 / 52) / 384, "reproduced"),
        ("Table 2.4 step 1 to", "2", 3, "contradicted"),
        ("Table 2.4 step 7 to", "254", 254, "reproduced"),
        ("Table 2.5 direction bit", "10", 10, "reproduced"),  # 0x400
        ("Table 2.6 READ DATA value", "0x01", 2, "explained"),
        ("Table 2.6 SYNC WRITE value", "0x07", 0x83, "explained"),
        ("Table 2.8 UDRIE level", "0", 1, "contradicted"),
        ("section 2.3.1, stall torque", "26", 2.6 / 9.80665 * 100, "explained"),
        ("section 2.3.2, speed for 0x3FF", "114", 1023 * 0.111, "reproduced"),
        ("section 2.3.2, 512 in hexadecimal", "0x1ff", 512, "contradicted"),
        ("section 2.3.2, example, angle", "207.9", 594 * 300 / 1024, "explained"),  # 594 * 0.35
        ("section 2.3.2, example, checksum", "0x84", 255 - (1 + 5 + 3 + 0x1E + 0x52 + 2), "reproduced"),
        ("section 2.3.2 e, supply", "12", 11.1, "contradicted"),  # the battery's
        ("section 2.3.2 f, bytes per ms at 1 Mbps", "125", 100, "explained"),  # 8 bits of 10
        ("section 2.5, timer clock", "15.625", 15625, "explained"),
        ("section 2.5, TCNT1", "0x64", 256 - 156.25, "reproduced"),
        ("section 2.5, Timer1, interrupt", "10", (65536 - 100) / 15.625, "explained"),  # 8 bits: 156 / 15.625
        ("section 4.1.1, sampling time", "16", 20, "contradicted"),
        ("section 3.1.1, L1", "18.5", math.sqrt(342.25), "reproduced"),
        ("section 3.1.1, L2", "18.5", 462.5 / 18.5, "contradicted"),
        ("section 3.2, L1", "17", 18.5, "contradicted"),
        ("section 3.2, L2", "25", 25, "reproduced"),
        ("appendix, L1 L2 in L1L2S3", "462.5", 18.5**2, "explained"),  # 18.5 * 25
        ("conclusion, K_v", "0.02", 0.2, "contradicted"),
        ("conclusion, K_env", "9", 12, "contradicted"),
        ("conclusion, D_env", "5", 5, "reproduced"),
        ("conclusion, M_env", "9", 1, "contradicted"),
    ],
)
def test_figures(where, printed, recomputed, verdict):
    finding = FOUND[where]
    assert (finding.printed_text, finding.verdict) == (printed, verdict)
    assert finding.recomputed == pytest.approx(recomputed, rel=1e-9)


def test_every_initial_value_is_that_of_one_servo_or_the_other():
    initial = [f for f in REPORT.findings if f.table == "2.1" and f.column == "initial"]
    assert len(initial) == 50 - 13 - 4  # thirteen are measured at power-on, four copied
    assert {f.verdict for f in initial} == {"reproduced", "explained"}
    silent = [f.row for f in initial if "the RX-24F's sheet has nothing" in f.arithmetic]
    assert silent == [f"address {n}" for n in (10, 19, 32, 33, 45)]
    assert [f.row for f in initial if f.verdict == "explained"] == [
        f"address {n}" for n in (0, 4, 11, 17, 18, 26, 27)
    ]


def test_a_cause_shows_where_its_figure_comes_from():
    assert "(38400 - 38461.54) / 38400 = -0.160 %" in FOUND["Table 2.2 value 34 error"].arithmetic
    assert FOUND["Table 2.6 READ DATA value"].arithmetic.endswith("above it 1")
    assert FOUND["Table 2.6 SYNC WRITE value"].arithmetic.endswith("6 + 1 = 7")


def test_the_packets_are_those_of_the_codec():
    for name in ("instruction packet", "status packet"):
        assert FOUND[f"section 2.3.2, example, {name}"].verdict == "reproduced"


def test_only_with_18_5_and_25_cm_does_the_arm_start_at_a_whole_angle():
    told = FOUND["section 3.2, L1"].cause
    assert "18.5 and 25: 45.00; 17 and 25: 37.21; 18.5 and 18.5: 77.62" in told
    # Law of cosines: the elbow's outside angle, then the hand where it should be.
    x, y = -11.322, 7.653
    elbow = math.acos((x * x + y * y - 18.5**2 - 25**2) / (2 * 18.5 * 25))
    shoulder = math.radians(45)
    assert 18.5 * math.cos(shoulder) + 25 * math.cos(shoulder + elbow) == pytest.approx(x, abs=2e-4)
    assert 18.5 * math.sin(shoulder) + 25 * math.sin(shoulder + elbow) == pytest.approx(y, abs=2e-4)


def verdicts(verdict):
    return [
        f.where.removeprefix("equation (").removesuffix(")")
        for f in REPORT.findings
        if f.kind == "equation" and f.verdict == verdict
    ]


def test_the_verdicts_on_the_equations():
    assert verdicts("contradicted") == [
        *("2.17", "2.24", "2.26", "2.34", "2.35", "2.36", "2.39", "2.40", "2.46", "2.48"),
        *("3.9", "3.9, matrix 3", "3.9, matrix 5", "3.9, multiplied out", "3.17", "3.20, entries"),
        *("3.26", "3.31", "3.32", "3.33", "3.35", "3.36", "appendix (xc2_dot2"),
    ]
    assert verdicts("explained") == [
        *("2.6", "2.13", "2.14", "2.15", "2.19", "2.29", "2.30", "2.37", "3.24", "3.28", "3.29", "3.34"),
    ]


def test_the_jacobian_is_right_in_all_nine_entries_and_its_inverse_in_eight():
    for matrix, wrong in (("3.17", []), ("3.20", ["3,2"])):
        entries = [f for f in REPORT.findings if f.where.startswith(f"equation ({matrix}, entries) entry")]
        assert len(entries) == 9
        assert [f.where.split()[-1] for f in entries if f.verdict != "reproduced"] == wrong


def test_the_position_of_the_multiplied_matrix_is_right_and_its_attitude_is_not():
    entries = {
        f.where.split()[-1]: f.verdict
        for f in REPORT.findings
        if f.where.startswith("equation (3.9, multiplied out) entry")
    }
    assert len(entries) == 16
    right = {place for place, verdict in entries.items() if verdict == "reproduced"}
    assert right == {"1,4", "2,4", "3,4", "3,3", "4,1", "4,2", "4,3", "4,4"}


@pytest.mark.parametrize(
    ("number", "printed", "true"),
    [
        # zeta = 0.5: 100 e^(0.5 pi / sqrt(0.75)), and the same with a minus.
        ("2.17", 100 * math.exp(0.5 * math.pi / math.sqrt(0.75)), 100 * math.exp(-0.5 * math.pi / math.sqrt(0.75))),
        # omega = (1, 2, 2), M = diag(1, 2, 3): (omega x M omega)_z = 1 * 4 - 2 * 1; (omega x M v)_z = 0 - 2 * 1.
        ("2.39", -2, 2),
        # omega = (1, 2, 2), p = (1, 0, 0): (omega x omega x p)_x = 1 * 1 - 9 = -8.
        ("2.46", 8, -8),
        # Both links level, at rest: m1 g 0.0925 +- 1.8633 * 0.185, m1 g = 1.726.
        ("3.31", 1.726 * 0.0925 - 1.8633 * 0.185, -1.726 * 0.0925 - 1.8633 * 0.185),
        # 1.8633 * (0.31 - 0.185); without y nothing is left.
        ("3.36", 0, 1.8633 * 0.125),
    ],
)  # fmt: skip
def test_worked_lines_can_be_followed(number, printed, true):
    shown = re.search(r"printed (\S+).*, true (\S+)", FOUND[f"equation ({number})"].arithmetic)
    found = [float(text) for text in shown.groups()]
    assert found == pytest.approx([printed, true], abs=1e-3)


def test_the_appendix_gives_a_turning_arm_no_acceleration():
    assert FOUND["appendix (xc2_dot1)"].verdict == "reproduced"
    # Stretched out, 43.5 cm at 1 rad/s: inwards with 43.5 cm/s2.
    assert FOUND["appendix (xc2_dot2)"].arithmetic.endswith("printed 0 cm/s², true -43.5 cm/s²")


def test_differences_are_good_enough_to_be_the_truth():
    rates = [rate(np.sin)(t) for t in (0.0, 0.3, 1.0)]
    assert rates == pytest.approx([math.cos(t) for t in (0.0, 0.3, 1.0)], abs=1e-13)
    assert rate(rate(np.sin))(0.4) == pytest.approx(-math.sin(0.4), abs=1e-11)


def test_numbers_of_an_earlier_version_are_recognised():
    references = [f for f in REPORT.findings if f.where.endswith("its number")]
    assert [f.verdict for f in references] == ["explained"] * 8 + ["contradicted"]


def test_as_printed_and_recomputed_know_the_same_misprints():
    for misprint in receptionist_torques.MISPRINTS:
        assert FOUND[f"equation ({misprint.equation})"].verdict != "reproduced"
