"""The four experiments of the arm paper's chapter 4 on our rig, each with the paper's claims and our verdict."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from kinlab.control import Environment, PositionGains, SecondOrder
from kinlab.dynamics import Mechanism
from kinlab.dynamixel import Faults, MemoryPort
from kinlab.errors import UsageError
from kinlab.kinematics.resolved_motion import Track
from kinlab.names import resolve
from kinlab.papers import receptionist_torques
from kinlab.papers.equations import NONE
from kinlab.papers.receptionist_line import line, misprint_note, singularities
from kinlab.rig.arm import ArmServos, Push, Record, RunawayError, Settings, Setup, run
from kinlab.rig.arm.loop import KGF_CM, TABLE_4_1
from kinlab.robots import Limb, Robot

CONCLUSION_GAINS = PositionGains(3.8, 0.02)
ENVIRONMENTS = {"table-4.1": TABLE_4_1, "conclusion": Environment(0.2, 9, 5, 9)}
EXPERIMENTS = ("track", "comply", "observe")
# "A little pressure against the motion" (section 4.2.2); neither force nor time is printed.
PUSH = Push(0.4, 0.6, "hand", (-5.0, 0.0, 0.0))


class Claim(NamedTuple):
    """What the paper says, and what our rig says to it.

    Attributes:
        where: in the paper.
        claim: in words.
        measured: the figure that judges it, in `unit`.
        verdict: "reproduced" or "contradicted".
        cause: why.
    """

    where: str
    claim: str
    measured: float
    unit: str
    verdict: str
    cause: str


@dataclass(frozen=True)
class Outcome:
    """An experiment.

    Attributes:
        title: of it.
        runs: the records, by name.
        claims: what they say to the paper.
        notes: what else is to be known.
    """

    title: str
    runs: dict[str, Record]
    claims: tuple[Claim, ...]
    notes: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """As the command line prints it."""
        return {
            "experiment": self.title,
            "claims": [claim._asdict() | {"measured": round(claim.measured, 4)} for claim in self.claims],
            "notes": list(self.notes),
            "runs": {name: record.to_json() for name, record in self.runs.items()},
        }


Tell = Callable[[int, Record], None]


@dataclass(frozen=True)
class Port:
    """Where a real arm is: a serial port and its speed in bps."""

    name: str
    baud: int = 1_000_000

    def drive(
        self, limb: Limb, track: Track, settings: Settings, setup: Setup, tell: Tell | None = None
    ) -> Record:
        """One run on the real arm, from its track's first point; the torque is off afterwards, whatever happens.

        Raises:
            KinlabError: it does not come to the start, runs away, or falls silent.
        """
        with ArmServos.real(limb, self.name, self.baud, setup) as servos:
            servos.hold()
            servos.approach(track.q[0].tolist())
            return run(servos, track, settings, tell)


def drive(
    robot: Robot,
    limb: Limb,
    track: Track,
    settings: Settings,
    setup: Setup,
    pushes: Sequence[Push] = (),
    tell: Tell | None = None,
    drop: float = 0.0,
) -> Record:
    """One run on the emulated bus, which loses bytes by chance once the arm moves; the torque is off afterwards.

    Raises:
        UsageError: `drop` is no chance.
        KinlabError: the loop runs away, or a servo falls silent.
    """
    if not 0 <= drop < 1:
        raise UsageError(f"the chance that a byte is lost is at least 0 and less than 1, got {drop}")
    with ArmServos.emulated(robot, limb, track.q[0].tolist(), pushes, setup) as servos:
        servos.hold()
        if drop and isinstance(servos.bus.port, MemoryPort):
            servos.bus.port.chain.faults = Faults(drop=drop)
        return run(servos, track, settings, tell)


def experiment(robot: Robot, limb: Limb, name: str) -> Outcome:
    """An experiment of chapter 4 as the paper has it: track, comply or observe.

    Raises:
        UsageError: no such experiment.
    """
    name = resolve(name, EXPERIMENTS, "experiment")
    track, setup, settings = line(limb), Setup(), Settings("position" if name == "track" else "compliance")
    if name == "comply":
        return pushed(robot, limb, track, settings, setup)
    record = drive(robot, limb, track, settings, setup)
    if name == "observe":
        return free_motion(settings, record)
    return tracking(robot, limb, track, settings, setup, record)


def tracking(
    robot: Robot, limb: Limb, track: Track, settings: Settings, setup: Setup, record: Record
) -> Outcome:
    """Sections 4.1.1 and 4.1.2: what `record` says to the line without a position controller, or with one."""
    worst = float(np.degrees(np.abs(record.error)).max())
    notes = [*singularities(limb, track)]
    if settings.law == "none":
        verdict = "reproduced" if worst > 6 else "contradicted"
        cause = (
            "each goal is 2.5 mm ahead of where the arm is, and what the slope leaves over is never made good"
        )
        claim = Claim(
            "section 4.1.1", "more than 6 deg of error, up to 20 and more", worst, "deg", verdict, cause
        )
        return Outcome("without a position controller", {"none": record}, (claim,), tuple(notes))
    verdict, cause = "reproduced" if worst < 6 else "contradicted", "the loop is as fast as the line"
    if worst >= 6 and not settings.running_sum and min(settings.gains) > 0:
        model = SecondOrder.of_position(*settings.gains)
        cause = (
            f"by (2.11) and (2.12) a system of {model.omega:.2f} rad/s and zeta {model.zeta:.3f}, which rises in "
            f"{model.rise_time:.2f} s: too slow for a line of {len(track.q) * settings.dt:.2f} s"
        )
    elif worst >= 6:
        cause = "the servo's slope and the cycle's delay let it swing"
    claim = Claim("section 4.1.2", "less than 6 deg of error", worst, "deg", verdict, cause)
    notes.append(misprint_note(limb))
    for name, reading in other_readings(settings, setup).items():
        notes.append(f"{name}: {_largest(robot, limb, track, *reading)}")
    return Outcome("with position control", {"position": record}, (claim,), tuple(notes))


def other_readings(settings: Settings, setup: Setup) -> dict[str, tuple[Settings, Setup]]:
    """What the paper may have run instead: its integration is not printed, and the slope is that of another rig."""
    summed = replace(settings, running_sum=True)
    return {
        "rates summed up without the cycle time, slope 64": (summed, replace(setup, slope=64)),
        "rates summed up without the cycle time, slope 32, the factory's": (summed, replace(setup, slope=32)),
        "integrated in seconds, slope 32": (replace(settings, running_sum=False), replace(setup, slope=32)),
    }


def _largest(robot: Robot, limb: Limb, track: Track, settings: Settings, setup: Setup) -> str:
    try:
        error = np.degrees(np.abs(drive(robot, limb, track, settings, setup).error)).max()
    except RunawayError as away:
        return str(away)
    return f"{error:.1f} deg of error at most"


def free_motion(settings: Settings, record: Record) -> Outcome:
    """Section 4.2.1: the line untouched, measured torque against that by Newton and Euler."""
    worst = float(np.abs(record.torque_error).max() / KGF_CM)
    unfiltered = float(np.abs(record.torques["load"] - record.torques["dynamic"]).max() / KGF_CM)
    claim = Claim(
        "section 4.2.1",
        "torque errors of up to more than 1.5 kgf cm",
        worst,
        "kgf cm",
        "reproduced" if worst > 1.5 else "contradicted",
        f"dry friction in the gears and the arm's swinging, {unfiltered:.2f} kgf cm before the filter of alpha "
        f"{settings.alpha:g}, which lags by {settings.dt * (1 / settings.alpha - 1):.2f} s",
    )
    return Outcome("compliance in free motion", {"free": record}, (claim,), (_simplified(record),))


def _simplified(record: Record) -> str:
    """What the paper's own torque equations miss along the line."""
    arm, track = Mechanism.of(record.limb), record.track
    every = frozenset(m.equation for m in receptionist_torques.MISPRINTS)
    said = []
    for how, printed in (("as printed", every), ("corrected", NONE)):
        off = (
            np.abs(receptionist_torques.missed(arm, track.q, track.qd, track.qdd, printed)).max(axis=0)
            / KGF_CM
        )
        joints = ", ".join(f"{joint} {v:.2f}" for joint, v in zip(record.limb.joint_names, off, strict=True))
        said.append(f"{how} up to {joints}")
    return f"the paper's simplified torques (3.26) to (3.36) miss, in kgf cm: {'; '.join(said)}"


def _fighting(record: Record) -> float:
    """The mean load of the third servo while somebody pushes, in kgf cm."""
    under = np.abs(record.torques["pushed"]).max(axis=1) > 0
    return float(np.abs(record.torques["load"][under, -1]).mean() / KGF_CM) if under.any() else 0.0


def pushed(
    robot: Robot,
    limb: Limb,
    track: Track,
    settings: Settings,
    setup: Setup,
    pushes: Sequence[Push] = (PUSH,),
    tell: Tell | None = None,
) -> Outcome:
    """Section 4.2.2: the line, pushed, without compliance and with it."""
    runs, yielded, notes = {}, {}, []
    for law in ("position", "compliance"):
        with_law = replace(settings, law=law)
        runs[law] = drive(robot, limb, track, with_law, setup, pushes, tell)
        untouched = drive(robot, limb, track, with_law, setup)
        way = np.degrees(np.abs(runs[law].angles["real"] - untouched.angles["real"])).max(axis=0)
        yielded[law] = way
        names = ", ".join(f"{joint} {angle:.1f}" for joint, angle in zip(limb.joint_names, way, strict=True))
        notes.append(f"{law}: the push moves the arm by up to {names} deg")
    third = float(np.degrees(np.abs(runs["compliance"].error))[:, -1].max())
    ratio = float(yielded["compliance"][-1] / max(yielded["position"][-1], 1e-9))
    strong, soft = (_fighting(runs[law]) for law in ("position", "compliance"))
    with_print = (
        "(2.26) weighs the yielding with Kenv again: a steady torque moves the reference by Kf rad per kgf cm"
    )
    claims = (
        Claim(
            "section 4.2.2 b", "deviation of more than 15 deg for servo 3 under compliance", third, "deg",
            "reproduced" if third > 15 else "contradicted", with_print,
        ),
        Claim(
            "section 4.2.2 b", "with compliance the arm yields to the push more than without", ratio, "times",
            "reproduced" if ratio > 1 else "contradicted", "the third servo, pushed less untouched, with over without",
        ),
        Claim(
            "section 4.2.2 a", "without compliance the servo fights with a larger torque", strong - soft, "kgf cm",
            "reproduced" if strong > 1.1 * soft else "contradicted",
            f"mean load of the third servo under the push {strong:.1f} kgf cm without, {soft:.1f} with: "
            "once nothing moves, a servo carries what the hand exerts, whatever its law",
        ),
    )  # fmt: skip
    return Outcome("pushed, without and with compliance", runs, claims, tuple(notes))


def pushed_by_people(record: Record) -> Outcome:
    """Section 4.2.2 on a real arm, where nobody knows the force: how far it was moved under compliance."""
    third = float(np.degrees(np.abs(record.error))[:, -1].max())
    claim = Claim(
        "section 4.2.2 b", "deviation of more than 15 deg for servo 3 under compliance", third, "deg",
        "reproduced" if third > 15 else "contradicted", "a real arm, pushed by whoever stood there",
    )  # fmt: skip
    return Outcome("pushed by hand, with compliance", {"compliance": record}, (claim,))


def observing(record: Record) -> Outcome:
    """What (2.23) and the reaction-torque observer (2.37) make of a push, against the torque that it had."""
    applied = -record.torques["pushed"]
    notes = []
    estimates = {
        "external": "load through the filter less Newton-Euler (2.23)",
        "reaction": "observer (2.37)",
    }
    for name, what in estimates.items():
        off = record.torques[name] - applied
        rms, peak = np.sqrt((off**2).mean(axis=0)) / KGF_CM, np.abs(off).max() / KGF_CM
        joints = ", ".join(f"{j} {v:.2f}" for j, v in zip(record.limb.joint_names, rms, strict=True))
        notes.append(f"{what}: off by {joints} kgf cm (root mean square), at most {peak:.2f}")
    return Outcome("a push, and what the observers find", {"observed": record}, (), tuple(notes))
