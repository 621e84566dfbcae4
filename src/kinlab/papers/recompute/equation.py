"""Numbered equations, each in its printed form against the truth, over many places at once.

The truth comes from somewhere else than the equation: from the geometry of the robot's own kinematics, a
derivative taken by differences, a product multiplied out. A paper's module samples quantities by name (arrays
over a leading dimension) and gives for each equation the printed form, the corrected one where they differ, and
the truth, as functions of those quantities.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array
from kinlab.papers.equations import NotComputable
from kinlab.papers.recompute.finding import Finding, Verdict

Quantities = Mapping[str, Array]
Form = Callable[[Quantities], ArrayLike]
# Two forms that differ by no more than this part of their size are the same.
SAME = 1e-9


@dataclass(frozen=True)
class Equation:
    """A numbered equation.

    Attributes:
        number: as printed, without brackets.
        printed: its text.
        value: its printed form, evaluated.
        truth: what it must give, from elsewhere.
        corrected, corrected_value: text and form that are right; none where the print is.
        unit: of its value: "deg" shows radians as degrees.
        inputs: the quantities that the worked line names, with their units.
        cause: what is to be known.
        damaged: the scan did it; the verdict is then "explained", and `cause` says what the scan did.
        reading: the corrected form is what the print means in another convention, which `cause` names: the
            verdict is then "explained" as well.
        entries: of a matrix, its printed texts in rows; each becomes a finding of its own.
    """

    number: str
    printed: str
    value: Form
    truth: Form
    corrected: str = ""
    corrected_value: Form | None = None
    unit: str = ""
    inputs: Mapping[str, str] | None = None
    cause: str = ""
    damaged: bool = False
    reading: bool = False
    entries: tuple[tuple[str, ...], ...] = ()


def check(paper: str, equation: Equation, samples: Quantities, where: str = "equation") -> Iterator[Finding]:
    """The finding for an equation, and those for its entries."""
    truth = np.asarray(equation.truth(samples), float)
    right = equation.corrected_value or equation.value
    if not _same(np.asarray(right(samples), float), truth).all():
        raise AssertionError(f"{paper} ({equation.number}): the corrected form is not the truth")
    reason = ""
    printed = np.full(truth.shape, np.nan)
    try:
        with np.errstate(invalid="ignore", divide="ignore"):
            printed = np.broadcast_to(np.asarray(equation.value(samples), float), truth.shape)
    except NotComputable as missing:
        reason = str(missing)
    same = _same(printed, truth)
    excused = equation.damaged or equation.reading
    verdict: Verdict = "reproduced" if same.all() else "explained" if excused else "contradicted"
    name = f"{where} ({equation.number})"
    yield Finding(
        paper, name, "equation", equation.printed, equation.corrected or equation.printed, equation.unit,
        verdict, equation.cause, _worked(equation, samples, printed, truth, reason), damaged=equation.damaged,
    )  # fmt: skip
    for i, row in enumerate(equation.entries):
        for j, text in enumerate(row):
            fits = bool(same[..., i, j].all())
            k = int(np.argmax(np.abs(np.nan_to_num(printed[..., i, j] - truth[..., i, j], nan=np.inf))))
            yield Finding(
                paper, f"{name} entry {i + 1},{j + 1}", "entry", text, text if fits else float(truth[k, i, j]), "",
                "reproduced" if fits else "explained" if excused else "contradicted", "" if fits else equation.cause,
                f"{_inputs(equation, samples, k)}printed {printed[k, i, j]:.4f}, true {truth[k, i, j]:.4f}",
                damaged=equation.damaged and not fits,
            )  # fmt: skip


def _same(one: Array, other: Array) -> Array:
    return np.asarray(np.abs(one - other) <= SAME * np.maximum(1.0, np.abs(other)))


def _inputs(equation: Equation, samples: Quantities, k: int) -> str:
    shown = []
    for name, unit in (equation.inputs or {}).items():
        value = float(np.broadcast_to(samples[name], _length(samples))[k])
        shown.append(f"{name} = {_shown(value, unit)}")
    return f"at {', '.join(shown)}: " if shown else ""


def _worked(equation: Equation, samples: Quantities, printed: Array, truth: Array, reason: str) -> str:
    """One line: the inputs of the sample where the print is furthest off, what it gives there, and the truth."""
    if truth.ndim > 1:
        same = _same(printed, truth)
        entries = same.reshape(len(same), -1).all(axis=0)
        return f"{entries.sum()} of {entries.size} entries agree at {len(truth)} places"
    k = int(np.argmax(np.abs(np.nan_to_num(printed - truth, nan=np.inf))))
    begin = _inputs(equation, samples, k)
    true = _shown(float(truth[k]), equation.unit)
    if not np.isfinite(printed[k]):
        return f"{begin}printed form has no value{f' ({reason})' if reason else ''}, true {true}"
    return f"{begin}printed {_shown(float(printed[k]), equation.unit)}, true {true}"


def _length(samples: Quantities) -> tuple[int, ...]:
    return (max(len(np.atleast_1d(v)) for v in samples.values()),)


def _shown(value: float, unit: str) -> str:
    if unit == "deg":
        value = float(np.degrees(value))
    return f"{value:.4g} {unit}".strip() if abs(value) >= 1e4 else f"{round(value, 4):g} {unit}".strip()
