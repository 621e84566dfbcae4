"""How an equation is judged."""

import numpy as np
import pytest

from kinlab.papers.recompute.equation import Equation, check

SAMPLES = {"x": np.array([1.0, 2.0, 3.0]), "y": np.array([2.0, 4.0, 6.0])}


def judged(**more):
    """The findings for "y = 3x", which is y = 2x."""
    given = {
        "number": "1", "printed": "y = 3x", "value": lambda s: 3 * s["x"], "truth": lambda s: s["y"],
        "corrected": "y = 2x", "corrected_value": lambda s: 2 * s["x"], "inputs": (("x", "x", "mm"),), "unit": "mm",
    }  # fmt: skip
    return list(check("ours", Equation(**(given | more)), SAMPLES))


def test_a_wrong_equation_is_contradicted_and_worked_out():
    (finding,) = judged()
    assert finding.verdict == "contradicted"
    assert (finding.printed, finding.recomputed) == ("y = 3x", "y = 2x")
    assert finding.arithmetic == "at x = 1 mm: printed 3 mm, true 2 mm"


def test_a_right_one_is_reproduced():
    (finding,) = judged(printed="y = 2x", value=lambda s: 2 * s["x"], corrected="", corrected_value=None)
    assert (finding.verdict, finding.recomputed) == ("reproduced", "y = 2x")


def test_damage_and_another_reading_explain():
    (damaged,) = judged(damaged=True)
    (read,) = judged(reading=lambda s: 3 * s["x"] - s["x"], cause="x counted once less")
    (no_use,) = judged(reading=lambda s: 3 * s["x"] - 1)
    assert [f.verdict for f in (damaged, read, no_use)] == ["explained", "explained", "contradicted"]
    assert [f.damaged for f in (damaged, read, no_use)] == [True, False, False]


def test_a_reading_may_change_the_truth():
    (finding,) = judged(reading=lambda s: 3 * s["x"], reading_truth=lambda s: s["y"] + s["x"])
    assert finding.verdict == "explained"


def test_a_correction_must_be_the_truth():
    with pytest.raises(AssertionError, match=r"ours \(1\): the corrected form is not the truth"):
        judged(corrected_value=lambda s: 2 * s["x"] + 1e-6)


def test_no_value_is_no_truth():
    (finding,) = judged(value=lambda s: np.arccos(2 * s["x"]))
    assert finding.verdict == "contradicted"
    assert "the printed form has no value, true 2 mm" in finding.arithmetic


def test_entries_are_judged_one_by_one():
    def matrix(s, wrong):
        return np.array([[[x, 0.0], [x + wrong, 1.0]] for x in s["x"]])

    whole, *entries = check(
        "ours",
        Equation(
            "2", "M", lambda s: matrix(s, 0.5), lambda s: matrix(s, 0), "N", lambda s: matrix(s, 0),
            entries=(("x", "0"), ("x", "1")),
        ),
        SAMPLES,
    )  # fmt: skip
    assert whole.verdict == "contradicted"
    assert whole.arithmetic == "3 of 4 entries agree at 3 places"
    assert [entry.verdict for entry in entries] == ["reproduced", "reproduced", "contradicted", "reproduced"]
    assert [entry.where for entry in entries][2] == "equation (2) entry 2,1"
    assert entries[2].recomputed == 1.0
