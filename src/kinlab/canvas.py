"""Drawing with characters: lines in braille dots, marks and labels on top; text out, for any face and any test.

A dot is as wide as high on a terminal whose cells are twice as high as wide, so that one scale serves
both directions and nothing looks stretched.
"""

import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise

_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
_ASCII_LINE = "*"

Point = tuple[float, float]


def without_braille() -> bool:
    """Whether the terminal cannot show braille: by wish ($KINLAB_ASCII), by its kind, or by its encoding."""
    encoding = getattr(sys.__stdout__, "encoding", None) or "utf-8"
    wish = os.environ.get("KINLAB_ASCII", "")
    return wish not in ("", "0") or os.environ.get("TERM") == "linux" or "utf" not in encoding.lower()


class Canvas:
    """A field of `columns` x `rows` characters that shows a rectangle of the world, x right, y up.

    Args:
        columns, rows: of the field, in characters.
        points: what must be in sight; the scale is chosen so that it fits, with a margin.
        ascii_only: for terminals and readers without braille.
        margin: dots that stay free at each edge.
    """

    def __init__(
        self, columns: int, rows: int, points: Iterable[Point], *, ascii_only: bool = False, margin: int = 3
    ) -> None:
        self.columns, self.rows, self.ascii_only = columns, rows, ascii_only
        xs, ys = zip(*points, strict=True)
        wide, high = max(xs) - min(xs), max(ys) - min(ys)
        across, up = max(2 * columns - 2 * margin, 1), max(4 * rows - 2 * margin, 1)
        self._per_dot: float = max(wide / across, high / up, 1e-12)
        self._centre = ((max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2)
        self._bits = [[0] * columns for _ in range(rows)]
        self._chars: dict[tuple[int, int], str] = {}
        self._roles: dict[tuple[int, int], str] = {}

    @property
    def cell_width(self) -> float:
        """How much of the world one character is wide, in its unit."""
        return 2.0 * self._per_dot

    def line(self, start: Point, end: Point, role: str, *, dashed: bool = False, thick: bool = False) -> None:
        """A straight line; `role` names what it is, for a face to colour. A thick one is two dots wide."""
        (x0, y0), (x1, y1) = self._dot(start), self._dot(end)
        steps = max(int(max(abs(x1 - x0), abs(y1 - y0))), 1)
        for i in range(steps + 1):
            if dashed and i % 6 >= 3:
                continue
            x, y = round(x0 + (x1 - x0) * i / steps), round(y0 + (y1 - y0) * i / steps)
            self._set(x, y, role)
            if thick:
                steep = abs(y1 - y0) > abs(x1 - x0)
                self._set(x + steep, y + (not steep), role)

    def fill(self, inside: Callable[[float, float], bool], role: str) -> None:
        """Every dot whose place (x, y) is `inside`."""
        for y in range(4 * self.rows):
            for x in range(2 * self.columns):
                if inside(
                    (x - self.columns) * self._per_dot + self._centre[0],
                    (2 * self.rows - y) * self._per_dot + self._centre[1],
                ):
                    self._set(x, y, role)

    def outline(
        self, inside: Callable[[list[float], list[float]], Sequence[Sequence[bool]]], role: str
    ) -> None:
        """The edge of a region: every dot inside it that has a dot beside, above or below it that is not.

        Args:
            inside: gives, for the places of the dots' columns (x) and rows (y, downwards), row by row which are inside.
            role: what it is. The edge of the field is none of it.
        """
        wide, high = 2 * self.columns, 4 * self.rows
        xs = [(x - self.columns) * self._per_dot + self._centre[0] for x in range(wide)]
        ys = [(2 * self.rows - y) * self._per_dot + self._centre[1] for y in range(high)]
        held = inside(xs, ys)
        for y, row in enumerate(held):
            above, below = held[max(y - 1, 0)], held[min(y + 1, high - 1)]
            for x in range(wide):
                if row[x] and not (
                    above[x] and below[x] and row[max(x - 1, 0)] and row[min(x + 1, wide - 1)]
                ):
                    self._set(x, y, role)

    def mark(self, point: Point, char: str, role: str) -> None:
        """One character at a place, over any line."""
        cell = self._cell(point)
        if cell:
            self._chars[cell], self._roles[cell] = char, role

    def label(self, point: Point, text: str, role: str, *, left: bool = False) -> None:
        """Text beside a place, where there is room for it: right, left, above, below; else nowhere.

        Args:
            left: whether to try the left side first.
        """
        cell = self._cell(point)
        if not cell:
            return
        row, column = cell
        places = [
            (row, column + 2),
            (row, column - 1 - len(text)),
            (row - 1, column + 1),
            (row + 1, column + 1),
        ]
        if left:
            places[:2] = places[1::-1]
        for r, c in places:
            inside = 0 <= r < self.rows and c >= 0 and c + len(text) <= self.columns
            # Two names side by side would read as one.
            apart = not any(self._chars.get((r, at), "").isalnum() for at in (c - 1, c + len(text)))
            if (
                inside
                and apart
                and not any((r, c + i) in self._chars or self._bits[r][c + i] for i in range(len(text)))
            ):
                for i, char in enumerate(text):
                    self._chars[r, c + i], self._roles[r, c + i] = char, role
                return

    def place(self, column: int, row: int) -> Point:
        """The place of the world that is in the middle of a character."""
        x = (2 * column + 1 - self.columns) * self._per_dot + self._centre[0]
        y = (2 * self.rows - 4 * row - 2) * self._per_dot + self._centre[1]
        return x, y

    def spans(self) -> list[list[tuple[str, str]]]:
        """The picture row by row, as runs of (text, role)."""
        picture = []
        used = {r for r, _ in self._roles}
        for r in range(self.rows):
            if r not in used:
                picture.append([(" " * self.columns, "")])
                continue
            runs: list[tuple[str, str]] = []
            for c in range(self.columns):
                char, role = self._char(r, c), self._roles.get((r, c), "")
                if runs and runs[-1][1] == role:
                    runs[-1] = (runs[-1][0] + char, role)
                else:
                    runs.append((char, role))
            picture.append(runs)
        return picture

    def text(self) -> str:
        """The picture as plain text, without spaces at the ends of its lines."""
        return "\n".join("".join(text for text, _ in row).rstrip() for row in self.spans())

    def _char(self, row: int, column: int) -> str:
        char = self._chars.get((row, column))
        if char:
            return char
        bits = self._bits[row][column]
        if not bits:
            return " "
        return _ASCII_LINE if self.ascii_only else chr(0x2800 + bits)

    def _dot(self, point: Point) -> Point:
        x = (point[0] - self._centre[0]) / self._per_dot + self.columns
        y = (self._centre[1] - point[1]) / self._per_dot + 2 * self.rows
        return x, y

    def _cell(self, point: Point) -> tuple[int, int] | None:
        x, y = self._dot(point)
        # Rounded like the dots of lines, so that a mark covers the end of its line.
        row, column = round(y) // 4, round(x) // 2
        return (row, column) if 0 <= row < self.rows and 0 <= column < self.columns else None

    def _set(self, x: int, y: int, role: str) -> None:
        row, column = y // 4, x // 2
        if 0 <= row < self.rows and 0 <= column < self.columns:
            self._bits[row][column] |= _DOTS[y % 4][x % 2]
            self._roles[row, column] = role


def chart(
    series: Mapping[str, Sequence[Point]],
    columns: int,
    rows: int,
    *,
    ascii_only: bool = False,
    zero: bool = True,
    marks: Mapping[float, str] | None = None,
) -> tuple[Canvas, tuple[float, float], tuple[float, float]]:
    """Curves over one another, each named where it ends: the canvas, and the ranges that x and y fill.

    The axes have scales of their own. A gap in a curve is a point that is not a number.

    Args:
        series: by name, the points of each curve, x ascending.
        columns, rows: of the field, in characters.
        ascii_only: without braille.
        zero: whether zero of y is in sight, dashed, whatever the curves do.
        marks: what is written under the field at values of x.
    """
    real = [p for points in series.values() for p in points if p[1] == p[1]]
    low_x, high_x = min(x for x, _ in real), max(x for x, _ in real)
    ys = [y for _, y in real] + ([0.0] if zero else [])
    low_y, high_y = min(ys), max(ys)
    # In dots, with room for the names at the right.
    width = 2.0 * (columns - max(map(len, series)) - 3) - 6
    below = 4.0 if marks else 0.0
    height = 4.0 * rows - 6 - below
    across, up = width / max(high_x - low_x, 1e-300), height / max(high_y - low_y, 1e-300)
    canvas = Canvas(columns, rows, [(0.0, -below), (2.0 * columns - 6, height)], ascii_only=ascii_only)
    for x, text in (marks or {}).items():
        for i, char in enumerate(text):
            canvas.mark(((x - low_x) * across + 2.0 * i, -below), char, "axis")
    if low_y <= 0.0 <= high_y:
        canvas.line((0.0, -low_y * up), (width, -low_y * up), "axis", dashed=True)
    for i, (name, points) in enumerate(series.items()):
        role = f"link{i % 3}"
        places = [((x - low_x) * across, (y - low_y) * up) for x, y in points]
        for start, end in pairwise(places):
            if start[1] == start[1] and end[1] == end[1]:
                canvas.line(start, end, role)
        last = next((p for p in reversed(places) if p[1] == p[1]), None)
        if last is not None:
            canvas.label(last, name, role)
    return canvas, (low_x, high_x), (low_y, high_y)
