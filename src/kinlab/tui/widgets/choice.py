"""One of a few names, in one row; a list opens to choose from."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar, cast

from rich.text import Text
from textual import on
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.events import Click
from textual.widget import Widget
from textual.widgets import Select
from textual.widgets._select import SelectOverlay

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp


class Choice(Widget, can_focus=True):
    """A list of names, of which one is chosen; posts `Select.Changed`, and nothing when it is set by `put`.

    It is Textual's Select with nothing mounted until the list opens: a station has several, and each would bring
    five widgets to the first frame.
    """

    DEFAULT_CSS = """
    Choice {
        width: 20; height: 1; background: $surface; color: $foreground; layout: vertical;
        &:hover { background: $panel; }
        &:focus { background: $panel; text-style: bold reverse; }
        & > SelectOverlay {
            width: 1fr; min-width: 20; height: auto; max-height: 12; margin-top: 1;
            overlay: screen; constrain: none inside;
            color: $foreground; border: tall $quiet; background: $surface; text-style: none;
            & > .option-list--option { padding: 0 1; }
        }
    }
    """
    BINDINGS: ClassVar[list[BindingType]] = [Binding("enter,space,down,up", "show_overlay", show=False)]

    def __init__(self, names: Iterable[str], value: str, **settings: Any) -> None:
        super().__init__(**settings)
        self.names = self.labels = list(names)
        self._value = value

    @property
    def value(self) -> str:
        """The one that is chosen; a new one is told."""
        return self._value

    @value.setter
    def value(self, name: str) -> None:
        if name != self._value:
            self.put(name)
            # The message wants a Select, and uses of it only what is here as well.
            self.post_message(Select.Changed(cast("Select[str]", self), name))

    def offer(self, names: Iterable[str], value: str, labels: Iterable[str] | None = None) -> None:
        """Other names, one of them chosen; tells nobody.

        Args:
            labels: what is shown for each; default the names.
        """
        self.names = list(names)
        self.labels = self.names if labels is None else list(labels)
        self.put(value)

    def put(self, value: str) -> None:
        """Choose; tells nobody."""
        self._value = value
        self.refresh()

    def render(self) -> Content:
        arrow = "v" if cast("KinlabApp", self.app).ascii_only else "▾"
        room = self.size.width - 3
        label = self.labels[self.names.index(self._value)] if self._value in self.names else self._value
        return Content(f" {label[:room]:<{room}}{arrow} ")

    # The list.

    def action_show_overlay(self) -> None:
        """Open the list, at what is chosen."""
        if self.query(SelectOverlay):
            return
        overlay = SelectOverlay()
        overlay.add_options([Text(label, no_wrap=True, overflow="ellipsis") for label in self.labels])
        # As wide as the longest, with its border and room beside it: a name that is broken up reads as two.
        overlay.styles.min_width = min(max(map(len, self.labels)) + 6, self.app.size.width)
        self.mount(overlay)
        overlay.select(self.names.index(self._value) if self._value in self.names else 0)
        overlay.focus()

    def on_click(self, event: Click) -> None:
        if event.widget is self:
            self.action_show_overlay()

    @on(SelectOverlay.Dismiss)
    async def _close(self, event: SelectOverlay.Dismiss) -> None:
        event.stop()
        await self.query(SelectOverlay).remove()
        if not event.lost_focus:
            self.focus()

    @on(SelectOverlay.UpdateSelection)
    async def _choose(self, event: SelectOverlay.UpdateSelection) -> None:
        event.stop()
        await self.query(SelectOverlay).remove()
        self.focus()
        self.value = self.names[event.option_index]
