"""Buttons as on a player: back and forth by phase and by frame, play and pause."""

from typing import TYPE_CHECKING, cast

from textual.content import Content
from textual.events import Click
from textual.widget import Widget

if TYPE_CHECKING:
    from kinlab.tui.station import Station

BUTTONS = (("|<", "phase(-1)"), ("<", "frame(-1)"), ("", "play"), (">", "frame(1)"), (">|", "phase(1)"))


class Transport(Widget):
    """Five buttons in a row; each runs an action of the station."""

    DEFAULT_CSS = "Transport { width: 28; height: 1; }"
    playing = False

    def show(self, playing: bool) -> None:
        """Whether it is playing."""
        if playing != self.playing:
            self.playing = playing
            self.refresh()

    def _parts(self) -> list[tuple[str, str]]:
        station = cast("Station", self.screen)
        middle = station.say("transport.pause" if self.playing else "transport.play")
        return [(f" {sign or f'{middle:^5}'} ", run) for sign, run in BUTTONS]

    def render(self) -> Content:
        pieces: list[tuple[str, str] | str] = []
        for text, _ in self._parts():
            pieces += [(text, "bold on $panel"), " "]
        return Content.assemble(*pieces)

    async def on_click(self, event: Click) -> None:
        at = 0
        for text, run in self._parts():
            if at <= event.x < at + len(text):
                await self.screen.run_action(run)
                return
            at += len(text) + 1
