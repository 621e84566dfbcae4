"""`kinlab fk`: joint angles as the place and attitude of the tip."""

from typing import Annotated, Any

import typer

from kinlab.cli.command import (
    FrameOption,
    JsonOption,
    LimbOption,
    NumericCommand,
    RobotArgument,
    RobotsOption,
    command_app,
    print_json,
)

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab fk xl430-hexapod 7.6 28.3 -112.8 --jacobian")
def fk(
    robot: RobotArgument,
    angles: Annotated[
        list[float],
        typer.Argument(
            metavar="ANGLE...", help="The joints' angles in deg, from the body.", show_default=False
        ),
    ],
    limb: LimbOption = None,
    frame: FrameOption = "limb",
    dh: Annotated[bool, typer.Option("--dh", help="The limb's Denavit-Hartenberg parameters.")] = False,
    jacobian: Annotated[
        bool, typer.Option("--jacobian", help="The Jacobian and its manipulability.")
    ] = False,
    as_printed: Annotated[
        bool, typer.Option("--as-printed", help="What the paper's equations give as they stand, and why.")
    ] = False,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Joint angles as the place and attitude of the tip."""
    from kinlab.robots import load_robot
    from kinlab.robots.tip import pose_of_tip

    machine = load_robot(robot, robots)
    which = machine.limb(limb)
    answer = pose_of_tip(machine, which, angles, frame=frame)
    printed: Any = ()
    if as_printed:
        from kinlab.papers import fk_as_printed

        printed = fk_as_printed(machine, which, answer.q)
    if json:
        document = answer.to_json(jacobian=jacobian)
        if dh:
            document["dh"] = answer.dh_json()
        if as_printed:
            document["as_printed"] = [variant.to_json(which, answer.frame) for variant in printed]
        print_json(document)
        return
    from kinlab.cli.fk_tables import show_answer

    show_answer(answer, dh=dh, jacobian=jacobian, printed=printed if as_printed else None)
