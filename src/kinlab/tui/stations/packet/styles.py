"""What the sandbox's styles look like. The words beside the bytes say the same: colour only repeats it."""

from collections.abc import Mapping, Sequence

from rich.style import Style
from textual.content import Content

from kinlab.dynamixel.sandbox.session import Line

# The theme's colour, "" for that of plain text, and whether it is bold.
STYLES = {
    "arrow": ("", True),
    "header": ("quiet", False),
    "id": ("sky", False),
    "length": ("purple", False),
    "instruction": ("orange", True),
    "address": ("green", False),
    "data": ("", True),
    "check": ("purple", True),
    "good": ("sky", False),
    "bad": ("vermillion", True),
    "odd": ("orange", False),
    "dim": ("quiet", False),
    "verb": ("", True),
}
INDENT = 3
FIELD = 4  # parts of a line that shows a field


def css_style(name: str) -> str:
    """The style for Textual's content."""
    colour, bold = STYLES.get(name, ("", False))
    return " ".join(part for part in ("bold" if bold else "", f"${colour}" if colour else "") if part)


def rich_style(name: str, theme: Mapping[str, str]) -> Style:
    """The style for Rich's text; `theme` gives the colours."""
    colour, bold = STYLES.get(name, ("", False))
    return Style(color=theme[colour] if colour else None, bold=bold or None)


def content(line: Line) -> Content:
    """A line of the sandbox, coloured."""
    return Content.assemble(*(Content.styled(text, css_style(style)) for style, text in line if text))


def folded(lines: Sequence[Line], width: int) -> list[Line]:
    """Lines in as many as they take: those of a packet's fields in columns, the others a little indented."""
    fields = [line for line in lines if _is_field(line)]
    columns = [max((len(line[i][1].strip()) for line in fields), default=0) for i in range(FIELD - 1)]
    columns[1] = min(columns[1], width // 3)
    rows: list[Line] = []
    for line in lines:
        if not _is_field(line):
            rows += flowed(line, INDENT, width)
            continue
        (style, offset), *parts = line
        place: Line = [(style, f" {offset.strip():>{columns[0]}} ")]
        place += [(s, f" {t.strip():<{wide}} ") for (s, t), wide in zip(parts, columns[1:], strict=False)]
        indent = sum(len(text) for _, text in place) + 1
        rows += flowed([*place, ("", " "), parts[-1]], indent, width)
    return rows


def _is_field(line: Line) -> bool:
    """Whether it is a field of a packet: where, which bytes, what they are called, what they mean."""
    return len(line) == FIELD and line[0][0] == "dim" and line[0][1].strip().isdecimal()


def flowed(line: Line, indent: int, width: int) -> list[Line]:
    """A line in as many as it takes, the later ones indented."""
    rows: list[Line] = [[]]
    column = 0
    for style, text in line:
        for word in _words(text):
            if column + len(word.rstrip()) > width and column > indent:
                rows.append([("", " " * indent)])
                column, word = indent, word.lstrip()
            rows[-1].append((style, word))
            column += len(word)
    return rows


def _words(text: str) -> list[str]:
    """The text cut before each word, so that the blanks in front belong to it."""
    found: list[str] = []
    start = 0
    for at in range(1, len(text)):
        if text[at] == " " != text[at - 1]:
            found.append(text[start:at])
            start = at
    return [*found, text[start:]] if text else found
