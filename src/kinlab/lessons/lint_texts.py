"""What is wrong with a lesson's words: translations, numbers that differ between languages, terms, markup."""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from kinlab.language import LANGUAGES
from kinlab.lessons.course import Course, Term
from kinlab.lessons.filling import PLACEHOLDER
from kinlab.lessons.format import EXERCISE, FIGURE, KINDS
from kinlab.lessons.lesson import Lesson, Place
from kinlab.lessons.reading import Block, Page, read_page
from kinlab.names import suggestion

Found = tuple[Place, str]
WIDEST_CODE = 80
# Digits inside a name, such as theta2, are no number.
_NUMBER = re.compile(r"(?<!\w)\d+(?:[.,]\d+)*")
_CODE = re.compile(r"(?ms)^```.*?^```\s*$|^(?: {4}|\t)[^\n]*$|`[^`\n]*`")
_HTML = re.compile(r"</?[a-zA-Z][^<>\n]*>")


def pages(lesson: Lesson) -> dict[str, Page]:
    """The files of a lesson by language."""
    return {
        code: read_page(lesson.folder / f"{code}.md", f"{lesson.id}/{code}.md") for code in lesson.languages
    }


def translations(lesson: Lesson) -> Iterator[Found]:
    """Texts that are missing in a language, and placeholders and numbers that differ."""
    found = pages(lesson)
    english = found["en"]
    for code, name in LANGUAGES.items():
        if code not in found:
            yield english.place, f"there is no {code}.md: the lesson is not there in {name}"
            continue
        if code != "en":
            yield from _translation(english, found[code])


def _translation(english: Page, other: Page) -> Iterator[Found]:
    for key in ("title", "goals"):
        if key not in other.front:
            yield other.place, f"'{key}' is missing"
        elif isinstance(other.front[key], list) and len(other.front[key]) != len(english.front[key]):
            yield (
                other.at(key),
                f"'{key}' has {len(other.front[key])} entries, in en.md {len(english.front[key])}",
            )
    order = [name for name in english.blocks if name in other.blocks]
    if order != list(other.blocks):
        yield other.place, "the blocks stand in another order than in en.md"
    for name, block in english.blocks.items():
        translated = other.blocks.get(name)
        if translated is None:
            yield other.place, f"the {block.kind} '{name}' is missing"
            continue
        theirs = dict(_texts(translated, block.data))
        for path, text in _texts(block, block.data):
            if path not in theirs:
                yield translated.place, f"'{name}': '{path}' is missing"
            else:
                yield from _same_numbers(translated.place, f"'{name}', {path}", text, theirs[path])
        for path in theirs.keys() - dict(_texts(block, block.data)).keys():
            yield translated.place, f"'{name}': '{path}' is not there in en.md"
    yield from _same_numbers(other.place, "the text", _prose(english), _prose(other))


def _texts(block: Block, original: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Every text of a block that is to be translated, with a path that names it."""
    fields = FIGURE if block.kind == "figure" else {**EXERCISE, **KINDS[original["kind"]]}
    for key, field in fields.items():
        if field.translated and key != "id" and key in block.data:
            yield from _flat(key, block.data[key])


def _flat(path: str, value: Any) -> Iterator[tuple[str, str]]:
    if isinstance(value, str):
        yield path, value
    elif isinstance(value, list):
        for i, each in enumerate(value, 1):
            yield from _flat(f"{path} {i}", each)
    elif isinstance(value, dict):
        for key, each in value.items():
            if key not in ("compute", "with"):
                yield from _flat(f"{path}.{key}", each)


def _prose(page: Page) -> str:
    return "\n\n".join(part[0] for part in page.parts if not isinstance(part, Block))


def _same_numbers(place: Place, what: str, ours: str, theirs: str) -> Iterator[Found]:
    for kind, pick in (("placeholders", _placeholders), ("numbers", _numbers)):
        one, other = pick(ours), pick(theirs)
        missing, more = one - other, other - one
        if missing or more:
            parts = [
                f"{word} {', '.join(sorted(counted.elements()))}"
                for word, counted in (("lacks", missing), ("adds", more))
                if counted
            ]
            yield place, f"{what}: other {kind} than in en.md: {'; '.join(parts)}"


def _placeholders(text: str) -> Counter[str]:
    return Counter(found[0] for found in PLACEHOLDER.finditer(text))


def _numbers(text: str) -> Counter[str]:
    return Counter(found.replace(",", ".") for found in _NUMBER.findall(PLACEHOLDER.sub(" ", text)))


def terms(course: Course, lesson: Lesson) -> Iterator[Found]:
    """Terms of the glossary that are used and explained nowhere before, and explanations that are none."""
    explained: set[str] = set()
    waiting, seen = [lesson.id], set()
    while waiting:
        name = waiting.pop()
        if name in course.lessons and name not in seen:
            seen.add(name)
            explained |= set(course.lessons[name].explains)
            waiting += course.lessons[name].prerequisites
    for code, page in pages(lesson).items():
        text = _CODE.sub(" ", _prose(page) + "\n\n" + "\n".join(_words(page, lesson)))
        used = {term.name for term in course.glossary.values() if _uses(text, term)}
        for name in sorted(used - explained):
            yield (
                page.place,
                (
                    f"uses the term '{name}', which neither this lesson nor one before it explains"
                    " ('explains' in its front matter, or a prerequisite)"
                ),
            )
        if code == "en":
            for name in lesson.explains:
                if name not in course.glossary:
                    near = suggestion(name, course.glossary)
                    yield page.at("explains"), f"explains '{name}', which is not in glossary.toml{near}"
                elif name not in used:
                    yield page.at("explains"), f"explains '{name}', and never uses it"
    for term in course.glossary.values():
        if term.name in lesson.explains and term.meanings.keys() < LANGUAGES.keys():
            yield Place("glossary.toml", 1), f"'{term.name}' is not there in every language"


def _words(page: Page, lesson: Lesson) -> Iterator[str]:
    kinds = {exercise.id: exercise.kind for exercise in lesson.exercises}
    for name, block in page.blocks.items():
        yield from (text for _, text in _texts(block, {"kind": kinds.get(name, "state")}))


def _uses(text: str, term: Term) -> bool:
    forms = "|".join(re.escape(form) for form in (term.name, *term.forms))
    return re.search(rf"(?i)(?<![\w-])(?:{forms})(?![\w-])", text) is not None


def markdown(lesson: Lesson) -> Iterator[Found]:
    """Markup that not every face can show."""
    for page in pages(lesson).values():
        for part in page.parts:
            if isinstance(part, Block):
                continue
            text, place = part
            for number, line in enumerate(text.split("\n"), place.line):
                here = Place(place.file, number)
                if line.startswith(("    ", "\t")) and len(line) - 4 > WIDEST_CODE:
                    yield here, f"code is {len(line) - 4} characters wide; {WIDEST_CODE} fit everywhere"
                tag = _HTML.search(_CODE.sub(" ", line))
                if tag:
                    yield here, f"raw HTML {tag[0]} is not shown"
                if re.search(r"!\[[^]]*\]\(", line):
                    yield here, "pictures are drawn by the core: use a figure block"
