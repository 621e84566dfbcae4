"""How answers look: tables, places, drawings. Rich is imported here and in nothing that `--json` needs."""

from collections.abc import Mapping, Sequence
from typing import Any

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from kinlab.canvas import Canvas, chart
from kinlab.robots.drawing import draw_limb
from kinlab.robots.model import Limb
from kinlab.robots.workspace import Section

# Colours that stay apart for the colour-blind (Okabe and Ito), repeated by marks and labels.
STYLES = {
    "link0": "#56B4E9",
    "link1": "#E69F00",
    "link2": "#009E73",
    "tip": "bold",
    "joint": "bold",
    "target": "bold #CC79A7",
}


def console() -> Console:
    """Where people look: as wide as the terminal, colours only where it has them."""
    return Console(highlight=False)


def show(*parts: RenderableType) -> None:
    """Print tables and text for people."""
    out = console()
    for part in parts:
        if isinstance(part, Table) and part.title:
            # Rich would fold a title to the width of its table.
            out.print(Text(str(part.title), style="italic"))
            part.title = None
        out.print(part, markup=False)


def table(title: str, *columns: str | tuple[str, str]) -> Table:
    """An empty table. A column given as (name, unit) holds numbers: its unit stands below, its cells to the right."""
    found = Table(title=title, box=None, pad_edge=False, padding=(0, 3, 0, 0))
    for column in columns:
        if isinstance(column, tuple):
            found.add_column(Text("\n".join(filter(None, column))), justify="right", no_wrap=True)
        else:
            # A name that stands first is what a reader looks for: it is not folded.
            found.add_column(
                column, overflow="fold", no_wrap=not found.columns, min_width=min(len(column), 12)
            )
    return found


def sentences(*rows: tuple[str | Text, str]) -> Table:
    """Sentences behind short heads, folded beside them."""
    found = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=False)
    found.add_column(justify="right", no_wrap=True)
    found.add_column(overflow="fold")
    for head, sentence in rows:
        found.add_row(head, sentence)
    return found


def place(values: Any, digits: int = 3) -> str:
    """A place for reading: `(75, 10, -46)`, without zeros that say nothing."""
    return "(" + ", ".join(number(v, digits) for v in values) + ")"


def fixed(value: float, digits: int) -> str:
    """A number with exactly `digits` decimals, without a minus before nothing."""
    return f"{round(value, digits) + 0.0:.{digits}f}"


def number(value: float, digits: int = 3) -> str:
    """A number with at most `digits` decimals."""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def drawing(limb: Limb, q: Any, target: Any) -> RenderableType:
    """The limb from the side and from the top, where the terminal has room and can draw; else nothing."""
    out = console()
    if out.width < 60:
        return Text("")
    width = min(38, out.width // 2 - 2)
    plain = not out.encoding.lower().startswith("utf")
    side, top = draw_limb(limb, q, target, columns=width, ascii_only=plain)
    views = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=True, header_style="italic")
    for name, canvas in (("side", side), ("top", top)):
        views.add_column(
            Text(f"{name}, one character is {number(canvas.cell_width, 1)} mm wide"),
            width=width,
            no_wrap=True,
        )
    views.add_row(picture(side), picture(top))
    return views


def picture(canvas: Canvas) -> RenderableType:
    """A canvas in colours."""
    rows = []
    for spans in canvas.spans():
        row = Text()
        for text, role in spans:
            row.append(text, style=STYLES.get(role, ""))
        rows.append(row)
    return Group(*rows)


def section(name: str, cut: Section, limb: Limb) -> list[RenderableType]:
    """A section of a workspace: reachable places filled, the first joint and the stance marked."""
    canvas = Canvas(
        min(76, console().width),
        18,
        [(float(x), float(y)) for x in cut.across[[0, -1]] for y in cut.up[[0, -1]]] + [(0.0, 0.0)],
        ascii_only=not console().encoding.lower().startswith("utf"),
    )
    canvas.fill(cut.holds, "link0")
    canvas.mark((0.0, 0.0), "o" if canvas.ascii_only else "●", "joint")
    scale = f"{name}, {cut.plane}; one character is {number(canvas.cell_width * 1000, 1)} mm wide"
    return [Text(scale, style="italic"), picture(canvas)]


def plotted(
    title: str, series: Mapping[str, Sequence[tuple[float, float]]], x: str, y: str
) -> list[RenderableType]:
    """Curves under a line that says what they are, in which units, and what the field spans."""
    out = console()
    plain = not out.encoding.lower().startswith("utf")
    canvas, across, up = chart(series, min(78, out.width), 9, ascii_only=plain)
    spans = f"x {number(across[0])} to {number(across[1])} {x}, y {number(up[0])} to {number(up[1])} {y}"
    return [Text(f"{title}; {spans}", style="italic"), picture(canvas)]
