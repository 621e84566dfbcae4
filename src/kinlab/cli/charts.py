"""Curves over time with characters: their own scales right and up, on the canvas that the drawings use."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

from rich.console import Group, RenderableType
from rich.text import Text

from kinlab.canvas import Canvas
from kinlab.cli.show import STYLES, console, number

ROLES = ("link0", "link1", "link2")


def chart(
    title: str, unit: str, t: Sequence[float], curves: Mapping[str, Sequence[float]], rows: int = 9
) -> RenderableType:
    """Curves over `t`, s, named below; all on one scale."""
    out = console()
    plain = not out.encoding.lower().startswith("utf")
    columns = max(20, min(96, out.width - 12))
    wide, high = 2 * columns - 6, 4 * rows - 6
    values = [v for curve in curves.values() for v in curve if v == v]
    low, top = min([0.0, *values]), max([0.0, *values])
    span, until = (top - low) or 1.0, max(t) or 1.0
    canvas = Canvas(columns, rows, [(0, 0), (wide, high)], ascii_only=plain)

    def places(x: float, y: float) -> tuple[float, float]:
        return wide * x / until, high * (y - low) / span

    canvas.line(places(0.0, 0.0), places(until, 0.0), "", dashed=True)
    for role, curve in zip(ROLES, curves.values(), strict=False):
        points = [places(x, y) for x, y in zip(t, curve, strict=True) if y == y]
        for a, b in pairwise(points):
            canvas.line(a, b, role)
    lines = []
    for r, spans in enumerate(canvas.spans()):
        edge = number(top, 2) if r == 0 else number(low, 2) if r == rows - 1 else ""
        row = Text(f"{edge:>8} ")
        for text, role in spans:
            row.append(text, style=STYLES.get(role, ""))
        lines.append(row)
    legend = Text(" " * 9)
    for role, name in zip(ROLES, curves, strict=False):
        legend.append("-- " if plain else "━━ ", style=STYLES[role])
        legend.append(f"{name}   ")
    legend.append(f"0 to {number(until, 2)} s")
    return Group(Text(f"{title} [{unit}]", style="italic"), *lines, legend)
