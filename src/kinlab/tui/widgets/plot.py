"""Curves over one another, under a line that says what they are and what the field spans."""

from collections.abc import Mapping, Sequence

from kinlab.canvas import Canvas, Point, chart
from kinlab.tui.numbers import shown
from kinlab.tui.widgets.picture import Picture

Series = Mapping[str, Sequence[Point]]


class Plot(Picture):
    """A small plot of up to three curves, named where they end."""

    def __init__(
        self, title: str = "", x: str = "", y: str = "", *, zero: bool = True, id: str | None = None
    ) -> None:
        """An empty plot.

        Args:
            title: what is plotted.
            x, y: units.
            zero: whether zero of y is always in sight.
        """
        super().__init__(self._chart, self._line, id=id)
        self.title, self.x, self.y, self._zero = title, x, y, zero
        self._series: Series = {}
        self._spans = ((0.0, 0.0), (0.0, 0.0))

    def plot(self, series: Series, title: str | None = None) -> None:
        """Show these curves; points that are not a number leave gaps."""
        self._series = series
        self.title = self.title if title is None else title
        self.redraw()

    def _chart(self, columns: int, rows: int, ascii_only: bool) -> Canvas:
        real = {name: points for name, points in self._series.items() if any(y == y for _, y in points)}
        if not real or columns < 12 or rows < 2:
            self._spans = ((0.0, 0.0), (0.0, 0.0))
            return Canvas(columns, rows, [(0.0, 0.0), (1.0, 1.0)], ascii_only=ascii_only)
        canvas, across, up = chart(real, columns, rows, ascii_only=ascii_only, zero=self._zero)
        self._spans = (across, up)
        return canvas

    def _line(self, canvas: Canvas) -> str:
        (x0, x1), (y0, y1) = self._spans
        # Three figures say as much as a plot shows.
        y, x = (f"{_short(low)}..{_short(high)}" for low, high in ((y0, y1), (x0, x1)))
        return f"{self.title}  {y} {self.y}, {x} {self.x}"


def _short(value: float) -> str:
    return shown(value, 1 if abs(value) >= 10 else 2)
