"""What the commands of `kinlab arm` have in common: the arm, its line, its gains, a run, and the answer."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import typer

from kinlab.cli.arm_options import (
    BAUD,
    Alpha,
    Baud,
    Csv,
    Denv,
    EnvironmentName,
    Kenv,
    Kf,
    Kp,
    Kv,
    Live,
    Margin,
    Menv,
    Profile,
    Punch,
    Pushes,
    Real,
    Slope,
    SpeedLimit,
    Summed,
    TorqueLimit,
)
from kinlab.cli.command import (
    ForceOption,
    JsonOption,
    LimbOption,
    RobotsOption,
    RrdOption,
    check_rrd,
    print_json,
    write_rrd,
)

if TYPE_CHECKING:
    from kinlab.kinematics.resolved_motion import Track
    from kinlab.papers.receptionist_experiments import Outcome, Tell
    from kinlab.rig.arm import Push, Record, Settings, Setup
    from kinlab.robots import Limb, Robot
    from kinlab.scene import Recording

# Nobody knows yet how a real arm takes these gains: this share of its torque, and this speed (deg/s), at most.
REAL_TORQUE, REAL_SPEED = 0.4, 200.0


class Bench(NamedTuple):
    """What the experiments under compliance are made with."""

    robot: "Robot"
    limb: "Limb"
    path: "Track"
    settings: "Settings"
    setup: "Setup"
    pushes: "tuple[Push, ...]"
    real: str | None
    baud: int
    tell: "Tell | None"

    def record(self) -> "Record":
        """One run."""
        return record_of(*self)


def under_compliance(work: "Callable[[Bench], tuple[Outcome, str]]") -> Callable[..., None]:
    """A command with the options of compliance control; `work` gives the outcome and what is plotted of it."""

    def command(
        push: Pushes = None,
        environment: EnvironmentName = "table-4.1",
        kf: Kf = None,
        kenv: Kenv = None,
        denv: Denv = None,
        menv: Menv = None,
        kp: Kp = 3.8,
        kv: Kv = 0.2,
        summed: Summed = False,
        alpha: Alpha = 0.05,
        profile: Profile = "steps",
        slope: Slope = 64,
        margin: Margin = 0,
        punch: Punch = 32,
        torque_limit: TorqueLimit = 1.0,
        speed_limit: SpeedLimit = 700.0,
        real: Real = None,
        baud: Baud = BAUD,
        live: Live = False,
        csv: Csv = None,
        rrd: RrdOption = None,
        force: ForceOption = False,
        limb: LimbOption = None,
        robots: RobotsOption = None,
        json: JsonOption = False,
    ) -> None:
        from kinlab.cli.arm_tables import watching
        from kinlab.files import check_writable

        if csv:
            check_writable(csv)
        check_rrd(rrd, force)
        machine, arm = arm_of(robots, limb)
        path = line_of(arm, profile, None, None, 1.28)
        settings = compliance_of(environment, (kf, kenv, denv, menv), (kp, kv), summed, alpha)
        setup = setup_of(slope, margin, punch, torque_limit, speed_limit, real)
        with watching(live, real is not None) as tell:
            outcome, plot = work(
                Bench(machine, arm, path, settings, setup, pushes_of(push), real, baud, tell)
            )
        answer(outcome, plot, csv, json)
        write_rrd(rrd, force, lambda: scene_of(machine, outcome))

    command.__doc__ = work.__doc__
    return command


def arm_of(robots: Path | None, limb: str | None) -> "tuple[Robot, Limb]":
    """The robot and the limb."""
    from kinlab.robots import load_robot

    machine = load_robot("receptionist-arm", robots)
    return machine, machine.limb(limb)


def line_of(arm: "Limb", profile: str, start: Any, end: Any, seconds: float) -> "Track":
    """A line in mm of the paper frame; the experiment's own where nothing is given."""
    from kinlab.papers.receptionist_line import FROM, TO, line
    from kinlab.units import check_place, to_metres

    places = []
    for given, printed, what in ((start, FROM, "--from"), (end, TO, "--to")):
        if given is not None:
            check_place(given, what)
        places.append(printed if given is None else to_metres(given))
    return line(arm, profile, places[0], places[1], seconds)


def compliance_of(name: str, own: Any, gains: Any, summed: bool, alpha: float) -> "Settings":
    """Compliance control with a printed set of gains, and those that are changed."""
    from kinlab.control import PositionGains
    from kinlab.names import resolve
    from kinlab.papers.receptionist_experiments import ENVIRONMENTS
    from kinlab.rig.arm import Settings

    printed = ENVIRONMENTS[resolve(name, ENVIRONMENTS, "set of environment gains")]
    changed = {k: v for k, v in zip(printed._fields, own, strict=True) if v is not None}
    return Settings("compliance", PositionGains(*gains), printed._replace(**changed), summed, alpha)


def setup_of(
    slope: int, margin: int, punch: int, torque_limit: float, speed_limit: float, real: str | None
) -> "Setup":
    """How the servos are set up; real ones give less and go slower."""
    from kinlab.rig.arm import Setup
    from kinlab.units import to_radians

    if real:
        torque_limit, speed_limit = min(torque_limit, REAL_TORQUE), min(speed_limit, REAL_SPEED)
    return Setup(slope, margin, punch, torque_limit, to_radians(speed_limit))


def pushes_of(texts: list[str] | None) -> "tuple[Push, ...]":
    """Hands that push."""
    from kinlab.rig.arm import parse_push

    return tuple(parse_push(text) for text in texts or ())


def record_of(
    machine: "Robot",
    arm: "Limb",
    path: "Track",
    settings: "Settings",
    setup: "Setup",
    pushes: "tuple[Push, ...]",
    real: str | None,
    baud: int,
    tell: "Tell | None",
    drop: float = 0.0,
) -> "Record":
    """A run, emulated or real; after a Ctrl-C the torque is off, and so it is said."""
    from kinlab.errors import UsageError
    from kinlab.papers.receptionist_experiments import Port, drive

    if real and pushes:
        raise UsageError("a real arm is pushed by hand; --push is for the emulated one")
    if real and drop:
        raise UsageError("a real bus loses what it loses; --drop is for the emulated one")
    if not real and baud != BAUD:
        raise UsageError("--baud is the speed of a real bus: it goes with --real")
    try:
        if real:
            return Port(real, baud).drive(arm, path, settings, setup, tell)
        return drive(machine, arm, path, settings, setup, pushes, tell, drop)
    except KeyboardInterrupt:
        typer.echo("kinlab: interrupted; the torque is off", err=True)
        raise typer.Exit(130) from None


def scene_of(machine: "Robot", outcome: "Outcome") -> "Recording":
    """An experiment in 3-D."""
    from kinlab.scene import arm_scene

    return arm_scene(machine, outcome)


def answer(outcome: "Outcome", plot: str, csv: Path | None, json: bool) -> None:
    """Print JSON, or show plots and verdicts, and only then write CSV: a disk may be full."""
    from kinlab.cli.arm_tables import show_outcome

    if json:
        print_json(outcome.to_json())
    else:
        show_outcome(outcome, plot)
    if csv:
        for i, (name, record) in enumerate(outcome.runs.items()):
            record.to_csv(csv if i == 0 else csv.with_stem(f"{csv.stem}-{name}"))
