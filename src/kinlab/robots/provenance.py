"""Where a figure comes from, so that nothing assumed is shown as if it were printed."""

from dataclasses import dataclass
from typing import Literal

KINDS = ("printed", "inferred", "assumed")


@dataclass(frozen=True)
class Provenance:
    """`printed` in the paper, `inferred` from it, or `assumed`; and the place, or the reason."""

    kind: Literal["printed", "inferred", "assumed"]
    text: str


UNSOURCED = Provenance("assumed", "the file gives no source")


@dataclass(frozen=True)
class Dimension:
    """A figure of a robot with its source.

    Attributes:
        name: what it is, as in the robots file.
        value: in mm, deg or g, as `unit` says: figures for people to read.
        unit: "mm", "deg" or "g".
        source: where it comes from.
    """

    name: str
    value: float | tuple[float, ...]
    unit: str
    source: Provenance
