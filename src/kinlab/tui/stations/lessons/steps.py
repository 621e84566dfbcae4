"""The exercises of a lesson in a row, each with how it stands and at a click."""

from collections.abc import Sequence
from dataclasses import dataclass

from textual.content import Content
from textual.events import Click
from textual.message import Message
from textual.widget import Widget

# For each way that an exercise or a lesson may stand: a sign, one for terminals without it, and a colour.
SIGNS = {
    "open": ("○", ".", ""),
    "begun": ("◐", "-", "$orange"),
    "solved": ("●", "*", "$sky"),
    "shown": ("◆", "=", "$orange"),
    "end": ("■", "#", ""),
    "broken": ("×", "x", "$vermillion"),
}


def sign(standing: str, ascii_only: bool) -> Content:
    """How something stands, in one character."""
    mark, plain, colour = SIGNS[standing]
    return Content.styled(plain if ascii_only else mark, colour)


class Steps(Widget):
    """Numbers with signs; where one is now is reversed."""

    DEFAULT_CSS = "Steps { height: 1; width: 1fr; padding: 0 1; }"
    WIDTH = 5

    @dataclass
    class Chosen(Message):
        """A step was clicked at."""

        step: int

    def __init__(self) -> None:
        super().__init__()
        self._standings: Sequence[str] = ()
        self._at = 0
        self._ascii = False

    def put(self, standings: Sequence[str], at: int, *, ascii_only: bool) -> None:
        """Show how each step stands, and where one is."""
        self._standings, self._at, self._ascii = standings, at, ascii_only
        self.refresh()

    @property
    def _wide(self) -> int:
        """Columns of each; fewer where there are many."""
        return max(min(self.WIDTH, self.size.width // max(len(self._standings), 1)), 2)

    def render(self) -> Content:
        pieces = []
        for i, standing in enumerate(self._standings):
            mark = sign(standing, self._ascii)
            name = "" if standing == "end" else str(i + 1)
            text = Content.assemble(f" {name}" if self._wide > len(name) + 1 else name, mark)
            text = Content.assemble(text, " " * max(self._wide - text.cell_length, 0))
            pieces.append(text.stylize("bold reverse") if i == self._at else text)
        return Content.assemble(*pieces)

    def on_click(self, event: Click) -> None:
        step = (event.x - 1) // self._wide
        if 0 <= step < len(self._standings):
            self.post_message(self.Chosen(step))
