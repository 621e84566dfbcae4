"""The bar at the top: the stations with the keys that open them, each at a click."""

from typing import TYPE_CHECKING, cast

from textual.content import Content
from textual.events import Click
from textual.widget import Widget

from kinlab.tui.stations import STATIONS
from kinlab.tui.widgets.said import say

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp


class StationBar(Widget):
    """The program's name, and the stations with the keys that open them now; the open one is reversed."""

    DEFAULT_CSS = "StationBar { height: 1; background: $panel; color: $foreground; }"

    def on_mount(self) -> None:
        self.screen.bindings_updated_signal.subscribe(self, lambda _: self.refresh())

    def _parts(self) -> list[tuple[str, str]]:
        """The texts of the bar, each with the station that it leads to."""
        focused = self.screen.focused
        parts = [(" KinLab ", "")]
        for i, name in enumerate(STATIONS, 1):
            # A field takes digits for itself; there, the function key is the one that works.
            taken = focused is not None and focused.check_consume_key(str(i), str(i))
            key = f"F{i + 1}" if taken else f"{i}"
            parts.append((f" {key} {say(self, f'station.{name}')} ", name))
        # Where there is no room for all, it is the program's name that can be spared.
        room = self.size.width - sum(len(text) for text, _ in parts)
        return parts if room >= 0 else parts[1:]

    def render(self) -> Content:
        mode = self.app.current_mode
        pieces = [
            Content.styled(text, "bold reverse" if name == mode else ("bold" if not name else ""))
            for text, name in self._parts()
        ]
        return Content.assemble(*pieces)

    async def on_click(self, event: Click) -> None:
        at = 0
        for text, name in self._parts():
            at += len(text)
            if event.x < at:
                if name:
                    await cast("KinlabApp", self.app).open_station(name)
                return
