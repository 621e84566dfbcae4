"""A number as it is printed: its text, so that 3.98 and 3.980 differ, and what a computed value has to do with it."""

import math
import re
from dataclasses import dataclass

# Doubles that should lie on the edge between two printed figures lie this part of the last digit beside it.
SLACK = 1e-6
_NUMBER = re.compile(r"[+-]?\d+(\.\d+)?")
_HEX = re.compile(r"0[xX][0-9a-fA-F]+")


@dataclass(frozen=True)
class Figure:
    """A number as it is printed.

    Attributes:
        text: the print, with a decimal point: "3.980", "-60", "0x18".
        damaged: the scan has visibly harmed it, so that it does not count against the paper.
    """

    text: str
    damaged: bool = False

    @classmethod
    def read(cls, cell: str) -> "Figure":
        """A cell of a table file; one that ends in "?" is damaged.

        Raises:
            ValueError: it is no number.
        """
        text = cell.removesuffix("?")
        if not (_NUMBER.fullmatch(text) or _HEX.fullmatch(text)):
            raise ValueError(f"'{cell}' is no printed number, such as 3.980, -60 or 0x18")
        return cls(text, cell.endswith("?"))

    @property
    def value(self) -> float:
        """The number."""
        return float(int(self.text, 16)) if _HEX.fullmatch(self.text) else float(self.text)

    @property
    def decimals(self) -> int:
        """How many digits stand behind the point."""
        return len(self.text.partition(".")[2]) if _NUMBER.fullmatch(self.text) else 0

    def rounds(self, value: float, decimals: int | None = None) -> bool:
        """Whether `value`, rounded to the printed decimals, is this; of two equally near figures either will do.

        Args:
            value: what was computed.
            decimals: of the column, where a zero at the end of this figure was left out.
        """
        step = 10.0 ** -(self.decimals if decimals is None else decimals)
        return math.isfinite(value) and abs(value - self.value) <= step * (0.5 + SLACK)

    def cuts(self, value: float, decimals: int | None = None) -> bool:
        """Whether `value`, with all further decimals left off, is this."""
        scale = 10.0 ** (self.decimals if decimals is None else decimals)
        if not math.isfinite(value):
            return False
        left = math.trunc(value * scale + math.copysign(SLACK, value))
        return left == round(self.value * scale)
