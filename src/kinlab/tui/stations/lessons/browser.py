"""The list of lessons: how far one is, and what each is about."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.content import Content
from textual.events import Resize
from textual.message import Message
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from kinlab.tui.stations.lessons.flow import Block, Flow
from kinlab.tui.stations.lessons.steps import sign
from kinlab.tui.widgets import Said

SCROLLBAR = 2  # columns that the list may lose, with a gap


@dataclass(frozen=True)
class Row:
    """A lesson in the list.

    Attributes:
        id: of the lesson; of one that cannot be read, "".
        standing: as `steps.SIGNS` has it.
        number: in the course.
        title: of the lesson.
        facts: at the right end.
        about: what is said of it while it is chosen.
    """

    id: str
    standing: str
    number: str
    title: str
    facts: str
    about: tuple[Block, ...]

    @property
    def sought(self) -> str:
        """In which words are looked for."""
        return " ".join((self.id, self.title, *(block.markdown for block in self.about))).casefold()


class Search(Input):
    """Words to look for. Down and Enter go to the list, Escape gives up."""

    DEFAULT_CSS = "Search { width: 1fr; background: $surface; }"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "to_list", show=False),
        Binding("escape", "give_up", show=False),
    ]

    def __init__(self) -> None:
        super().__init__(compact=True, select_on_focus=False, id="search")
        self.cursor_blink = False

    def check_consume_key(self, key: str, character: str | None) -> bool:
        """The question mark remains the help's."""
        return character != "?" and super().check_consume_key(key, character)

    def action_to_list(self) -> None:
        """Go to what was found."""
        self.screen.query_one(List).focus()

    def action_give_up(self) -> None:
        """Look for nothing, and go to the list."""
        self.value = ""
        self.action_to_list()


class List(OptionList):
    """One row for each lesson."""

    DEFAULT_CSS = """
    List { height: 1fr; border: none; padding: 0; background: transparent; scrollbar-size-vertical: 1;
        scrollbar-color: $faint; scrollbar-background: $background; text-wrap: nowrap; text-overflow: ellipsis;
    }
    List:focus { border: none; }
    """

    @dataclass
    class Widened(Message):
        """Its rows have another width now."""

    def __init__(self) -> None:
        super().__init__(compact=True, markup=False)

    def on_resize(self, event: Resize) -> None:
        self.post_message(self.Widened())


class Browser(Vertical):
    """Search, list, and what the chosen lesson is about."""

    DEFAULT_CSS = """
    Browser {
        #looking { height: 1; padding: 0 1; }
        #looking Said { color: $quiet; margin: 0 1 0 0; }
        #tally { width: auto; color: $quiet; }
        #lessons { height: 1fr; }
        #about { height: 7; border-top: solid $faint; padding: 0 1; scrollbar-size-vertical: 1;
            scrollbar-color: $faint; scrollbar-background: $background; }
    }
    """

    @dataclass
    class Opened(Message):
        """A lesson was chosen."""

        id: str

    def __init__(self) -> None:
        super().__init__()
        self.rows: Sequence[Row] = ()
        self.only_open = False
        self._shown: list[Row] = []

    def compose(self) -> ComposeResult:
        with Horizontal(id="looking"):
            yield Said("search")
            yield Search()
            yield Static(id="tally", markup=False)
        with Vertical(id="found"):
            with Vertical(id="lessons"):
                yield List()
            with VerticalScroll(id="about", can_focus=False):
                yield Flow(id="about-text")

    def put(self, rows: Sequence[Row], tally: str, chosen: str = "") -> None:
        """Show these lessons, one of them chosen."""
        self.rows = rows
        self.query_one("#tally", Static).update(Content(tally))
        self._fill(chosen or self.chosen)

    @property
    def chosen(self) -> str:
        """The id of the lesson on which the cursor stands; "" where it is none."""
        at = self.query_one(List).highlighted
        return self._shown[at].id if at is not None and at < len(self._shown) else ""

    def _fill(self, chosen: str) -> None:
        """The rows that are looked for."""
        words = self.query_one(Search).value.casefold().split()
        self._shown = [
            row
            for row in self.rows
            if (not self.only_open or row.standing in ("open", "begun", "broken"))
            and all(word in row.sought for word in words)
        ]
        found = self.query_one(List)
        found.clear_options()
        found.add_options([Option(self._line(row)) for row in self._shown])
        ids = [row.id for row in self._shown]
        found.highlighted = ids.index(chosen) if chosen in ids else 0 if ids else None
        self._tell()

    def _line(self, row: Row) -> Content:
        room = max(self.query_one(List).size.width - SCROLLBAR, 30)
        ascii_only = bool(getattr(self.app, "ascii_only", False))
        title = f"{row.number:>2}  {row.title}"
        gap = room - 3 - len(title) - len(row.facts)
        if gap < 2:
            title, gap = f"{title[: max(len(title) + gap - 3, 10)]}…", 2
        return Content.assemble(
            " ", sign(row.standing, ascii_only), " ", title, " " * gap, Content.styled(row.facts, "dim")
        )

    def _tell(self) -> None:
        at = self.query_one(List).highlighted
        self.query_one("#about-text", Flow).put(
            *(self._shown[at].about if at is not None and self._shown else ())
        )
        self.query_one("#about", VerticalScroll).scroll_home(animate=False)

    @on(List.Widened)
    def _widened(self) -> None:
        self._fill(self.chosen)

    @on(Input.Changed, "#search")
    def _looked_for(self, event: Input.Changed) -> None:
        event.stop()
        self._fill(self.chosen)

    @on(Input.Submitted, "#search")
    def _to_list(self, event: Input.Submitted) -> None:
        event.stop()
        self.query_one(List).focus()

    @on(OptionList.OptionHighlighted)
    def _moved(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()
        self._tell()

    @on(OptionList.OptionSelected)
    def _selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.post_message(self.Opened(self._shown[event.option_index].id))
