"""`kinlab learn export|verify|lint|new`: what lecturers and authors do with lessons."""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from kinlab.cli.command import JsonOption, print_json
from kinlab.cli.learn_options import LessonsOption, ProfileOption, course_of, progress_of
from kinlab.errors import FileError, UsageError
from kinlab.names import suggestion


def export(
    ctx: typer.Context,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    csv: Annotated[bool, typer.Option("--csv", help="Rows for a spreadsheet, in the place of JSON.")] = False,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="FILE", help="Default: standard output.")
    ] = None,
    json: JsonOption = False,
) -> None:
    """Your work as a file for the lecturer. It holds every answer, and the seed that decides your numbers."""
    import json as format_json

    from kinlab.files import write_whole
    from kinlab.lessons.export import to_csv, to_json

    if csv and json:
        raise UsageError("--csv and --json are two formats: give one")
    course, speaks = course_of(ctx, None, lessons)
    progress = progress_of(ctx, profile, speaks)
    if not progress.seed:
        raise UsageError(
            f"the profile '{progress.profile}' has not begun any lesson{_others(progress.profile)}"
        )
    text = (
        to_csv(progress)
        if csv
        else format_json.dumps(to_json(progress, course), indent=2, ensure_ascii=False)
    )
    if output:
        write_whole(output, text if csv else text + "\n")
        typer.echo(f"{output}: {len(progress.events)} event(s) of {progress.profile}", err=True)
    else:
        typer.echo(text, nl=not csv)


def _others(profile: str) -> str:
    from kinlab.lessons.progress import profiles

    return suggestion(profile, profiles())


def verify(
    ctx: typer.Context,
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="What students exported.", show_default=False)
    ],
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Judge students' answers again, and sum up the class.

    Exit code 1 where something is forged, or a file among others cannot be read.
    """
    from kinlab.cli import learn_tables
    from kinlab.lessons.export import Handed, read_handed
    from kinlab.lessons.verify import verify as recompute

    course, _ = course_of(ctx, None, lessons)
    handed: list[Handed] = []
    unread: list[str] = []
    for file in files:
        try:
            handed += read_handed(file)
        except FileError as error:
            unread.append(str(error))
    if not handed:
        raise FileError("\nkinlab: ".join(unread))
    with _telling() as tell:
        results = recompute(handed, course, tell)
    if json:
        print_json(
            {"ok": not unread and not any(r.forged for r in results), "unread": unread}
            | {"students": [r.to_json(course) for r in results]}
        )
    else:
        learn_tables.show_class(course, results)
    for message in unread:
        typer.echo(f"kinlab: {message}", err=True)
    if unread or any(result.forged for result in results):
        raise typer.Exit(1)


def lint(
    ctx: typer.Context,
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[LESSON...]", help="Only these. Default: all.")
    ] = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Find what is wrong with lessons. Texts, references, terms, and every exercise over many seeds."""
    from kinlab.lessons.lint import lint as find

    course, _ = course_of(ctx, None, lessons)
    wanted = [course.lesson(name).id for name in names or ()]
    with _telling() as tell:
        findings = find(course, wanted or None, tell)
    if json:
        print_json({"ok": not findings, "findings": [finding.to_json() for finding in findings]})
    else:
        for finding in findings:
            typer.echo(str(finding))
        looked = wanted or list(course.lessons)
        exercises = sum(len(course.lessons[name].exercises) for name in looked)
        typer.echo(
            f"{len(looked)} lesson(s), {exercises} exercise(s): {len(findings) or 'no'} finding(s)",
            err=bool(findings),
        )
    if findings:
        raise typer.Exit(1)


@contextmanager
def _telling() -> Iterator[Callable[[str], None]]:
    """A function that says what is looked at just now, on a line of its own that is gone in the end."""
    if not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield lambda name: None
        return

    def tell(name: str) -> None:
        sys.stderr.write(f"\r\x1b[K{name} ...")
        sys.stderr.flush()

    try:
        yield tell
    finally:
        sys.stderr.write("\r\x1b[K")


def new(
    ctx: typer.Context,
    name: Annotated[str, typer.Argument(metavar="NAME", help="Of the lesson: small letters and hyphens.")],
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Make a lesson from a template, in both languages."""
    from kinlab.lessons.course import own_lessons
    from kinlab.lessons.template import new_lesson

    if name in ctx.parent.command.list_commands(ctx.parent):  # type: ignore[union-attr]
        raise UsageError(f"'{name}' is a command of kinlab learn: a lesson needs another name")
    folder = lessons or ctx.obj[2] or own_lessons() or Path("my-lessons")
    made = new_lesson(name, folder)
    if json:
        print_json({"files": [str(path) for path in made]})
        return
    for path in made:
        typer.echo(str(path))
    typer.echo(f"See it:   kinlab learn {name} --lessons {folder}")
    typer.echo(f"Check it: kinlab learn lint {name} --lessons {folder}")
