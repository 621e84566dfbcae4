"""What `kinlab papers` prints for people."""

from collections import Counter
from collections.abc import Iterator
from itertools import accumulate, groupby

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from kinlab.cli.show import console, sentences, show, table
from kinlab.papers.recompute import VERDICTS, Finding, Report, Verdict
from kinlab.papers.tables import PrintedTable

STYLES = {"reproduced": "green", "explained": "yellow", "contradicted": "bold red", "measured": "dim"}
MARKS = {"reproduced": "✓", "explained": "≈", "contradicted": "✗", "measured": "·"}
PLAIN_MARKS = {"reproduced": "=", "explained": "~", "contradicted": "x", "measured": "."}
# Columns that the summary takes with the verdicts' names above its counts; in fewer it has their marks.
WIDE = 80
MEANINGS = {
    "reproduced": "the paper's own inputs give the printed figure, at its printed precision",
    "explained": "they do not, and a named cause, itself computed, does",
    "contradicted": "they do not, and nothing that was tried does",
    "measured": "measured or chosen by the authors: there is nothing to compute it from",
}


def show_summary(reports: list[Report]) -> None:
    """Every paper in a line, and what the verdicts mean."""
    wide = console().width >= WIDE
    heads = VERDICTS if wide else [_mark(verdict).plain for verdict in VERDICTS]
    found = table("", "paper", *((head, "") for head in heads), ("scan", ""), ("checked", ""))
    found.padding = (0, 2 if wide else 1, 0, 0)
    # Where there is little room a name may fold, and no count loses a digit.
    found.columns[0].no_wrap = False
    for report in reports:
        coverage = report.coverage.to_json()
        counts = [Text(str(report.count(verdict)), style=STYLES[verdict]) for verdict in VERDICTS]
        share = f"{100 * coverage['recomputed'] / coverage['cells']:.0f} %"
        found.add_row(report.paper.name, *counts, str(report.damaged or ""), share)
    show(found, "")
    legend = [(_mark(verdict), f"{verdict}: {MEANINGS[verdict]}") for verdict in VERDICTS]
    whole = (
        sum(report.coverage.cells for report in reports),
        sum(report.coverage.equations for report in reports),
    )
    show(
        sentences(
            *legend,
            ("", "scan: the scan at hand is damaged there; not counted against the paper"),
            ("", f"checked: of the {whole[0]} figures in tables and the {whole[1]} numbered equations"),
        ),
        "",
        "All of one paper: kinlab papers NAME",
        "What does not follow: kinlab papers --only contradicted",
    )


def show_findings(report: Report, number: str | None, only: Verdict | None) -> None:
    """The findings of a paper, or those of a table or of a verdict, in the order of the print.

    Measured figures of a table stand in one line for each reason, and the entries of a matrix that agree in that of
    its equation.
    """
    findings = [f for f in report.select(number, only) if f.kind != "entry" or f.verdict != "reproduced"]
    if not findings and number is None:
        return
    show(Text(report.paper.name, style="bold").append(f"   {report.paper.title}", style="not bold"), "")
    if number is not None:
        show(*_grid(report, report.paper.table(number)))
    for verdict, group in groupby(_in_blocks(findings), lambda finding: finding.verdict):
        if verdict == "reproduced":
            show(_followed(list(group)), "")
        elif verdict == "measured":
            for (place, cause), count in Counter((f"Table {f.table}", f.cause) for f in group).items():
                what = "one figure" if count == 1 else f"{count} figures"
                show(_mark("measured").append(f" {place}, {what}: {cause}", style="not dim"))
            show("")
        else:
            for finding in group:
                show(*_differs(finding), "")
    if not findings:
        show(f"no finding of it is {only}" if only else "no figure stands in it")


def _in_blocks(findings: list[Finding]) -> Iterator[Finding]:
    """In the order of the print, but within a table first what is measured, then what follows, then the rest."""
    order = ("measured", "reproduced", "explained", "contradicted")
    for number, block in groupby(findings, lambda f: f.table if f.kind == "cell" else None):
        alike = list(block)
        yield from alike if number is None else sorted(alike, key=lambda f: order.index(f.verdict))


def _utf() -> bool:
    return console().encoding.lower().startswith("utf")


def _mark(verdict: Verdict) -> Text:
    return Text((MARKS if _utf() else PLAIN_MARKS)[verdict], style=STYLES[verdict])


def _followed(findings: list[Finding]) -> Table:
    """What is reproduced, a line each: place and print, and how it comes about."""
    found = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=False)
    found.add_column(overflow="fold", max_width=max(30, console().width // 2))
    found.add_column(overflow="fold", style="dim")
    for finding in findings:
        head = _mark("reproduced").append(
            f" {finding.where}: {_with_unit(finding.printed_text, finding)}", "default"
        )
        found.add_row(head, "; ".join(filter(None, (finding.arithmetic, finding.cause))))
    return found


def _differs(finding: Finding) -> list[RenderableType]:
    """What the print says, what is true, how, and why."""
    own = _with_unit(finding.recomputed_text, finding) if finding.recomputed_text else "no such figure"
    head = _mark(finding.verdict).append(f" {finding.where}", style="not bold default")
    lines = [
        ("printed", _with_unit(finding.printed_text, finding)),
        ("corrected" if finding.kind == "equation" else "recomputed", own),
        ("explained", finding.explained_text),
        ("how", finding.arithmetic),
        ("why", finding.reason),
    ]
    return [head, Padding(sentences(*(line for line in lines if line[1])), (0, 0, 0, 2), expand=False)]


def _with_unit(text: str, finding: Finding) -> str:
    numeric = finding.kind in ("cell", "figure")
    return f"{text} {finding.unit}" if numeric and finding.unit else text


def _grid(report: Report, printed: PrintedTable) -> list[RenderableType]:
    """A table as printed, beside each figure that does not follow what it should be; in parts, where it is wide."""
    cells = report.cells(printed)
    columns = {
        name: [_figure(cells.get((row, name)), unit) for row in printed.rows]
        for name, unit in printed.units.items()
    }
    parts: list[RenderableType] = []
    title = f"Table {printed.number}: {printed.title}"
    names = list(columns)
    while names:
        # What fits beside the names of the rows, and one column in any case.
        room = console().width - max(map(len, printed.rows))
        widths = [3 + max(len(name), *(len(text) for text in columns[name])) for name in names]
        count = max(1, sum(total <= room for total in accumulate(widths)))
        part = table(title, "", *((name, printed.units[name]) for name in names[:count]))
        for k, row in enumerate(printed.rows):
            part.add_row(row, *(columns[name][k] for name in names[:count]))
        parts += [part, ""]
        names, title = names[count:], ""
    return parts


def _figure(finding: Finding | None, unit: str) -> Text:
    """A cell: the print, its unit where that is not its column's, what it should be, and the mark."""
    text = Text()
    if finding is None:
        return text
    text.append(finding.printed_text + ("" if finding.unit == unit else f" {finding.unit}"))
    if finding.verdict in ("explained", "contradicted"):
        arrow = "→" if _utf() else "->"
        text.append(f" {arrow} {finding.recomputed_text or 'none'}", style=STYLES[finding.verdict])
    return text.append(" ").append(_mark(finding.verdict))
