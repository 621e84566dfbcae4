"""`kinlab walk`: a gait on the rig, and what it costs."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kinlab.cli.command import (
    ForceOption,
    GaitOption,
    JsonOption,
    NumericCommand,
    RobotArgument,
    RobotsOption,
    RrdOption,
    SpeedOption,
    TurnOption,
    check_rrd,
    command_app,
    print_json,
    write_rrd,
)

if TYPE_CHECKING:
    from kinlab.dynamixel import Passage
    from kinlab.rig import Errand, Order, Rig, Sample, WalkResult
    from kinlab.scene import Recording

INTERRUPTED = 130
# The speeds of krsri-hexapod, Table 2.
PAPERS_SPEEDS = "10:40:3"

app = command_app()


@app.command(
    cls=NumericCommand,
    epilog="Example: kinlab walk krsri-hexapod --gait tripod --speed 20 --distance 1000",
)
def walk(
    robot: RobotArgument,
    name: GaitOption = None,
    speed: SpeedOption = 20.0,
    turn: TurnOption = 0.0,
    distance: Annotated[
        float, typer.Option(metavar="MM", help="How far, in mm; with --speed 0 it turns once round.")
    ] = 1000.0,
    rate: Annotated[float, typer.Option(metavar="HZ", help="Commands and readings per second.")] = 50.0,
    port: Annotated[
        str | None,
        typer.Option(help="/dev/ttyUSB0, ./ttyDXL, HOST:PORT. Default: emulated servos, in simulated time."),
    ] = None,
    baud: Annotated[int, typer.Option(help="Speed of the bus in bps.")] = 1_000_000,
    setting: Annotated[
        tuple[str, str] | None,
        typer.Option("--set", metavar="NAME RANGE", help="Walk again and again: --set speed 10:40:3."),
    ] = None,
    gaits: Annotated[
        tuple[str, str] | None,
        typer.Option("--compare", metavar="GAIT GAIT", help="What two gaits cost over --set speed."),
    ] = None,
    csv: Annotated[
        Path | None, typer.Option(help="File for the measured ticks, or for the walks of a sweep.")
    ] = None,
    live: Annotated[
        bool, typer.Option("--live", help="A panel in real time: voltage, current, power, Wh, speed.")
    ] = False,
    mirror: Annotated[
        str | None,
        typer.Option(metavar="HOST:PORT", help="Show every pose in a viewer that `kinlab view` has opened."),
    ] = None,
    rrd: RrdOption = None,
    force: ForceOption = False,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """A gait on the rig: joint speeds, loads, tracking error, energy.

    The gait goes to the servos as sync writes, and their positions, loads and
    voltages are read back. The torque is off at the end, and on Ctrl-C.
    """
    import numpy as np

    from kinlab.errors import UsageError
    from kinlab.files import check_writable
    from kinlab.gait import find_gait
    from kinlab.rig import Order, prepare, span, sweep
    from kinlab.robots import load_robot

    if baud <= 0:
        raise UsageError(f"a speed is more than 0 bps, not {baud}")
    if live and (json or setting or gaits):
        raise UsageError(
            "--live shows one walk to a person: it goes with neither --json, --set nor --compare"
        )
    if gaits and name:
        raise UsageError("--compare names its gaits itself: --gait has no place beside it")
    if (rrd or mirror) and (setting or gaits):
        raise UsageError("--rrd and --mirror show one walk: they go with neither --set nor --compare")
    if csv:
        check_writable(csv)
    check_rrd(rrd, force)
    machine = load_robot(robot, robots)
    first = find_gait(machine, gaits[0] if gaits else name, robots)
    order = Order(machine, first, speed / 1000, float(np.radians(turn)), distance / 1000, rate)
    if gaits:
        second = find_gait(machine, gaits[1], robots)
        answer = _compared(order, second, setting or ("speed", PAPERS_SPEEDS), port, baud, csv)
        if json:
            print_json(answer.to_json())
        else:
            from kinlab.cli.walk_tables import show_comparison

            show_comparison(answer)
        return
    if setting:
        _sweep(sweep(order, setting[0], span(setting[1])), port, baud, csv, json)
        return
    packets: list[Passage] | None = [] if rrd else None
    result = _one(prepare(order), port, baud, live, mirror, packets)
    # Shown first: a disk that is full costs the files, and not what was measured.
    if json:
        print_json(result.to_json())
    else:
        from kinlab.cli.walk_tables import show_walk

        show_walk(result)
    if csv:
        _save(csv, result.series())
    write_rrd(rrd, force, lambda: _scene(result, packets or ()))
    if not (result.complete or live):
        raise typer.Exit(INTERRUPTED)


def _scene(result: "WalkResult", packets: "Sequence[Passage]") -> "Recording":
    from kinlab.scene import walk_scene

    return walk_scene(result, packets)


def _sweep(errands: Sequence["Errand"], port: str | None, baud: int, csv: Path | None, json: bool) -> None:
    """Walk again and again; what was walked is kept and shown, whatever stops the rest."""
    robot = errands[0].order.robot
    results, stopped = _walked(robot, errands, port, baud)
    if results:
        _save_rows(csv, results)
    if json:
        print_json({"robot": robot.name, "walks": [result.to_json() for result in results]})
    elif results:
        from kinlab.cli.walk_tables import show_sweep

        show_sweep(robot.name, results)
    _finish(results, len(errands), stopped)


def _one(
    errand: "Errand",
    port: str | None,
    baud: int,
    live: bool,
    mirror: str | None,
    packets: "list[Passage] | None",
) -> "WalkResult":
    """One walk; Ctrl-C ends it early, and what was measured until then counts.

    Args:
        mirror: the address of a viewer that shows it.
        packets: takes what goes over the bus.
    """
    from contextlib import nullcontext, suppress

    from kinlab.cli.walk_live import Panel
    from kinlab.cli.walk_progress import progress
    from kinlab.dynamixel import RealClock
    from kinlab.rig import Record, Rig, Throttle, WalkResult, walk_on

    if packets is not None:
        from kinlab.scene import check_recordable

        check_recordable(errand)
    samples: list[Any] = []
    throttle = Throttle(errand)
    show = Panel(errand, throttle) if live else progress([errand])
    with nullcontext(lambda sample: None) if mirror is None else _mirrored(errand, mirror) as reflect:
        rig = Rig.open(errand.order.robot, port, baud, clock=RealClock() if live else None)
        if packets is not None:
            rig.bus.tap = packets.append
        # An unfinished walk leaves the torque off: the rig's own `with` sees to it.
        try:
            with suppress(KeyboardInterrupt), rig, show as tell:
                for sample in walk_on(rig, errand, lambda: throttle.tempo):
                    samples.append(sample)
                    tell(errand, sample)
                    reflect(sample)
                    if throttle.stopped:
                        break
        finally:
            _warn(rig)
    if not samples:
        typer.echo("kinlab: interrupted before the first step", err=True)
        raise typer.Exit(INTERRUPTED)
    return WalkResult.of(errand, Record(rig.wiring, samples), rig)


@contextmanager
def _mirrored(errand: "Errand", address: str) -> Iterator[Callable[["Sample"], None]]:
    """A function that shows every tick in a viewer."""
    from kinlab.errors import KinlabError
    from kinlab.rig.wiring import Wiring
    from kinlab.scene import Mirror

    walk = errand.walk
    wiring = Wiring.of(walk.robot, walk.robot.legs)
    mirror = Mirror(walk.robot, address)

    def show(sample: "Sample") -> None:
        mirror.show(wiring.by_limb(sample.reading.q), walk.at(sample.way).body, sample.t)

    try:
        yield show
    finally:
        # A viewer that was closed meanwhile does not undo the walk.
        try:
            mirror.close()
        except KinlabError as error:
            typer.echo(f"kinlab: {error}", err=True)


def _walked(
    robot: Any, errands: Sequence["Errand"], port: str | None, baud: int
) -> tuple[list["WalkResult"], BaseException | None]:
    """Errands, one after the other, on one rig; those that were walked to their end, and what stopped the rest."""
    from kinlab.cli.walk_progress import progress
    from kinlab.dynamixel import PortError
    from kinlab.rig import Record, Rig, WalkResult, walk_on

    records: list[Record] = []
    stopped: BaseException | None = None
    rig = Rig.open(robot, port, baud)
    try:
        with rig, progress(errands) as tell:
            for errand in errands:
                samples = []
                for sample in walk_on(rig, errand):
                    samples.append(sample)
                    tell(errand, sample)
                records.append(Record(rig.wiring, samples))
    except (KeyboardInterrupt, PortError) as error:
        stopped = error
    finally:
        _warn(rig)
    results = [WalkResult.of(errand, record, rig) for errand, record in zip(errands, records, strict=False)]
    return results, stopped


def _finish(results: Sequence["WalkResult"], asked: int, stopped: BaseException | None) -> None:
    """Say what is missing of walks that were stopped, after what was walked has been shown."""
    if stopped is None:
        return
    reason = f": {stopped}" if str(stopped) else ""
    typer.echo(f"kinlab: stopped after {len(results)} of {asked} walks{reason}", err=True)
    raise typer.Exit(INTERRUPTED if isinstance(stopped, KeyboardInterrupt) else 1)


def _warn(rig: "Rig") -> None:
    """Say what a person must know who is about to touch the robot."""
    if rig.unconfirmed:
        servos = ", ".join(map(str, rig.unconfirmed))
        typer.echo(f"kinlab: torque off is not confirmed by servo {servos}", err=True)


def _compared(
    order: "Order", other: Any, setting: tuple[str, str], port: str | None, baud: int, csv: Path | None
) -> Any:
    """What two gaits cost at the same speeds, beside the robot's paper."""
    from dataclasses import replace

    from kinlab.errors import UsageError
    from kinlab.papers.comparison import compare
    from kinlab.rig import check_steady, costs, span, sweep

    if order.gait == other:
        raise UsageError(f"--compare takes two gaits, got {other.name} twice")
    if not "speed".startswith(setting[0]):
        raise UsageError(f"--compare goes over speeds, not over {setting[0]}")
    speeds = span(setting[1])
    errands = [e for gait in (order.gait, other) for e in sweep(replace(order, gait=gait), "speed", speeds)]
    for errand in errands:
        check_steady(errand)
    results, stopped = _walked(order.robot, errands, port, baud)
    _save_rows(csv, results)
    _finish(results, len(errands), stopped)
    half = len(speeds)
    energy = {
        gait.name: costs(part) for gait, part in ((order.gait, results[:half]), (other, results[half:]))
    }
    return compare(order.robot, [speed / 1000 for speed in speeds], energy)


def _save_rows(path: Path | None, results: Sequence["WalkResult"]) -> None:
    if path:
        _save(path, [{"gait": result.errand.order.gait.name, **result.row()} for result in results])


def _save(path: Path, rows: list[dict[str, Any]]) -> None:
    """Rows as CSV, the file whole or not there."""
    from csv import DictWriter
    from io import StringIO

    from kinlab.files import write_whole

    text = StringIO()
    writer = DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()})
    write_whole(path, text.getvalue())
