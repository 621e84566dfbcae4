"""A lesson's Markdown as lines of text: wrapped, without pictures of frames, easy to read aloud."""

import re
from collections.abc import Iterator

Span = tuple[str, str]
Line = list[Span]
_INLINE = re.compile(
    r"(\*\*|__)(?=\S)(.+?)(?<=\S)\1|(?<![\w*])\*(?=\S)([^*\n]+?)(?<=\S)\*(?!\w)|`([^`\n]+)`|\[([^]\n]+)\]\(([^)\s]+)\)"
)
_ITEM = re.compile(r"(\s*)([-*+]|\d{1,3}[.)]|[a-z]\))\s+(.*)")
_HEADING = re.compile(r"(#{1,6})\s+(.*?)\s*#*$")


def prose(markdown: str, columns: int) -> Iterator[Line]:
    """Markdown as lines of (style, text); a blank one between blocks, none at the ends."""
    first = True
    for block in _blocks(markdown):
        if not first:
            yield []
        first = False
        yield from _shown(block, columns)


def _blocks(markdown: str) -> Iterator[list[str]]:
    """Lines that belong together: paragraphs, lists, tables, code."""
    block: list[str] = []
    fence = ""
    for line in markdown.split("\n"):
        mark = re.match(r"(`{3,}|~{3,})", line)
        if fence or mark:
            block.append(line)
            if fence and line.rstrip() == fence:
                yield block
                block, fence = [], ""
            elif mark and not fence:
                if block[:-1]:
                    yield block[:-1]
                block, fence = [line], mark[1]
            continue
        if _HEADING.match(line):
            if block:
                yield block
            yield [line]
            block = []
        elif line.strip():
            block.append(line)
        elif block:
            yield block
            block = []
    if block:
        yield block


def _shown(block: list[str], room: int) -> Iterator[Line]:
    heading = _HEADING.match(block[0])
    if heading:
        yield from wrapped(heading[2], room, style="verb")
    elif block[0].startswith(("```", "~~~")):
        yield from ([("id", f"    {line}")] for line in block[1:-1])
    elif all(line.startswith(("    ", "\t")) for line in block):
        yield from ([("id", line)] for line in block)
    elif block[0].lstrip().startswith("|"):
        yield from _table(block, room)
    else:
        yield from _paragraphs(block, room)


def _paragraphs(block: list[str], room: int) -> Iterator[Line]:
    """Text that is wrapped; items of a list and hard breaks begin a line of their own."""
    pieces: list[tuple[str, str]] = []
    broken = True
    for line in block:
        item = _ITEM.match(line)
        if item:
            mark = "-" if item[2] in "*+-" else item[2]
            pieces.append((f"{item[1]}{mark} ", item[3]))
        elif line.startswith(">"):
            pieces.append(("  ", line.lstrip("> ")))
        elif broken or not pieces:
            pieces.append(("", line.strip()))
        else:
            head, text = pieces[-1]
            pieces[-1] = head, f"{text} {line.strip()}"
        broken = line.endswith("  ")
    for head, text in pieces:
        yield from wrapped(text.strip(), room, head=head)


def _table(block: list[str], room: int) -> Iterator[Line]:
    """Columns as wide as their cells; what does not fit of the last one is folded."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in block]
    rows = [row for row in rows if not all(re.fullmatch(r":?-+:?", cell) for cell in row)]
    count = max(map(len, rows))
    wide = [max(len(_plain(row[i])) if i < len(row) else 0 for row in rows) for i in range(count)]
    left = sum(wide[:-1]) + 2 * count
    for number, row in enumerate(rows):
        style = "header" if number == 0 else ""
        line: Line = [("", "  ")]
        for cell, size in zip(row[: count - 1], wide, strict=False):
            line += [*spans(cell, style), ("", " " * (size - len(_plain(cell)) + 2))]
        last = wrapped(row[-1] if len(row) == count else "", max(room - left, 20), style=style)
        for folded in last:
            yield [*line, *folded]
            line = [("", " " * left)]


def _plain(text: str) -> str:
    return "".join(part for _, part in spans(text))


def spans(text: str, style: str = "") -> Line:
    """Inline markup as (style, text)."""
    found: Line = []
    end = 0
    for match in _INLINE.finditer(text):
        found.append((style, text[end : match.start()]))
        if match[2]:
            found += spans(match[2], "verb")
        elif match[3]:
            found.append((style or "arrow", match[3]))
        elif match[4]:
            found.append(("id", match[4]))
        else:
            found.append((style, f"{match[5]} ({match[6]})"))
        end = match.end()
    found.append((style, text[end:]))
    return [span for span in found if span[1]]


def wrapped(text: str, room: int, *, head: str = "", style: str = "") -> Iterator[Line]:
    """Text in lines of at most `room` characters; what follows the first begins below the text after `head`."""
    line: Line = [("", head)] if head else []
    used = len(head)
    fresh = True
    for word in _words(text, style):
        size = sum(len(part) for _, part in word)
        if not fresh and used + 1 + size > room:
            yield line
            line, used, fresh = [("", " " * len(head))] if head else [], len(head), True
        if not fresh:
            line.append(("", " "))
            used += 1
        line += word
        used += size
        fresh = False
    yield line


def _words(text: str, style: str) -> list[Line]:
    """What a line must not break: a word with the full stop that follows its markup."""
    found: list[Line] = []
    glued = False
    for look, piece in spans(text, style):
        for word in re.findall(r"\S+|\s+", piece):
            if word.isspace():
                glued = False
            elif glued:
                found[-1].append((look, word))
            else:
                found.append([(look, word)])
                glued = True
    return found
