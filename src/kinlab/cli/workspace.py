"""`kinlab workspace`: how far a limb reaches, and where it cannot."""

from typing import Annotated

import typer

from kinlab.cli.command import (
    JsonOption,
    LimbOption,
    NumericCommand,
    RobotArgument,
    RobotsOption,
    command_app,
    print_json,
)

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab workspace xl430-hexapod --limb R1 --samples 100000")
def workspace(
    robot: RobotArgument,
    limb: LimbOption = None,
    samples: Annotated[
        int, typer.Option("--samples", "-n", help="How many poses and places to try.")
    ] = 20_000,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """How far a limb reaches, and where it cannot, within the limits of joints and servos."""
    from kinlab.robots import load_robot
    from kinlab.robots.workspace import workspace as explore

    machine = load_robot(robot, robots)
    answer = explore(machine, machine.limb(limb), samples=samples)
    if json:
        print_json(answer.to_json())
        return
    from rich.text import Text

    from kinlab.cli.show import number, place, section, show, table

    found = answer.to_json()
    show(Text(f"{answer.robot.name} {answer.limb.name}", style="bold"))
    facts = table(f"workspace in the limb frame, {answer.samples} samples", "", "")
    facts.show_header = False
    facts.add_row("box", f"{place(found['lower_mm'], 1)} to {place(found['upper_mm'], 1)} mm")
    facts.add_row(
        "distance from first joint",
        f"{number(found['nearest_mm'], 1)} to {number(found['farthest_mm'], 1)} mm",
    )
    if answer.volume is None:
        facts.add_row("volume", "not estimated: this limb has no closed form to try places with")
    else:
        facts.add_row(
            "volume", f"{found['volume_cm3']:.1f} cm3, standard error {found['volume_error_cm3']:.1f}"
        )
    show("", facts)
    show("", *section("side", answer.side, answer.limb), "", *section("top", answer.top, answer.limb))
