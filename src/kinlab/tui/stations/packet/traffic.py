"""What went over the wire, packet for packet."""

from dataclasses import dataclass

from textual import on
from textual.content import Content
from textual.events import Resize
from textual.message import Message
from textual.widgets import OptionList

from kinlab.dynamixel.sandbox import Session
from kinlab.dynamixel.sandbox.inspection import traffic
from kinlab.dynamixel.sandbox.session import Exchange
from kinlab.tui.stations.packet.styles import content, flowed

INDENT = 23  # where the bytes begin


class Traffic(OptionList):
    """The latest exchanges, the newest at the bottom. Enter or a click on one asks to show it."""

    DEFAULT_CSS = """
    Traffic { height: 1fr; border: none; padding: 0; background: transparent; scrollbar-size-vertical: 1;
    }
    Traffic:focus { border: none; }
    """

    @dataclass
    class Chosen(Message):
        """An exchange was chosen."""

        exchange: Exchange

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(compact=True, markup=False, id=id)
        self._session: Session | None = None
        self._shown: list[Exchange] = []

    def put(self, session: Session) -> None:
        """Show the session's exchanges, if there are new ones."""
        exchanges = list(session.exchanges)
        first = exchanges[0] if exchanges else None
        # The oldest ones are forgotten as new ones come.
        gone = next((i for i, shown in enumerate(self._shown) if shown is first), len(self._shown))
        for _ in range(gone):
            self.remove_option_at_index(0)
        fresh = exchanges[len(self._shown) - gone :]
        self._session, self._shown = session, exchanges
        if fresh:
            self.add_options([self._row(exchange) for exchange in fresh])
            self.highlighted = len(exchanges) - 1

    def _row(self, exchange: Exchange) -> Content:
        width = max(self.scrollable_content_region.width - 1, 30)
        assert self._session is not None
        lines = [row for line in traffic(self._session, exchange) for row in flowed(line, INDENT, width)]
        return Content("\n").join(content(line) for line in lines)

    def on_resize(self, event: Resize) -> None:
        at = self.highlighted
        self.set_options([self._row(exchange) for exchange in self._shown])
        self.highlighted = at

    @on(OptionList.OptionSelected)
    def _chosen(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.post_message(self.Chosen(self._shown[event.option_index]))
