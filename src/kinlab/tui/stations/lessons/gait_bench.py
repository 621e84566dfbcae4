"""The gaits of a lesson's robot: bars over a cycle, and at an instant of it the feet from above."""

from dataclasses import dataclass
from typing import Any, ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.message import Message
from textual.widgets import Select

from kinlab.canvas import Canvas
from kinlab.gait import Cycle, gaits_for
from kinlab.gait.drawing import draw_support
from kinlab.tui.numbers import shown
from kinlab.tui.stations.gait.diagram import Diagram
from kinlab.tui.widgets import Choice, Picture, Said


class GaitBench(Vertical):
    """A gait to choose, its diagram to move in, and what the robot stands on then."""

    DEFAULT_CSS = """
    GaitBench {
        #chosen { height: 1; }
        Choice { width: 16; margin-right: 1; }
        Picture { height: 1fr; }
    }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", "step(-1)", show=False),
        Binding("right", "step(1)", show=False),
    ]

    @dataclass
    class Wanted(Message):
        """Another gait is to be shown; `GaitBench.take` takes it."""

        gait: str

    def __init__(self) -> None:
        super().__init__()
        self.cycle: Cycle | None = None
        self.t = 0.0

    def compose(self) -> ComposeResult:
        with Horizontal(id="chosen"):
            yield Choice([], "")
            yield Said("walk.nothing", id="standing")
        yield Diagram()
        yield Picture(self._draw, self._caption)

    def take(self, cycle: Cycle) -> None:
        """Show a walk, from the beginning of its cycle."""
        self.cycle = cycle
        robot, gait = cycle.walk.robot, cycle.walk.gait
        self.query_one(Choice).offer(gaits_for(robot), gait.name)
        self.query_one(Diagram).show(gait, tuple(leg.name for leg in robot.legs))
        self._show(0.0)

    def _show(self, t: float) -> None:
        cycle = self.cycle
        if cycle is None:
            return
        self.t = t % cycle.walk.period
        frame = cycle.frame_at(self.t)
        self.query_one(Diagram).point(self.t / cycle.walk.period)
        self.query_one("#standing", Said).fill(
            "walk.standing",
            now=f"{cycle.state.static[frame] * 1000:.1f}",
            least=f"{min(each.static for each in cycle.least) * 1000:.1f}",
        )
        self.query_one(Picture).redraw()

    def _draw(self, columns: int, rows: int, ascii_only: bool) -> Canvas | None:
        if self.cycle is None:
            return None
        state = self.cycle.state
        return draw_support(
            state.frame(self.cycle.frame_at(self.t)), around=state, columns=columns, rows=rows,
            ascii_only=ascii_only,
        )  # fmt: skip

    def _caption(self, canvas: Canvas) -> str:
        station: Any = self.screen
        return str(station.say("leg.top", cell=shown(canvas.cell_width, 1)))

    def action_step(self, frames: int) -> None:
        """Go on by frames, or back."""
        if self.cycle is not None:
            self._show(self.cycle.frames_on(self.t, frames))

    @on(Select.Changed)
    def _chosen(self, event: Select.Changed) -> None:
        event.stop()
        self.post_message(self.Wanted(str(event.value)))

    @on(Diagram.Sought)
    def _sought(self, event: Diagram.Sought) -> None:
        event.stop()
        if self.cycle is not None:
            self._show(event.share * self.cycle.walk.period)

    @on(Diagram.Turned)
    def _turned(self, event: Diagram.Turned) -> None:
        event.stop()
        self.action_step(event.frames)
