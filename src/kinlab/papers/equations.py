"""A paper's equations as a chain of numbered steps, each faulty one with a printed and a corrected form.

A chain is evaluated with a set of equation numbers: those are taken letter for letter, all others
corrected. All of them give what the paper prints, none what is true, one alone what it costs.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from kinlab.kinematics.transforms import Array

Printed = frozenset[str]
NONE: Printed = frozenset()
# Rounding may carry the cosine of a stretched leg this far beyond 1.
ROUNDING = 1e-12


class NotComputable(Exception):  # noqa: N818 - not an error: what the print leads to
    """An equation has no value at this target; the message names it and says why."""


class Answer(NamedTuple):
    """Joint angles (n,) in rad, in the limb's convention, and what is to be said of how they came about."""

    q: Array
    remark: str = ""


@dataclass(frozen=True)
class Misprint:
    """An equation whose printed form differs from the one that is true of the robot.

    Attributes:
        equation: its number, by which it is selected.
        printed, corrected: both forms.
        remark: what a reader must know, such as where a convention excuses it.
    """

    equation: str
    printed: str
    corrected: str
    remark: str = ""


@dataclass(frozen=True)
class InverseEquations:
    """A paper's inverse kinematics.

    Attributes:
        variant: "equations", or "tables" where the tables were computed in another way.
        where: the equations or tables.
        kind: of the limb that they describe, a `ClosedForm.kind`.
        misprints: what is wrong with them.
        note: how they were read, and what else is to be known.
        solve: (target (3,) in metres and the paper's axes, the limb's lengths, which misprints are
            in force) to an `Answer`; for limbs that choose their attitude also `heading` in rad.
        own_tip: where the tables rest on a leg of their own, its foot (3,) for angles and lengths.
    """

    variant: str
    where: str
    kind: str
    misprints: tuple[Misprint, ...]
    note: str
    solve: Callable[..., Answer]
    own_tip: Callable[[Array, tuple[float, ...]], Array] | None = None


@dataclass(frozen=True)
class ForwardEquations:
    """A paper's forward kinematics.

    Attributes:
        where: the equations.
        axes: of the joints that they describe, in `frame`, (n, 3).
        frame: "paper" or "limb", the axes they are written in.
        misprints: what is wrong with them.
        note: how they were read.
        pose: (angles (n,) in rad, lengths (n,) of the links in metres, which misprints are in
            force) to the pose (4, 4) of the tip. The attitude of a misprint need not be a rotation.
        attitude: whether the pose's attitude is that of the limb's tip; DH frames are turned.
    """

    where: str
    axes: tuple[tuple[float, float, float], ...]
    frame: str
    misprints: tuple[Misprint, ...]
    note: str
    pose: Callable[[Array, tuple[float, ...], Printed], Array]
    attitude: bool = True


def acos(value: float, equation: str) -> float:
    """The inverse cosine, in rad.

    Raises:
        NotComputable: `equation` asks for that of a number beyond 1.
    """
    if abs(value) > 1 + ROUNDING:
        raise NotComputable(f"equation ({equation}) asks for the acos of {value:.4g}")
    return math.acos(max(-1.0, min(1.0, value)))


def quotient(numerator: float, denominator: float, equation: str) -> float:
    """A division.

    Raises:
        NotComputable: `equation` divides by zero.
    """
    if denominator == 0:
        raise NotComputable(f"equation ({equation}) divides by zero")
    return numerator / denominator
