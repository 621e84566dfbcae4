"""Reading a lesson's folder: `en.md`, and `id.md` with the same texts in Bahasa Indonesia.

A page is Markdown with TOML between two lines of +++ at its head, and fenced blocks `exercise` and
`figure` where they belong in the text. Data only: nothing of it is ever executed.
"""

import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinlab.language import LANGUAGES
from kinlab.lessons.building import build_exercise, build_figure, check_translation, drawn
from kinlab.lessons.format import FRONT, ID, INSTRUMENTS, FormatError, check
from kinlab.lessons.lesson import Lesson, Part, Place, Prose
from kinlab.names import suggestion

_FENCE = re.compile(r"^(`{3,}|~{3,})\s*([a-z]*)")
_LINE_OF_TOML = re.compile(r"\(at line (\d+), column \d+\)")
_LARGEST = 200_000
# What a terminal would obey, and what turns the direction of text around.
_ODD = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


@dataclass(frozen=True)
class Block:
    """A fenced block: "exercise" or "figure", its TOML, and where each line of it stands."""

    kind: str
    data: dict[str, Any]
    place: Place
    source: tuple[str, ...]

    def at(self, key: str | None) -> Place:
        """The line that sets `key`; the block's first where none does."""
        return find_key(self.source, self.place, key)


@dataclass(frozen=True)
class Page:
    """One file: its front matter, and prose and blocks in turn."""

    front: dict[str, Any]
    place: Place
    source: tuple[str, ...]
    parts: tuple[tuple[str, Place] | Block, ...]

    def at(self, key: str | None) -> Place:
        """The line of the front matter that sets `key`."""
        return find_key(self.source, self.place, key)

    @property
    def blocks(self) -> dict[str, Block]:
        """By id."""
        return {str(part.data.get("id")): part for part in self.parts if isinstance(part, Block)}


def find_key(source: tuple[str, ...], place: Place, key: str | None) -> Place:
    """The line that sets `key` in TOML that begins after `place`."""
    if key is not None:
        sets = re.compile(rf"\s*(\[+.*\b)?{re.escape(key)}\b")
        for number, line in enumerate(source, place.line + 1):
            if sets.match(line):
                return Place(place.file, number)
    return place


def read_lesson(folder: Path) -> Lesson:
    """The lesson in a folder.

    Raises:
        LessonError: with the file and the line.
    """
    name = folder.name
    if not re.fullmatch(ID, name):
        raise Place(name, 1).error("a lesson's folder is named in small letters, digits and hyphens")
    pages = {
        code: read_page(folder / f"{code}.md", f"{name}/{code}.md")
        for code in LANGUAGES
        if code == "en" or (folder / f"{code}.md").exists()
    }
    english = pages["en"]
    try:
        check(english.front, FRONT)
    except FormatError as error:
        raise english.at(error.key).error(str(error)) from None
    for code, page in pages.items():
        if code != "en":
            check_translation(page, english)
    front = english.front
    return Lesson(
        name, folder,
        {code: page.front["title"] for code, page in pages.items() if "title" in page.front},
        {code: tuple(page.front["goals"]) for code, page in pages.items() if "goals" in page.front},
        tuple(front.get("prerequisites", ())), front.get("robot", ""), _instrument(english), front["minutes"],
        front["version"], front.get("order", 1000), tuple(front.get("explains", ())), drawn(front, english.at),
        {code: _parts(code, pages) for code in pages}, tuple(pages),
    )  # fmt: skip


def _instrument(page: Page) -> str:
    """What a lesson's robot is shown by."""
    robot, named = page.front.get("robot", ""), page.front.get("instrument")
    if named is None:
        return INSTRUMENTS[0] if robot else ""
    if named not in INSTRUMENTS:
        raise page.at("instrument").error(f"there is no instrument '{named}'{suggestion(named, INSTRUMENTS)}")
    if not robot:
        raise page.at("instrument").error("an instrument shows a 'robot', and none is named")
    return str(named)


def _parts(code: str, pages: Mapping[str, Page]) -> tuple[Part, ...]:
    """English decides which blocks there are and in which order; prose comes from the translation where it can.

    The prose before a block that the translation leaves out stands in English.
    """
    built: dict[str, Part] = {}
    for name, block in pages["en"].blocks.items():
        texts = {language: page.blocks[name] for language, page in pages.items() if name in page.blocks}
        built[name] = build_figure(texts) if block.kind == "figure" else build_exercise(texts)
    before = {language: _prose_before(language, page) for language, page in pages.items()}
    parts: list[Part] = []
    for name in [*built, ""]:
        parts += before[code].get(name, before["en"][name])
        if name:
            parts.append(built[name])
    return tuple(parts)


def _prose_before(language: str, page: Page) -> dict[str, list[Prose]]:
    """The prose that stands before each block, and before the end ("")."""
    found: dict[str, list[Prose]] = {}
    waiting: list[Prose] = []
    for part in page.parts:
        if isinstance(part, Block):
            found[str(part.data["id"])] = waiting
            waiting = []
        else:
            waiting.append(Prose(part[0], language, part[1]))
    found[""] = waiting
    return found


def read_page(path: Path, name: str) -> Page:
    """One file, as far as it can be read without knowing its fields.

    Raises:
        LessonError: with the file and the line.
    """
    place = Place(name, 1)
    lines = read_text(path, name).split("\n")
    if lines[0].rstrip() != "+++":
        raise place.error("begins with no front matter: TOML between two lines of +++")
    end = next((i for i in range(1, len(lines)) if lines[i].rstrip() == "+++"), None)
    if end is None:
        raise place.error("the front matter has no end: a line of +++")
    front = read_toml(lines[1:end], place)
    return Page(front, place, tuple(lines[1:end]), tuple(_split(lines, end + 1, name)))


def read_text(path: Path, name: str) -> str:
    """The text of a file: not too long, UTF-8, and with nothing in it that a terminal would obey.

    Raises:
        LessonError: with the file and the line.
    """
    place = Place(name, 1)
    try:
        # A device or a pipe might never end.
        if path.exists() and not path.is_file():
            raise place.error("is no file")
        with path.open("rb") as file:
            raw = file.read(_LARGEST + 1)
    except OSError as error:
        raise place.error(f"cannot be read: {error.strerror}") from None
    if len(raw) > _LARGEST:
        raise place.error(f"a page has at most {_LARGEST // 1000} kB")
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise Place(name, line).error("is not UTF-8 text") from None
    text = text.replace("\r\n", "\n")
    odd = _ODD.search(text)
    if odd:
        line = text.count("\n", 0, odd.start()) + 1
        raise Place(name, line).error(_odd(odd[0]))
    return text


def _odd(character: str) -> str:
    return f"holds the control character U+{ord(character):04X}"


def _split(lines: list[str], start: int, name: str) -> list[tuple[str, Place] | Block]:
    parts: list[tuple[str, Place] | Block] = []
    seen: set[str] = set()
    prose_from, at = start, start

    def prose(until: int) -> None:
        text = "\n".join(lines[prose_from:until]).strip("\n")
        if text.strip():
            skipped = next(i for i in range(prose_from, until) if lines[i].strip())
            parts.append((text, Place(name, skipped + 1)))

    while at < len(lines):
        fence = _FENCE.match(lines[at])
        if not fence:
            at += 1
            continue
        place = Place(name, at + 1)
        mark, kind = fence[1], fence[2]
        ours = kind in ("exercise", "figure")
        # A block of ours holds no fences: another one that opens before it ends is a forgotten end.
        ends = (
            i
            for i in range(at + 1, len(lines))
            if lines[i].rstrip() == mark or (ours and _FENCE.match(lines[i]))
        )
        end = next(ends, None)
        if end is None or lines[end].rstrip() != mark:
            raise place.error(f"the block has no end: a line of {mark}")
        if ours:
            prose(at)
            data = read_toml(lines[at + 1 : end], place)
            block = Block(kind, data, place, tuple(lines[at + 1 : end]))
            own = data.get("id")
            if not isinstance(own, str) or not re.fullmatch(ID, own):
                raise block.at("id").error(f"{kind}: 'id' is a name in small letters, digits and hyphens")
            if own in seen:
                raise block.at("id").error(f"two blocks have the id '{own}'")
            seen.add(own)
            parts.append(block)
            prose_from = end + 1
        at = end + 1
    prose(len(lines))
    return parts


def read_toml(lines: Sequence[str], place: Place) -> dict[str, Any]:
    """TOML whose first line follows `place`.

    Raises:
        LessonError: with the file and the line.
    """
    try:
        data = tomllib.loads("\n".join(lines))
        # A text may have written it as \\u001b.
        odd = next((found[0] for text in _texts(data) if (found := _ODD.search(text))), None)
    except (ValueError, RecursionError) as error:
        message = str(error)
        found = _LINE_OF_TOML.search(message)
        line = int(found[1]) if found else len(lines) if "at end" in message else 1
        said = _LINE_OF_TOML.sub("", message).replace("(at end of document)", "").strip()
        raise Place(place.file, place.line + line).error(f"no valid TOML: {said}") from None
    if odd:
        written = f"\\u{ord(odd):04x}"
        at = next((i for i, line in enumerate(lines, 1) if written in line.lower()), 1)
        raise Place(place.file, place.line + at).error(_odd(odd))
    return data


def _texts(value: Any) -> Iterator[str]:
    """Every text in a tree of TOML, names too."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for name, each in value.items():
            yield name
            yield from _texts(each)
    elif isinstance(value, list):
        for each in value:
            yield from _texts(each)
