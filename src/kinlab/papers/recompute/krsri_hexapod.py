"""The gaits of the KRSRI robot (2025), recomputed: Tables 1 to 5, and the figures that are quoted of them."""

from collections.abc import Iterator

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.energy import GAITS, GROUNDS
from kinlab.papers.recompute.finding import Finding, Judge, mean_line
from kinlab.papers.recompute.krsri_equations import equations
from kinlab.papers.recompute.paper import Paper, numbers
from kinlab.papers.tables import printed_table

NAME = "krsri-hexapod"
JUDGE = Judge(NAME)
# The text says it of four columns. Of four columns of eleven figures each that have nothing to do with the speed, the
# strongest correlates more than this once in twenty times (Student's t, at 5 % / 4).
BY_CHANCE = 0.721


def recompute() -> Iterator[Finding]:
    """Every finding, in the order of the print."""
    yield from abstract()
    yield from equations()
    yield JUDGE.figure("section 3.4, value of π", "3.14", np.pi, "", "3.14159... to two decimals")
    yield JUDGE.figure(
        "section 3.5, legs that stand in the wave gait", "5", 6 - 1, "legs", "6 legs - 1 that swings = 5"
    )
    for ground, (energy, way) in GROUNDS.items():
        yield from runs(energy)
        yield from consumption(ground, energy)
        yield from runs(way)
        yield from JUDGE.averages(printed_table(NAME, way))
        yield from quoted_averages(f"text below Table {way}", way)
        yield from accuracy(ground, way)
    yield compared()
    yield from conclusion()


def runs(number: str) -> Iterator[Finding]:
    """The rows of Tables 2 to 5: speeds are chosen, durations follow from (27), the rest is measured."""
    table = printed_table(NAME, number)
    for row in table.runs:
        cells = table.rows[row]
        speed, way = cells["speed"].figure.value, 10 * cells["distance"].figure.value
        for name, cell in cells.items():
            if name == "duration":
                yield JUDGE.cell(
                    cell, way / speed, f"(27): {way:g} mm / {speed:g} mm/s = {way / speed:.2f} s"
                )
            elif name in GAITS:
                yield JUDGE.measured(cell, "measured, the mean of three runs")
            else:
                yield JUDGE.measured(cell, "chosen by the authors")


def abstract() -> Iterator[Finding]:
    """The consumption and the averages that the abstract quotes."""
    table = printed_table(NAME, "2")
    for gait, speed, printed in (
        ("wave", 10, "0.338"), ("wave", 13, "0.252"), ("tripod", 10, "0.343"), ("tripod", 13, "0.271"),
        ("tripod", 40, "0.098"), ("wave", 40, "0.195"),
    ):  # fmt: skip
        row = int(np.flatnonzero(table.column("speed") == speed)[0])
        cell = table.rows[table.runs[row]][gait]
        yield JUDGE.figure(
            f"abstract, {gait} on flat ground at {speed} mm/s", printed, cell.figure.value, "Wh",
            f"{cell.where} prints {cell.figure.text}", table="2",
        )  # fmt: skip
    yield from cheaper("abstract", "flat", "2")
    for _, way in GROUNDS.values():
        yield from quoted_averages("abstract", way)


def cheaper(where: str, ground: str, number: str) -> Iterator[Finding]:
    """From which speed on the tripod costs less, and up to which the wave does."""
    table = printed_table(NAME, number)
    speed, wave, tripod = (table.column(name) for name in ("speed", *GAITS))
    less = speed[tripod < wave]
    k = int(np.argmax(speed == less.min()))
    line = (
        f"at {speed[k]:g} mm/s {tripod[k]:g} < {wave[k]:g} Wh, "
        f"at {speed[k - 1]:g} mm/s {tripod[k - 1]:g} > {wave[k - 1]:g}"
    )
    remark = "so at every greater speed, and at no smaller" if (tripod < wave)[k:].all() else ""
    place = f"{where}, speed from which the tripod costs less on {ground} ground"
    yield JUDGE.figure(place, "16", float(less.min()), "mm/s", line, remark=remark, table=number)
    place = f"{where}, speed up to which the wave costs less on {ground} ground"
    yield JUDGE.figure(place, "13", float(speed[wave < tripod].max()), "mm/s", line, table=number)


def quoted_averages(where: str, number: str) -> Iterator[Finding]:
    """The averages of Table 3 or 5, as percentages."""
    printed = {"3": ("90.0", "91.7"), "5": ("83.7", "80.8")}[number]
    table = printed_table(NAME, number)
    for gait, figure in zip(GAITS, printed, strict=True):
        column = table.column(gait)
        line = f"{mean_line(column)} {'cm of 100 cm' if table.units[gait] == 'cm' else '%'}"
        yield JUDGE.figure(
            f"{where}, average way of the {gait}, Table {number}", figure, float(column.mean()), "%", line, table=number
        )  # fmt: skip


def consumption(ground: str, number: str) -> Iterator[Finding]:
    """What the text says of the energy over speed."""
    table = printed_table(NAME, number)
    speed = table.column("speed")
    rises = {gait: np.flatnonzero(np.diff(table.column(gait)) > 0) + 1 for gait in GAITS}
    fits = {gait: _straight(speed, table.column(gait)) for gait in GAITS}
    where = f"text below Table {number}"
    for gait in GAITS:
        energy = table.column(gait)
        trend = float(np.polyfit(speed, energy, 1)[0])
        ups = ", ".join(f"{energy[k - 1]:g} to {energy[k]:g} Wh at {speed[k]:g} mm/s" for k in rises[gait])
        yield JUDGE.claim(
            f"{where}, energy of the {gait} falls with speed", "falls", "falls" if trend < 0 else "rises", trend < 0,
            f"from {energy[0]:g} Wh at {speed[0]:g} mm/s to {energy[-1]:g} Wh at {speed[-1]:g} mm/s; a line through "
            f"all falls by {-trend * 1e3:.2f} mWh per mm/s",
            f"not at every step: {ups}" if ups else "at every step", table=number,
        )  # fmt: skip
    straighter = max(GAITS, key=lambda gait: fits[gait])
    steadier = min(GAITS, key=lambda gait: len(rises[gait]))
    yield JUDGE.claim(
        f"{where}, the tripod falls more linearly than the wave", "tripod", straighter, straighter == "tripod",
        f"share of the variance that a straight line explains: wave {fits['wave']:.3f}, tripod {fits['tripod']:.3f}; "
        f"steps at which the energy rises: wave {len(rises['wave'])}, tripod {len(rises['tripod'])}",
        table=number, reading=("linear in the sense of steady", steadier == "tripod"),
    )  # fmt: skip
    yield from cheaper(where, ground, number)


def accuracy(ground: str, number: str) -> Iterator[Finding]:
    """Whether the way that is covered depends on the speed: the text says that it does not."""
    table = printed_table(NAME, number)
    speed = table.column("speed")
    for gait in GAITS:
        r = float(np.corrcoef(speed, table.column(gait))[0, 1])
        yield JUDGE.claim(
            f"text below Table {number}, the way of the {gait} on {ground} ground has nothing to do with speed",
            "unrelated", "unrelated" if abs(r) < BY_CHANCE else "related", abs(r) < BY_CHANCE,
            f"correlation of the columns speed and {gait}: r = {r:.3f}; of four unrelated columns the strongest passes "
            f"{BY_CHANCE} by chance once in twenty", table=number,
        )  # fmt: skip


def compared() -> Finding:
    """Broken ground costs more than flat."""
    means = {gait: [float(printed_table(NAME, n).column(gait).mean()) for n in ("2", "4")] for gait in GAITS}
    holds = all(flat < broken for flat, broken in means.values())
    less = [
        f"{gait} at {speed:g} mm/s {broken:g} < {flat:g}"
        for gait in GAITS
        for speed, flat, broken in zip(
            printed_table(NAME, "2").column("speed"), *(printed_table(NAME, n).column(gait) for n in ("2", "4")),
            strict=True,
        )
        if broken < flat
    ]  # fmt: skip
    line = "; ".join(
        f"mean of the {gait} {flat:.4f} and {broken:.4f} Wh" for gait, (flat, broken) in means.items()
    )
    return JUDGE.claim(
        "text below Table 4, broken ground costs a little more", "more", "more" if holds else "less", holds, line,
        f"except {', '.join(less)}", table="4",
    )  # fmt: skip


def conclusion() -> Iterator[Finding]:
    """The averages and the range of speeds once more."""
    for ground, (energy, way) in GROUNDS.items():
        yield from cheaper("conclusion", ground, energy)
        yield from quoted_averages("conclusion", way)


def _straight(x: Array, y: Array) -> float:
    """The share of the variance of `y` that a straight line over `x` explains."""
    return float(np.corrcoef(x, y)[0, 1] ** 2)


PAPER = Paper(
    name=NAME,
    title="Pengembangan Algoritma Gait Robot KRSRI ITN Malang Menggunakan Wave Gait, 2025",
    equations=numbers(1, 29),
    recompute=recompute,
)
