"""Names of views in a row, of which one is open."""

from collections.abc import Sequence
from dataclasses import dataclass

from textual.content import Content
from textual.events import Click
from textual.message import Message
from textual.widget import Widget


class Tabs(Widget):
    """One row of names, each at a click; the open one is reversed."""

    DEFAULT_CSS = "Tabs { height: 1; padding: 0 1; color: $quiet; }"

    @dataclass
    class Chosen(Message):
        """A view was clicked at."""

        name: str

    def __init__(self, views: Sequence[str]) -> None:
        super().__init__()
        self._labels = {view: view for view in views}
        self._open = views[0]

    def name_them(self, labels: dict[str, str], chosen: str) -> None:
        """Other words for the views."""
        self._labels = labels
        self.choose(chosen)

    def choose(self, view: str) -> None:
        """Open a view; tells nobody."""
        self._open = view
        self.refresh()

    def render(self) -> Content:
        return Content.assemble(
            *(
                Content.styled(f" {label} ", "bold reverse" if view == self._open else "")
                for view, label in self._labels.items()
            )
        )

    def on_click(self, event: Click) -> None:
        at = 1
        for view, label in self._labels.items():
            at += len(label) + 2
            if event.x < at:
                self.post_message(self.Chosen(view))
                return
