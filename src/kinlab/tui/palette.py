"""The command palette: every action of the station, every station, and what works everywhere."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any, cast

from textual.command import DiscoveryHit, Hit, Hits, Provider
from textual.content import Content

from kinlab.tui.station import Station
from kinlab.tui.stations import STATIONS

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp


class Actions(Provider):
    """Actions by their help texts, in the language of now."""

    def _entries(self) -> Iterator[tuple[str, str, Callable[[], Any]]]:
        app = cast("KinlabApp", self.app)
        station = self.screen
        if not isinstance(station, Station):
            return
        for name in STATIONS:
            title = station.say("shell.open", station=station.say(f"station.{name}"))
            yield title, station.say(f"about.{name}"), partial(app.open_station, name)
        # What has a key for each direction comes last: it is rarely looked for here.
        for action in sorted(station.all_actions(), key=lambda action: bool(action.each)):
            if action.id == "palette":
                continue
            keys = action.keys.split(",")
            for i, run in enumerate(action.runs):
                which = f" ({keys[i]})" if action.each else ""
                area = f"{station.say(f'station.{station.NAME}')}: " if action in station.ACTIONS else ""
                title = area + station.say(f"action.{action.id}.label") + which
                yield title, station.say(f"action.{action.id}.help"), partial(station.run_action, run)

    async def discover(self) -> Hits:
        for title, text, run in self._entries():
            yield DiscoveryHit(Content(title), run, title, text)

    async def search(self, query: str) -> Hits:
        matcher = self.matcher(query)
        for title, text, run in self._entries():
            score = max(matcher.match(title), matcher.match(text) * 0.8)
            if score > 0:
                yield Hit(score, Content(title), run, title, text)
