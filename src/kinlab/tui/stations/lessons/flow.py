"""Text and figures one below the other, wrapped to the width that there is."""

from collections.abc import Sequence
from dataclasses import dataclass

from textual.content import Content
from textual.geometry import Size
from textual.message import Message
from textual.widget import Widget

from kinlab.dynamixel.sandbox.session import Line
from kinlab.lessons.drawing import Picture
from kinlab.lessons.lesson import Figure
from kinlab.lessons.prose import prose
from kinlab.tui.stations.packet.styles import content

MOST_COLUMNS = 88  # longer lines are hard to read
INDENT = 2  # of a figure
ROLES = {
    "link0": "$sky", "stance": "$sky", "good": "$sky", "link1": "$orange", "swing": "$orange",
    "link2": "$green", "centre": "$green", "joint": "bold", "tip": "bold", "now": "bold",
    "target": "bold $purple", "printed": "$vermillion", "bad": "$vermillion",
    "axis": "$faint", "outline": "$faint", "ground": "$faint", "other": "$quiet", "support": "$quiet",
}  # fmt: skip


@dataclass(frozen=True)
class Block:
    """Something to read or to look at.

    Attributes:
        markdown: a lesson's text; shown by its own small marks, never obeyed.
        style: of all of it; "" for each part's own.
        head: stands in front of its first line, and the others are indented as far.
        figure: to be drawn, in the place of the text.
    """

    markdown: str = ""
    style: str = ""
    head: str = ""
    figure: Figure | None = None


class Flow(Widget):
    """Blocks, a blank line between each two of them."""

    DEFAULT_CSS = "Flow { height: auto; width: 100%; }"

    @dataclass
    class Wanted(Message):
        """Figures are to be drawn, at most so wide; `Flow.draw` takes them."""

        flow: "Flow"
        figures: list[Figure]
        columns: int

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self.blocks: Sequence[Block] = ()
        self._pictures: dict[tuple[str, int], Picture] = {}
        self._asked: set[tuple[str, int]] = set()
        self._rows: list[Content] = []
        self._width = 0

    def put(self, *blocks: Block, fresh: bool = False) -> None:
        """Show these; `fresh` where figures of the same name are others now."""
        if fresh:
            self._pictures.clear()
            self._asked.clear()
        elif tuple(blocks) == tuple(self.blocks):
            return
        self.blocks = blocks
        self._changed()

    def draw(self, figure: Figure, columns: int, picture: Picture) -> None:
        """Take a figure that was wanted."""
        self._pictures[figure.id, columns] = picture
        self._changed()

    def _changed(self) -> None:
        before, width = len(self._rows), self._width
        self._width = 0
        self.refresh(layout=not width or len(self._lines(width)) != before)

    def get_content_height(self, container: Size, viewport: Size, width: int) -> int:
        return len(self._lines(width))

    def render(self) -> Content:
        return Content("\n").join(self._lines(self.content_size.width))

    def _lines(self, width: int) -> list[Content]:
        if width != self._width:
            self._width, self._rows = width, []
            for block in self.blocks:
                if self._rows:
                    self._rows.append(Content(""))
                room = min(width, MOST_COLUMNS)
                self._rows += self._figure(block.figure, room) if block.figure else written(block, room)
            self._want(min(width, MOST_COLUMNS) - INDENT)
        return self._rows

    def _figure(self, figure: Figure, width: int) -> list[Content]:
        picture = self._pictures.get((figure.id, width - INDENT))
        if picture is None:
            return [Content.styled("…", "$quiet")]
        head = Content(" " * INDENT)
        return [
            Content.assemble(head, *(Content.styled(text, ROLES.get(role, "")) for text, role in row))
            for row in picture.rows
        ]

    def _want(self, columns: int) -> None:
        wanted = [b.figure for b in self.blocks if b.figure and (b.figure.id, columns) not in self._asked]
        if wanted and columns > INDENT:
            self._asked |= {(figure.id, columns) for figure in wanted}
            self.post_message(self.Wanted(self, wanted, columns))


def written(block: Block, width: int) -> list[Content]:
    """A block of text as lines."""
    found = []
    blank = " " * len(block.head)
    for i, line in enumerate(prose(block.markdown, max(width - len(block.head), 10))):
        parts: Line = [(style, text) for style, text in line]
        shown = content(parts)
        if block.style:
            shown = Content.styled(shown.plain, block.style)
        head = Content.styled(blank if i else block.head, block.style)
        found.append(Content.assemble(head, shown))
    return found
