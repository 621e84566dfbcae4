"""What walking costs: Tables 2 to 5 of krsri-hexapod, a model of two terms, and where two gaits cost the same.

A robot that walks pays for standing by the second and for walking by the metre: E = P0 t + E1 d. The
first term is what a gait costs however slowly it goes, the second what each metre costs however fast.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.kinematics.transforms import Array
from kinlab.papers.tables import printed_table
from kinlab.robots import Robot

PAPER = "krsri-hexapod"
GAITS = ("wave", "tripod")
# The tables of energy and of distance on each ground.
GROUNDS = {"flat": ("2", "3"), "broken": ("4", "5")}
SECONDS = 3600.0


@dataclass(frozen=True, eq=False)
class EnergyModel:
    """E = P0 t + E1 d, fitted by least squares.

    Attributes:
        power: P0, W.
        per_metre: E1, Wh/m.
        covariance: of the two, (2, 2), in those units, from the residuals.
        residual: root of the mean square of what the fit leaves, Wh.
    """

    power: float
    per_metre: float
    covariance: Array
    residual: float

    def energy(self, duration: ArrayLike, distance: ArrayLike) -> Array:
        """Wh for durations in s and distances in m."""
        return np.asarray(
            self.power * np.asarray(duration, float) / SECONDS + self.per_metre * np.asarray(distance, float)
        )

    def at_speed(self, speed: ArrayLike) -> Array:
        """Wh per metre at speeds in m/s."""
        return self.energy(1 / np.asarray(speed, float), 1.0)

    def to_json(self) -> dict[str, float]:
        """W, Wh and their standard errors."""
        power, per_metre = np.sqrt(np.diag(self.covariance)).tolist()
        return {
            "power_w": self.power,
            "power_error_w": power,
            "per_metre_wh": self.per_metre,
            "per_metre_error_wh": per_metre,
            "residual_wh": self.residual,
        }


def fit(duration: ArrayLike, distance: ArrayLike, energy: ArrayLike) -> EnergyModel:
    """The model of runs (N,): s, m, Wh. At least three are needed to say how well it fits."""
    t, d, E = (np.asarray(v, float) for v in (duration, distance, energy))
    A = np.stack([t / SECONDS, d], axis=-1)
    inverse = np.linalg.inv(A.T @ A)
    power, per_metre = (inverse @ A.T @ E).tolist()
    left = E - A @ [power, per_metre]
    covariance = inverse * (left @ left) / (len(E) - 2)
    return EnergyModel(power, per_metre, covariance, float(np.sqrt(np.mean(left**2))))


@dataclass(frozen=True)
class Crossover:
    """Where two gaits cost the same.

    Attributes:
        speed: m/s; below it the first costs less by the second. None where the models do not cross.
        error: its standard error, m/s, to first order from the models' covariances.
    """

    speed: float | None
    error: float | None

    def to_json(self) -> dict[str, float | None]:
        """In mm/s."""
        return {
            "crossover_mm_s": None if self.speed is None else self.speed * 1000,
            "crossover_error_mm_s": None if self.error is None else self.error * 1000,
        }


def crossover(one: EnergyModel, other: EnergyModel) -> Crossover:
    """The speed at which a metre costs the same in both: v = -(P0 - P0') / (E1 - E1')."""
    power = (one.power - other.power) / SECONDS
    metre = one.per_metre - other.per_metre
    if power * metre >= 0:
        return Crossover(None, None)
    speed = -power / metre
    # Both models' errors are independent of each other.
    gradient = np.array([-1 / (metre * SECONDS), power / metre**2])
    variance = gradient @ (one.covariance + other.covariance) @ gradient
    return Crossover(float(speed), float(np.sqrt(variance)))


@dataclass(frozen=True, eq=False)
class Ground:
    """What the paper measured on one ground, and what follows from it.

    Attributes:
        name: "flat" or "broken".
        energy_table, distance_table: their numbers.
        speed, duration, distance: of the runs (N,), m/s, s, m.
        energy: by gait (N,), Wh.
        reached: by gait (N,), percent of the way.
        models: by gait.
        crossover: of wave and tripod.
        averages: of `reached`, by gait: computed and printed.
    """

    name: str
    energy_table: str
    distance_table: str
    speed: Array
    duration: Array
    distance: Array
    energy: dict[str, Array]
    reached: dict[str, Array]
    models: dict[str, EnergyModel]
    crossover: Crossover
    averages: dict[str, tuple[float, float]]

    def to_json(self) -> dict[str, Any]:
        """Rows in the units of the tables, models, crossover and averages."""
        rows = []
        for i, speed in enumerate(self.speed * 1000):
            row: dict[str, float] = {"speed_mm_s": float(speed), "duration_s": float(self.duration[i])}
            for gait in GAITS:
                row[f"{gait}_wh"] = float(self.energy[gait][i])
                row[f"{gait}_model_wh"] = float(self.models[gait].energy(self.duration[i], self.distance[i]))
                row[f"{gait}_reached_percent"] = float(self.reached[gait][i])
            rows.append(row)
        return {
            "ground": self.name,
            "where": f"Tables {self.energy_table} and {self.distance_table}",
            "rows": rows,
            "models": {gait: model.to_json() for gait, model in self.models.items()},
            **self.crossover.to_json(),
            "averages": {
                gait: {"recomputed_percent": computed, "printed_percent": printed}
                for gait, (computed, printed) in self.averages.items()
            },
        }


def measured_energy(name: str) -> Ground:
    """The paper's runs on "flat" or "broken" ground: Tables 2 and 3, or 4 and 5."""
    energy_table, distance_table = GROUNDS[name]
    runs, ways = printed_table(PAPER, energy_table), printed_table(PAPER, distance_table)
    speed, duration, distance = (runs.column(key) for key in ("speed", "duration", "distance"))
    energy = {gait: runs.column(gait) for gait in GAITS}
    # In cm or percent: a way of 100 cm makes them the same.
    reached = {gait: ways.column(gait) for gait in GAITS}
    averages = ways.rows["average"]
    models = {gait: fit(duration, distance / 100, energy[gait]) for gait in GAITS}
    return Ground(
        name, energy_table, distance_table, speed / 1000, duration, distance / 100, energy, reached, models,
        crossover(models["wave"], models["tripod"]),
        {gait: (float(reached[gait].mean()), averages[gait].figure.value) for gait in GAITS},
    )  # fmt: skip


def energy_of(robot: Robot) -> tuple[Ground, ...]:
    """What the robot's paper measured, ground by ground.

    Raises:
        UsageError: it measured no energy.
    """
    if robot.paper != PAPER:
        raise UsageError(f"the paper of {robot.name} measures no energy; that of {PAPER} does")
    return tuple(measured_energy(name) for name in GROUNDS)


def electric_energy(current: ArrayLike, voltage: ArrayLike, dt: float) -> float:
    """Wh of currents (N,) in A and voltages (N,) in V, one every `dt` s: krsri-hexapod, (28)."""
    return float(np.sum(np.asarray(current, float) * np.asarray(voltage, float) * dt) / SECONDS)


def distance_covered(planned: ArrayLike, error_x: ArrayLike, error_y: ArrayLike) -> Array:
    """The way really covered, in the unit of the arguments: krsri-hexapod, (29), L = sqrt((L1 - ey)^2 + ex^2).

    Args:
        planned: L1, along y of the paper, its forwards.
        error_x: how far aside of the goal the robot stopped.
        error_y: how far short of it.
    """
    return np.asarray(np.hypot(np.asarray(planned, float) - np.asarray(error_y, float), error_x))
