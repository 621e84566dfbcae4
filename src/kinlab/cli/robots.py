"""`kinlab robots`: the robots, and everything about one with its source."""

from typing import Annotated

import typer

from kinlab.cli.command import (
    JsonOption,
    NumericCommand,
    RobotsOption,
    command_app,
    complete_robot,
    print_json,
)

app = command_app()


@app.command(
    cls=NumericCommand, epilog="Example: kinlab robots udiebot; kinlab robots udiebot --urdf > udiebot.urdf"
)
def robots(
    name: Annotated[
        str | None, typer.Argument(help="Show this robot.", show_default=False, autocompletion=complete_robot)
    ] = None,
    urdf: Annotated[bool, typer.Option("--urdf", help="Write the robot as URDF to standard output.")] = False,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """List the robots; or show one: lengths, joints, limits and servos, each with its source."""
    from kinlab.errors import UsageError
    from kinlab.robots import load_robot, load_robots
    from kinlab.robots.describe import describe

    if urdf and json:
        raise UsageError("--urdf and --json are two formats: give one")
    if name is None:
        if urdf:
            raise UsageError("--urdf writes one robot: name it, as in kinlab robots udiebot --urdf")
        machines = load_robots(robots)
        if json:
            print_json({"robots": [describe(machine) for machine in machines.values()]})
            return
        from kinlab.cli.robots_tables import show_list

        show_list(list(machines.values()))
        return
    machine = load_robot(name, robots)
    if urdf:
        from kinlab.robots.urdf import to_urdf

        typer.echo(to_urdf(machine), nl=False)
    elif json:
        print_json(describe(machine))
    else:
        from kinlab.cli.robots_tables import show_robot

        show_robot(machine)
