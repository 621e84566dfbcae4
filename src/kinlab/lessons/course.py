"""The course: KinLab's own lessons, and those of a folder that a teacher names."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from kinlab.errors import FileError
from kinlab.language import LANGUAGES
from kinlab.lessons.lesson import Lesson, LessonError, Place
from kinlab.lessons.progress import Progress
from kinlab.lessons.reading import read_lesson, read_text, read_toml
from kinlab.names import resolve
from kinlab.shipped import shipped

GLOSSARY = "glossary.toml"
VARIABLE = "KINLAB_LESSONS"


@dataclass(frozen=True)
class Term:
    """A word of the field.

    Attributes:
        name: as the lessons write it.
        meanings: in a sentence, by language.
        forms: other forms of it in a text, such as the plural.
    """

    name: str
    meanings: Mapping[str, str]
    forms: tuple[str, ...] = ()

    def meaning(self, language: str) -> str:
        """In that language, else in English."""
        return self.meanings.get(language, self.meanings["en"])


@dataclass(frozen=True)
class Course:
    """Lessons that can be taken, and what is wrong with the others.

    Attributes:
        lessons: by id, in the order of the course.
        problems: of files that could not be read, each with its name and line.
        glossary: by name.
    """

    lessons: Mapping[str, Lesson]
    problems: tuple[LessonError, ...]
    glossary: Mapping[str, Term]

    def lesson(self, name: str) -> Lesson:
        """The lesson that `name` means: exact, a unique beginning, or its number in the course.

        Raises:
            UsageError: no such lesson.
        """
        if name not in self.lessons and name.isdecimal() and 1 <= int(name) <= len(self.lessons):
            return list(self.lessons.values())[int(name) - 1]
        broken = next((p for p in self.problems if str(p).startswith((f"{name}/", f"{name}:"))), None)
        if broken is not None and name not in self.lessons:
            raise broken
        return self.lessons[resolve(name, self.lessons, "lesson")]

    def term(self, word: str) -> Term | None:
        """The term of the glossary that a word is a form of, if there is one."""
        folded = word.casefold()
        every = self.glossary.values()
        return next((t for t in every if folded in (f.casefold() for f in (t.name, *t.forms))), None)

    def next_for(self, progress: Progress, after: str = "") -> Lesson | None:
        """The first lesson that a student has not finished, behind `after` where there is one; None where all are."""
        every = list(self.lessons.values())
        at = next((i for i, lesson in enumerate(every, 1) if lesson.id == after), 0)
        for lesson in [*every[at:], *every[:at]]:
            if not all(
                progress.standing(lesson.id, lesson.version, exercise.id).done
                for exercise in lesson.exercises
            ):
                return lesson
        return None


def load_course(folder: Path | None = None) -> Course:
    """KinLab's lessons and those in `folder` (default `$KINLAB_LESSONS`, if set).

    One of the same name takes the place of ours. A lesson with an error is left out and listed; the others
    still work. Needs no numpy.

    Raises:
        FileError: the folder cannot be read, or holds no lessons.
    """
    folder = folder or own_lessons()
    lessons: dict[str, Lesson] = {}
    problems: list[LessonError] = []
    glossary: dict[str, Term] = {}
    for root in [shipped("lessons"), *([folder] if folder else [])]:
        glossary |= read_glossary(root / GLOSSARY, problems)
        for each in lesson_folders(root):
            lessons.pop(each.name, None)
            try:
                lessons[each.name] = read_lesson(each)
            except LessonError as error:
                problems.append(error)
    ordered = sorted(lessons.values(), key=lambda lesson: (lesson.order, lesson.id))
    return Course({lesson.id: lesson for lesson in ordered}, tuple(problems), glossary)


def own_lessons() -> Path | None:
    """The folder of lessons of one's own that `$KINLAB_LESSONS` names; None where it names none."""
    named = os.environ.get(VARIABLE)
    return Path(named) if named else None


def lesson_folders(root: Path) -> list[Path]:
    """The lessons in a folder, unread.

    Raises:
        FileError: it cannot be read, or holds none.
    """
    try:
        found = sorted(
            each
            for each in root.iterdir()
            # A link that leads nowhere is a page all the same.
            if each.is_dir() and any(os.path.lexists(each / f"{code}.md") for code in LANGUAGES)
        )
    except OSError as error:
        raise FileError(f"{root}: cannot be read: {error.strerror}") from None
    if not found:
        raise FileError(f"{root}: holds no lessons: folders with a file en.md")
    return found


def read_glossary(path: Path, problems: list[LessonError]) -> dict[str, Term]:
    """The terms of a glossary's file; none where there is no such file."""
    place = Place(path.name, 1)
    if not path.exists():
        return {}
    try:
        tree = read_toml(read_text(path, path.name).split("\n"), Place(path.name, 0))
    except LessonError as error:
        problems.append(error)
        return {}
    found = {}
    for name, entry in tree.items():
        texts = (
            {code: entry[code] for code in LANGUAGES if isinstance(entry.get(code), str)}
            if isinstance(entry, dict)
            else {}
        )
        forms = entry.get("forms", []) if isinstance(entry, dict) else []
        if "en" not in texts or not isinstance(forms, list) or not all(isinstance(f, str) for f in forms):
            problems.append(place.error(f"'{name}' is a table with en, id and forms"))
            continue
        found[name] = Term(name, texts, tuple(forms))
    return found
