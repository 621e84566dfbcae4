"""A lesson's figures, drawn by the core when they are looked at."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from kinlab.canvas import Canvas
from kinlab.lessons.lesson import Figure
from kinlab.lessons.registry import evaluate, find, takes

# What every figure function may take besides its data.
SIZE = ("columns", "ascii_only")


@dataclass(frozen=True)
class Picture:
    """A drawn figure.

    Attributes:
        rows: runs of (text, role) for a face to colour.
        alt: what is to be seen, in words.
    """

    rows: tuple[tuple[tuple[str, str], ...], ...]
    alt: str

    @property
    def text(self) -> str:
        """Without colours, and without spaces at the ends of lines."""
        return "\n".join("".join(text for text, _ in row).rstrip() for row in self.rows)


def draw(figure: Figure, values: Mapping[str, Any], alt: str, columns: int, ascii_only: bool) -> Picture:
    """Draw a figure.

    Args:
        figure: which.
        values: of the student.
        alt: its description, filled in.
        columns: how wide it may be, at most.
        ascii_only: without braille.

    Raises:
        LessonError: it cannot be drawn.
    """
    for name in SIZE:
        if name in figure.draw.given:
            raise figure.draw.place.error(
                f"'{name}' is not a lesson's to give: the face knows how much it can show"
            )
    taken = takes(find(figure.draw, "figures"))
    size = dict(zip(SIZE, (columns, ascii_only), strict=True))
    drawn = evaluate(figure.draw, "figures", {**values, **{k: v for k, v in size.items() if k in taken}})
    rows: list[tuple[tuple[str, str], ...]] = []
    for each in drawn if isinstance(drawn, list | tuple) else [drawn]:
        if isinstance(each, Canvas):
            rows += [tuple(row) for row in each.spans()]
        else:
            rows += [((line, ""),) for line in str(each).splitlines()]
    while rows and not "".join(text for text, _ in rows[0]).strip():
        rows.pop(0)
    while rows and not "".join(text for text, _ in rows[-1]).strip():
        rows.pop()
    return Picture(tuple(rows), alt)
