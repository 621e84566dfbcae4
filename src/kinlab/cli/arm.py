"""`kinlab arm`: the receptionist's arm follows a line, yields to a hand, and observes what pushes it."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kinlab.cli.arm_bench import (
    Bench,
    answer,
    arm_of,
    compliance_of,
    line_of,
    record_of,
    scene_of,
    setup_of,
    under_compliance,
)
from kinlab.cli.arm_options import (
    BAUD,
    Baud,
    Csv,
    Drop,
    EnvironmentName,
    Kp,
    Kv,
    Live,
    Margin,
    Profile,
    Punch,
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
    NumericCommand,
    RobotsOption,
    RrdOption,
    check_rrd,
    command_app,
    print_json,
    write_rrd,
)

if TYPE_CHECKING:
    from kinlab.papers.receptionist_experiments import Outcome

app = command_app()


@app.callback(
    no_args_is_help=True, epilog='Example: kinlab arm comply --push "t=0.5 dur=0.4 at=hand force=-5,0,0"'
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
    baud: Baud = BAUD,
    drop: Drop = 0.0,
    live: Live = False,
    csv: Csv = None,
    trace: Annotated[
        Path | None, typer.Option(help="Write the packets of the cycle half-way, for `kinlab packet FILE`.")
    ] = None,
    rrd: RrdOption = None,
    force: ForceOption = False,
    limb: LimbOption = None,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Follow a straight line without a position controller, or with one."""
    from kinlab.cli.arm_tables import watching
    from kinlab.control import PositionGains
    from kinlab.errors import UsageError
    from kinlab.files import check_writable, write_whole
    from kinlab.papers.receptionist_experiments import tracking
    from kinlab.rig.arm import Settings
    from kinlab.rig.arm.trace import script

    settings = Settings(law, PositionGains(kp, kv), running_sum=summed)
    if settings.law == "compliance":
        raise UsageError("compliance is what `kinlab arm comply` is for")
    for file in filter(None, (csv, trace)):
        check_writable(file)
    check_rrd(rrd, force)
    machine, arm = arm_of(robots, limb)
    path = line_of(arm, profile, start, end, seconds)
    setup = setup_of(slope, margin, punch, torque_limit, speed_limit, real)
    with watching(live, real is not None) as tell:
        record = record_of(machine, arm, path, settings, setup, (), real, baud, tell, drop)
    outcome = tracking(machine, arm, path, settings, setup, record)
    answer(outcome, "error", csv, json)
    if trace:
        write_whole(trace, script(record, len(path.q) // 2, machine.name))
    write_rrd(rrd, force, lambda: scene_of(machine, outcome))


@app.command(
    "comply",
    cls=NumericCommand,
    epilog='Example: kinlab arm comply --push "t=0.5 dur=0.4 at=hand force=-5,0,0"',
)
@under_compliance
def _comply(bench: Bench) -> "tuple[Outcome, str]":
    """Be pushed on the line, without compliance and with it (section 4.2.2). A real arm is run with it alone."""
    from kinlab.papers.receptionist_experiments import PUSH, pushed, pushed_by_people

    if bench.real:
        return pushed_by_people(bench.record()), "error"
    return pushed(*bench[:5], bench.pushes or (PUSH,), bench.tell), "error"


@app.command("observe", cls=NumericCommand, epilog="Example: kinlab arm observe --profile quintic")
@under_compliance
def _observe(bench: Bench) -> "tuple[Outcome, str]":
    """Measured torque against computed torque in free motion (section 4.2.1); pushed, what the observers find."""
    from kinlab.papers.receptionist_experiments import free_motion, observing

    record = bench.record()
    return (observing(record), "pushes") if bench.pushes else (free_motion(bench.settings, record), "torque")


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

    machine, arm = arm_of(robots, limb)
    base = compliance_of(environment, (None,) * 4, (kp, kv), summed, 0.05)
    axes = [
        (name, scale(span, count)) for name, span, count in zip((x, y), (x_range, y_range), size, strict=True)
    ]
    with progress(size[0] * size[1]) as tell:
        found = sweep(machine, arm, settings_for(base, x, y), Setup(slope=slope), axes[0], axes[1], tell)
    if json:
        print_json(found.to_json())
    else:
        show_map(found)
