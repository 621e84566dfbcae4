"""Orders, sweeps, and what a walk's result says."""

from dataclasses import replace

import numpy as np
import pytest

from kinlab.errors import KinlabError, UsageError
from kinlab.gait import find_gait
from kinlab.rig import Order, Record, Rig, WalkResult, check_steady, costs, prepare, span, sweep, walk_on


@pytest.fixture
def order(krsri):
    return Order(krsri, find_gait(krsri, "tripod"), 0.02, 0.0, 1.0, 50.0)


@pytest.fixture
def result_of():
    def run(errand):
        with Rig.open(errand.order.robot) as rig:
            record = Record(rig.wiring, list(walk_on(rig, errand)))
        return WalkResult.of(errand, record, rig)

    return run


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("10:40:15", [10, 25, 40]),
        ("10:12", [10, 11, 12]),
        ("0.1:0.3:0.1", [0.1, 0.2, 0.3]),
        ("3:1:-1", [3, 2, 1]),
        ("7", [7]),
        ("10,20,15", [10, 20, 15]),
    ],
)
def test_ranges(text, numbers):
    assert span(text) == pytest.approx(numbers)


@pytest.mark.parametrize("text", ["", "a", "1:2:0", "1:2:-1", "1:2:3:4", "1:nan", "0:1e9:1e-3", "1,2:3"])
def test_ranges_that_are_none(text):
    with pytest.raises(UsageError):
        span(text)


@pytest.mark.parametrize(
    ("change", "kind", "word"),
    [
        ({"distance": 0.0}, UsageError, "distance must be above 0"),
        ({"distance": np.nan}, UsageError, "finite"),
        ({"rate": -1.0}, UsageError, "above 0"),
        ({"rate": 5000.0}, UsageError, "1000 commands a second"),
        ({"speed": 0.0}, UsageError, "a speed or a turn"),
        ({"speed": 1e-9}, UsageError, "would take"),
        ({"speed": 0.4}, KinlabError, "femur of L1 .* fastest possible speed .* 224 mm/s"),
        ({"speed": 0.0, "turn": 9.0}, KinlabError, "fastest possible turn"),
    ],
)
def test_orders_that_cannot_be(order, change, kind, word):
    with pytest.raises(kind, match=word):
        prepare(replace(order, **change))


def test_a_sweep_is_checked_before_anything_moves(order):
    errands = sweep(order, "spe", [10, 40])
    assert [e.order.speed for e in errands] == pytest.approx([0.01, 0.04])
    assert sweep(order, "distance", [50])[0].order.distance == pytest.approx(0.05)
    with pytest.raises(KinlabError, match="fastest"):
        sweep(order, "speed", [10, 400])
    with pytest.raises(UsageError, match="did you mean speed"):
        sweep(order, "sped", [10])


def test_steady_cycles_cost_power_over_speed(errand, result_of):
    result = result_of(errand("tripod", 40, 400))
    steady = result.steady
    assert steady.cycles == 3
    assert result.per_metre == pytest.approx(steady.power / 0.040 / 3600)
    assert costs([result]) == [result.per_metre]
    # Within the walk, and above what idling takes.
    watts = result.record.watts.sum(axis=1)
    assert 10.8 < watts.min() < steady.power < watts.max()
    assert result.complete
    assert result.covered[-1] == pytest.approx(0.4)


def test_a_short_walk_has_no_steady_part(errand, result_of):
    job = errand(distance=60)
    with pytest.raises(UsageError, match="at least 198 mm"):
        check_steady(job)
    result = result_of(job)
    assert result.steady is None
    with pytest.raises(KinlabError, match="no whole cycle"):
        costs([result])


def test_turning_on_the_spot(order, result_of):
    result = result_of(prepare(replace(order, speed=0.0, turn=np.radians(40), rate=20.0)))
    assert result.covered[-1] == pytest.approx(2 * np.pi)
    assert result.per_metre is None
    assert result.to_json()["distance_mm"] == 0.0
    assert result.series()[-1]["way_deg"] == pytest.approx(360)


def test_the_document_is_in_peoples_units(errand, result_of):
    result = result_of(errand("wave", 40, 200))
    data = result.to_json()
    femur = next(j for j in data["joints"] if (j["leg"], j["joint"]) == ("R1", "femur"))
    assert femur["limit_deg_s"] == pytest.approx(354)
    assert femur["planned_deg_s"] == pytest.approx(316, abs=1)
    assert data["fastest_mm_s"] == pytest.approx(44.8, abs=0.1)
    # What was planned is what the servo reports, but for its jerks from command to command.
    assert 0.7 < femur["measured_deg_s"] / femur["planned_deg_s"] < 1.3
    assert data["energy"]["idle_wh"] == pytest.approx(18 * 0.05 * 12 * data["duration_s"] / 3600, rel=0.01)
    assert data["achieved_rate_hz"] == pytest.approx(50, rel=0.01)
    assert result.row()["wh"] == data["energy"]["wh"]
    assert any("assumed: not printed; 18 AX-12A" in note for note in data["notes"])
    rows = result.series()
    assert rows[-1]["energy_wh"] == pytest.approx(data["energy"]["wh"])
    assert rows[-1]["way_mm"] == pytest.approx(200)
