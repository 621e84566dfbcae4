"""A lesson's text on the plain terminal."""

import shutil
from collections.abc import Iterator

from kinlab.lessons.prose import Line, prose

MOST_COLUMNS = 88


def width() -> int:
    """Columns of text: those of the terminal, but no longer lines than one reads with ease."""
    return min(shutil.get_terminal_size().columns, MOST_COLUMNS)


def lines(markdown: str) -> Iterator[Line]:
    """Markdown as lines of (style, text) that fit the terminal."""
    return prose(markdown, width())
