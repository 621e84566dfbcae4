"""How far walks in simulated time have come, on standard error."""

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kinlab.rig import Errand, Sample


@contextmanager
def progress(errands: Sequence["Errand"]) -> Iterator[Callable[["Errand", "Sample"], None]]:
    """A function that is told of every tick; a bar where a person looks, else nothing."""
    if not sys.stderr.isatty():
        yield lambda errand, sample: None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bars:
        task = bars.add_task("to the first pose", total=sum(errand.walk.duration for errand in errands))

        def tell(errand: "Errand", sample: "Sample") -> None:
            before = sum(e.walk.duration for e in errands[: errands.index(errand)])
            text = f"{errand.order.gait.name} {errand.order.speed * 1000:g} mm/s, {sample.way:.0f} s"
            bars.update(task, completed=before + sample.way, description=text)

        yield tell
