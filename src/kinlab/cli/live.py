"""The monitor's rounds on a terminal: a table that stays in place, or lines where the output is piped."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from rich.table import Table

    from kinlab.dynamixel.monitor import Monitor, Round


@contextmanager
def shown(monitor: "Monitor") -> Iterator[Callable[["Round"], None]]:
    """A function that shows a round."""
    if not sys.stdout.isatty():
        typer.echo(" ".join(["time_s", "id", *monitor.columns]))
        yield _print
        return
    from rich.live import Live

    with Live(auto_refresh=False) as live:
        yield lambda seen: live.update(_table(monitor, seen), refresh=True)


def _print(seen: "Round") -> None:
    for servo, row in seen.values.items():
        cells = ["-" if value is None else f"{value:g}" for value in row.values()]
        typer.echo(" ".join([f"{seen.time:.3f}", str(servo), *cells, seen.faults.get(servo, "")]).rstrip())


def _table(monitor: "Monitor", seen: "Round") -> "Table":
    from rich.table import Table

    table = Table(title=f"{seen.time:.1f} s   Ctrl-C ends")
    for name in ("id", *monitor.columns):
        table.add_column(name.removeprefix("present_"), justify="right")
    table.add_column("fault")
    for servo, row in seen.values.items():
        values = (row.get(name) for name in monitor.columns)
        table.add_row(
            str(servo),
            *("" if v is None else f"{v:g}" for v in values),
            seen.faults.get(servo, ""),
            style=None,
        )
    return table
