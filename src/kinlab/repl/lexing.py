"""Colours while typing."""

from collections.abc import Callable

from prompt_toolkit.document import Document
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.lexers import Lexer

from kinlab.dynamixel.sandbox import Session
from kinlab.dynamixel.sandbox.prompting import coloured


class LineLexer(Lexer):
    """Colours a line as the sandbox will understand it."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def lex_document(self, document: Document) -> Callable[[int], StyleAndTextTuples]:
        """Styled fragments, line by line."""
        return lambda number: styled(self._session, document.lines[number])


def styled(session: Session, line: str) -> StyleAndTextTuples:
    """A line as fragments of (style, text)."""
    return [(f"class:{style}" if style else "", text) for style, text in coloured(session, line)]
