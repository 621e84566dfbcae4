"""`kinlab papers`: what the papers print, recomputed."""

from pathlib import Path
from typing import Annotated

import typer

from kinlab.cli.command import JsonOption, NumericCommand, command_app, print_json

app = command_app()


def complete_paper(incomplete: str) -> list[str]:
    """Papers' names for the shell."""
    from kinlab.papers.recompute import PAPERS

    return [name for name in PAPERS if name.startswith(incomplete)]


def complete_verdict(incomplete: str) -> list[str]:
    """Verdicts for the shell."""
    from kinlab.papers.recompute import VERDICTS

    return [verdict for verdict in VERDICTS if verdict.startswith(incomplete)]


@app.command(
    cls=NumericCommand,
    epilog="Example: kinlab papers; kinlab papers xl430 --table 4; kinlab papers --only contradicted; "
    "kinlab papers --html papers.html",
)
def papers(
    name: Annotated[
        str | None,
        typer.Argument(help="Show this paper.", show_default=False, autocompletion=complete_paper),
    ] = None,
    table: Annotated[
        str | None, typer.Option("--table", "-t", metavar="N", help="One table of the paper, cell by cell.")
    ] = None,
    only: Annotated[
        str | None,
        typer.Option(
            "--only",
            metavar="VERDICT",
            help="reproduced, explained, contradicted or measured.",
            autocompletion=complete_verdict,
        ),
    ] = None,
    html: Annotated[
        Path | None,
        typer.Option(
            "--html",
            metavar="FILE",
            help="Write a page: each table as printed and as recomputed, side by side.",
        ),
    ] = None,
    json: JsonOption = False,
) -> None:
    """Recompute every number that the papers print; without a name, count the verdicts.

    A figure is reproduced where the paper's own inputs give it, explained
    where a named cause does, contradicted where nothing does that we tried,
    and measured where there is nothing to compute it from.
    """
    from kinlab.errors import UsageError
    from kinlab.papers.recompute import PAPERS, paper_of, recompute, to_json, verdict_of

    if table is not None and name is None:
        raise UsageError(
            f"--table is a table of one paper: name it, as in kinlab papers {PAPERS[0]} --table {table}"
        )
    if html is not None and (json or table is not None or only is not None):
        raise UsageError("--html writes whole papers: leave out --json, --table and --only")
    verdict = None if only is None else verdict_of(only)
    if html is not None:
        from kinlab.files import check_writable

        check_writable(html)
    names = PAPERS if name is None else (paper_of(name).name,)
    if table is not None:
        table = paper_of(names[0]).table(table).number
    reports = recompute(names)
    if html is not None:
        from kinlab.cli.papers_page import page
        from kinlab.files import write_whole

        write_whole(html, page(reports))
        typer.echo(f"wrote {html}", err=True)
    elif json:
        print_json(to_json(reports, table, verdict))
    elif name is None and verdict is None:
        from kinlab.cli.papers_tables import show_summary

        show_summary(reports)
    else:
        from kinlab.cli.papers_tables import show_findings

        for report in reports:
            show_findings(report, table, verdict)
