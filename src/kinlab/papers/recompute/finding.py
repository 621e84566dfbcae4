"""What recomputing one printed thing found, and how a verdict comes about: by computation, never by hand."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from kinlab.papers.figure import Figure
from kinlab.papers.tables import Cell, PrintedTable

Verdict = Literal["reproduced", "explained", "contradicted", "measured"]
VERDICTS: tuple[Verdict, ...] = ("reproduced", "explained", "contradicted", "measured")
Kind = Literal["cell", "figure", "claim", "equation", "entry"]


@dataclass(frozen=True)
class Cause:
    """A named way in which a printed figure may have come about, computed.

    Attributes:
        name: in words: "pi = 22/7", "target less reached, on the neighbouring row".
        value: what comes out.
        cut: it was printed with further decimals left off, not rounded.
        decimals: of the column, where the figure itself lost zeros at its end.
        arithmetic: how, in one line that a reader can redo by hand.
    """

    name: str
    value: float
    cut: bool = False
    decimals: int | None = None
    arithmetic: str = ""

    def gives(self, figure: Figure) -> bool:
        """Whether this is how `figure` came about."""
        return (figure.cuts if self.cut else figure.rounds)(self.value, self.decimals)


def cut(value: float, decimals: int) -> Cause:
    """The cause that leaves figures a little too near to zero."""
    places = {0: "the point", 1: "one decimal", 2: "two decimals", 3: "three decimals"}
    return Cause(
        f"cut after {places.get(decimals, f'{decimals} decimals')}, not rounded",
        value,
        cut=True,
        decimals=decimals,
    )


def mean_line(values: Iterable[float]) -> str:
    """A mean as a reader takes it: "(3.2 + 5.1 - 4) / 3 = 4.3 / 3 = 1.4333"."""
    terms = [float(value) for value in values]
    written = " ".join(f"{'-' if v < 0 else '+'} {abs(v):g}" for v in terms).removeprefix("+ ")
    total = round(sum(terms), 9)
    return f"({written}) / {len(terms)} = {total:g} / {len(terms)} = {round(total / len(terms), 4):g}"


@dataclass(frozen=True)
class Finding:
    """One printed thing, recomputed.

    Attributes:
        paper: its name.
        where: the place: "Table 4 row 2 theta2", "equation (5)", "abstract, average on z".
        kind: "cell" of a table, "figure" in the text, "claim" in words, numbered "equation", "entry" of a matrix.
        printed: the figure as it is printed, the equation's text, the claim in our words.
        recomputed: what the paper's own inputs give; the corrected equation; None where it is measured, and
            where there is no such number, as for a share of nothing.
        unit: of both.
        verdict: one of `VERDICTS`.
        cause: why, in words.
        arithmetic: the computation in one line that a reader can redo by hand.
        explained_by: the cause that gives the printed figure, where there is one.
        damaged: the scan did it; not counted against the paper.
        decimals: of the column, where the figure lost zeros at its end.
        table, row, column: of a cell; a figure that the text quotes from a table names the table alone.
    """

    paper: str
    where: str
    kind: Kind
    printed: Figure | str
    recomputed: float | str | None
    unit: str
    verdict: Verdict
    cause: str
    arithmetic: str
    explained_by: Cause | None = None
    damaged: bool = False
    decimals: int | None = None
    table: str = ""
    row: str = ""
    column: str = ""

    @property
    def printed_text(self) -> str:
        """The print as it stands."""
        return self.printed.text if isinstance(self.printed, Figure) else self.printed

    @property
    def recomputed_text(self) -> str:
        """What it should be: as printed where that is it, else with more digits; empty where there is nothing."""
        if self.recomputed is None or isinstance(self.recomputed, str):
            return self.recomputed or ""
        if self.verdict == "reproduced":
            return self.printed_text
        return self._shown(self.recomputed)

    @property
    def explained_text(self) -> str:
        """What the cause gives, where that is another number than `recomputed`."""
        text = "" if self.explained_by is None else self._shown(self.explained_by.value)
        return "" if text == self.recomputed_text else text

    @property
    def reason(self) -> str:
        """The cause, and the scan where it is to blame."""
        return f"{self.cause} (most likely the scan's doing)" if self.damaged else self.cause

    def _shown(self, value: float) -> str:
        """Two digits more than the print has, and three in any case."""
        decimals = 4
        if isinstance(self.printed, Figure):
            decimals = 2 + (self.printed.decimals if self.decimals is None else self.decimals)
        if value:
            decimals = max(decimals, 2 - math.floor(math.log10(abs(value))))
        text = f"{value + 0.0:.{decimals}f}"
        return text.rstrip("0").rstrip(".") if "." in text else text

    def to_json(self) -> dict[str, Any]:
        """As in the contract: `printed` a number where it is one, and `printed_text` as it stands."""
        return {
            "paper": self.paper,
            "where": self.where,
            "printed": self.printed.value if isinstance(self.printed, Figure) else self.printed,
            "recomputed": self.recomputed,
            "unit": self.unit,
            "verdict": self.verdict,
            "cause": self.cause,
            "kind": self.kind,
            "printed_text": self.printed_text,
            "arithmetic": self.arithmetic,
            "explained_value": None if self.explained_by is None else self.explained_by.value,
            "damaged": self.damaged,
            "table": self.table,
        }


@dataclass(frozen=True)
class Judge:
    """Makes findings for one paper.

    Attributes:
        paper: its name.
    """

    paper: str

    def cell(
        self,
        cell: Cell,
        own: float,
        arithmetic: str,
        causes: Iterable[Cause] = (),
        remark: str = "",
        decimals: int | None = None,
    ) -> Finding:
        """A cell of a table, against `own`: what the paper's own inputs give.

        Args:
            causes: tried in turn where `own` does not give the printed figure.
            remark: what a reader must know besides.
            decimals: of the column, where this figure lost zeros at its end.
        """
        place = (cell.table, cell.row, cell.column)
        return self._judge(
            cell.where, "cell", cell.figure, own, cell.unit, arithmetic, causes, remark, decimals, place
        )

    def figure(
        self,
        where: str,
        printed: str,
        own: float,
        unit: str,
        arithmetic: str,
        causes: Iterable[Cause] = (),
        remark: str = "",
        table: str = "",
        damaged: bool = False,
    ) -> Finding:
        """A figure that stands in the text, in the abstract, in a conclusion; `table` is the one it quotes."""
        figure = Figure(printed, damaged)
        return self._judge(
            where, "figure", figure, own, unit, arithmetic, causes, remark, None, (table, "", "")
        )

    def claim(
        self,
        where: str,
        claim: str,
        found: str,
        holds: bool,
        arithmetic: str,
        remark: str = "",
        table: str = "",
        reading: tuple[str, bool] | None = None,
    ) -> Finding:
        """What the text says in words of its figures, against what they show.

        Args:
            holds: whether `found` bears `claim` out.
            reading: another sense of the words, and whether the claim holds in it.
        """
        verdict: Verdict = "reproduced" if holds else "contradicted"
        if not holds and reading and reading[1]:
            verdict, remark = "explained", "; ".join(filter(None, (reading[0], remark)))
        return Finding(self.paper, where, "claim", claim, found, "", verdict, remark, arithmetic, table=table)

    def measured(self, cell: Cell, cause: str) -> Finding:
        """A cell that the authors measured or chose: there is nothing to compute it from."""
        return Finding(
            self.paper, cell.where, "cell", cell.figure, None, cell.unit, "measured", cause, "",
            damaged=cell.figure.damaged, table=cell.table, row=cell.row, column=cell.column,
        )  # fmt: skip

    def averages(self, table: PrintedTable, remarks: Mapping[str, str] | None = None) -> Iterator[Finding]:
        """The row "average" of a table, each against the column above it.

        Args:
            remarks: what a reader must know besides, by column.
        """
        for name, cell in table.rows["average"].items():
            column = table.column(name)
            mean = float(column.mean())
            yield self.cell(
                cell,
                mean,
                mean_line(column),
                [cut(mean, cell.figure.decimals)],
                (remarks or {}).get(name, ""),
            )

    def _judge(
        self,
        where: str,
        kind: Kind,
        figure: Figure,
        own: float,
        unit: str,
        arithmetic: str,
        causes: Iterable[Cause],
        remark: str,
        decimals: int | None,
        place: tuple[str, str, str],
    ) -> Finding:
        verdict: Verdict = "contradicted"
        found: Cause | None = None
        said = remark
        tried = list(causes)
        if figure.rounds(own, decimals):
            verdict = "reproduced"
        elif found := next((cause for cause in tried if cause.gives(figure)), None):
            verdict, said = "explained", "; ".join(filter(None, (found.name, remark)))
            arithmetic = "; ".join(filter(None, (arithmetic, found.arithmetic)))
        elif tried:
            names = ", ".join(f"{cause.name} ({cause.value:.6g})" for cause in tried)
            arithmetic = f"{arithmetic}; tried in vain: {names}"
        return Finding(
            self.paper, where, kind, figure, plain(own), unit, verdict, said, arithmetic, found, figure.damaged,
            decimals, *place,
        )  # fmt: skip


def plain(value: float) -> float | None:
    """A number without the dust that doubles gather, which no print would show; None where there is none."""
    return round(float(value), 12) + 0.0 if math.isfinite(value) else None
