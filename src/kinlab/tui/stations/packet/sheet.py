"""The sheet on which a packet is shown, taken apart."""

from collections.abc import Sequence

from textual.app import ComposeResult
from textual.containers import VerticalScroll
from textual.content import Content
from textual.events import Resize
from textual.widgets import Static

from kinlab.dynamixel.sandbox.session import Line
from kinlab.tui.stations.packet.styles import content, folded


class Sheet(VerticalScroll, can_focus=True):
    """Lines of the sandbox, folded to its width."""

    DEFAULT_CSS = """
    Sheet {
        height: 1fr; padding: 0 1;
        scrollbar-size-vertical: 1;
    }
    Sheet > Static { width: 100%; height: auto; }
    """

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._lines: Sequence[Line] = ()
        self._rows = 0
        self._page = Static(markup=False)

    def compose(self) -> ComposeResult:
        yield self._page

    def put(self, lines: Sequence[Line], *, to_end: bool = False) -> None:
        """Show these lines from the first one on, or down to the last one."""
        if lines != self._lines:
            # A copy: a list that goes on growing would never differ from itself.
            self._lines = list(lines)
            self._write()
        if to_end:
            self.scroll_end(animate=False)
        else:
            self.scroll_home(animate=False)

    def on_resize(self, event: Resize) -> None:
        self._write()

    def _write(self) -> None:
        width = max(self.scrollable_content_region.width, 20)
        rows = folded(self._lines, width)
        # The layout of the screen is the costly part; it changes only where the height does.
        self._page.update(Content("\n").join(content(row) for row in rows), layout=len(rows) != self._rows)
        self._rows = len(rows)
