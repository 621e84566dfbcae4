"""`kinlab body`: every leg's joints for a pose of the body over fixed feet."""

from typing import Annotated

import typer

from kinlab.cli.command import (
    JsonOption,
    NumericCommand,
    RobotArgument,
    RobotsOption,
    command_app,
    print_json,
)

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab body krsri-hexapod --xyz 0 0 20 --rpy 5 0 10")
def body(
    robot: RobotArgument,
    xyz: Annotated[
        tuple[float, float, float],
        typer.Option(metavar="X Y Z", help="Displacement of the body, in mm."),
    ] = (0.0, 0.0, 0.0),
    rpy: Annotated[
        tuple[float, float, float], typer.Option(metavar="R P Y", help="Its roll, pitch and yaw, in deg.")
    ] = (0.0, 0.0, 0.0),
    as_printed: Annotated[
        bool, typer.Option("--as-printed", help="Where the paper's equations put the feet, and why.")
    ] = False,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Every leg's joints for a pose of the body over fixed feet."""
    from kinlab.robots import load_robot
    from kinlab.robots.body import stand

    machine = load_robot(robot, robots)
    answer = stand(machine, xyz, rpy)
    printed = None
    if as_printed:
        from kinlab.papers import body_as_printed

        printed = body_as_printed(machine, answer.xyz, answer.rpy)
    if json:
        document = answer.to_json()
        if as_printed:
            document["as_printed"] = [] if printed is None else [printed.to_json()]
        print_json(document)
    else:
        from kinlab.cli.body_tables import show_answer

        show_answer(answer, printed, asked=as_printed)
    if not answer.pose.reachable.all():
        raise typer.Exit(1)
