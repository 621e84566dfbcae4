"""A student's work as a file for the lecturer: every reply, and the seed that decides the numbers."""

import csv
import io
import json
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from kinlab.errors import FileError
from kinlab.lessons.course import Course
from kinlab.lessons.progress import FORMAT, Event, Progress

COLUMNS = ("profile", "seed", *Event.__dataclass_fields__)
_LARGEST = 50_000_000
# What a spreadsheet would take for a formula.
_FORMULA = ("=", "@", "\t", "+", "-", "'")


@dataclass(frozen=True)
class Handed:
    """What a student handed in.

    Attributes:
        file: its name, for messages.
        profile, seed: of the student.
        events: all of them.
        claimed: by (lesson, version, exercise), the status, tries and hints that the file itself claims;
            empty for CSV.
        problems: what could not be read.
    """

    file: str
    profile: str
    seed: str
    events: tuple[Event, ...]
    claimed: dict[tuple[str, str, str], dict[str, Any]]
    problems: tuple[str, ...] = ()


def to_json(progress: Progress, course: Course) -> dict[str, Any]:
    """The document of `kinlab learn export`: events, and how the student stands by them."""
    return {
        "format": FORMAT,
        "profile": progress.profile,
        "seed": progress.seed,
        "events": [asdict(event) for event in progress.events],
        "exercises": [
            {"lesson": lesson.id, "version": lesson.version, "exercise": exercise.id, "status": now.status}
            | {"tries": now.tries, "hints": now.hints}
            for lesson in course.lessons.values()
            for exercise in lesson.exercises
            if (now := progress.standing(lesson.id, lesson.version, exercise.id)).tries or now.done
        ],
    }


def to_csv(progress: Progress) -> str:
    """A row for each event; replies that a spreadsheet would take for formulas begin with an apostrophe."""
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(COLUMNS)
    for event in progress.events:
        row = {"profile": progress.profile, "seed": progress.seed, **asdict(event)}
        row["ok"] = "yes" if event.ok else "no"
        writer.writerow(_harmless(str(row[name])) for name in COLUMNS)
    return text.getvalue()


def _harmless(cell: str) -> str:
    return f"'{cell}" if cell.startswith(_FORMULA) else cell


def read_handed(path: Path) -> list[Handed]:
    """What is in a file that `kinlab learn export` wrote, JSON or CSV; a CSV may hold several students.

    Raises:
        FileError: it cannot be read, or is none of the two.
    """
    try:
        if path.stat().st_size > _LARGEST:
            raise FileError(f"{path}: is larger than {_LARGEST // 1_000_000} MB")
        raw = path.read_bytes()
        # What PowerShell's > writes.
        text = raw.decode("utf-16" if raw.startswith((BOM_UTF16_LE, BOM_UTF16_BE)) else "utf-8-sig")
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise FileError(f"{path}: is not UTF-8 text") from None
    if text.lstrip().startswith("{"):
        return [_from_json(str(path), text)]
    return _from_csv(str(path), text)


def _from_json(file: str, text: str) -> Handed:
    try:
        data = json.loads(text)
        # JSON can name halves of characters, which nothing else can hold.
        json.dumps(data, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as error:
        raise FileError(f"{file}: no valid JSON: {error}") from None
    if data.get("format") != FORMAT or not all(isinstance(data.get(k), str) for k in ("profile", "seed")):
        raise FileError(f"{file}: is no export of KinLab: format, profile and seed are not there")
    rows = data.get("events")
    claims = data.get("exercises", [])
    if not isinstance(rows, list) or not isinstance(claims, list):
        raise FileError(f"{file}: 'events' and 'exercises' are lists")
    events, problems = _events(enumerate(rows, 1), "event")
    claimed = {
        (str(c.get("lesson")), str(c.get("version", "")), str(c.get("exercise"))): {
            name: c[name] for name in ("status", "tries", "hints") if name in c
        }
        for c in claims
        if isinstance(c, dict)
    }
    return Handed(file, data["profile"], data["seed"], events, claimed, problems)


def _from_csv(file: str, text: str) -> list[Handed]:
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline=""), strict=True))
    except csv.Error as error:
        raise FileError(f"{file}: no valid CSV: {error}") from None
    if not rows or not set(COLUMNS) <= rows[0].keys():
        raise FileError(
            f"{file}: is no export of KinLab, neither JSON nor CSV with the columns {', '.join(COLUMNS)}"
        )
    students: dict[tuple[str, str], list[tuple[int, Any]]] = {}
    for number, row in enumerate(rows, 2):
        plain = {k: v[1:] if v.startswith("'") else v for k, v in row.items() if isinstance(k, str) and v}
        event: dict[str, Any] = {name: plain.get(name, "") for name in Event.__dataclass_fields__}
        version = plain.get("version", "")
        event["version"] = int(version) if version.isdecimal() and len(version) < 10 else None
        event["ok"] = {"yes": True, "no": False}.get(plain.get("ok", ""))
        student = plain.get("profile", ""), plain.get("seed", "")
        students.setdefault(student, []).append((number, event))
    handed = []
    for (profile, seed), found in students.items():
        events, problems = _events(found, "line")
        handed.append(Handed(file, profile, seed, events, {}, problems))
    return handed


def _events(rows: Iterable[tuple[int, Any]], what: str) -> tuple[tuple[Event, ...], tuple[str, ...]]:
    events, problems = [], []
    for number, row in rows:
        try:
            events.append(Event.read(row))
        except ValueError:
            problems.append(f"{what} {number} cannot be read")
    return tuple(events), tuple(problems)
