"""`kinlab arm`: the receptionist's arm follows a line, yields to a hand, and observes what pushes it."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kinlab.cli.arm_options import (
    Alpha,
    Baud,
    Csv,
    Denv,
    Drop,
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
from kinlab.cli.command import JsonOption, LimbOption, NumericCommand, RobotsOption, command_app, print_json

if TYPE_CHECKING:
    from kinlab.kinematics.resolved_motion import Track
    from kinlab.papers.receptionist_experiments import Outcome, Tell
    from kinlab.rig.arm import Push, Record, Settings, Setup
    from kinlab.robots import Limb, Robot

REAL_TORQUE = 0.4

app = command_app()


@app.callback(
    no_args_is_help=True, epilog='Example: kinlab arm comply --push "t=0.5 dur=0.4 at=hand force=0,-5,0"'
)
def _arm() -> None:
    """The receptionist's arm on RX-24F servos: the experiments of its paper, emulated or real.

    Every command takes --json and --csv FILE.
    """


@app.command("track", cls=NumericCommand, epilog="Example: kinlab arm track --law none")
def _track(
    law: Annotated[str, typer.Option(help="none (section 4.1.1) or position (4.1.2).")] = "position",
    kp: Kp = 3.8,
    kv: Kv = 0.2,
    summed: Summed = False,
    profile: Profile = "steps",
    start: Annotated[
        tuple[float, float, float] | None, typer.Option("--from", help="In mm, paper frame.")
    ] = None,
    end: Annotated[
        tuple[float, float, float] | None, typer.Option("--to", help="In mm, paper frame.")
    ] = None,
    seconds: Annotated[float, typer.Option(help="Time for the line.")] = 1.28,
    slope: Slope = 64,
    margin: Margin = 0,
    punch: Punch = 32,
    torque_limit: TorqueLimit = 1.0,
    speed_limit: SpeedLimit = 700.0,
    real: Real = None,
    baud: Baud = 1_000_000,
    drop: Drop = 0.0,
    live: Live = False,
    csv: Csv = None,
    trace: Annotated[
        Path | None, typer.Option(help="Write the packets of the cycle half-way, for `kinlab packet FILE`.")
    ] = None,
    limb: LimbOption = None,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Follow a straight line without a position controller, or with one."""
    from kinlab.control import PositionGains
    from kinlab.errors import FileError, UsageError
    from kinlab.papers.receptionist_experiments import one_cycle, tracking
    from kinlab.rig.arm import Settings

    if law.casefold() == "compliance":
        raise UsageError("compliance is what `kinlab arm comply` is for")
    machine, arm = _arm_of(robots, limb)
    path = _line(arm, profile, start, end, seconds)
    settings = Settings(law, PositionGains(kp, kv), running_sum=summed)
    setup = _setup(slope, margin, punch, torque_limit, speed_limit, real)
    with _watching(live, real) as tell:
        record = _record(machine, arm, path, settings, setup, (), real, baud, tell, drop)
    if trace:
        try:
            trace.write_text(
                one_cycle(machine, arm, path, settings, setup, len(path.q) // 2), encoding="utf-8"
            )
        except OSError as error:
            raise FileError(f"{trace}: cannot be written: {error.strerror}") from None
    _answer(tracking(machine, arm, path, settings, setup, record), "error", csv, json)


@app.command(
    "comply",
    cls=NumericCommand,
    epilog='Example: kinlab arm comply --push "t=0.5 dur=0.4 at=hand force=0,-5,0"',
)
def _comply(
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
    baud: Baud = 1_000_000,
    live: Live = False,
    csv: Csv = None,
    limb: LimbOption = None,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Be pushed on the line, without compliance and with it (section 4.2.2). A real arm is run with it alone."""
    from kinlab.papers.receptionist_experiments import PUSH, pushed, pushed_by_people

    machine, arm = _arm_of(robots, limb)
    path = _line(arm, profile, None, None, 1.28)
    settings = _compliance(environment, (kf, kenv, denv, menv), (kp, kv), summed, alpha)
    setup = _setup(slope, margin, punch, torque_limit, speed_limit, real)
    with _watching(live, real) as tell:
        if real:
            record = _record(machine, arm, path, settings, setup, _pushes(push), real, baud, tell)
            outcome = pushed_by_people(record)
        else:
            outcome = pushed(machine, arm, path, settings, setup, _pushes(push) or (PUSH,), tell)
    _answer(outcome, "error", csv, json)


@app.command("observe", cls=NumericCommand, epilog="Example: kinlab arm observe --profile quintic")
def _observe(
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
    baud: Baud = 1_000_000,
    live: Live = False,
    csv: Csv = None,
    limb: LimbOption = None,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Measured torque against computed torque in free motion (section 4.2.1); pushed, what the observers find."""
    from kinlab.papers.receptionist_experiments import free_motion, observing

    machine, arm = _arm_of(robots, limb)
    path = _line(arm, profile, None, None, 1.28)
    settings = _compliance(environment, (kf, kenv, denv, menv), (kp, kv), summed, alpha)
    setup = _setup(slope, margin, punch, torque_limit, speed_limit, real)
    pushes = _pushes(push)
    with _watching(live, real) as tell:
        record = _record(machine, arm, path, settings, setup, pushes, real, baud, tell)
    if pushes:
        _answer(observing(record), "pushes", csv, json)
    else:
        _answer(free_motion(settings, record), "torque", csv, json)


@app.command(
    "map", cls=NumericCommand, epilog="Example: kinlab arm map kp kv --x-range 0.5 500 --y-range 0.05 100"
)
def _map(
    x: Annotated[str, typer.Argument(help="The gain to the right: kp, kv, kf, kenv, denv or menv.")] = "kp",
    y: Annotated[str, typer.Argument(help="The gain upwards.")] = "kv",
    x_range: Annotated[tuple[float, float], typer.Option(help="Its lowest and highest value.")] = (
        0.5,
        500.0,
    ),
    y_range: Annotated[tuple[float, float], typer.Option(help="Its lowest and highest value.")] = (
        0.05,
        100.0,
    ),
    size: Annotated[tuple[int, int], typer.Option(help="Columns and rows.")] = (40, 14),
    environment: EnvironmentName = "table-4.1",
    kp: Kp = 3.8,
    kv: Kv = 0.2,
    summed: Summed = False,
    slope: Slope = 64,
    limb: LimbOption = None,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """For which gains the loop settles, oscillates, or runs away; the linear model's bounds are drawn into it.

    With kp and kv position control is swept, with a gain of the environment compliance control.
    """
    from kinlab.cli.arm_tables import progress, show_map
    from kinlab.rig.arm import Setup
    from kinlab.rig.arm.stability import scale, settings_for, sweep

    machine, arm = _arm_of(robots, limb)
    base = _compliance(environment, (None,) * 4, (kp, kv), summed, 0.05)
    axes = [
        (name, scale(span, count)) for name, span, count in zip((x, y), (x_range, y_range), size, strict=True)
    ]
    with progress(size[0] * size[1]) as tell:
        found = sweep(machine, arm, settings_for(base, x, y), Setup(slope=slope), axes[0], axes[1], tell)
    if json:
        print_json(found.to_json())
    else:
        show_map(found)


def _arm_of(robots: Path | None, limb: str | None) -> "tuple[Robot, Limb]":
    from kinlab.robots import load_robot

    machine = load_robot("receptionist-arm", robots)
    return machine, machine.limb(limb)


def _line(arm: "Limb", profile: str, start: Any, end: Any, seconds: float) -> "Track":
    from kinlab.papers.receptionist_line import FROM, TO, line
    from kinlab.units import check_place, to_metres

    places = []
    for given, printed, what in ((start, FROM, "--from"), (end, TO, "--to")):
        if given is not None:
            check_place(given, what)
        places.append(printed if given is None else to_metres(given))
    return line(arm, profile, places[0], places[1], seconds)


def _compliance(name: str, own: Any, gains: Any, summed: bool, alpha: float) -> "Settings":
    from kinlab.control import PositionGains
    from kinlab.names import resolve
    from kinlab.papers.receptionist_experiments import ENVIRONMENTS
    from kinlab.rig.arm import Settings

    printed = ENVIRONMENTS[resolve(name, ENVIRONMENTS, "set of environment gains")]
    changed = {k: v for k, v in zip(printed._fields, own, strict=True) if v is not None}
    return Settings("compliance", PositionGains(*gains), printed._replace(**changed), summed, alpha)


def _setup(
    slope: int, margin: int, punch: int, torque_limit: float, speed_limit: float, real: str | None
) -> "Setup":
    from kinlab.rig.arm import Setup
    from kinlab.units import to_radians

    # Nobody knows yet how a real arm takes these gains.
    limit = min(torque_limit, REAL_TORQUE) if real else torque_limit
    return Setup(slope, margin, punch, limit, to_radians(speed_limit))


def _pushes(texts: list[str] | None) -> "tuple[Push, ...]":
    from kinlab.rig.arm import parse_push

    return tuple(parse_push(text) for text in texts or ())


def _watching(live: bool, real: str | None) -> Any:
    from kinlab.cli.arm_tables import watching

    return watching(live, real is not None)


def _record(
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
    try:
        if real:
            return Port(real, baud).drive(arm, path, settings, setup, tell)
        return drive(machine, arm, path, settings, setup, pushes, tell, drop)
    except KeyboardInterrupt:
        typer.echo("kinlab: interrupted; the torque is off", err=True)
        raise typer.Exit(130) from None


def _answer(outcome: "Outcome", plot: str, csv: Path | None, json: bool) -> None:
    from kinlab.cli.arm_tables import show_outcome

    if csv:
        for i, (name, record) in enumerate(outcome.runs.items()):
            record.to_csv(csv if i == 0 else csv.with_stem(f"{csv.stem}-{name}"))
    if json:
        print_json(outcome.to_json())
    else:
        show_outcome(outcome, plot)
