"""A canvas of the core, coloured by the roles of what is drawn."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from rich.segment import Segment
from rich.style import Style as RichStyle
from textual.events import MouseDown, MouseEvent, MouseMove, MouseUp
from textual.geometry import Size
from textual.message import Message
from textual.strip import Strip
from textual.style import Style
from textual.widget import Widget

from kinlab.canvas import Canvas

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp

Draw = Callable[[int, int, bool], Canvas | None]

# What each role looks like. Component classes would say the same, but every restyling of a screen would
# work out all of them for every picture, which takes longer than all the rest of it.
LOOKS = {
    "link0": "$sky", "link1": "$orange", "link2": "$green",
    "joint": "bold $foreground", "tip": "bold $foreground", "now": "bold $foreground",
    "target": "bold $purple",
    "stance": "$sky", "swing": "$orange", "centre": "$green",
    "good": "$sky", "printed": "$vermillion", "bad": "$vermillion",
    "axis": "$faint", "outline": "$faint", "ground": "$faint",
    "other": "$quiet", "support": "$quiet", "caption": "$quiet", "caption of focus": "bold reverse $foreground",
}  # fmt: skip


class Picture(Widget):
    """A drawing that fills its place: under a caption, whatever the function given draws for that size.

    Roles that have a colour are those of LOOKS.
    """

    DEFAULT_CSS = "Picture { min-height: 4; min-width: 12; }"

    @dataclass
    class Pointed(Message):
        """The mouse was pressed on, or dragged to, a place of the drawing.

        Attributes:
            picture: which.
            x, y: of the drawing, in its own unit.
        """

        picture: "Picture"
        x: float
        y: float

        @property
        def control(self) -> "Picture":
            """The picture."""
            return self.picture

    def __init__(
        self,
        draw: Draw,
        caption: Callable[[Canvas], str] | None = None,
        *,
        focusable: bool = False,
        id: str | None = None,
        classes: str | None = None,
    ) -> None:
        """A picture.

        Args:
            draw: gives the canvas for columns, rows, and whether it must do without braille; None: nothing to show.
            caption: gives the line above it, as text.
            focusable: whether it takes keys.
        """
        super().__init__(id=id, classes=classes)
        self._draw, self._caption = draw, caption
        self.can_focus = focusable
        self.canvas: Canvas | None = None
        self._strips: list[Strip] | None = None
        self._drawn_for = Size(0, 0)
        self._held = False

    def redraw(self) -> None:
        """What it shows has changed."""
        self._strips = None
        self.refresh()

    def notify_style_update(self) -> None:
        super().notify_style_update()
        self._strips = None

    def on_focus(self) -> None:
        self.redraw()  # the caption tells it

    def on_blur(self) -> None:
        self.redraw()

    def render_line(self, y: int) -> Strip:
        if self._strips is None or self._drawn_for != self.size:
            self._strips, self._drawn_for = self._lines(), self.size
        return self._strips[y] if y < len(self._strips) else Strip.blank(self.size.width, self.rich_style)

    def _lines(self) -> list[Strip]:
        columns, rows = self.size.width, self.size.height - (self._caption is not None)
        if columns < 1 or rows < 1:
            return []
        self.canvas = self._draw(columns, rows, cast("KinlabApp", self.app).ascii_only)
        if self.canvas is None:
            return []
        ground = self.rich_style
        lines = []
        if self._caption:
            style = ground + _look("caption of focus" if self.has_focus else "caption")
            text = self._caption(self.canvas)
            # What finds no room is left out whole, as half a number is another number.
            while len(text) > columns and ", " in text:
                text = text.rpartition(", ")[0]
            lines.append(Strip([Segment(text[:columns], style)]))
        lines += [
            Strip([Segment(text, ground + _look(role)) for text, role in spans])
            for spans in self.canvas.spans()
        ]
        return [line.adjust_cell_length(columns, ground) for line in lines]

    # The mouse.

    def on_mouse_down(self, event: MouseDown) -> None:
        self._held = True
        self.capture_mouse()
        self._point(event)

    def on_mouse_move(self, event: MouseMove) -> None:
        if self._held:
            self._point(event)

    def on_mouse_up(self, event: MouseUp) -> None:
        self._held = False
        self.release_mouse()

    def _point(self, event: MouseEvent) -> None:
        row = event.y - (self._caption is not None)
        if self.canvas is not None and 0 <= event.x < self.canvas.columns and 0 <= row < self.canvas.rows:
            x, y = self.canvas.place(event.x, row)
            self.post_message(self.Pointed(self, x, y))


def _look(role: str) -> RichStyle:
    """The style of a role in the theme of now; Textual remembers it until the theme changes."""
    return Style.parse(LOOKS.get(role, "")).rich_style
