"""One quantity in one row: its name, a slider, and the number in a field."""

from dataclasses import dataclass

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.content import Content
from textual.message import Message
from textual.widgets import Static

from kinlab.tui.widgets.number_field import NumberField
from kinlab.tui.widgets.said import retext
from kinlab.tui.widgets.slider import Slider


class Dial(Horizontal):
    """A quantity to turn: `Changed` tells of every new number, `Refused` of what is no number."""

    DEFAULT_CSS = """
    Dial {
        height: 1;
        .name { width: 10; padding: 0 1 0 0; }
        .unit { width: 6; color: $quiet; }
        Slider { width: 1fr; }
        NumberField { width: 9; margin: 0 1; }
    }
    """

    @dataclass
    class Changed(Message):
        """A person chose another number."""

        dial: "Dial"
        number: float

        @property
        def control(self) -> "Dial":
            """The dial."""
            return self.dial

    def __init__(
        self,
        label: str = "",
        unit: str = "",
        *,
        low: float = 0.0,
        high: float = 1.0,
        step: float = 1.0,
        number: float = 0.0,
        widest: tuple[float, float] = (-1e9, 1e9),
        id: str | None = None,
        classes: str | None = None,
    ) -> None:
        """A dial.

        Args:
            label: its name, as text.
            unit: shown behind the number.
            low, high: ends of the slider.
            step: of arrow keys.
            widest: what may be typed.
        """
        super().__init__(id=id, classes=classes)
        self._label = Static(Content(label), classes="name", markup=False)
        self._unit = Static(Content(unit), classes="unit", markup=False)
        self.slider = Slider(low, high, step)
        self.field = NumberField(number, unit, low=widest[0], high=widest[1], step=step)
        self.slider.value = number
        # Arrows up and down turn the field; Tab need not stop twice for one number.
        self.slider.can_focus = False

    @property
    def number(self) -> float:
        """The last good number."""
        return self.field.number

    def compose(self) -> ComposeResult:
        yield self._label
        yield self.slider
        yield self.field
        yield self._unit

    def label(self, text: str) -> None:
        """Another name."""
        retext(self._label, text)

    def span(self, low: float, high: float, step: float, unit: str | None = None) -> None:
        """Other ends of the slider, and another step or unit."""
        self.slider.span(low, high, step)
        self.field.step = step
        if unit is not None:
            self.field.unit = unit
            retext(self._unit, unit)

    def show(self, number: float) -> None:
        """Stand at a number; tells nobody."""
        self.slider.show(number)
        self.field.show(number)

    @on(Slider.Changed)
    def _slid(self, event: Slider.Changed) -> None:
        event.stop()
        self.field.show(event.value)
        self.post_message(self.Changed(self, event.value))

    @on(NumberField.Entered)
    def _entered(self, event: NumberField.Entered) -> None:
        event.stop()
        self.slider.show(event.number)
        self.post_message(self.Changed(self, event.number))
