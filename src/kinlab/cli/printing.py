"""Lines of (style, text) on standard output, coloured where a person reads them."""

import os
import sys
from collections.abc import Iterable

import typer

ANSI = {
    "arrow": "1",
    "header": "90",
    "id": "36",
    "length": "34",
    "instruction": "35",
    "address": "33",
    "data": "32",
    "check": "94",
    "good": "32",
    "bad": "31",
    "odd": "33",
    "dim": "90",
    "verb": "1",
}


def print_lines(lines: Iterable[list[tuple[str, str]]]) -> None:
    """Lines of (style, text); plain when piped, or with NO_COLOR."""
    coloured = sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
    for line in lines:
        if coloured:
            typer.echo(
                "".join(f"\x1b[{ANSI[style]}m{text}\x1b[0m" if style else text for style, text in line)
            )
        else:
            typer.echo("".join(text for _, text in line).rstrip())
