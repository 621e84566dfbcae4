"""How `kinlab arm` shows itself: plots, verdicts, maps, and a run while it goes on."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from rich.console import Group, RenderableType
from rich.text import Text

from kinlab.cli.show import console, number, plotted, sentences, show, table

if TYPE_CHECKING:
    from kinlab.papers.receptionist_experiments import Outcome, Tell
    from kinlab.rig.arm import Record
    from kinlab.rig.arm.stability import StabilityMap

SHOWN_EVERY = 4  # cycles
MARKS = (".", "~", "#")
MAP_STYLES = ("green", "yellow", "red")


def show_outcome(outcome: "Outcome", plot: str) -> None:
    """Plots of every run, then the claims with their verdicts."""
    show(Text(outcome.title, style="bold"))
    for name, record in outcome.runs.items():
        show("", *plots(record, plot, name))
    bus = [f"{name}: {_bus(record)}" for name, record in outcome.runs.items()]
    if outcome.claims:
        found = table("", "paper", "claim", ("rig", ""), "verdict")
        found.title = None
        for claim in outcome.claims:
            found.add_row(claim.where, claim.claim, f"{claim.measured:.2f} {claim.unit}", claim.verdict)
        show("", found, "", sentences(*((claim.verdict, claim.cause) for claim in outcome.claims)))
    show("", sentences(*(("note", note) for note in outcome.notes), *(("bus", text) for text in bus)))


def _bus(record: "Record") -> str:
    said = record.to_json()
    busy, late, missed = said["busy_ms"], said["overruns"], said["missed"]
    text = f"packets take {busy['mean']:.2f} of {said['cycle_ms']:g} ms, at most {busy['max']:.2f}"
    text += f"; {late} cycles did not fit" if late else "; every cycle fits"
    causes = ", ".join(f"{cause} ({count}x)" for cause, count in said["causes"].items())
    return text + (f"; {missed} answers missed, held: {causes}" if missed else "")


def plots(record: "Record", plot: str, name: str) -> list[RenderableType]:
    """The charts that belong to an experiment: "error", "torque" or "pushes"."""
    columns = {key: values.tolist() for key, values in record.columns().items()}

    def curves(kind: str, unit: str) -> dict[str, list[tuple[float, float]]]:
        names = record.limb.joint_names
        return {j: list(zip(columns["t_s"], columns[f"{kind}_{j}_{unit}"], strict=True)) for j in names}

    if plot == "error":
        return plotted(f"{name}: command less position", curves("error", "deg"), "s", "deg")
    kinds = {"torque": ("filtered", "dynamic"), "pushes": ("pushed", "reaction", "external")}[plot]
    return [
        part for kind in kinds for part in plotted(f"{name}: {kind} torque", curves(kind, "nm"), "s", "N m")
    ]


@contextmanager
def watching(live: bool, real: bool) -> "Iterator[Tell | None]":
    """A function to tell of each cycle, which draws the run on a terminal; None where nobody watches."""
    if not (live or real) or not sys.stdout.isatty():
        yield None
        return
    from rich.live import Live

    begun = time.monotonic()
    with Live(console=console(), auto_refresh=False, transient=True) as screen:

        def tell(k: int, record: "Record") -> None:
            if live and not real:
                time.sleep(max(0.0, begun + k * record.dt - time.monotonic()))
            if k and k % SHOWN_EVERY == 0:
                screen.update(Group(*plots(record.until(k), "error", "live")), refresh=True)

        yield tell


@contextmanager
def progress(count: int) -> Iterator[Callable[[], None]]:
    """A bar on standard error, on a terminal, that a function moves on."""
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()) as bar:
        task = bar.add_task("running the loop", total=count)
        yield lambda: bar.advance(task)


def show_map(found: "StabilityMap") -> None:
    """The map, y upwards, with the linear model's bounds in it."""
    show(Text(f"{found.law} control: {found.y} over {found.x}, both logarithmic", style="bold"))
    for row in reversed(range(len(found.ys))):
        text = Text(f"{found.ys[row]:>9.3g} ")
        for column in range(len(found.xs)):
            state = int(found.state[row, column])
            text.append(found.bound_at(row, column) or MARKS[state], style=MAP_STYLES[state])
        show(text)
    left, right = f"{found.xs[0]:.3g}", f"{found.xs[-1]:.3g}"
    show(Text(" " * 10 + left + right.rjust(len(found.xs) - len(left))))
    names = [(".", "settles"), ("~", "oscillates"), ("#", "runs away")]
    if found.critical is not None:
        names.append(("o", "linear model: damping ratio 1, oscillates below it for kv and denv (2.12, 2.14)"))
    if found.sampled is not None:
        names.append(("+", "linear model, sampled, one cycle of delay: runs away beyond"))
    show("", sentences(*names))
    if found.critical is None:
        show(Text("No bound: these two gains alone do not decide the linear model's damping."))
    counts = found.counts()
    show(Text(", ".join(f"{number(share * 100, 1)} % {name}" for name, share in counts.items())))
