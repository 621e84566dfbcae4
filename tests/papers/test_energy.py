"""What walking costs: the paper's tables, the model fitted to them, and its crossover."""

import numpy as np
import pytest

from kinlab import load_robot
from kinlab.errors import UsageError
from kinlab.papers.energy import crossover, distance_covered, electric_energy, energy_of, fit, measured_energy
from kinlab.papers.tables import printed_table


@pytest.mark.parametrize("number", ["2", "3", "4", "5"])
def test_the_tables_have_eleven_runs_of_a_metre(number):
    table = printed_table("krsri-hexapod", number)
    assert table.column("speed").tolist() == list(range(10, 41, 3))
    assert set(table.column("distance")) == {100}
    # Whole seconds, rounded.
    assert np.abs(table.column("duration") - 1000 / table.column("speed")).max() <= 0.5


# Averages as printed below tables 3 and 5, and the ends of the columns as the abstract quotes them.
@pytest.mark.parametrize(("ground", "wave", "tripod"), [("flat", 90.0, 91.7), ("broken", 83.7, 80.8)])
def test_averages_are_those_printed(ground, wave, tripod):
    found = measured_energy(ground).averages
    assert round(found["wave"][0], 1) == found["wave"][1] == wave
    assert round(found["tripod"][0], 1) == found["tripod"][1] == tripod


def test_the_abstract_quotes_table_2():
    flat = measured_energy("flat").energy
    assert flat["wave"][[0, 1, -1]].tolist() == [0.338, 0.252, 0.195]
    assert flat["tripod"][[0, 1, -1]].tolist() == [0.343, 0.271, 0.098]


def test_a_model_finds_the_terms_that_made_its_data():
    t = np.array([100.0, 60.0, 40.0, 25.0])
    model = fit(t, np.ones(4), 5.0 * t / 3600 + 0.02)
    assert model.power == pytest.approx(5)
    assert model.per_metre == pytest.approx(0.02)
    assert model.residual < 1e-12
    assert model.at_speed(0.01) == pytest.approx(5 * 100 / 3600 + 0.02)


@pytest.mark.parametrize("ground", ["flat", "broken"])
def test_the_fit_is_that_of_numpy_and_says_what_it_leaves(ground):
    runs = measured_energy(ground)
    for gait, model in runs.models.items():
        slope, offset = np.polyfit(runs.duration / 3600, runs.energy[gait], 1)
        assert (model.power, model.per_metre) == pytest.approx((slope, offset))
        left = runs.energy[gait] - model.energy(runs.duration, runs.distance)
        assert model.residual == pytest.approx(np.sqrt(np.mean(left**2)))
        _, covariance = np.polyfit(runs.duration / 3600, runs.energy[gait], 1, cov=True)
        assert model.covariance == pytest.approx(covariance)


@pytest.mark.parametrize("ground", ["flat", "broken"])
def test_wave_and_tripod_cost_the_same_at_the_crossover(ground):
    runs = measured_energy(ground)
    wave, tripod = runs.models["wave"], runs.models["tripod"]
    speed = runs.crossover.speed
    assert wave.at_speed(speed) == pytest.approx(tripod.at_speed(speed))
    assert wave.at_speed(speed / 2) < tripod.at_speed(speed / 2)
    assert wave.at_speed(speed * 2) > tripod.at_speed(speed * 2)
    # Between the runs where the measured columns change places.
    ahead = runs.energy["wave"] < runs.energy["tripod"]
    assert ahead.tolist() == [True, True] + [False] * 9
    assert runs.speed[0] < speed < runs.speed[2]


def test_the_crossovers_error_is_that_of_many_draws():
    runs = measured_energy("flat")
    rng = np.random.default_rng(0)
    draws = [
        rng.multivariate_normal([m.power, m.per_metre], m.covariance, 20_000)
        for m in (runs.models["wave"], runs.models["tripod"])
    ]
    difference = draws[0] - draws[1]
    speeds = -difference[:, 0] / 3600 / difference[:, 1]
    assert runs.crossover.error == pytest.approx(speeds.std(), rel=0.1)


def test_models_that_do_not_cross_say_so():
    t = np.array([100.0, 60.0, 40.0, 25.0])
    cheap, dear = (fit(t, np.ones(4), k * t / 3600 + k * 0.01) for k in (1, 2))
    assert crossover(cheap, dear).speed is None


def test_the_energy_of_a_current_is_a_sum_over_time():
    # 2 A at 12 V for half an hour, (28).
    assert electric_energy(np.full(1800, 2.0), np.full(1800, 12.0), 1.0) == pytest.approx(12)


def test_the_way_covered_counts_both_errors():
    # (29): 100 cm planned, 20 cm short, 60 cm aside.
    assert distance_covered(100, 60, 20) == pytest.approx(100)


def test_only_the_paper_that_measured_energy_has_any():
    assert [ground.name for ground in energy_of(load_robot("krsri-hexapod"))] == ["flat", "broken"]
    with pytest.raises(UsageError, match="the paper of udiebot measures no energy"):
        energy_of(load_robot("udiebot"))
