"""The page of `kinlab papers --html`: each table as printed and as recomputed, side by side; nothing but itself."""

from collections.abc import Iterable, Iterator
from html import escape
from pathlib import Path

import kinlab
from kinlab.cli.papers_tables import MARKS, MEANINGS
from kinlab.papers.recompute import VERDICTS, Finding, Report
from kinlab.papers.tables import PrintedTable


def page(reports: list[Report]) -> str:
    """A whole document; it asks for nothing from elsewhere."""
    title = reports[0].paper.name if len(reports) == 1 else "The papers"
    style = Path(__file__).with_suffix(".css").read_text(encoding="utf-8")
    parts = [
        "<!doctype html>",
        '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{escape(title)}, recomputed</title>",
        f"<style>\n{style}</style></head><body>",
        f"<h1>{escape(title)}, recomputed</h1>",
        "<p>Every figure in the tables, every numbered equation, and what the text quotes of them, computed again "
        "from the paper's own inputs. Papers are careful work, and so is reading them: each finding stands with the "
        "arithmetic, so that it can be checked in a minute.</p>",
        _legend(),
        _summary(reports),
        *(part for report in reports for part in _paper(report)),
        f'<p class="faint">Made by KinLab {escape(kinlab.__version__)}: kinlab papers --html</p>',
        "</body></html>",
    ]
    return "\n".join(parts) + "\n"


def _legend() -> str:
    rows = (
        f'<dt class="{verdict}"><span class="mark">{MARKS[verdict]}</span> {verdict}</dt>'
        f"<dd>{escape(MEANINGS[verdict])}</dd>"
        for verdict in VERDICTS
    )
    return (
        f'<dl class="legend">{"".join(rows)}</dl><p class="faint">Where the scan at hand is damaged, the finding '
        "says so, and does not count against the paper.</p>"
    )


def _summary(reports: list[Report]) -> str:
    """Every paper in a row, with a bar of its verdicts."""
    heads = "".join(
        f'<th class="{verdict}"><span class="mark">{MARKS[verdict]}</span> <span class="word">{verdict}</span></th>'
        for verdict in VERDICTS
    )
    rows = []
    for report in reports:
        counts = "".join(f'<td><b class="{v}">{report.count(v)}</b></td>' for v in VERDICTS)
        bar = "".join(f'<i class="{v}" style="flex-grow:{report.count(v)}"></i>' for v in VERDICTS)
        coverage = report.coverage.to_json()
        name = escape(report.paper.name)
        rows.append(
            f'<tr><td><a href="#{name}">{name}</a></td>{counts}<td>{coverage["recomputed"]} of {coverage["cells"]}</td>'
            f'<td><div class="bar">{bar}</div></td></tr>'
        )
    return (
        f'<div class="scroll summary"><table><thead><tr><th>paper</th>{heads}<th>checked</th><th></th></tr>'
        f"</thead><tbody>{''.join(rows)}</tbody></table></div>"
    )


def _paper(report: Report) -> Iterator[str]:
    name = report.paper.name
    yield f'<h2 id="{escape(name)}">{escape(name)}</h2><p class="faint">{escape(report.paper.title)}</p>'
    wrong = [f for f in report.findings if f.verdict == "contradicted"]
    if wrong:
        yield f"<h3>What does not follow ({len(wrong)})</h3>{_grouped(wrong)}"
    yield from _verdicts("Figures and claims of the text", ("figure", "claim"), report)
    yield from _verdicts("Equations", ("equation", "entry"), report)
    for table in report.paper.tables:
        yield from _table(report, table)


def _verdicts(title: str, kinds: tuple[str, ...], report: Report) -> Iterator[str]:
    """How many of some kinds of findings hold; those that are explained, and behind them those that hold.

    Entries of a matrix that hold stand for themselves in its equation.
    """
    shown = [f for f in report.findings if f.kind in kinds]
    odd = [f for f in shown if f.verdict == "explained"]
    right = [f for f in shown if f.verdict == "reproduced" and f.kind != "entry"]
    wrong = sum(f.verdict == "contradicted" and f.kind != "entry" for f in shown)
    if not shown:
        return
    told = [f"{len(right)} hold as printed"]
    told += [f"{sum(f.kind != 'entry' for f in odd)} are explained below"] if odd else []
    told += [f"{wrong} stand above"] if wrong else []
    yield f"<h3>{title}</h3><p>{', '.join(told)}.</p>{_grouped(odd) if odd else ''}"
    if right:
        yield f"<details><summary>{len(right)} that hold as printed</summary>{_list(right)}</details>"


def _table(report: Report, table: PrintedTable) -> Iterator[str]:
    """A table twice, and below it why its figures differ."""
    cells = report.cells(table)
    if not cells:
        return
    yield (
        f"<h3>Table {escape(table.number)}: {escape(table.title)}</h3>"
        f'<div class="pair" style="--columns:{len(table.units)}">'
        f"<div><h4>printed</h4>{_grid(table, cells, recomputed=False)}</div>"
        f"<div><h4>recomputed</h4>{_grid(table, cells, recomputed=True)}</div></div>"
    )
    differ = [f for f in cells.values() if f.verdict in ("explained", "contradicted")]
    if differ:
        yield _grouped(differ)
    followed = [f for f in cells.values() if f.verdict == "reproduced"]
    if followed:
        yield f"<details><summary>{len(followed)} figures that follow</summary>{_list(followed)}</details>"


def _grid(table: PrintedTable, cells: dict[tuple[str, str], Finding], recomputed: bool) -> str:
    heads = "".join(
        f"<th>{escape(name)}<small>{escape(unit) or '&nbsp;'}</small></th>"
        for name, unit in table.units.items()
    )
    rows = []
    for row in table.rows:
        line = "".join(_cell(cells.get((row, name)), unit, recomputed) for name, unit in table.units.items())
        rows.append(f"<tr><td>{escape(row)}</td>{line}</tr>")
    head = f"<thead><tr><th></th>{heads}</tr></thead>"
    return f'<div class="scroll"><table>{head}<tbody>{"".join(rows)}</tbody></table></div>'


def _cell(finding: Finding | None, unit: str, recomputed: bool) -> str:
    """A figure; where its unit is not its column's, with it; where a cause explains it, with what that gives."""
    if finding is None:
        return "<td></td>"
    own_unit = "" if finding.unit == unit else f" {finding.unit}"
    if not recomputed:
        return f"<td>{escape(finding.printed_text + own_unit)}</td>"
    own = finding.printed_text if finding.verdict == "measured" else finding.recomputed_text
    text = own + own_unit if own else "none"
    tip = "; ".join(filter(None, (finding.verdict, finding.arithmetic, finding.cause)))
    mark = f'<span class="mark">{MARKS[finding.verdict]}</span>'
    because = f"<small>{escape(finding.explained_text)}{mark}</small>" if finding.explained_text else mark
    return f'<td class="{finding.verdict}" title="{escape(tip)}">{escape(text)}{because}</td>'


def _grouped(findings: list[Finding]) -> str:
    """Cells that differ for one reason stand together: the first with its arithmetic, the rest behind it."""
    groups: dict[tuple[str, str], list[Finding]] = {}
    for finding in sorted(findings, key=lambda f: f.verdict):  # contradicted before explained
        alone = "" if finding.cause else finding.where
        groups.setdefault((finding.verdict, finding.cause or alone), []).append(finding)
    items = []
    for first, *rest in groups.values():
        more = f"<details><summary>{len(rest)} more for the same reason</summary>{_list(rest)}</details>"
        items.append(_item(first, more if rest else ""))
    return f'<ul class="findings">{"".join(items)}</ul>'


def _list(findings: Iterable[Finding]) -> str:
    return f'<ul class="findings">{"".join(_item(finding) for finding in findings)}</ul>'


def _item(finding: Finding, more: str = "") -> str:
    """A finding: the place, both figures, the arithmetic, the reason."""
    verdict = finding.verdict
    formula = ' class="formula"' if finding.kind in ("equation", "entry") else ""
    unit = f" {finding.unit}" if finding.unit and not formula and finding.kind != "claim" else ""
    head = f'<p><span class="mark">{MARKS[verdict]}</span> <b>{escape(finding.where)}</b>'
    said = f"<span{formula}>{escape(finding.printed_text + unit)}</span>"
    if verdict in ("explained", "contradicted"):
        own = escape(finding.recomputed_text + unit) if finding.recomputed_text else "no such figure"
        word = "corrected" if finding.kind == "equation" else "recomputed"
        said = f"printed {said}, {word} <b{formula}>{own}</b>"
    lines = [f"{head}: {said}</p>"]
    if finding.arithmetic:
        lines.append(f'<p class="how">{escape(finding.arithmetic)}</p>')
    if finding.cause:
        lines.append(f'<p class="faint">{escape(finding.reason)}</p>')
    return f'<li class="{verdict}">{"".join(lines)}{more}</li>'
