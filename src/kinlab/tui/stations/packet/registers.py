"""The registers of a servo, as they are now."""

from dataclasses import dataclass

from rich.text import Text
from textual import on
from textual.events import Resize
from textual.message import Message
from textual.widgets import DataTable

from kinlab.dynamixel.sandbox.inspection import Holding
from kinlab.tui.stations.packet.styles import rich_style

COLUMNS = ("address", "register", "access", "value")
WIDTHS = (4, 24, 2, 26)
LEAST = 12  # characters for a value
BEFORE = 2  # rows that stay in sight above a register that is shown


class Registers(DataTable[Text]):
    """One row for each register; what has just changed has a mark. Enter or a click on a row asks to change it."""

    DEFAULT_CSS = """
    Registers {
        height: 1fr; background: transparent; overflow-x: hidden;
        scrollbar-size: 1 1;
    }
    """

    @dataclass
    class Chosen(Message):
        """A register was chosen, with what it holds."""

        holding: Holding

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(cursor_type="row", zebra_stripes=False, cell_padding=1, id=id)
        self._held: dict[str, Holding] = {}
        self._marked: set[str] = set()

    def label(self, names: dict[str, str]) -> None:
        """Set the heads of the columns, by their ids."""
        if not self.columns:
            for key, width in zip(COLUMNS, WIDTHS, strict=True):
                self.add_column(Text(names[key]), key=key, width=width)
        for name, column in zip(COLUMNS, self.ordered_columns, strict=True):
            column.label = Text(names[name])
        self.refresh()

    def put(self, found: list[Holding], mark: str) -> None:
        """Show what the registers hold; `mark` stands behind what has changed since the last time."""
        now = {holding.register.name: holding for holding in found}
        if [h.register for h in now.values()] != [h.register for h in self._held.values()]:
            self._fill(found)
        else:
            changed = {name for name, holding in now.items() if holding.ticks != self._held[name].ticks}
            for name in changed | self._marked:
                text = self._value(now[name], mark if name in changed else "")
                self.update_cell(name, "value", text)
            self._marked = changed
        self._held = now

    def _fill(self, found: list[Holding]) -> None:
        self.clear()
        self._marked = set()
        dim = rich_style("dim", self.app.theme_variables)
        for holding in found:
            register = holding.register
            self.add_row(
                Text(str(register.address), dim, justify="right"),
                Text(register.name),
                Text(register.access, dim),
                self._value(holding, ""),
                key=register.name,
            )
        # What moves comes first; what is set once and for all is above.
        self.call_after_refresh(self.bring, next(h.register.name for h in found if h.register.area == "RAM"))

    def _value(self, holding: Holding, mark: str) -> Text:
        style = rich_style("odd" if mark else "", self.app.theme_variables)
        return Text(f"{holding.text} {mark}".rstrip(), style)

    def on_resize(self, event: Resize) -> None:
        if self.columns:
            others = sum(WIDTHS[:-1]) + 2 * len(WIDTHS) + 1
            self.ordered_columns[-1].width = max(event.size.width - others, LEAST)
            self.refresh()

    def bring(self, register: str) -> None:
        """Move to a register, and let some of those before it be seen as well."""
        row = self.get_row_index(register)
        self.move_cursor(row=row, scroll=False)
        self.scroll_to(y=row - BEFORE, animate=False)

    @on(DataTable.RowSelected)
    def _chosen(self, event: DataTable.RowSelected) -> None:
        event.stop()
        if event.row_key.value in self._held:
            self.post_message(self.Chosen(self._held[event.row_key.value]))
