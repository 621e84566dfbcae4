"""What every station has: the bar, the message line, the line of keys, words in the chosen language, help."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar, cast

from textual import on
from textual.app import ComposeResult
from textual.containers import Container
from textual.events import Resize
from textual.screen import Screen
from textual.widgets import Static

from kinlab.language import words_of
from kinlab.tui.actions import SHELL, Action, bindings
from kinlab.tui.widgets.bar import StationBar
from kinlab.tui.widgets.key_line import KeyLine
from kinlab.tui.widgets.number_field import NumberField
from kinlab.tui.widgets.said import Said, retext, say

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp

# A sign for each kind of message, and one for terminals without it.
SIGNS = {"good": ("●", "+"), "note": ("·", "-"), "warn": ("▲", "!"), "bad": ("■", "x")}


class Message(Static):
    """The message line: a sign and a sentence."""

    DEFAULT_CSS = """
    Message {
        height: auto; max-height: 2; min-height: 1; padding: 0 1; background: $panel;
        &.good { color: $sky; }
        &.warn { color: $orange; }
        &.bad { color: $vermillion; text-style: bold; }
    }
    """

    def __init__(self) -> None:
        super().__init__(markup=False)
        self.kind, self.text = "note", ""

    def tell(self, kind: str, text: str, ascii_only: bool) -> None:
        """Show a sentence."""
        if (kind, text) == (self.kind, self.text):
            return
        if kind != self.kind:
            self.set_classes(kind)
        self.kind, self.text = kind, text
        retext(self, f"{SIGNS[kind][ascii_only]} {text}")


class Station(Screen[None]):
    """A screen of the laboratory; `kinlab.tui` tells how one is made."""

    NAME: ClassVar[str] = ""
    ACTIONS: ClassVar[tuple[Action, ...]] = ()
    MINIMUM: ClassVar[tuple[int, int]] = (60, 20)
    DEFAULT_CSS = """
    Station {
        layout: vertical;
        #body { height: 1fr; }
        #too-small { display: none; width: 100%; height: 100%; content-align: center middle; text-align: center; }
        &.-too-small {
            StationBar, #body, Message, KeyLine { display: none; }
            #too-small { display: block; }
        }
    }
    """

    def __init_subclass__(cls, **settings: Any) -> None:
        if cls.ACTIONS:
            cls.BINDINGS = bindings(cls.ACTIONS)
        super().__init_subclass__(**settings)

    @property
    def lab(self) -> "KinlabApp":
        """The application."""
        return cast("KinlabApp", self.app)

    @property
    def words(self) -> str:
        """The package whose words are the station's."""
        return type(self).__module__.rpartition(".")[0]

    # What a station fills in.

    @classmethod
    def prepare(cls) -> None:
        """Have the core work out, and remember, what the first frame would wait for; runs in a thread."""

    def compose_body(self) -> ComposeResult:
        """The station's own widgets."""
        yield from ()

    def ready(self) -> None:
        """Begin: everything is in place, and what was kept has been restored."""

    def relabel(self) -> None:
        """Set again, in the language of now, the texts that are not in a `Said`."""

    def state(self) -> dict[str, Any]:
        """What is kept until the next run; plain JSON."""
        return {}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up what was kept, as far as it makes sense; called before `ready`."""

    # What it can use.

    def say(self, key: str, **values: object) -> str:
        """A text of the station's words, else of the shell's, in the language of now."""
        own = words_of(self.words)
        return own.say(self.lab.tongue, key, **values) if key in own.entries else say(self, key, **values)

    def tell(self, kind: str, text: str) -> None:
        """Put a sentence on the message line; kinds are good, note, warn and bad."""
        self.query_one(Message).tell(kind, text, self.lab.ascii_only)

    # The rest is the shell's.

    def compose(self) -> ComposeResult:
        yield StationBar()
        with Container(id="body"):
            yield from self.compose_body()
        yield Message()
        yield KeyLine()
        yield Said("shell.too_small", id="too-small", columns=0, rows=0, wide=0, high=0)

    def on_mount(self) -> None:
        self.restore(self.lab.settings.stations.get(self.NAME, {}))
        self.ready()

    def on_resize(self, event: Resize) -> None:
        wide, high = self.MINIMUM
        small = event.size.width < wide or event.size.height < high
        self.set_class(small, "-too-small")
        notice = self.query_one("#too-small", Said)
        notice.fill(columns=event.size.width, rows=event.size.height, wide=wide, high=high)

    @on(NumberField.Refused)
    def _explain(self, event: NumberField.Refused) -> None:
        if event.field.problem is not None:
            key, values = event.field.problem
            self.tell("bad", self.say(key, **values))

    def action_leave(self) -> None:
        """Let no field have the keys, so that letters are actions."""
        self.set_focus(None)

    def speak(self) -> None:
        """Show every text in the language of now."""
        for said in self.query(Said):
            said.speak()
        self.query_one(StationBar).refresh(layout=True)
        self.query_one(KeyLine).refresh()
        self.relabel()

    def all_actions(self) -> Iterator[Action]:
        """What can be done here: the station's own, then what works everywhere."""
        yield from self.ACTIONS
        yield from SHELL
