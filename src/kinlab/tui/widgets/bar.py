"""The bar at the top: the stations, each at a click."""

from typing import TYPE_CHECKING, cast

from textual.content import Content
from textual.events import Click
from textual.widget import Widget

from kinlab.tui.stations import STATIONS
from kinlab.tui.widgets.said import say

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp


class StationBar(Widget):
    """The program's name, and the stations with their digits; the open one is reversed."""

    DEFAULT_CSS = "StationBar { height: 1; background: $panel; color: $foreground; }"

    def _parts(self) -> list[tuple[str, str]]:
        """The texts of the bar, each with the station that it leads to."""
        parts = [(" KinLab ", "")]
        for i, name in enumerate(STATIONS, 1):
            parts.append((f" {i} {say(self, f'station.{name}')} ", name))
        return parts

    def render(self) -> Content:
        mode = self.app.current_mode
        pieces = [
            Content.styled(text, "bold reverse" if name == mode else ("bold" if not name else ""))
            for text, name in self._parts()
        ]
        return Content.assemble(*pieces)

    def on_click(self, event: Click) -> None:
        at = 0
        for text, name in self._parts():
            at += len(text)
            if event.x < at:
                if name:
                    cast("KinlabApp", self.app).open_station(name)
                return
