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
from kinlab.papers.recompute.finding import Finding, Verdict, plain

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
        inputs: what the worked line names: the paper's symbol, the quantity, its unit.
        cause: what is to be known.
        damaged: the scan did it; the verdict is then "explained", and `cause` says what the scan did.
        reading: the printed form in another convention, which `cause` names; where it gives the truth, the
            verdict is "explained".
        reading_truth: what it must give, where that convention changes the truth as well.
        entries: of a matrix, its printed texts in rows; each becomes a finding of its own.
    """

    number: str
    printed: str
    value: Form
    truth: Form
    corrected: str = ""
    corrected_value: Form | None = None
    unit: str = ""
    inputs: tuple[tuple[str, str, str], ...] = ()
    cause: str = ""
    damaged: bool = False
    reading: Form | None = None
    reading_truth: Form | None = None
    entries: tuple[tuple[str, ...], ...] = ()


def check(paper: str, equation: Equation, samples: Quantities, where: str = "equation") -> Iterator[Finding]:
    """The finding for an equation, and those for its entries."""
    truth = np.asarray(equation.truth(samples), float)
    right = equation.corrected_value or equation.value
    if not _same(_value(right, samples, truth), truth).all():
        raise AssertionError(f"{paper} ({equation.number}): the corrected form is not the truth")
    printed = _value(equation.value, samples, truth)
    same = _same(printed, truth)
    excused = equation.damaged or _is_right_as_read(equation, samples, truth)
    verdict: Verdict = "reproduced" if same.all() else "explained" if excused else "contradicted"
    name = f"{where} ({equation.number})"
    worst = int(np.argmin(same.reshape(len(same), -1).all(axis=1)))
    yield Finding(
        paper, name, "equation", equation.printed, equation.corrected or equation.printed, equation.unit, verdict,
        equation.cause, _worked(equation, samples, printed, truth, worst), damaged=equation.damaged and not same.all(),
    )  # fmt: skip
    for i, row in enumerate(equation.entries):
        for j, text in enumerate(row):
            k = int(np.argmin(same[:, i, j]))
            fits = bool(same[:, i, j].all())
            yield Finding(
                paper, f"{name} entry {i + 1},{j + 1}", "entry", text, text if fits else plain(truth[k, i, j]), "",
                "reproduced" if fits else verdict, "" if fits else equation.cause,
                f"{_inputs(equation, samples, k)}printed {_shown(printed[k, i, j], '')}, "
                f"true {_shown(truth[k, i, j], '')}",
                damaged=equation.damaged and not fits,
            )  # fmt: skip


def _value(form: Form, samples: Quantities, truth: Array) -> Array:
    """A form at all samples; NaN where it has no value."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.broadcast_to(np.asarray(form(samples), float), truth.shape)


def _is_right_as_read(equation: Equation, samples: Quantities, truth: Array) -> bool:
    if equation.reading is None:
        return False
    meant = truth if equation.reading_truth is None else _value(equation.reading_truth, samples, truth)
    return bool(_same(_value(equation.reading, samples, truth), meant).all())


def _same(one: Array, other: Array) -> Array:
    return np.asarray(np.abs(one - other) <= SAME * np.maximum(1.0, np.abs(other)))


def _inputs(equation: Equation, samples: Quantities, k: int) -> str:
    shown = [f"{symbol} = {_shown(float(samples[name][k]), unit)}" for symbol, name, unit in equation.inputs]
    return f"at {', '.join(shown)}: " if shown else ""


def _worked(equation: Equation, samples: Quantities, printed: Array, truth: Array, k: int) -> str:
    """One line: the inputs of the first sample where the print is off, what it gives there, and the truth."""
    begin = _inputs(equation, samples, k)
    if truth.ndim == 2:
        return f"{begin}printed {_place(printed[k], equation.unit)}, true {_place(truth[k], equation.unit)}"
    if truth.ndim > 2:
        entries = _same(printed, truth).reshape(len(truth), -1).all(axis=0)
        return f"{entries.sum()} of {entries.size} entries agree at {len(truth)} places"
    true = _shown(float(truth[k]), equation.unit)
    if not np.isfinite(printed[k]):
        return f"{begin}the printed form has no value, true {true}"
    return f"{begin}printed {_shown(float(printed[k]), equation.unit)}, true {true}"


def _place(values: Array, unit: str) -> str:
    return f"({', '.join(_shown(float(v), '') for v in values)}) {unit}".strip()


def _shown(value: float, unit: str) -> str:
    if unit == "deg":
        value = float(np.degrees(value))
    return f"{value:.4g} {unit}".strip() if abs(value) >= 1e4 else f"{round(value, 4) + 0.0:g} {unit}".strip()
