"""A slider: a value between two ends, by arrow keys, wheel, click and drag."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, cast

from textual.binding import Binding, BindingType
from textual.content import Content
from textual.events import MouseDown, MouseEvent, MouseMove, MouseScrollDown, MouseScrollUp, MouseUp
from textual.message import Message
from textual.widget import Widget

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp


class Slider(Widget, can_focus=True):
    """One row that shows where a value is between its ends."""

    DEFAULT_CSS = """
    Slider { height: 1; min-width: 8; color: $quiet; }
    Slider:focus { color: $foreground; text-style: bold; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left,down,minus", "nudge(-1)", show=False),
        Binding("right,up,plus", "nudge(1)", show=False),
        Binding("shift+left,pagedown", "nudge(-10)", show=False),
        Binding("shift+right,pageup", "nudge(10)", show=False),
        Binding("home", "end(0)", show=False),
        Binding("end", "end(1)", show=False),
    ]

    @dataclass
    class Changed(Message):
        """A person moved it."""

        slider: "Slider"
        value: float

        @property
        def control(self) -> "Slider":
            """The slider."""
            return self.slider

    def __init__(
        self, low: float = 0.0, high: float = 1.0, step: float = 0.1, *, id: str | None = None
    ) -> None:
        super().__init__(id=id)
        self.low, self.high, self.step = low, high, step
        self.value = low
        self._held = False

    def span(self, low: float, high: float, step: float) -> None:
        """Other ends, and another step."""
        self.low, self.high, self.step = low, high, step
        self.refresh()

    def show(self, value: float) -> None:
        """Stand at `value`, which may lie beyond the ends; tells nobody."""
        if value != self.value:
            self.value = value
            self.refresh()

    def render(self) -> Content:
        plain = cast("KinlabApp", self.app).ascii_only
        rail, knob, out_left, out_right = ("-", "O", "<", ">") if plain else ("─", "●", "◀", "▶")
        width = self.size.width
        share = (self.value - self.low) / max(self.high - self.low, 1e-12)
        mark = knob if 0 <= share <= 1 else (out_left if share < 0 else out_right)
        at = round(min(max(share, 0.0), 1.0) * (width - 1))
        # Only what can be seen of the value makes a new frame; the number beside it is exact.
        return Content.assemble(rail * at, Content.styled(mark, "bold $orange"), rail * (width - 1 - at))

    def action_nudge(self, steps: int) -> None:
        """Go some steps, from where it stands to the next round value in that direction."""
        self._go(round(self.value / self.step + steps, 6) * self.step)

    def action_end(self, which: int) -> None:
        """Go to an end."""
        self._go(self.high if which else self.low)

    def _go(self, value: float) -> None:
        value = min(max(value, self.low), self.high)
        if value != self.value:
            self.show(value)
            self.post_message(self.Changed(self, value))

    def on_mouse_down(self, event: MouseDown) -> None:
        self._held = True
        self.capture_mouse()
        self._drag(event)

    def on_mouse_move(self, event: MouseMove) -> None:
        if self._held:
            self._drag(event)

    def on_mouse_up(self, event: MouseUp) -> None:
        self._held = False
        self.release_mouse()

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        event.stop()
        self.action_nudge(1)

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        event.stop()
        self.action_nudge(-1)

    def _drag(self, event: MouseEvent) -> None:
        share = event.x / max(self.size.width - 1, 1)
        value = self.low + min(max(share, 0.0), 1.0) * (self.high - self.low)
        self._go(round(value / self.step) * self.step)
