"""`kinlab view`: a robot, a target, a gait, an experiment or a saved recording in 3-D."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kinlab.cli.command import (
    ForceOption,
    FrameOption,
    JsonOption,
    LimbOption,
    NumericCommand,
    RobotsOption,
    SpeedOption,
    TurnOption,
    check_rrd,
    command_app,
    print_json,
    write_rrd,
)

if TYPE_CHECKING:
    from kinlab.robots import Robot
    from kinlab.scene import Recording, View

SPEED, CYCLES, PORT, PAGE_PORT = 20.0, 3, 9876, 9090

app = command_app()


@app.command(
    cls=NumericCommand, epilog="Example: kinlab view krsri-hexapod --gait wave --speed 20 --save walk.rrd"
)
def view(
    robot: Annotated[
        str,
        typer.Argument(
            metavar="ROBOT|FILE.rrd", show_default=False, help="A robot, or a recording that was saved."
        ),
    ],
    limb: LimbOption = None,
    target: Annotated[
        tuple[float, float, float] | None,
        typer.Option("--target", metavar="X Y Z", help="A target of the limb, as `kinlab ik` takes it."),
    ] = None,
    frame: FrameOption = "limb",
    unit: Annotated[str, typer.Option("--unit", "-u", help="Unit of the target: mm, cm or m.")] = "mm",
    gait: Annotated[
        str | None, typer.Option("--gait", "-g", metavar="NAME", help="A gait of its kind.")
    ] = None,
    speed: SpeedOption = SPEED,
    turn: TurnOption = 0.0,
    cycles: Annotated[int, typer.Option(metavar="N", help="Of the gait.")] = CYCLES,
    arm: Annotated[
        str | None,
        typer.Option(metavar="EXPERIMENT", help="One of `kinlab arm`: track, comply or observe."),
    ] = None,
    frames: Annotated[bool, typer.Option("--frames", help="Every frame as three arrows.")] = False,
    workspace: Annotated[
        bool, typer.Option("--workspace", help="What the limb reaches, as a cloud.")
    ] = False,
    save: Annotated[
        Path | None, typer.Option(metavar="FILE.rrd", help="Keep it; nothing opens unless asked.")
    ] = None,
    force: ForceOption = False,
    spawn: Annotated[
        bool, typer.Option("--spawn", help="Open rerun's window: what happens without --save or --serve.")
    ] = False,
    serve: Annotated[
        bool, typer.Option("--serve", help="Show it in the browser, from this machine alone.")
    ] = False,
    port: Annotated[
        int, typer.Option(help="Where the viewer takes live data, see `kinlab walk --mirror`.")
    ] = PORT,
    page_port: Annotated[int, typer.Option(help="Of the page of --serve.")] = PAGE_PORT,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """See it in 3-D: a robot, a target, a gait, an experiment or a recording.

    Without a subject the robot stands. Scrub `time` or `phase`; drag to turn,
    right-drag to move, scroll to come nearer. Needs the extra kinlab[view].
    """
    from kinlab.errors import UsageError
    from kinlab.robots import load_robot

    subject = _subject({"--target": target, "--gait": gait, "--arm": arm})
    for option, given, subjects in (
        ("--limb", limb, ("", "--target", "--arm")),
        ("--workspace", workspace, ("", "--target")),
        ("--frame", frame != "limb", ("--target",)),
        ("--unit", unit != "mm", ("--target",)),
        ("--speed", speed != SPEED, ("--gait",)),
        ("--turn", turn, ("--gait",)),
        ("--cycles", cycles != CYCLES, ("--gait",)),
    ):
        if given and subject not in subjects:
            raise UsageError(f"{option} says nothing about {subject or 'a robot that stands'}")
    if Path(robot).suffix.lower() == ".rrd":
        _check_recorded(
            Path(robot), bool(subject or limb or workspace or frames or save or force or robots or json)
        )
        if how := _viewer(spawn, serve, None, port, page_port):
            _show(Path(robot), how)
        return
    machine = load_robot(robot, robots)
    check_rrd(save, force, "--save")
    how = _viewer(spawn, serve, save, port, page_port)
    reached = True
    if target is not None:
        recording, reached = _target(machine, limb, target, frame, unit, frames=frames, workspace=workspace)
    elif gait is not None:
        recording = _gait(machine, gait, speed, turn, cycles, frames, robots)
    elif arm is not None:
        recording = _experiment(machine, limb, arm, frames)
    else:
        from kinlab.scene import robot_scene

        which = machine.limb(limb) if limb else None
        recording = robot_scene(machine, which, frames=frames, workspace=workspace)
    size = write_rrd(save, force, lambda: recording)
    if json:
        page = how.page if how and how.browser else None
        file = None if save is None else str(save)
        what = subject.removeprefix("--") or "robot"
        print_json({"robot": machine.name, "subject": what, "file": file, "bytes": size, "page": page})
    if how:
        _show(recording, how)
    if not reached:
        raise typer.Exit(1)


def _subject(asked: dict[str, Any]) -> str:
    """The one option of `asked` that is given; "" where none is."""
    from kinlab.errors import UsageError

    given = [option for option, value in asked.items() if value is not None]
    if len(given) > 1:
        raise UsageError(f"{' and '.join(given)} are pictures of their own: ask for one of them")
    return given[0] if given else ""


def _viewer(spawn: bool, serve: bool, save: Path | None, port: int, page_port: int) -> "View | None":
    """How it is looked at; None where it is only saved."""
    from kinlab.errors import UsageError
    from kinlab.scene import View, check_viewer

    if spawn and serve:
        raise UsageError("--spawn opens a window, --serve a page: ask for one of them")
    if page_port != PAGE_PORT and not serve:
        raise UsageError("--page-port is for the page of --serve")
    if save and not (spawn or serve):
        if port != PORT:
            raise UsageError("--port is for a viewer: --save opens none without --spawn or --serve")
        return None
    how = View(serve, port, page_port)
    check_viewer(how)
    return how


def _check_recorded(file: Path, more: bool) -> None:
    """Refuse a file that is no recording, and options that would change one."""
    from kinlab.errors import UsageError
    from kinlab.scene import check_recording

    if more:
        raise UsageError(f"{file} is shown as it was saved: only --spawn, --serve and ports go with it")
    check_recording(file)


def _show(recording: "Recording | Path", how: "View") -> None:
    """Look at it, until the viewer is closed or Ctrl-C ends it."""
    import signal
    from contextlib import suppress

    from kinlab.endings import endings
    from kinlab.scene import viewing

    # However it is ended, the viewer ends with it.
    for ending in endings():
        signal.signal(ending, signal.default_int_handler)
    with suppress(KeyboardInterrupt), viewing(recording, how) as viewer:
        where = (
            f"open {how.page}   Ctrl-C ends" if how.browser else "close the window, or press Ctrl-C, to end"
        )
        typer.echo(f"kinlab: {where}", err=True)
        viewer.wait()


def _target(
    machine: "Robot", limb: str | None, target: Any, frame: str, unit: str, **more: bool
) -> "tuple[Recording, bool]":
    """The scene of a target, and whether it is reached."""
    from kinlab.papers import as_printed
    from kinlab.robots.target import solve_target
    from kinlab.scene import target_scene
    from kinlab.units import to_metres

    answer = solve_target(machine, machine.limb(limb), to_metres(target, unit), frame=frame)
    if answer.chosen is None:
        typer.echo(f"kinlab: not reached: {answer.reason}", err=True)
    printed = as_printed(machine, answer.limb, answer.target, answer.rotation)
    return target_scene(answer, printed, **more), answer.chosen is not None


def _gait(
    machine: "Robot", name: str, speed: float, turn: float, cycles: int, frames: bool, robots: Path | None
) -> "Recording":
    import numpy as np

    from kinlab.errors import UsageError
    from kinlab.gait import assess, find_gait, plan
    from kinlab.scene import gait_scene

    if not 1 <= cycles <= 100:
        raise UsageError(f"--cycles is a number from 1 to 100, got {cycles}")
    walk = plan(machine, find_gait(machine, name, robots), forward=speed / 1000, turn=float(np.radians(turn)))
    assess(walk)
    return gait_scene(walk, cycles=cycles, frames=frames)


def _experiment(machine: "Robot", limb: str | None, name: str, frames: bool) -> "Recording":
    from kinlab.errors import UsageError
    from kinlab.papers.receptionist_experiments import experiment
    from kinlab.scene import arm_scene

    if machine.paper != "receptionist-arm":
        raise UsageError(f"--arm shows the experiments of the receptionist-arm, not of {machine.name}")
    return arm_scene(machine, experiment(machine, machine.limb(limb), name), frames=frames)
