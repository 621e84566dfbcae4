"""What walking costs: krsri-hexapod's Table 2. Speeds in mm/s, durations in s, ways in m, energies in Wh."""

from functools import cache

import numpy as np

from kinlab.papers.energy import EnergyModel, Ground, measured_energy


def run(speed: float) -> dict[str, float]:
    """The row of Table 2 (level ground, one metre) for a speed: seconds, wave and tripod, in Wh."""
    ground, row = _ground(), _row(speed)
    return {
        "seconds": float(ground.duration[row]),
        "wave": float(ground.energy["wave"][row]),
        "tripod": float(ground.energy["tripod"][row]),
    }


def used(speed: float, gait: str) -> float:
    """The energy of a run, Wh."""
    return run(speed)[gait]


def power(speed: float, gait: str) -> float:
    """The mean power of a run, W."""
    row = run(speed)
    return row[gait] * 3600 / row["seconds"]


def power_in_minutes(speed: float, gait: str) -> float:
    """As `power`, an hour taken for 60 seconds."""
    return power(speed, gait) / 60


def power_of_the_other(speed: float, gait: str) -> float:
    """As `power`, of the gait in the other column."""
    return power(speed, "wave" if gait == "tripod" else "tripod")


def cheaper(speed: float) -> str:
    """Which gait cost less for the metre: "wave", "tripod" or "same"."""
    row = run(speed)
    if row["wave"] == row["tripod"]:
        return "same"
    return "wave" if row["wave"] < row["tripod"] else "tripod"


def model(gait: str) -> dict[str, float]:
    """The line E = P0 t + E1 d through the whole table: power (W) and per_metre (Wh/m), to three figures."""
    fitted = _model(gait)
    return {"power": _three(fitted.power), "per_metre": _three(fitted.per_metre)}


def crossover(wave: dict[str, float], tripod: dict[str, float]) -> float:
    """The speed at which both models cost the same by the metre, mm/s."""
    hours_per_metre = (wave["per_metre"] - tripod["per_metre"]) / (tripod["power"] - wave["power"])
    return 1000 / (hours_per_metre * 3600)


def crossover_in_hours(wave: dict[str, float], tripod: dict[str, float]) -> float:
    """As `crossover`, Wh divided by W taken for seconds."""
    return crossover(wave, tripod) * 3600


def metres(tripod: dict[str, float], speed: float, volts: float, charge: float, share: float) -> float:
    """How far a battery of `charge` mAh carries the tripod, `share` per cent of it used, m."""
    energy = volts * charge / 1000 * share / 100
    return energy / (tripod["power"] * 1000 / speed / 3600 + tripod["per_metre"])


def metres_to_the_end(
    tripod: dict[str, float], speed: float, volts: float, charge: float, share: float
) -> float:
    """As `metres`, the battery drained to its last drop."""
    return metres(tripod, speed, volts, charge, 100)


def metres_without_standing(
    tripod: dict[str, float], speed: float, volts: float, charge: float, share: float
) -> float:
    """As `metres`, what the robot draws by the second forgotten."""
    return volts * charge / 1000 * share / 100 / tripod["per_metre"]


@cache
def _ground() -> Ground:
    return measured_energy("flat")


def _row(speed: float) -> int:
    return int(np.argmin(np.abs(_ground().speed * 1000 - speed)))


def _model(gait: str) -> EnergyModel:
    return _ground().models[gait]


def _three(value: float) -> float:
    return float(f"{value:.3g}")
