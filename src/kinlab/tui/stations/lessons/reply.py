"""Where an answer goes: typed on a line, or chosen from a list."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from rich.highlighter import Highlighter
from rich.style import Style
from rich.text import Text
from textual import on
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.events import Key
from textual.geometry import Region
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from kinlab.lessons.prose import spans
from kinlab.tui.stations.lessons.steps import sign
from kinlab.tui.stations.packet.styles import content

Span = tuple[int, int]


class Reply(Input):
    """A line for an answer; what is at fault in it is underlined until another character is typed.

    Escape empties it, and leaves it where it is empty.
    """

    DEFAULT_CSS = "Reply { width: 1fr; background: transparent; }"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "give_up", show=False),
        Binding("up", "to_options", show=False),
    ]

    @dataclass
    class Given(Message):
        """An answer is to be judged."""

        text: str

    @dataclass
    class Typed(Message):
        """The line holds something else."""

        text: str

    def __init__(self, *, id: str | None = None) -> None:
        self.faults: Sequence[Span] = ()
        super().__init__(compact=True, highlighter=_Faults(self), select_on_focus=False, id=id)
        self.cursor_blink = False

    def check_consume_key(self, key: str, character: str | None) -> bool:
        """No answer has a question mark in it: that key remains the help's."""
        return character != "?" and super().check_consume_key(key, character)

    def put(self, text: str, faults: Sequence[Span] = ()) -> None:
        """Hold a text, with faults in it; tells nobody."""
        self.faults = faults
        with self.prevent(Input.Changed):
            self.value = text
            self.cursor_position = len(text)
        self.refresh()

    def action_give_up(self) -> None:
        """Empty the line; an empty one gives the keys to the station."""
        if self.value:
            self.value = ""
        else:
            self.screen.set_focus(None)

    def action_to_options(self) -> None:
        """Go to the list above, where there is one."""
        options = self.screen.query_one(Options)
        if options.display:
            options.focus()

    @on(Input.Changed)
    def _changed(self, event: Input.Changed) -> None:
        event.stop()
        self.faults = ()
        self.post_message(self.Typed(event.value))

    @on(Input.Submitted)
    def _submitted(self, event: Input.Submitted) -> None:
        event.stop()
        self.post_message(self.Given(event.value))


class _Faults(Highlighter):
    """Underlines what is at fault."""

    def __init__(self, reply: Reply) -> None:
        self._reply = reply

    def highlight(self, text: Text) -> None:
        colour = self._reply.app.theme_variables.get("vermillion")
        for start, end in self._reply.faults:
            text.stylize(Style(color=colour, bold=True, underline=True), start, end)


class Marks(Static):
    """A line of arrows below an answer, as underlining alone is overlooked."""

    DEFAULT_CSS = "Marks { height: 1; color: $vermillion; text-style: bold; text-wrap: nowrap; }"

    def __init__(self) -> None:
        super().__init__(markup=False)

    def put(self, indent: int, faults: Sequence[Span]) -> None:
        """Point at these places of a line that begins `indent` characters further right."""
        row = [" "] * (indent + max((end for _, end in faults), default=0))
        for start, end in faults:
            row[indent + start : indent + end] = "^" * (end - start)
        self.display = bool(faults)
        self.update(Content("".join(row)))


class Options(OptionList):
    """What there is to choose from, or to put in order: by arrows and Enter, by its letter, or at a click."""

    DEFAULT_CSS = """
    Options { height: auto; border: none; padding: 0; margin: 1 0 0 0; background: transparent; }
    Options:focus { border: none; }
    """

    @dataclass
    class Chosen(Message):
        """One was chosen."""

        label: str

    def __init__(self) -> None:
        super().__init__(compact=True, markup=False)
        self._labels: list[str] = []

    def check_consume_key(self, key: str, character: str | None) -> bool:
        """Letters that choose."""
        return character in self._labels

    def put(
        self, offered: Mapping[str, str], said: Mapping[str, str], *, plain: bool, ascii_only: bool
    ) -> None:
        """Show them.

        Args:
            offered: texts by label.
            said: by label what is known of it: "solved", "broken", or its place in the order.
            plain: whether the texts are equations, in which stars are stars.
            ascii_only: without signs.
        """
        at = self.highlighted
        fresh = list(offered) != self._labels
        self._labels = list(offered)
        self.clear_options()
        self.add_options([Option(self._row(*each, said, plain, ascii_only)) for each in offered.items()])
        self.highlighted = 0 if fresh or at is None else at

    @staticmethod
    def _row(label: str, text: str, said: Mapping[str, str], plain: bool, ascii_only: bool) -> Content:
        known = said.get(label, "")
        mark = sign(known, ascii_only) if known in ("solved", "broken") else Content(f"{known:1}")
        shown = Content(text) if plain else content(spans(text))
        own = "" if text == label else f"{label}) "
        return Content.assemble(mark, " ", Content.styled(own or label, "bold"), shown if own else "")

    def on_key(self, event: Key) -> None:
        if event.character in self._labels:
            event.stop()
            event.prevent_default()
            self.highlighted = self._labels.index(str(event.character))
            self.post_message(self.Chosen(str(event.character)))

    @on(OptionList.OptionHighlighted)
    def _moved(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()
        if self.has_focus and isinstance(self.parent, Widget):
            # The list has all its rows; it is what holds it that scrolls.
            row = event.option_index * self.size.height // max(self.option_count, 1)
            self.parent.scroll_to_region(
                Region(0, self.virtual_region.y + row, self.size.width, 1), animate=False
            )

    @on(OptionList.OptionSelected)
    def _selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.post_message(self.Chosen(self._labels[event.option_index]))
