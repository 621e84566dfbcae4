"""Two gaits beside the paper: crossings of curves, and what is said of them."""

import numpy as np
import pytest

from kinlab.papers.comparison import compare, crossings, curves
from kinlab.papers.energy import measured_energy
from kinlab.robots import load_robot

SPEED = np.array([0.01, 0.02, 0.03, 0.04])


def two_terms(power, per_metre):
    return power / SPEED / 3600 + per_metre


def test_curves_of_two_terms_give_their_terms_back():
    found = curves("made up", SPEED, {"wave": two_terms(6.0, 0.14), "tripod": two_terms(12.0, 0.02)})
    assert found.models["wave"].power == pytest.approx(6.0)
    assert found.models["tripod"].per_metre == pytest.approx(0.02)
    assert found.fitted.speed == pytest.approx(6.0 / 3600 / 0.12)
    # Straight between points, a crossing lies near that of the curves.
    assert found.crossings == pytest.approx([found.fitted.speed], rel=0.15)
    assert found.cheaper is None


def test_a_gait_that_always_costs_less():
    found = curves("made up", SPEED, {"a": two_terms(6.0, 0.1), "b": two_terms(7.0, 0.1)})
    assert (found.crossings, found.cheaper) == ((), "a")
    assert found.to_json()["crossover_mm_s"] is None


def test_too_few_speeds_for_a_model():
    found = curves("made up", [0.04, 0.01], {"a": [1, 4], "b": [2, 3]})
    assert (found.models, found.fitted) == ({}, None)
    assert found.speed.tolist() == [0.01, 0.04]
    assert found.crossings == pytest.approx([0.025])


def test_crossings():
    assert crossings(np.arange(4.0), np.array([1.0, -1.0, -1.0, 1.0])) == (0.5, 2.5)
    assert crossings(np.arange(3.0), np.array([1.0, 0.0, -1.0])) == (1.0,)
    assert crossings(np.arange(2.0), np.array([1.0, 2.0])) == ()


def test_the_paper_stands_beside_the_rig_where_it_measured():
    energy = {"wave": two_terms(6.0, 0.14), "tripod": two_terms(12.0, 0.02)}
    answer = compare(load_robot("krsri-hexapod"), SPEED, energy)
    rig, flat, broken = answer.sources
    assert "emulated" in rig.label
    assert (flat.label[:18], broken.label[:18]) == ("the paper, Table 2", "the paper, Table 4")
    # "wave costs less at 10 to 13 mm/s, tripod from 16 on" is printed.
    assert 13 < flat.crossings[0] * 1000 < 16
    assert flat.fitted.speed == measured_energy("flat").crossover.speed
    assert answer.notes
    other = compare(load_robot("xl430-hexapod"), SPEED, energy)
    assert (len(other.sources), other.notes) == (1, ())
    assert (
        len(
            compare(
                load_robot("krsri-hexapod"), SPEED, {"ripple": energy["wave"], "wave": energy["tripod"]}
            ).sources
        )
        == 1
    )
