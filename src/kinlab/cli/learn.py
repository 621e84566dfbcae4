"""`kinlab learn`: the course. Without a lesson, the list; with one, the lesson."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from kinlab.cli import learn_class
from kinlab.cli.command import JsonOption, NumericCommand, command_app, print_json
from kinlab.cli.learn_options import (
    ExerciseArgument,
    LangOption,
    LessonArgument,
    LessonGroup,
    LessonsOption,
    ProfileOption,
    course_of,
    progress_of,
    sitting_of,
)
from kinlab.errors import UsageError

app = command_app()


@app.callback(
    cls=LessonGroup,
    invoke_without_command=True,
    epilog="Example: kinlab learn leg-geometry --lang id",
    subcommand_metavar="[LESSON | COMMAND] [ARGS]...",
)
def _learn(
    ctx: typer.Context,
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Lessons: text, live figures, and exercises that are checked.

    Without a lesson, the list of them. With one, the lesson: it asks, you
    answer, and what you have done is kept. Every student gets numbers of
    their own; a teacher reproduces them by the name of the profile.
    """
    ctx.obj = (lang, profile, lessons)
    if json and ctx.invoked_subcommand:
        raise UsageError("--json goes behind the lesson or the command: kinlab learn leg-geometry --json")
    if ctx.invoked_subcommand is None:
        _list(ctx, None, None, None, json)


@app.command("list", cls=NumericCommand, epilog="Example: kinlab learn list --profile ani")
def _list(
    ctx: typer.Context,
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """The lessons, and how far you are."""
    from kinlab.cli import learn_tables

    course, speaks = course_of(ctx, lang, lessons)
    progress = progress_of(ctx, profile, speaks)
    if json:
        print_json(learn_tables.list_json(course, progress, speaks))
    else:
        learn_tables.show_list(course, progress, speaks)


@app.command("start", cls=NumericCommand, epilog="Example: kinlab learn leg-geometry --watch answers.txt")
def _start(
    ctx: typer.Context,
    lesson: LessonArgument,
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    watch: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Answers from this file, checked whenever it is saved."),
    ] = None,
    figures: Annotated[
        bool, typer.Option("--figures/--no-figures", help="Draw figures, or describe them in words.")
    ] = True,
    ascii_only: Annotated[
        bool, typer.Option("--ascii", help="Figures of plain characters, as with KINLAB_ASCII=1.")
    ] = False,
    json: JsonOption = False,
) -> None:
    """Take a lesson. LESSON alone means the same.

    Answer when you are asked, or type hint, solution, skip, what WORD, quit
    (petunjuk, solusi, lewati, apa KATA, keluar). Numbers may have a decimal comma, and
    units.
    """
    from kinlab.cli import learn_tables

    if json and watch:
        raise UsageError("--json shows the lesson once, --watch takes it: give one of the two")
    sitting, course = sitting_of(ctx, lesson, lang, profile, lessons)
    if json:
        print_json(learn_tables.lesson_json(sitting, ascii_only=ascii_only))
    elif watch:
        from kinlab.cli.learn_watch import watch_file

        watch_file(sitting, watch)
    else:
        from kinlab.canvas import without_braille
        from kinlab.cli.learn_session import Session

        Session(sitting, course, figures=figures, ascii_only=ascii_only or without_braille()).run()


@app.command("check", cls=NumericCommand, epilog="Example: kinlab learn check leg-geometry foot 75,3 -63 -28")
def _check(
    ctx: typer.Context,
    lesson: LessonArgument,
    exercise: ExerciseArgument,
    answer: Annotated[
        list[str], typer.Argument(metavar="ANSWER...", help="As you would type it.", show_default=False)
    ],
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Check one answer, and keep it. Exit code 1 where it is not right."""
    sitting, _ = sitting_of(ctx, lesson, lang, profile, lessons)
    name = sitting.lesson.exercise(exercise).id
    verdict = sitting.check(name, " ".join(answer))
    now = sitting.standing(name)
    if json:
        print_json(
            {"lesson": sitting.lesson.id, "exercise": name, "ok": verdict.ok, "code": verdict.code}
            | {"message": verdict.message, "counts": verdict.counts, "status": now.status, "tries": now.tries}
        )
    else:
        _print(verdict.message)
    if not verdict.ok:
        raise typer.Exit(1)


@app.command("hint", cls=NumericCommand, epilog="Example: kinlab learn hint leg-geometry foot")
def _hint(
    ctx: typer.Context,
    lesson: LessonArgument,
    exercise: ExerciseArgument,
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """The next hint for an exercise. When none is left, all of them again."""
    sitting, _ = sitting_of(ctx, lesson, lang, profile, lessons)
    name = sitting.lesson.exercise(exercise).id
    following = sitting.hint(name)
    found = [following] if following else sitting.hints(name)
    if json:
        print_json({"hints": [{"number": h.number, "count": h.count, "text": h.text} for h in found]})
        return
    if following is None:
        _print(sitting.say("talk.no-more-hints"))
    for each in found:
        _print(sitting.say("talk.hint", number=each.number, count=each.count, text=each.text))


@app.command("solution", cls=NumericCommand, epilog="Example: kinlab learn solution leg-geometry foot")
def _solution(
    ctx: typer.Context,
    lesson: LessonArgument,
    exercise: ExerciseArgument,
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """The solution, after three tries. The exercise then counts as shown."""
    from kinlab.errors import KinlabError
    from kinlab.lessons.progress import TRIES_BEFORE_SOLUTION

    sitting, _ = sitting_of(ctx, lesson, lang, profile, lessons)
    name = sitting.lesson.exercise(exercise).id
    text = sitting.solution(name)
    if text is None:
        made = sitting.standing(name).tries
        raise KinlabError(sitting.say("talk.no-solution", tries=TRIES_BEFORE_SOLUTION, made=made))
    if json:
        print_json({"lesson": sitting.lesson.id, "exercise": name, "solution": text})
    else:
        _print(text)


@app.command("reset", cls=NumericCommand, epilog="Example: kinlab learn reset leg-geometry")
def _reset(
    ctx: typer.Context,
    lesson: LessonArgument,
    lang: LangOption = None,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="Without asking.")] = False,
    json: JsonOption = False,
) -> None:
    """Begin a lesson anew, with the same numbers. The history stays in the file."""
    sitting, _ = sitting_of(ctx, lesson, lang, profile, lessons)
    name = sitting.lesson.id
    if not yes:
        if json or not (sys.stdin and sys.stdin.isatty()):
            raise UsageError("a lesson is reset after asking; with --json or without a terminal, say --yes")
        done = len(sitting.tasks) - len(sitting.open)
        try:
            reply = input(sitting.say("talk.reset-ask", lesson=name, count=done))
        except EOFError:
            reply = ""
        if reply.strip().casefold() not in ("y", "yes", "ya"):
            typer.echo(sitting.say("talk.unchanged"))
            raise typer.Exit(1)
    sitting.reset()
    if json:
        print_json({"lesson": name, "open": sitting.open})
    else:
        typer.echo(sitting.say("talk.reset-done", lesson=name))


for _name, _command, _example in (
    ("export", learn_class.export, "Example: kinlab learn export --profile ani --output ani.json"),
    ("verify", learn_class.verify, "Example: kinlab learn verify class/*.json"),
    ("lint", learn_class.lint, "Example: kinlab learn lint --lessons my-lessons"),
    ("new", learn_class.new, "Example: kinlab learn new my-lesson --lessons my-lessons"),
):
    app.command(_name, cls=NumericCommand, epilog=_example)(_command)


def _print(markdown: str) -> None:
    from kinlab.cli.learn_prose import lines
    from kinlab.cli.printing import print_lines

    print_lines(lines(markdown))
