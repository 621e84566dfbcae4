"""The panel of a walk in real time: what krsri-hexapod's web page shows (figure 9), and its speed control."""

import sys
from collections.abc import Callable
from contextlib import ExitStack
from threading import Thread
from types import TracebackType
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from rich.panel import Panel as RichPanel

    from kinlab.rig import Errand, Sample, Throttle

EVERY = 0.1  # s between pictures
EVERY_LINE = 1.0  # s between lines where the output is no terminal
KEYS = {
    "+": 1, "=": 1, "\x1b[A": 1, "\x1b[C": 1, "\x1bOA": 1, "\x1bOC": 1,
    "-": -1, "\x1b[B": -1, "\x1b[D": -1, "\x1bOB": -1, "\x1bOD": -1,
}  # fmt: skip


class Panel:
    """A context that gives a function to tell every tick; keys change the walk's speed meanwhile."""

    def __init__(self, errand: "Errand", throttle: "Throttle") -> None:
        self._errand = errand
        self._throttle = throttle
        self._stack = ExitStack()
        self._shown = -EVERY_LINE

    def __enter__(self) -> Callable[["Errand", "Sample"], None]:
        if sys.stdin.isatty():
            from kinlab.cli.keys import keys

            read = self._stack.enter_context(keys())
            Thread(target=self._listen, args=(read,), daemon=True).start()
        if not sys.stdout.isatty():
            return self._line
        from rich.live import Live

        screen = self._stack.enter_context(Live(auto_refresh=False))

        def draw(errand: "Errand", sample: "Sample") -> None:
            if sample.t - self._shown >= EVERY:
                self._shown = sample.t
                screen.update(self._picture(sample), refresh=True)

        return draw

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    def _listen(self, read: Callable[[], str]) -> None:
        while key := read():
            # Keys pressed quickly come in one piece.
            for pressed in [key] if key.startswith("\x1b") else key:
                if pressed in ("q", "Q"):
                    self._throttle.stopped = True
                    return
                self._throttle.change(KEYS.get(pressed, 0))

    def _facts(self, sample: "Sample") -> dict[str, str]:
        order = self._errand.order
        return {
            "timer": f"{sample.t:.1f} s",
            "voltage": f"{sample.voltage:.2f} V",
            "current": f"{sample.current:.3f} A",
            "power": f"{sample.power:.2f} W",
            "energy": f"{sample.energy:.4f} Wh",
            "speed": f"{sample.tempo * order.speed * 1000:.1f} mm/s ({sample.tempo:.0%})",
            "walked": f"{sample.way / self._errand.walk.duration:.0%}",
        }

    def _line(self, errand: "Errand", sample: "Sample") -> None:
        if sample.t - self._shown >= EVERY_LINE:
            self._shown = sample.t
            typer.echo("  ".join(f"{name} {fact}" for name, fact in self._facts(sample).items()))

    def _picture(self, sample: "Sample") -> "RichPanel":
        from rich.panel import Panel as RichPanel
        from rich.table import Table

        facts = Table(box=None, show_header=False, padding=(0, 2))
        for name, fact in self._facts(sample).items():
            facts.add_row(name, fact)
        facts.add_row("keys", "+ faster, - slower, q stops")
        walk = self._errand.walk
        return RichPanel(facts, title=f"{walk.robot.name}, {walk.gait.name}", expand=False)
