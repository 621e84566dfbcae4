"""Commands that take numbers: `kinlab ik udiebot -20 35 -60` needs no `--` before a minus sign."""

import re
from typing import Any

import typer
from typer.core import TyperCommand

_NUMBER = re.compile(r"[+-]?(\d|\.\d|inf|nan)", re.IGNORECASE)


class NumericCommand(TyperCommand):
    """A command for which a token that looks like a number is never an option."""

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
            options += rest[:wanted]
            del rest[:wanted]
        return super().parse_args(ctx, [*options, "--", *values])


def numeric_app(**settings: Any) -> typer.Typer:
    """A Typer application of one command, in the house's style."""
    return typer.Typer(
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
        **settings,
    )
