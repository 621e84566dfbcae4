"""A walk that has been walked: what it cost, how far the feet were off, how near the servos were to their limits."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array
from kinlab.rig.follow import INSTANT, SECONDS
from kinlab.rig.record import Record
from kinlab.rig.rig import Rig
from kinlab.rig.walking import Errand

CURRENT_NOTE = (
    "the servos report no current: it is estimated as standby current plus stall current times load, for the share "
    "of the time that the motor's bridge is on (load plus speed over no-load speed)"
)


@dataclass(frozen=True)
class Steady:
    """Whole cycles at full speed, without the start and the stop.

    Attributes:
        cycles: how many.
        power: mean, W.
    """

    cycles: int
    power: float


@dataclass(frozen=True, eq=False, repr=False)
class WalkResult:
    """What came of an errand.

    Attributes:
        errand: what was to be done.
        record: what was measured.
        port: by name.
        emulated: whether the servos are emulated, with the robot's weight on them.
        unconfirmed: servos that did not confirm that their torque is off.
    """

    errand: Errand
    record: Record
    port: str
    emulated: bool
    unconfirmed: tuple[int, ...] = ()

    @classmethod
    def of(cls, errand: Errand, record: Record, rig: Rig) -> "WalkResult":
        """The result of `errand` on `rig`."""
        return cls(errand, record, rig.bus.port.name, rig.chain is not None, rig.unconfirmed)

    @property
    def duration(self) -> float:
        """Of what was measured, s."""
        return float(self.record.t[-1])

    @property
    def complete(self) -> bool:
        """Whether it was walked to its end."""
        return bool(self.record.way[-1] > self.errand.walk.duration - INSTANT)

    @cached_property
    def covered(self) -> Array:
        """How far the body should have come at each tick (F,), m, or rad where it only turns."""
        walk = self.errand.walk
        return walk.travel(self.record.way) * (walk.speed or abs(walk.turn))

    @property
    def energy(self) -> float:
        """Wh: krsri-hexapod, (28)."""
        return float(self.record.joules[-1]) / SECONDS

    @property
    def power(self) -> float:
        """Mean, W."""
        return float(self.record.joules[-1]) / self.duration if self.duration else 0.0

    @cached_property
    def steady(self) -> Steady | None:
        """Its steady part; None where it has not one whole cycle, or its tempo was changed."""
        walk, record = self.errand.walk, self.record
        pace = walk.pace
        assert pace is not None
        begin = pace.begin + pace.ramp
        cycles = int((pace.end - pace.ramp - begin) / walk.period + 1e-9)
        end = begin + cycles * walk.period
        if cycles < 1 or record.way[-1] < end or np.abs(record.way - record.t)[:-1].max() > walk.period / 100:
            return None
        joules = np.interp([begin, end], record.way, record.joules)
        return Steady(cycles, float(joules[1] - joules[0]) / (end - begin))

    @property
    def per_metre(self) -> float | None:
        """Wh per metre of steady walking; None without a steady part, or without a way."""
        speed = self.errand.walk.speed
        return self.steady.power / speed / SECONDS if self.steady and speed else None

    @property
    def notes(self) -> tuple[str, ...]:
        """What is estimated or assumed, in sentences."""
        robot = self.errand.walk.robot
        found = [CURRENT_NOTE, *_standby_notes(self.record)]
        mass = next((d for d in robot.dimensions if d.name == "mass"), None)
        if not self.emulated:
            found.append("an emulated chain behind a port knows no weight; real legs carry theirs")
        elif mass is None:
            found.append("nobody gives the robot's mass: its legs carry nothing")
        else:
            found.append(
                f"the standing legs carry {mass.value:g} g ({mass.source.kind}: {mass.source.text}), quasi-static"
            )
        return tuple(found)

    def to_json(self) -> dict[str, Any]:
        """The document of `kinlab walk --json`: mm, deg, Wh."""
        errand, record = self.errand, self.record
        walk = errand.walk
        amps, watts = record.amps.sum(axis=1), record.watts.sum(axis=1)
        fastest = errand.limits.fastest
        return {
            "robot": walk.robot.name,
            "gait": walk.gait.name,
            "speed_mm_s": errand.order.speed * 1000,
            "turn_deg_s": float(np.degrees(errand.order.turn)),
            "distance_mm": errand.order.distance * 1000 if errand.order.speed else 0.0,
            "period_s": walk.period,
            "port": self.port,
            "emulated": self.emulated,
            "complete": self.complete,
            "duration_s": self.duration,
            "rate_hz": errand.order.rate,
            "achieved_rate_hz": (len(record.t) - 1) / self.duration if self.duration else 0.0,
            "ticks": len(record.t),
            "energy": {
                "wh": self.energy,
                "idle_wh": record.idle_joules / SECONDS,
                "motor_current_wh": record.motor_joules / SECONDS,
                "steady_power_w": self.steady.power if self.steady else None,
                "wh_per_m": self.per_metre,
                "mean_power_w": self.power,
                "mean_voltage_v": _mean(record.volts),
                "mean_current_a": _mean(amps),
                "peak_current_a": _most(amps),
                "peak_power_w": _most(watts),
            },
            "tracking": self._tracking(),
            "joints": self._joints(),
            "fastest_mm_s": None if fastest is None else fastest * 1000,
            "lost": {str(number): count for number, count in record.lost.items()},
            "alarms": {str(number): names for number, names in record.alarms.items()},
            "torque_off_unconfirmed": list(self.unconfirmed),
            "notes": list(self.notes),
        }

    def row(self) -> dict[str, float | None]:
        """One line of a sweep, the gait apart."""
        found = self.to_json()
        energy, tracking = found["energy"], found["tracking"]
        tightest = max(found["joints"], key=lambda joint: joint["used"])
        return {
            "speed_mm_s": found["speed_mm_s"],
            "turn_deg_s": found["turn_deg_s"],
            "distance_mm": found["distance_mm"],
            "rate_hz": found["rate_hz"],
            "duration_s": self.duration,
            "wh": energy["wh"],
            "idle_wh": energy["idle_wh"],
            "wh_per_m": energy["wh_per_m"],
            "steady_power_w": energy["steady_power_w"],
            "mean_current_a": energy["mean_current_a"],
            "mean_error_mm": tracking["mean_mm"],
            "max_error_mm": tracking["max_mm"],
            "joint_speed_used": tightest["used"],
            "lost": sum(found["lost"].values()),
        }

    def series(self) -> list[dict[str, float]]:
        """The walk tick by tick, each value by its name with its unit."""
        record = self.record
        name, scale = ("way_mm", 1000.0) if self.errand.order.speed else ("way_deg", 180 / np.pi)
        ways, errors = self.covered * scale, record.errors * 1000
        legs = [f"{limb.name}_error_mm" for limb in record.wiring.limbs]
        return [
            {
                "time_s": sample.t,
                name: way,
                "voltage_v": sample.voltage,
                "current_a": sample.current,
                "power_w": sample.power,
                "energy_wh": sample.energy,
                **dict(zip(legs, off, strict=True)),
            }
            for sample, way, off in zip(record.samples, ways.tolist(), errors.tolist(), strict=True)
        ]

    def error_curves(self) -> dict[str, list[tuple[float, float]]]:
        """The tracking error of the foot that is furthest off, and the mean of all, for two cycles in the middle.

        By name, points of time in s and error in mm; NaN where a servo did not answer.
        """
        t, errors = self.record.t, self.record.errors * 1000
        near = np.abs(t - t[-1] / 2) <= self.errand.walk.period
        seen = errors[near]
        worst = int(np.argmax(np.nan_to_num(seen).max(axis=0)))
        curves = {self.record.wiring.limbs[worst].name: seen[:, worst], "mean": seen.mean(axis=1)}
        return {
            name: list(zip(t[near].tolist(), values.tolist(), strict=True)) for name, values in curves.items()
        }

    def _tracking(self) -> dict[str, Any]:
        errors = self.record.errors * 1000
        names = [limb.name for limb in self.record.wiring.limbs]
        return {
            "mean_mm": _mean(errors),
            "rms_mm": None if _mean(errors) is None else float(np.sqrt(np.nanmean(errors**2))),
            "max_mm": _most(errors),
            "legs": {
                name: {"mean_mm": _mean(errors[:, i]), "max_mm": _most(errors[:, i])}
                for i, name in enumerate(names)
            },
        }

    def _joints(self) -> list[dict[str, Any]]:
        record, limits = self.record, self.errand.limits
        wiring = record.wiring
        planned, allowed = (np.degrees(v).ravel().tolist() for v in (limits.speeds, limits.allowed))
        return [
            {
                "leg": leg,
                "joint": joint,
                "servo": servo.id,
                "model": servo.model.name,
                "planned_deg_s": planned[j],
                "measured_deg_s": _most(np.degrees(np.abs(record.velocity[:, j]))),
                "limit_deg_s": allowed[j],
                "used": planned[j] / allowed[j],
                "mean_load": _mean(np.abs(record.load[:, j])),
                "peak_load": _most(np.abs(record.load[:, j])),
                "peak_torque_nm": _times(_most(np.abs(record.load[:, j])), float(wiring.stall_torque[j])),
                "mean_current_a": _mean(record.amps[:, j]),
            }
            for j, ((leg, joint), servo) in enumerate(zip(wiring.joints, wiring.servos, strict=True))
        ]


def costs(results: Sequence[WalkResult]) -> list[float]:
    """Wh per metre of steady walking, walk by walk.

    Raises:
        KinlabError: a walk has no steady part.
    """
    found = []
    for result in results:
        if result.per_metre is None:
            walk = result.errand.walk
            raise KinlabError(
                f"{walk.gait.name} at {walk.speed * 1000:g} mm/s has no whole cycle at full speed"
            )
        found.append(result.per_metre)
    return found


def _standby_notes(record: Record) -> list[str]:
    models = {servo.model.name: servo.model for servo in record.wiring.servos}
    notes = []
    for model in models.values():
        if model.standby is None:
            notes.append(f"nobody gives the standby current of {model.name}: it is left out")
        else:
            source = model.standby_source
            notes.append(
                f"standby current of {model.name}: {model.standby * 1000:g} mA ({source.kind}: {source.text})"
            )
    return notes


def _mean(values: Array) -> float | None:
    return float(np.nanmean(values)) if np.isfinite(values).any() else None


def _most(values: Array) -> float | None:
    return float(np.nanmax(values)) if np.isfinite(values).any() else None


def _times(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor
