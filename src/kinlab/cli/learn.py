"""`kinlab learn`: the course. Without a lesson, the list; with one, the lesson."""

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from kinlab.cli.command import JsonOption, NumericCommand, command_app, converted_plainly, print_json
from kinlab.errors import UsageError
from kinlab.language import language
from kinlab.names import suggestion

if TYPE_CHECKING:
    from kinlab.lessons import Course, Progress, Sitting

# How often a watched file is looked at, s.
GLANCE = 0.3


class LessonGroup(TyperGroup):
    """A group whose first word may also be a lesson."""

    def get_params(self, ctx: Any) -> list[Any]:
        return converted_plainly(super().get_params(ctx))

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if args[0] not in self.commands:
            args = ["start", *args]
        return super().resolve_command(ctx, args)


def complete_lesson(incomplete: str) -> list[str]:
    """Lessons' names for the shell."""
    from kinlab.lessons import load_course

    return [name for name in load_course().lessons if name.startswith(incomplete)]


LessonArgument = Annotated[
    str,
    typer.Argument(
        metavar="LESSON",
        help="Its name, a beginning of it, or its number.",
        show_default=False,
        autocompletion=complete_lesson,
    ),
]
ExerciseArgument = Annotated[
    str, typer.Argument(metavar="EXERCISE", help="Its name, or a beginning of it.", show_default=False)
]
LangOption = Annotated[
    str | None, typer.Option("--lang", help="en or id. Default: $KINLAB_LANG, else as the system speaks.")
]
ProfileOption = Annotated[
    str | None,
    typer.Option("--profile", "-p", metavar="NAME", help="Whose progress; decides the numbers. [student]"),
]
LessonsOption = Annotated[
    Path | None, typer.Option("--lessons", metavar="DIR", help="A folder with lessons of your own besides.")
]

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
    if ctx.invoked_subcommand is None:
        _list(ctx, None, None, None, json)


def _course(ctx: typer.Context, lang: str | None, lessons: Path | None) -> "tuple[Course, str]":
    from kinlab.lessons import load_course

    return load_course(lessons or ctx.obj[2]), language(lang or ctx.obj[0])


def _progress(ctx: typer.Context, profile: str | None, speaks: str) -> "Progress":
    from kinlab.language import words_of
    from kinlab.lessons import Progress
    from kinlab.lessons.progress import PROFILE

    found = Progress(profile or ctx.obj[1] or PROFILE)
    if found.set_aside:
        message = words_of("kinlab.lessons").say(
            speaks, "talk.set-aside", path=found.path, aside=found.set_aside.name, count=len(found.events)
        )
        typer.echo(f"kinlab: {message}", err=True)
    return found


def _sitting(
    ctx: typer.Context, lesson: str, lang: str | None, profile: str | None, lessons: Path | None
) -> "tuple[Sitting, Course]":
    from kinlab.lessons import Sitting

    course, speaks = _course(ctx, lang, lessons)
    which = course.lesson(lesson)
    return Sitting(which, _progress(ctx, profile, speaks), speaks), course


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

    course, speaks = _course(ctx, lang, lessons)
    progress = _progress(ctx, profile, speaks)
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
        bool, typer.Option("--ascii", help="Figures of plain characters, without braille.")
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
    sitting, course = _sitting(ctx, lesson, lang, profile, lessons)
    if json:
        print_json(learn_tables.lesson_json(sitting, ascii_only=ascii_only))
    elif watch:
        _watch(sitting, watch)
    else:
        from kinlab.cli.learn_session import Session

        Session(sitting, course, figures=figures, ascii_only=ascii_only).run()


def _watch(sitting: "Sitting", path: Path) -> None:
    """Check the answers in a file whenever it changes, until all are right."""
    from kinlab.cli.learn_prose import prose
    from kinlab.cli.printing import print_lines
    from kinlab.files import write_whole
    from kinlab.lessons.sheet import blank, read_sheet

    if not path.exists():
        write_whole(path, blank(sitting))
        typer.echo(sitting.say("talk.sheet-made", path=path))
    typer.echo(sitting.say("talk.watching", path=path))
    seen: tuple[int, int] | None = None
    known: dict[str, str] = {}
    while sitting.open:
        state = path.stat()
        if (state.st_mtime_ns, state.st_size) == seen:
            time.sleep(GLANCE)
            continue
        seen = state.st_mtime_ns, state.st_size
        replies = read_sheet(_read(path))
        for name, reply in replies.items():
            if known.get(name) == reply:
                continue
            if name not in sitting.tasks:
                typer.echo(
                    sitting.say(
                        "talk.sheet-unknown", path=path, name=name, near=suggestion(name, sitting.tasks)
                    )
                )
                continue
            if sitting.standing(name).done:
                continue
            verdict = sitting.check(name, reply)
            style = "good" if verdict.ok else "bad" if verdict.counts else "odd"
            print_lines([[(style, text) for _, text in line] for line in prose(f"{name}: {verdict.message}")])
        known = replies
        sys.stdout.flush()
    each = [sitting.standing(name).status for name in sitting.tasks]
    typer.echo(
        sitting.say("talk.finished", solved=each.count("solved"), count=len(each), shown=each.count("shown"))
    )


def _read(path: Path) -> str:
    from kinlab.errors import FileError

    try:
        return path.read_bytes().decode("utf-8", errors="replace")
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}") from None


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
    sitting, _ = _sitting(ctx, lesson, lang, profile, lessons)
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
    """The next hint for an exercise; all of them again when there is none left."""
    sitting, _ = _sitting(ctx, lesson, lang, profile, lessons)
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
    """The solution, after three tries; the exercise then counts as shown."""
    from kinlab.errors import KinlabError
    from kinlab.lessons.progress import TRIES_BEFORE_SOLUTION

    sitting, _ = _sitting(ctx, lesson, lang, profile, lessons)
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
) -> None:
    """Begin a lesson anew, with the same numbers. The history stays in the file."""
    sitting, _ = _sitting(ctx, lesson, lang, profile, lessons)
    name = sitting.lesson.id
    if not yes:
        if not sys.stdin.isatty():
            raise UsageError("a lesson is reset after asking; without a terminal, say --yes")
        done = len(sitting.tasks) - len(sitting.open)
        try:
            reply = input(sitting.say("talk.reset-ask", lesson=name, count=done))
        except EOFError:
            reply = ""
        if reply.strip().casefold() not in ("y", "yes", "ya"):
            typer.echo(sitting.say("talk.unchanged"))
            raise typer.Exit(1)
    sitting.reset()
    typer.echo(sitting.say("talk.reset-done", lesson=name))


@app.command(
    "export", cls=NumericCommand, epilog="Example: kinlab learn export --profile ani --output ani.json"
)
def _export(
    ctx: typer.Context,
    profile: ProfileOption = None,
    lessons: LessonsOption = None,
    csv: Annotated[bool, typer.Option("--csv", help="Rows for a spreadsheet, in the place of JSON.")] = False,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="FILE", help="Default: standard output.")
    ] = None,
    json: JsonOption = False,
) -> None:
    """Your work for the lecturer: every answer, with the seed that decides the numbers."""
    import json as format_json

    from kinlab.files import write_whole
    from kinlab.lessons.export import to_csv, to_json

    if csv and json:
        raise UsageError("--csv and --json are two formats: give one")
    course, speaks = _course(ctx, None, lessons)
    progress = _progress(ctx, profile, speaks)
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


@app.command("verify", cls=NumericCommand, epilog="Example: kinlab learn verify class/*.json")
def _verify(
    ctx: typer.Context,
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="What students exported.", show_default=False)
    ],
    lang: LangOption = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Judge students' answers again, and sum up the class. Exit code 1 where something is forged."""
    from kinlab.cli import learn_tables
    from kinlab.lessons.export import read_handed
    from kinlab.lessons.verify import verify

    course, _ = _course(ctx, lang, lessons)
    handed = [each for file in files for each in read_handed(file)]
    results = verify(handed, course, _tell if sys.stderr.isatty() else lambda profile: None)
    if json:
        print_json(
            {"ok": not any(r.forged for r in results), "students": [r.to_json(course) for r in results]}
        )
    else:
        learn_tables.show_class(course, results)
    if any(result.forged for result in results):
        raise typer.Exit(1)


@app.command("lint", cls=NumericCommand, epilog="Example: kinlab learn lint --lessons my-lessons")
def _lint(
    ctx: typer.Context,
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[LESSON...]", help="Only these. Default: all.")
    ] = None,
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Find what is wrong with lessons: texts, references, terms, and every exercise over many seeds."""
    from kinlab.lessons.lint import lint

    course, _ = _course(ctx, None, lessons)
    wanted = [course.lesson(name).id for name in names or ()]
    findings = lint(course, wanted or None, _tell if sys.stderr.isatty() else lambda lesson: None)
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


def _tell(name: str) -> None:
    """What is looked at just now, on a line that is written over."""
    sys.stderr.write(f"\r\x1b[K{name} ...")
    sys.stderr.flush()


@app.command("new", cls=NumericCommand, epilog="Example: kinlab learn new my-lesson --lessons my-lessons")
def _new(
    ctx: typer.Context,
    name: Annotated[str, typer.Argument(metavar="NAME", help="Of the lesson: small letters and hyphens.")],
    lessons: LessonsOption = None,
    json: JsonOption = False,
) -> None:
    """Make a lesson from a template, in both languages."""
    from kinlab.lessons.template import new_lesson

    folder = lessons or ctx.obj[2] or Path("my-lessons")
    made = new_lesson(name, folder)
    if json:
        print_json({"files": [str(path) for path in made]})
        return
    for path in made:
        typer.echo(str(path))
    typer.echo(f"See it:   kinlab learn {name} --lessons {folder}")
    typer.echo(f"Check it: kinlab learn lint {name} --lessons {folder}")


def _print(markdown: str) -> None:
    from kinlab.cli.learn_prose import prose
    from kinlab.cli.printing import print_lines

    print_lines(prose(markdown))
