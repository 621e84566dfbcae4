"""`kinlab ik`: a target as joint angles, servo angles and commands, with the error at every depth."""

from typing import TYPE_CHECKING, Annotated

import typer

from kinlab.cli.command import (
    ForceOption,
    FrameOption,
    JsonOption,
    LimbOption,
    NumericCommand,
    RobotArgument,
    RobotsOption,
    RrdOption,
    check_rrd,
    command_app,
    print_json,
    write_rrd,
)

if TYPE_CHECKING:
    from kinlab.robots.target import TargetReport
    from kinlab.scene import Recording

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab ik xl430-hexapod 75 10 -46 --limb R1 --as-printed")
def ik(
    robot: RobotArgument,
    target: Annotated[
        list[float], typer.Argument(metavar="X Y Z", help="The target, in mm.", show_default=False)
    ],
    limb: LimbOption = None,
    frame: FrameOption = "limb",
    unit: Annotated[str, typer.Option("--unit", "-u", help="Unit of the target: mm, cm or m.")] = "mm",
    every: Annotated[bool, typer.Option("--all", "-a", help="Every solution, not only the chosen.")] = False,
    servos: Annotated[
        bool,
        typer.Option("--servos/--no-servos", help="Servo angles and commands beside the joints' angles."),
    ] = True,
    rpy: Annotated[
        tuple[float, float, float] | None,
        typer.Option(metavar="R P Y", help="Roll, pitch and yaw of the tip in deg, for limbs of six joints."),
    ] = None,
    yaw: Annotated[
        float | None, typer.Option(metavar="DEG", help="Yaw alone: the tip level, turned by DEG.")
    ] = None,
    as_printed: Annotated[
        bool, typer.Option("--as-printed", help="What the paper's equations give as they stand, and why.")
    ] = False,
    method: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="Iterate by rmrc, dls, newton, gauss-newton, lm or ccd."),
    ] = None,
    trace: Annotated[bool, typer.Option("--trace", help="With --method: every step that it took.")] = False,
    compare: Annotated[
        bool, typer.Option("--compare", help="Run this target through all methods, side by side.")
    ] = False,
    rrd: RrdOption = None,
    force: ForceOption = False,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """A target as joint angles, servo angles and commands.

    The answer is checked by forward kinematics, and its error shown at four
    depths: of the mathematics, of the servos' resolution, of the equations as
    the paper prints them, and as the paper measured.
    """
    import numpy as np

    from kinlab.errors import UsageError
    from kinlab.robots import load_robot
    from kinlab.robots.target import solve_target
    from kinlab.units import to_metres

    if len(target) != 3:
        raise UsageError(f"a target is three numbers X Y Z, got {len(target)}")
    if rpy is not None and yaw is not None:
        raise UsageError("--yaw DEG is short for --rpy 0 0 DEG: give one of the two")
    if compare and (as_printed or every or method is not None or rrd):
        raise UsageError(
            "--compare shows every method by itself: leave --all, --as-printed, --method and --rrd out"
        )
    if trace and method is None:
        raise UsageError("--trace shows the steps of a method: name one with --method")
    check_rrd(rrd, force)
    machine = load_robot(robot, robots)
    which = machine.limb(limb)
    point = to_metres(target, unit)
    turned = (0.0, 0.0, yaw) if yaw is not None else rpy
    attitude = None if turned is None else np.radians(turned)
    if compare:
        from kinlab.robots.methods import compare_methods

        report = compare_methods(machine, which, point, frame=frame, rpy=attitude)
        if json:
            print_json(report.to_json())
        else:
            from kinlab.cli.ik_tables import show_comparison

            show_comparison(report)
        if not report.reached:
            raise typer.Exit(1)
        return
    answer = solve_target(machine, which, point, frame=frame, rpy=attitude, method=method)
    write_rrd(rrd, force, lambda: _scene(answer))
    if json:
        document = answer.to_json(servos=servos)
        if as_printed:
            from kinlab.papers import as_printed as evaluate

            printed = evaluate(machine, which, answer.target, answer.rotation)
            document["as_printed"] = [variant.to_json(which, answer.frame) for variant in printed]
        print_json(document)
    else:
        from kinlab.cli.ik_tables import show_answer

        show_answer(answer, every=every, servos=servos, as_printed=as_printed, trace=trace)
    if answer.chosen is None:
        raise typer.Exit(1)


def _scene(answer: "TargetReport") -> "Recording":
    from kinlab.papers import as_printed
    from kinlab.scene import target_scene

    return target_scene(answer, as_printed(answer.robot, answer.limb, answer.target, answer.rotation))
