"""Colours while typing: a command as one, bytes by the field they belong to."""

import re
from collections.abc import Callable

from prompt_toolkit.document import Document
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.lexers import Lexer

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.hextext import HexError, parse_hex
from kinlab.dynamixel.sandbox import VERBS, Session
from kinlab.dynamixel.sandbox.assembling import looks_like_bytes
from kinlab.dynamixel.sandbox.display import style_of

OF_BYTES = frozenset({"send", "decode", "step", "expect", "crc"})


class LineLexer(Lexer):
    """Colours a line as the sandbox will understand it."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def lex_document(self, document: Document) -> Callable[[int], StyleAndTextTuples]:
        """Styled fragments, line by line."""
        return lambda number: styled(self._session, document.lines[number])


def styled(session: Session, line: str) -> StyleAndTextTuples:
    """A line as fragments of (style, text)."""
    code, sign, comment = line.partition("#")
    match = re.match(r"(\s*)(\S*)(.*)", code)
    assert match is not None
    blank, verb, rest = match.groups()
    after: StyleAndTextTuples = [("class:dim", sign + comment)]
    if session.assembling is not None and looks_like_bytes(code.strip()):
        return [*_bytes(session, code, session.assembling), *after]
    head: StyleAndTextTuples = [("", blank), ("class:verb" if verb in VERBS else "class:bad", verb)]
    if verb in OF_BYTES:
        before = session.assembling or b"" if verb == "step" else b""
        return [*head, *_bytes(session, rest, before), *after]
    return [*head, ("", rest), *after]


def _bytes(session: Session, text: str, before: bytes) -> StyleAndTextTuples:
    """Hexadecimal bytes in the colours of their fields; `before` are those that were assembled earlier."""
    fragments: StyleAndTextTuples = []
    styles: dict[int, str] = {}
    words = re.findall(r"\s+|\S+", text)
    values = [_value(word) for word in words]
    data = before + b"".join(value for value in values if value)
    for part in dissect(data, tables=session.table).fields:
        styles.update(dict.fromkeys(range(part.offset, part.offset + len(part.data)), style_of(part.name)))
    at = len(before)
    for word, value in zip(words, values, strict=True):
        fragments.append((f"class:{styles.get(at, '')}" if value else "", word))
        at += len(value or b"")
    return fragments


def _value(word: str) -> bytes | None:
    try:
        return parse_hex(word) if not word.isspace() else None
    except HexError:
        return None
