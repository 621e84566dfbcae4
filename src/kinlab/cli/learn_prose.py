"""A lesson's Markdown as lines for this terminal."""

import shutil
from collections.abc import Iterator

from kinlab.lessons import prose as lines
from kinlab.lessons.prose import Line

MOST_COLUMNS = 88


def width() -> int:
    """Columns of text: those of the terminal, but no longer lines than one reads with ease."""
    return min(shutil.get_terminal_size().columns, MOST_COLUMNS)


def prose(markdown: str) -> Iterator[Line]:
    """Markdown as lines of (style, text) as wide as is read with ease."""
    return lines.prose(markdown, width())
