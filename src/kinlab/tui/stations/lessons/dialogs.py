"""What opens above the lessons: whose progress it is, whether a lesson is really to begin anew, what a word means."""

from collections.abc import Iterable
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static

from kinlab.errors import KinlabError, UsageError
from kinlab.lessons.course import Term
from kinlab.lessons.progress import Progress, profiles
from kinlab.tui.station import Station
from kinlab.tui.stations.lessons.flow import Block, Flow

CSS = """
{name} {{ align: center middle; }}
{name} > Vertical {{
    width: 60; max-width: 100%; height: auto; max-height: 100%;
    background: $surface; border: round $quiet; padding: 0 1;
}}
{name} Static {{ height: auto; }}
{name} .head {{ text-style: bold; }}
{name} OptionList {{ height: auto; max-height: 8; border: none; padding: 0; background: $surface; }}
{name} Input {{ background: $panel; }}
{name} #wrong {{ color: $vermillion; text-style: bold; }}
"""
LEAVE = Binding("ctrl+q", "app.quit", show=False, priority=True)


class Profiles(ModalScreen[str | None]):
    """The profiles that there are, and a line for another name; gives the name, or None."""

    DEFAULT_CSS = CSS.format(name="Profiles")
    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "dismiss", show=False), LEAVE]

    def __init__(self, station: Station, profile: str) -> None:
        super().__init__()
        self._station = station
        self._names = sorted({*profiles(), profile})
        self._profile = profile

    def compose(self) -> ComposeResult:
        say = self._station.say
        with Vertical():
            yield Static(say("profiles.head"), classes="head", markup=False)
            yield OptionList(*(Content(name) for name in self._names), compact=True, markup=False)
            yield Static(say("profiles.other"), markup=False)
            yield Input(compact=True)
            yield Static(id="wrong", markup=False)
            yield Static(say("profiles.close"), markup=False)

    def on_mount(self) -> None:
        names = self.query_one(OptionList)
        names.highlighted = self._names.index(self._profile)
        names.focus()

    @on(OptionList.OptionSelected)
    def _chosen(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.dismiss(self._names[event.option_index])

    @on(Input.Submitted)
    def _entered(self, event: Input.Submitted) -> None:
        event.stop()
        try:
            name = Progress(event.value.strip()).profile
        except UsageError:
            self.query_one("#wrong", Static).update(Content(self._station.say("profiles.wrong")))
        except KinlabError as error:
            self.query_one("#wrong", Static).update(Content(str(error)))
        else:
            self.dismiss(name)


class Sure(ModalScreen[bool]):
    """Something that takes work away: only Y, or a click on the line that says so, does it."""

    DEFAULT_CSS = CSS.format(name="Sure")
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("y", "dismiss(True)", show=False),
        Binding("escape,n,t,q,enter", "dismiss(False)", show=False),
        LEAVE,
    ]

    def __init__(self, station: Station, text: str) -> None:
        super().__init__()
        self._station = station
        self._text = text

    def compose(self) -> ComposeResult:
        with Vertical():
            yield Static(self._text, classes="head", markup=False)
            yield OptionList(
                *(Content(self._station.say(f"sure.{each}")) for each in ("no", "yes")),
                compact=True,
                markup=False,
            )

    def on_mount(self) -> None:
        rows = self.query_one(OptionList)
        rows.highlighted = 0
        rows.focus()

    @on(OptionList.OptionSelected)
    def _chosen(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.dismiss(event.option_index == 1)


class Glossary(ModalScreen[None]):
    """The words of the field: letters look for one, the arrows go through them."""

    DEFAULT_CSS = CSS.format(name="Glossary") + "Glossary #meaning { margin: 1 0 0 0; }"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,enter,f11", "dismiss", show=False),
        Binding("up", "move(-1)", show=False, priority=True),
        Binding("down", "move(1)", show=False, priority=True),
        LEAVE,
    ]

    def __init__(self, station: Station, terms: Iterable[Term], language: str) -> None:
        super().__init__()
        self._station = station
        self._terms = sorted(terms, key=lambda term: term.name.casefold())
        self._language = language
        self._found = self._terms

    def compose(self) -> ComposeResult:
        with Vertical():
            yield Static(self._station.say("glossary"), classes="head", markup=False)
            yield Input(compact=True)
            yield OptionList(compact=True, markup=False)
            yield Flow(id="meaning")

    def on_mount(self) -> None:
        self.query_one(Input).focus()
        self._look_for("")

    @on(Input.Changed)
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self._look_for(event.value.strip().casefold())

    def _look_for(self, word: str) -> None:
        self._found = [t for t in self._terms if any(word in form.casefold() for form in (t.name, *t.forms))]
        names = self.query_one(OptionList)
        names.clear_options()
        names.add_options([Content(term.name) for term in self._found])
        names.highlighted = 0 if self._found else None
        self._explain()

    @on(OptionList.OptionHighlighted)
    def _explain(self) -> None:
        at = self.query_one(OptionList).highlighted
        term = self._found[at] if at is not None and at < len(self._found) else None
        self.query_one("#meaning", Flow).put(*([Block(term.meaning(self._language))] if term else []))

    def action_move(self, rows: int) -> None:
        """Go to the word below, or above."""
        names = self.query_one(OptionList)
        if self._found:
            names.highlighted = ((names.highlighted or 0) + rows) % len(self._found)
