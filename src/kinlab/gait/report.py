"""What `kinlab gait` shows: a walk, its phases, margins and limits, as one object that turns into JSON."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from kinlab.errors import UsageError
from kinlab.gait.landing import DECELERATION, HEEL_STRIKE, Landing, landings
from kinlab.gait.limits import Limits, assess
from kinlab.gait.schedule import Phase
from kinlab.gait.stability import Least, Stability, least_margins, mass_note, stability, theory
from kinlab.gait.swing import CURVES, Jumps, jumps
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array
from kinlab.robots.target import angles_deg
from kinlab.units import shown_mm

# Frames of a cycle in the JSON, and of each cycle of the walk whose slip is measured.
FRAMES = 60
CYCLES = 3


@dataclass(frozen=True, eq=False)
class GaitReport:
    """A walk that goes on for ever, and what is to be known about it.

    Attributes:
        walk: the walk.
        limits: how near it comes to its servos' limits.
        least: the smallest margins of each phase.
        theory: the wave gait's formula, metres; None where it does not apply.
        landings: how the feet come down, without and with each of eros's optimisations, by name.
    """

    walk: Walk
    limits: Limits
    least: tuple[Least, ...]
    theory: float | None
    landings: dict[str, Landing]

    @cached_property
    def slip(self) -> float:
        """The farthest that a standing foot moves in a walk of some cycles from standing and back, metres."""
        walk = self.walk
        distance = CYCLES * walk.period * (walk.speed or abs(walk.turn) or 1 / walk.period)
        journey = walk.over(distance)
        frames = int(FRAMES * journey.duration / walk.period) + 1
        return journey.at(np.linspace(0.0, journey.duration, frames)).slip()

    def phase(self, number: int) -> Phase:
        """The phase of that number.

        Raises:
            UsageError: the gait has fewer, or numbers begin at 1.
        """
        phases = self.walk.gait.phases
        if not 1 <= number <= len(phases):
            raise UsageError(f"gait {self.walk.gait.name} has phases 1 to {len(phases)}, got {number}")
        return phases[number - 1]

    def still(self, phase: Phase, share: float = 0.5) -> Stability:
        """One frame within `phase`, a share of it after its start."""
        legs = [leg.name for leg in self.walk.robot.legs]
        at = float(phase.start + (phase.end - phase.start) * share) * self.walk.period
        return stability(self.walk.at(at), [leg in phase.stance for leg in legs])

    @cached_property
    def trace(self) -> Array:
        """The static margin at evenly spaced instants of a cycle (N,), metres."""
        times = np.arange(4 * FRAMES) / (4 * FRAMES) * self.walk.period
        return stability(self.walk.at(times)).static

    @property
    def support(self) -> dict[str, tuple[float, float]]:
        """The smallest margins of centre of mass and zero moment point on one foot and on two, metres."""
        found = {}
        for name, feet in (("single", 1), ("double", 2)):
            phases = [least for least in self.least if len(least.phase.stance) == feet]
            if phases:
                found[name] = (min(least.static for least in phases), min(least.zmp for least in phases))
        return found

    @property
    def jumps(self) -> dict[str, Jumps]:
        """What each curve would do at both ends of this walk's swing, in m/s and m/s2."""
        walk = self.walk
        time = walk.swing_time
        found = {}
        for curve in {**CURVES, walk.curve.name: walk.curve}.values():
            jump = jumps(curve, walk.duty)
            scales = (walk.stroke / time, walk.lift / time, walk.stroke / time**2, walk.lift / time**2)
            found[curve.name] = Jumps(
                *((first * scale, last * scale) for (first, last), scale in zip(jump, scales, strict=True))
            )
        return found

    @property
    def notes(self) -> tuple[str, ...]:
        """Whether it would fall, and what is assumed, in sentences."""
        walk = self.walk
        found = [self._balance] if min(least.static for least in self.least) < 0 else []
        found += [f"gait {walk.gait.name} is {walk.gait.source.kind}: {walk.gait.source.text}"]
        found.append(f"mass: {mass_note(walk.robot)}")
        found.append("stride and lift are assumed where none was asked for: no paper prints a stroke")
        if self.theory is not None:
            found.append("the formula's feet stand in two straight lines; those of a real robot need not")
        if walk.robot.kind == "humanoid":
            found += [DECELERATION, HEEL_STRIKE]
        return tuple(found)

    @property
    def _balance(self) -> str:
        """What a negative static margin means."""
        least = min(self.least, key=lambda found: found.static)
        zmp = min(found.zmp for found in self.least) * 1000
        said = (
            f"in phase {least.phase.number} the centre of mass lies up to {-least.static * 1000:.1f} mm outside the "
            "feet on the ground: a robot that stopped there would fall"
        )
        if zmp >= 0:
            return f"{said}; while it walks, its zero moment point stays {zmp:.1f} mm inside them"
        return (
            f"{said}; while it walks, its zero moment point lies up to {-zmp:.1f} mm outside too, and it tips"
        )

    def to_json(self, frames: int = FRAMES) -> dict[str, Any]:
        """The contract of `kinlab gait --json`; `frames` of one cycle, evenly spaced."""
        walk, gait = self.walk, self.walk.gait
        least = min(self.least, key=lambda found: found.static)
        ahead = [found.longitudinal for found in self.least]
        fastest = self.limits.fastest
        leg, joint = self.limits.tightest
        return {
            "robot": walk.robot.name,
            "gait": gait.name,
            "kind": gait.kind,
            "duty_factor": walk.duty,
            "touchdown": {name: float(phase) for name, phase in gait.touchdown.items()},
            "period_s": walk.period,
            "speed_mm_s": walk.velocity[0] * 1000,
            "sideways_mm_s": walk.velocity[1] * 1000,
            "turn_deg_s": float(np.degrees(walk.turn)),
            "stride_mm": walk.stride * 1000,
            "stroke_mm": walk.stroke * 1000,
            "lift_mm": walk.lift * 1000,
            "sway_mm": walk.sway * 1000,
            "trajectory": walk.curve.name,
            "margins": {
                "static_mm": least.static * 1000,
                "longitudinal_mm": None if None in ahead else min(v for v in ahead if v is not None) * 1000,
                "energy_mm": min(found.energy for found in self.least) * 1000,
                "zmp_mm": min(found.zmp for found in self.least) * 1000,
                "theory_mm": None if self.theory is None else self.theory * 1000,
            },
            "support": {
                name: {"static_mm": static * 1000, "zmp_mm": zmp * 1000}
                for name, (static, zmp) in self.support.items()
            },
            "slip_mm": self.slip * 1000,
            "limits": {
                "leg": leg,
                "joint": joint,
                "model": self.limits.model,
                "deg_s": float(np.degrees(self.limits.speed)),
                "used": self.limits.used,
                "fastest_mm_s": None if fastest is None else fastest * 1000,
            },
            "jumps": {name: _jumps_json(jump) for name, jump in self.jumps.items()},
            "landing": {name: _landing_json(found) for name, found in self.landings.items()},
            "events": [self._event_json(found) for found in self.least],
            "frames": _frames_json(stability(walk.at(np.arange(frames) / frames * walk.period))),
            "notes": list(self.notes),
        }

    def _event_json(self, least: Least) -> dict[str, Any]:
        phase = least.phase
        return {
            "number": phase.number,
            "phase": float(phase.start),
            "phase_exact": str(phase.start),
            "t_s": float(phase.start) * self.walk.period,
            "swing": list(phase.swing),
            "stance": list(phase.stance),
            "stability_margin_mm": least.static * 1000,
            "longitudinal_margin_mm": None if least.longitudinal is None else least.longitudinal * 1000,
            "energy_margin_mm": least.energy * 1000,
            "zmp_margin_mm": least.zmp * 1000,
        }


def report(walk: Walk, *, keep_period: bool = False) -> GaitReport:
    """Everything about `walk`, an endless one.

    Raises:
        KinlabError: the robot cannot walk like this, see `assess`.
    """
    limits = assess(walk, keep_period=keep_period)
    return GaitReport(walk, limits, least_margins(walk), theory(walk), landings(walk))


def _jumps_json(jump: Jumps) -> dict[str, list[float]]:
    names = (
        "velocity_along_mm_s",
        "velocity_height_mm_s",
        "acceleration_along_mm_s2",
        "acceleration_height_mm_s2",
    )
    return {name: [v * 1000 for v in pair] for name, pair in zip(names, jump, strict=True)}


def _landing_json(found: Landing) -> dict[str, float]:
    return {
        "down_mm_s": found.down * 1000,
        "along_mm_s": found.along * 1000,
        "toe_down_deg": float(np.degrees(found.toe_down)),
        "toe_up_deg": float(np.degrees(found.toe_up)),
    }


def _frames_json(state: Stability) -> list[dict[str, Any]]:
    motion = state.motion
    legs = motion.walk.robot.legs
    margins = {
        "stability_margin_mm": state.static,
        "longitudinal_margin_mm": state.longitudinal,
        "energy_margin_mm": state.energy,
        "zmp_margin_mm": state.zmp_margin,
    }
    return [
        {
            "t_s": float(motion.t[i]),
            "feet_mm": {leg.name: shown_mm(motion.feet[i, k]) for k, leg in enumerate(legs)},
            "angles_deg": {leg.name: angles_deg(leg, motion.q[i, k]) for k, leg in enumerate(legs)},
            "swing": [leg.name for k, leg in enumerate(legs) if motion.swing[i, k]],
            # A pacing robot's side has no edge ahead of the centre of mass, nor behind it.
            **{name: None if np.isnan(v[i]) else float(v[i]) * 1000 for name, v in margins.items()},
        }
        for i in range(len(motion.t))
    ]
