"""The group `kinlab`, which imports a command's module when that command is asked for."""

import os
import sys
from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

import kinlab as package
from kinlab.cli.command import converted_plainly

COMMANDS = {
    "tour": "the whole path once, in ten seconds: the first thing to run",
    "robots": "list the robots; show one with the source of every dimension; write URDF",
    "ik": "a target in millimetres as joint angles, servo ticks, and the error they leave",
    "fk": "joint angles as the position and attitude of the tip",
    "body": "every leg's joints for a pose of the body over fixed feet",
    "workspace": "how far a limb reaches, and where it cannot",
    "gait": "a gait phase by phase: which legs swing, which carry, how safely, how fast at most",
    "walk": "the gait on the servos: joint speeds, loads, tracking error, energy; sweeps and comparisons",
    "arm": "the receptionist's arm follows a line, yields to a hand, and observes what pushes it",
    "view": "see a robot, a target, a gait or an experiment in 3-D, in rerun",
    "packet": "Dynamixel packets byte by byte, at a prompt, on an emulated chain or a real bus",
    "emulate": "an emulated servo chain for other programs, on a pty or TCP",
    "learn": "the course: lessons that check themselves, in English and Bahasa Indonesia",
    "bus": "scan, read, write and monitor the servos on a port",
    "papers": "every number that the papers print, recomputed: what follows, what does not, and why",
    "serve": "the laboratory in a browser, for one person or a class",
}


class LazyGroup(TyperGroup):
    """A command group whose members are imported one by one, when they are needed."""

    def __init__(self, **attrs: Any) -> None:
        super().__init__(**attrs)
        # Typer takes the names from here for "did you mean".
        self.commands: Any = dict.fromkeys(COMMANDS)

    def get_params(self, ctx: Any) -> list[Any]:
        return converted_plainly(super().get_params(ctx))

    def list_commands(self, ctx: Any) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if cmd_name not in COMMANDS:
            return None
        command = typer.main.get_command(import_module(f"kinlab.cli.{cmd_name}").app)
        command.name = cmd_name
        command.short_help = COMMANDS[cmd_name]
        return command


app = typer.Typer(
    cls=LazyGroup,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"kinlab {package.__version__}")
        raise typer.Exit


@app.callback(epilog="Start with: kinlab tour")
def _root(
    ctx: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """A robotics laboratory for the terminal. Without a command, it opens there.

    Pick a robot, give a target in millimetres, and see the joint angles, the
    servo ticks, and how far off the foot lands.
    """
    if ctx.invoked_subcommand is not None:
        return
    if sys.stdin.isatty() and sys.stdout.isatty() and os.environ.get("TERM") != "dumb":
        from kinlab.tui.app import run

        raise typer.Exit(run())
    typer.echo(ctx.get_help())


kinlab = typer.main.get_command(app)
