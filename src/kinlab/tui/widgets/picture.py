"""A canvas of the core, coloured by the roles of what is drawn."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, cast

from rich.segment import Segment
from textual.events import MouseDown, MouseEvent, MouseMove, MouseUp
from textual.geometry import Size
from textual.message import Message
from textual.strip import Strip
from textual.widget import Widget

from kinlab.canvas import Canvas

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp

Draw = Callable[[int, int, bool], Canvas | None]


class Picture(Widget):
    """A drawing that fills its place: under a caption, whatever the function given draws for that size.

    Roles that have a colour are those of COMPONENT_CLASSES, without "picture--".
    """

    COMPONENT_CLASSES: ClassVar[set[str]] = {
        f"picture--{role}"
        for role in (
            "link0", "link1", "link2", "joint", "tip", "target", "axis", "outline", "other", "printed",
            "stance", "swing", "support", "centre", "ground", "now", "good", "bad", "caption",
        )
    }  # fmt: skip
    DEFAULT_CSS = """
    Picture {
        min-height: 4; min-width: 12;
        .picture--link0, .picture--stance, .picture--good { color: $sky; }
        .picture--link1, .picture--swing { color: $orange; }
        .picture--link2, .picture--centre { color: $green; }
        .picture--joint, .picture--tip, .picture--now { text-style: bold; color: $foreground; }
        .picture--target { text-style: bold; color: $purple; }
        .picture--printed, .picture--bad { color: $vermillion; }
        .picture--axis, .picture--outline, .picture--ground { color: $faint; }
        .picture--other, .picture--support, .picture--caption { color: $quiet; }
        &:focus .picture--caption { text-style: bold reverse; color: $foreground; }
    }
    """

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
            style = ground + self.get_component_rich_style("picture--caption", partial=True)
            lines.append(Strip([Segment(self._caption(self.canvas)[:columns], style)]))
        styles = {"": ground}
        for spans in self.canvas.spans():
            segments = []
            for text, role in spans:
                if role not in styles:
                    name = f"picture--{role}"
                    known = name in self.COMPONENT_CLASSES
                    more = self.get_component_rich_style(name, partial=True) if known else ground
                    styles[role] = ground + more
                segments.append(Segment(text, styles[role]))
            lines.append(Strip(segments))
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
