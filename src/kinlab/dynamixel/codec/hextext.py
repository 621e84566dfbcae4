"""Bytes as people type and paste them: FF FF 01, 0xFF,0xFF, \\xff\\xff, FFFF01."""

import re

from kinlab.errors import UsageError

_SEPARATORS = re.compile(r"[\s,;:.\-\[\](){}'\"]+")
_TOKEN = re.compile(r"[^\s,;:.\-\[\](){}'\"]+")


class HexError(UsageError):
    """Text that is no bytes.

    Attributes:
        position: of the first character that does not fit, from 0.
    """

    def __init__(self, text: str, position: int, reason: str) -> None:
        super().__init__(f"{reason} at position {position + 1}\n  {text}\n  {' ' * position}^")
        self.position = position


def parse_hex(text: str) -> bytes:
    """The bytes that `text` writes in hexadecimal.

    Separators may be spaces, commas, colons, dots; 0x and \\x are understood. Several bytes may stand
    together (FFFF01); an odd digit alone is a byte (F is 0F).

    Raises:
        HexError: anything else, with the position.

    >>> parse_hex("FF 0xFF, 01").hex()
    'ffff01'
    """
    data = bytearray()
    for token in _TOKEN.finditer(text):
        at, word = token.start(), token[0]
        for part in re.finditer(r"(?:0[xX]|\\[xX])?([^\\]*?)(?=\\|0[xX]|$)", word):
            digits = part[1]
            if not part[0]:
                continue
            wrong = re.search(r"[^0-9a-fA-F]", digits)
            if wrong:
                raise HexError(
                    text, at + part.start(1) + wrong.start(), f"'{wrong[0]}' is no hexadecimal digit"
                )
            if not digits:
                raise HexError(text, at + part.start(1), "a byte is missing")
            if len(digits) % 2 and len(digits) > 1:
                raise HexError(text, at + part.end(1) - 1, "an odd number of digits leaves half a byte")
            data += bytes.fromhex(digits.rjust(2, "0") if len(digits) == 1 else digits)
    return bytes(data)


def show_hex(data: bytes) -> str:
    """Bytes as FF FF 01."""
    return data.hex(" ").upper()
