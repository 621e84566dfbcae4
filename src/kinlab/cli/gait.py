"""`kinlab gait`: a gait phase by phase."""

import sys
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
    from kinlab.gait import Walk
    from kinlab.scene import Recording

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab gait krsri-hexapod --gait wave --speed 20 --phase 1")
def gait(
    robot: RobotArgument,
    name: GaitOption = None,
    speed: SpeedOption = 20.0,
    sideways: Annotated[float, typer.Option(metavar="MM_S", help="To the left, in mm/s.")] = 0.0,
    turn: TurnOption = 0.0,
    stride: Annotated[float | None, typer.Option(metavar="MM", help="Way per cycle, in mm.")] = None,
    period: Annotated[
        float | None, typer.Option(metavar="S", help="Of a cycle, in s; instead of the stride.")
    ] = None,
    lift: Annotated[float | None, typer.Option(metavar="MM", help="Of a swinging foot, in mm.")] = None,
    height: Annotated[float, typer.Option(metavar="MM", help="Of the body above its stance, in mm.")] = 0.0,
    rpy: Annotated[
        tuple[float, float, float],
        typer.Option(metavar="R P Y", help="Roll, pitch and yaw of the body, in deg."),
    ] = (0.0, 0.0, 0.0),
    trajectory: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="Foot trajectory: line-sine, quarter-circle, cycloid, matched-cycloid, matched-quintic, bezier.",
        ),
    ] = None,
    decelerate: Annotated[
        bool, typer.Option("--decelerate", help="Landing deceleration, as eros has it.")
    ] = False,
    heel_strike: Annotated[bool, typer.Option("--heel-strike", help="Heel strike, as eros has it.")] = False,
    experiment: Annotated[
        str | None,
        typer.Option(metavar="MM", help="Step, sway and lift of an experiment of eros: 8, 16 or 24."),
    ] = None,
    phase: Annotated[int | None, typer.Option(metavar="N", help="One phase, from 1.")] = None,
    step: Annotated[bool, typer.Option("--step", help="Walk the phases, one a key press.")] = False,
    as_printed: Annotated[
        bool,
        typer.Option("--as-printed", help="The foot trajectory as the paper prints it, and what is wrong."),
    ] = False,
    energy: Annotated[
        bool,
        typer.Option(
            "--energy", help="What the paper measured that wave and tripod cost, and a model of it."
        ),
    ] = False,
    frames: Annotated[int, typer.Option(metavar="N", help="Frames of a cycle in the JSON.")] = 60,
    rrd: RrdOption = None,
    force: ForceOption = False,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """A gait phase by phase: which legs swing, which carry, how safely.

    Speeds beyond what the servos or the legs allow are refused, with the joint
    that is at its limit and the fastest possible speed.
    """
    import numpy as np

    from kinlab.errors import UsageError
    from kinlab.gait import find_curve, find_gait, plan
    from kinlab.gait.landing import find_experiment
    from kinlab.gait.report import report
    from kinlab.robots import load_robot

    if frames < 1:
        raise UsageError(f"expected at least 1 frame, got {frames}")
    if energy:
        _energy(load_robot(robot, robots), json, rrd)
        return
    if step and (json or phase is not None):
        raise UsageError("--step shows all phases to a person: it goes with neither --json nor --phase")
    check_rrd(rrd, force)
    machine = load_robot(robot, robots)
    schedule = find_gait(machine, name, robots)
    walk = plan(
        machine,
        schedule,
        forward=speed / 1000,
        sideways=sideways / 1000,
        turn=float(np.radians(turn)),
        stride=None if stride is None else stride / 1000,
        period=period,
        lift=None if lift is None else lift / 1000,
        curve=None if trajectory is None else find_curve(trajectory),
        height=height / 1000,
        rpy=np.radians(rpy),
        decelerate=decelerate,
        heel_strike=heel_strike,
        experiment=None if experiment is None else find_experiment(experiment),
    )
    answer = report(walk, keep_period=period is not None)
    only = None if phase is None else answer.phase(phase)
    printed: Any = None
    if as_printed:
        from kinlab.papers import footstep_as_printed

        printed = footstep_as_printed(walk)
    write_rrd(rrd, force, lambda: _scene(walk))
    if json:
        document = answer.to_json(frames)
        if only is not None:
            document["events"] = [event for event in document["events"] if event["number"] == phase]
        if as_printed:
            document["as_printed"] = [] if printed is None else [printed.to_json()]
        print_json(document)
    elif step:
        _step(answer)
    else:
        from kinlab.cli.gait_tables import show_as_printed, show_gait, show_phase

        if only is not None:
            show_phase(answer, only)
        else:
            show_gait(answer)
            if experiment is not None:
                from kinlab.cli.show import sentences, show
                from kinlab.gait.landing import EXPERIMENT_NOTE

                show(sentences(("-", EXPERIMENT_NOTE)))
        if as_printed:
            show_as_printed(printed)


def _scene(walk: "Walk") -> "Recording":
    from kinlab.scene import gait_scene

    return gait_scene(walk)


def _energy(machine: Any, json: bool, rrd: Path | None) -> None:
    """The paper's tables of energy and distance, and their model."""
    from kinlab.errors import UsageError
    from kinlab.papers.energy import energy_of

    if rrd:
        raise UsageError("--energy shows tables, of which there is no picture in 3-D: leave --rrd out")
    grounds = energy_of(machine)
    if json:
        print_json({"robot": machine.name, "energy": [ground.to_json() for ground in grounds]})
        return
    from kinlab.cli.energy_tables import show_energy

    show_energy(machine, grounds)


def _step(answer: Any) -> None:
    """The phases one by one, forwards and backwards, for ever, until q."""
    from kinlab.cli.gait_tables import show_phase
    from kinlab.cli.keys import keys
    from kinlab.cli.show import console, show
    from kinlab.errors import UsageError

    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise UsageError("--step waits for keys, and standard input or output is no terminal; try --phase 1")
    phases = answer.walk.gait.phases
    at = 0
    with keys() as next_key:
        while True:
            console().clear()
            show_phase(answer, phases[at])
            swing = ", ".join(phases[at].swing) or "no leg"
            where = f"phase {phases[at].number} of {len(phases)}, {swing} in the air"
            show("", f"{where}   any key: next   b or left: back   q: quit")
            key = next_key()
            if key in ("q", "Q", "\x1b", "\x04", ""):
                return
            at = (at + (-1 if key in ("b", "p", "\x1b[D", "\x1bOD") else 1)) % len(phases)
