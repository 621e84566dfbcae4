"""The help of a screen: what it is for, and every key of it."""

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import VerticalScroll
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Static

from kinlab.tui.actions import Action
from kinlab.tui.station import Station
from kinlab.tui.widgets.key_line import key_name

WIDTH, KEYS = 76, 13  # of the help, and of its column of keys


class Help(ModalScreen[None]):
    """Over a station: its purpose in a few sentences, its actions, and what works everywhere."""

    DEFAULT_CSS = f"""
    Help {{ align: center middle; }}
    Help > VerticalScroll {{
        width: {WIDTH}; max-width: 100%; height: auto; max-height: 100%;
        background: $surface; border: round $quiet; padding: 0 2;
        scrollbar-size-vertical: 1;
    }}
    Help .head {{ text-style: bold; margin-top: 1; }}
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,question_mark,f1,q,enter", "dismiss", show=False),
        Binding("ctrl+q", "app.quit", show=False, priority=True),
    ]

    def __init__(self, station: Station) -> None:
        super().__init__()
        self.station = station

    def compose(self) -> ComposeResult:
        station = self.station
        with VerticalScroll() as page:
            page.border_subtitle = Content(station.say("shell.close_help"))
            yield Static(station.say(f"station.{station.NAME}"), classes="head", markup=False)
            yield Static(station.say("help"), markup=False)
            yield Static(station.say("shell.keys"), classes="head", markup=False)
            yield Static(self._keys())

    def _keys(self) -> Content:
        lines = []
        for action in self.station.all_actions():
            keys = self._names(action)
            text = self.station.say(f"action.{action.id}.help")
            room = min(WIDTH, self.app.size.width) - KEYS - 10
            for i, part in enumerate(Content(text).wrap(max(room, 20)) if keys else ()):
                head = "" if i else keys
                lines.append(Content.assemble(Content.styled(f"{head:>{KEYS}}  ", "bold $orange"), part))
        return Content("\n").join(lines)

    def _names(self, action: Action) -> str:
        if action.each:
            return key_name(self.app, self.station.say, action.bindings()[0])
        return " ".join(self.app.get_key_display(Binding(key.key, "")) for key in action.bindings())

    def on_mount(self) -> None:
        self.query_one(VerticalScroll).focus()
