"""What the commands of `kinlab learn` share: options, and the course, progress and sitting that they name."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from kinlab.cli.command import converted_plainly
from kinlab.language import language, words_of

if TYPE_CHECKING:
    from kinlab.lessons import Course, Progress, Sitting


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
    Path | None,
    typer.Option(
        "--lessons",
        metavar="DIR",
        help="A folder with lessons of your own besides. Default: $KINLAB_LESSONS.",
    ),
]


def course_of(ctx: typer.Context, lang: str | None, lessons: Path | None) -> "tuple[Course, str]":
    """The lessons, and the language that the student reads."""
    from kinlab.lessons import load_course

    return load_course(lessons or ctx.obj[2]), language(lang or ctx.obj[0])


def progress_of(ctx: typer.Context, profile: str | None, speaks: str) -> "Progress":
    """The student's progress; a file that was damaged is named."""
    from kinlab.lessons import Progress
    from kinlab.lessons.progress import PROFILE

    named = profile if profile is not None else ctx.obj[1]
    found = Progress(PROFILE if named is None else named)
    if found.set_aside:
        message = words_of("kinlab.lessons").say(
            speaks, "talk.set-aside", path=found.path, aside=found.set_aside.name, count=len(found.events)
        )
        typer.echo(f"kinlab: {message}", err=True)
    return found


def sitting_of(
    ctx: typer.Context, lesson: str, lang: str | None, profile: str | None, lessons: Path | None
) -> "tuple[Sitting, Course]":
    """The student at a lesson."""
    from kinlab.lessons import Sitting

    course, speaks = course_of(ctx, lang, lessons)
    which = course.lesson(lesson)
    return Sitting(which, progress_of(ctx, profile, speaks), speaks), course
