"""A field for a number: says what is wrong with it, and keeps the last good one."""

from dataclasses import dataclass
from typing import ClassVar

from textual import on
from textual.actions import SkipAction
from textual.binding import Binding, BindingType
from textual.events import Key
from textual.message import Message
from textual.widgets import Input

from kinlab.tui.numbers import NotANumberError, read, shown

WIDTH = 24
LONGEST = 32  # characters of a number and its unit; what is pasted beyond is no number


class NumberField(Input):
    """A number with its unit: decimal comma or point, other units of the quantity, arrows up and down.

    Attributes:
        number: the last good one, in `unit`.
        problem: what is wrong with what stands there now, as the key of a sentence and its values; None: nothing.
    """

    DEFAULT_CSS = """
    NumberField {
        width: 12; height: 1; border: none; background: $panel; padding: 0;
        &:focus { background: $faint; text-style: bold; }
        &.-wrong { color: $vermillion; text-style: bold underline; }
    }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "nudge(1)", show=False),
        Binding("down", "nudge(-1)", show=False),
        Binding("shift+up,pageup", "nudge(10)", show=False),
        Binding("shift+down,pagedown", "nudge(-10)", show=False),
        Binding("escape", "undo", show=False),
    ]

    @dataclass
    class Entered(Message):
        """A good number stands there."""

        field: "NumberField"
        number: float

        @property
        def control(self) -> "NumberField":
            """The field."""
            return self.field

    @dataclass
    class Refused(Message):
        """What stands there is no number; `NumberField.problem` says why."""

        field: "NumberField"

        @property
        def control(self) -> "NumberField":
            """The field."""
            return self.field

    def __init__(
        self,
        number: float = 0.0,
        unit: str = "",
        *,
        low: float = -1e9,
        high: float = 1e9,
        step: float = 1.0,
        id: str | None = None,
    ) -> None:
        super().__init__(shown(number), compact=True, select_on_focus=True, max_length=LONGEST, id=id)
        self.number, self.unit, self.step = number, unit, step
        self.low, self.high = low, high
        self.problem: tuple[str, dict[str, object]] | None = None
        self.cursor_blink = False

    @property
    def content_width(self) -> int:
        """As wide for every short number: one of another width would lay out the whole screen anew."""
        return max(super().content_width, WIDTH)

    def check_consume_key(self, key: str, character: str | None) -> bool:
        """No number has a question mark in it: that key remains the help's."""
        return character != "?" and super().check_consume_key(key, character)

    def on_resize(self) -> None:
        """Show the number from its beginning; while there was no room at all, it slid out of sight."""
        self.scroll_to(x=0, animate=False, immediate=True)

    def on_key(self, event: Key) -> None:
        """Leave the question mark to the help."""
        if event.character == "?":
            event.prevent_default()

    def show(self, number: float) -> None:
        """Put a number there; tells nobody. A person who is typing is not disturbed by the number that stood there."""
        if self.has_focus and abs(number - self.number) < 5e-4:
            return
        self.number = number
        self._judge(None)
        with self.prevent(Input.Changed):
            self.value = shown(number)
        # As when it got the focus: what is typed next takes the place of the number.
        if self.has_focus:
            self.action_select_all()

    def action_nudge(self, steps: int) -> None:
        """Go some steps up or down."""
        number = round(self.number / self.step + steps, 6) * self.step
        self._enter(min(max(number, self.low), self.high))

    def action_copy(self) -> None:
        """Nothing: a field selects its number by itself, so that Ctrl-C would never leave the program."""
        raise SkipAction

    def action_undo(self) -> None:
        """Go back to the last good number; where it stands there, leave the field."""
        if self.problem is None:
            self.screen.set_focus(None)
        else:
            self._enter(self.number)

    def _enter(self, number: float) -> None:
        self.number = number
        self._judge(None)
        with self.prevent(Input.Changed):
            self.value = shown(number)
            self.cursor_position = len(self.value)
        self.post_message(self.Entered(self, number))

    def _judge(self, problem: tuple[str, dict[str, object]] | None) -> None:
        self.problem = problem
        self.set_class(problem is not None, "-wrong")

    @on(Input.Changed)
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        try:
            number = read(event.value, self.unit)
            if not self.low <= number <= self.high:
                raise NotANumberError(
                    "field.range",
                    text=shown(number),
                    low=shown(self.low),
                    high=shown(self.high),
                    unit=self.unit,
                )
        except NotANumberError as wrong:
            self._judge((wrong.key, wrong.values))
            self.post_message(self.Refused(self))
            return
        if self.problem is None and number == self.number:
            return
        self._judge(None)
        self.number = number
        self.post_message(self.Entered(self, number))

    @on(Input.Submitted)
    def _settled(self, event: Input.Submitted) -> None:
        event.stop()
        if self.problem is None:
            self._enter(self.number)
