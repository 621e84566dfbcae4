"""What the commands share: numbers as people type them, the options they have in common, and output."""

import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, get_args, get_origin

import typer

# Typer's insides, which its version is held below 0.30 for: what a parameter's value goes through.
from typer._click.exceptions import BadParameter
from typer._coercion import RuntimeParam
from typer.core import TyperCommand

from kinlab.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Callable

    from kinlab.scene import Recording

_NUMBER = re.compile(r"[+\N{MINUS SIGN}-]?(\d|[.,]\d|inf|nan)", re.IGNORECASE)


def complete_robot(incomplete: str) -> list[str]:
    """Robots' names for the shell."""
    from kinlab.robots import robot_names

    return [name for name in robot_names() if name.startswith(incomplete)]


RobotArgument = Annotated[
    str,
    typer.Argument(
        help="Name of a robot, or a unique beginning of it.",
        show_default=False,
        autocompletion=complete_robot,
    ),
]
LimbOption = Annotated[str | None, typer.Option("--limb", "-l", help="The limb. Default: the robot's first.")]
FrameOption = Annotated[str, typer.Option("--frame", "-f", help="Axes of the numbers: limb, body or paper.")]
GaitOption = Annotated[
    str | None, typer.Option("--gait", "-g", metavar="NAME", help="Default: the first of the robot's kind.")
]
SpeedOption = Annotated[float, typer.Option("--speed", metavar="MM_S", help="Forwards, in mm/s.")]
TurnOption = Annotated[float, typer.Option("--turn", metavar="DEG_S", help="To the left, in deg/s.")]
JsonOption = Annotated[
    bool, typer.Option("--json", help="One JSON document on standard output, nothing else.")
]
RobotsOption = Annotated[
    Path | None,
    typer.Option("--robots", help="A robots file that adds to KinLab's robots. Default: $KINLAB_ROBOTS."),
]
RrdOption = Annotated[
    Path | None, typer.Option("--rrd", metavar="FILE.rrd", help="Write it as a 3-D recording for rerun.")
]
ForceOption = Annotated[bool, typer.Option("--force", help="Replace a recording that exists.")]


@dataclass(frozen=True)
class PlainParam(RuntimeParam):
    """Typed values by Python's own conversions, which start at once; a comma serves as the decimal mark."""

    def _coerce_value(self, value: Any, param: Any, ctx: Any) -> Any:
        return _convert(value, self.annotation, param, ctx)


def _convert(value: Any, annotation: Any, param: Any, ctx: Any) -> Any:
    if get_origin(annotation) in (list, tuple):
        kinds = get_args(annotation)
        kinds = kinds if get_origin(annotation) is tuple else kinds * len(value)
        return [_convert(v, kind, param, ctx) for v, kind in zip(value, kinds, strict=True)]
    if annotation in (float, int) and isinstance(value, str):
        text = value.replace("\N{MINUS SIGN}", "-")
        text = text.replace(",", ".") if annotation is float else text
        try:
            if "_" in text:
                raise ValueError
            return annotation(text)
        except ValueError:
            what = "a number" if annotation is float else "a whole number"
            raise BadParameter(f"expected {what}, got '{value}'", ctx=ctx, param=param) from None
    return annotation(value)


def converted_plainly(params: list[Any]) -> list[Any]:
    """`params` without Typer's own conversion: it imports pydantic, which takes longer than all of `kinlab ik`."""
    for param in params:
        described = param.type_descriptor
        param._runtime_param = PlainParam(described.parameter_info, described.annotation)
    return params


class NumericCommand(TyperCommand):
    """A command for which a token that looks like a number is never an option: `ik udiebot -20 35 -60`."""

    def get_params(self, ctx: Any) -> list[Any]:
        return converted_plainly(super().get_params(ctx))

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        takes: dict[str, int] = {}
        for param in self.params:
            for name in [*param.opts, *param.secondary_opts]:
                flag = getattr(param, "is_flag", False) or getattr(param, "count", False)
                takes[name] = 0 if flag else param.nargs
        options: list[str] = []
        values: list[str] = []
        rest = list(args)
        while rest:
            token = rest.pop(0)
            if token == "--":
                values += rest
                break
            if not token.startswith("-") or token == "-" or _NUMBER.match(token):
                values.append(token)
                continue
            options.append(token)
            # Only an option given by its exact name, without "=", takes the tokens that follow it.
            wanted = takes.get(token, 0)
            if len(rest) < wanted or "--" in rest[:wanted]:
                values_word = "a value" if wanted == 1 else f"{wanted} values"
                raise UsageError(f"{token} takes {values_word}, got {' '.join(rest[:wanted]) or 'none'}")
            options += rest[:wanted]
            del rest[:wanted]
        return super().parse_args(ctx, [*options, "--", *values])


def command_app() -> typer.Typer:
    """A Typer application of one command, in the house's style."""
    return typer.Typer(
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        add_completion=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )


def check_rrd(path: Path | None, force: bool, option: str = "--rrd") -> None:
    """Refuse, before the work, a recording that could not be written; nothing where none is asked for."""
    if path:
        from kinlab.scene import check_new, load_rerun

        load_rerun()
        check_new(path, force)
    elif force:
        raise UsageError(f"--force is for {option}: there is no file to replace")


def write_rrd(path: Path | None, force: bool, scene: "Callable[[], Recording]") -> int | None:
    """Write a recording where one is asked for, and say how to look at it; its size in bytes."""
    if path is None:
        return None
    from shlex import quote

    from kinlab.scene import save

    size = save(scene(), path, force)
    typer.echo(
        f"kinlab: {path}: {size / 1000:.0f} kB; look at it with: kinlab view {quote(str(path))}", err=True
    )
    return size


def print_json(document: Any) -> None:
    """The one JSON document on standard output."""
    typer.echo(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False))
