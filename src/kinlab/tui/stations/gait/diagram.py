"""The gait diagram: a bar for each leg over one cycle, a cursor in it, and a hand that moves it."""

from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, cast

from textual.content import Content
from textual.events import MouseDown, MouseEvent, MouseMove, MouseScrollDown, MouseScrollUp, MouseUp
from textual.message import Message
from textual.widget import Widget

from kinlab.gait import Gait
from kinlab.gait.drawing import bars

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp
    from kinlab.tui.station import Station

GAP = 1


class Diagram(Widget, can_focus=True):
    """Bars, and the instant that is shown; click, drag and wheel move it."""

    DEFAULT_CSS = """
    Diagram { height: auto; }
    Diagram:focus { text-style: none; background: $surface; }
    """

    @dataclass
    class Sought(Message):
        """A person wants to see another instant: a share of the cycle."""

        share: float

    @dataclass
    class Turned(Message):
        """A person turned the wheel: so many frames on, or back."""

        frames: int

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self.share = 0.0
        self._gait: Gait | None = None
        self._legs: tuple[str, ...] = ()
        self._held = False

    def show(self, gait: Gait, legs: tuple[str, ...]) -> None:
        """Show another gait, its legs in this order."""
        self._gait, self._legs = gait, legs
        self.refresh(layout=True)

    def point(self, share: float) -> None:
        """Put the cursor at a share of the cycle."""
        before, self.share = self._cursor(), share
        if self._cursor() != before:
            self.refresh()

    @property
    def _names(self) -> int:
        return max(map(len, self._legs), default=0) + GAP

    def _columns(self) -> int:
        return max(self.size.width - self._names - 1, 8)

    def _cursor(self) -> int:
        return min(int(self.share * self._columns()), self._columns() - 1)

    def render(self) -> Content:
        if self._gait is None:
            return Content("")
        plain = cast("KinlabApp", self.app).ascii_only
        width, at, names = self._columns(), self._cursor(), self._names
        drawn = bars(self._gait, width, ascii_only=plain)
        air, ground = ("#", ".") if plain else ("█", "·")
        colours = {air: "$orange", ground: "$sky"}
        lines = []
        for leg in self._legs:
            bar = drawn[leg]
            pieces: list[str | tuple[str, str]] = [(f"{leg:<{names}}", "bold" if bar[at] == air else "")]
            for part, style in ((bar[:at], ""), (bar[at], " bold reverse"), (bar[at + 1 :], "")):
                pieces += [("".join(run), colours[char] + style) for char, run in groupby(part)]
            lines.append(Content.assemble(*pieces))
        lines.append(Content.assemble(" " * names, (self._axis(width, at, "^" if plain else "▲"), "$quiet")))
        if not self.screen.has_class("-narrow"):
            legend = cast("Station", self.screen).say("diagram.legend", air=air, ground=ground)
            lines.append(Content.assemble(" " * names, (legend, "$quiet")))
        return Content("\n").join(lines)

    def _axis(self, width: int, at: int, mark: str) -> str:
        axis = [" "] * width
        axis[0], axis[-1] = "0", "1"
        percent = f"{self.share:.0%}"
        right = at + len(percent) + 2 < width - 1
        text, begin = (f"{mark} {percent}", at) if right else (f"{percent} {mark}", at - len(percent) - 1)
        axis[begin : begin + len(text)] = text
        return "".join(axis)

    # The mouse.

    def on_mouse_down(self, event: MouseDown) -> None:
        self._held = True
        self.capture_mouse()
        self._seek(event)

    def on_mouse_move(self, event: MouseMove) -> None:
        if self._held:
            self._seek(event)

    def on_mouse_up(self, event: MouseUp) -> None:
        self._held = False
        self.release_mouse()

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        event.stop()
        self.post_message(self.Turned(-1))

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        event.stop()
        self.post_message(self.Turned(1))

    def _seek(self, event: MouseEvent) -> None:
        share = (event.x - self._names + 0.5) / self._columns()
        self.post_message(self.Sought(min(max(share, 0.0), 1 - 1e-9)))
