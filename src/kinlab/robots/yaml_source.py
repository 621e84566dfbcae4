"""YAML as plain data with line numbers, from files that nobody has checked.

Built on PyYAML's parser events and not on its loader: only scalars, lists and mappings come out,
whatever tags a file carries; aliases are shared, never copied; nesting, size and duplicate keys
are refused with the line at which they stand.
"""

import re
from pathlib import Path
from typing import Any

import yaml

from kinlab.errors import FileError

MAX_BYTES = 1_000_000
MAX_DEPTH = 20
MAX_VALUES = 100_000

_PREFIX = "tag:yaml.org,2002:"
# What a terminal would obey instead of showing.
_CONTROL = re.compile("[\\x00-\\x08\\x0b-\\x1f\\x7f-\\x9f]")
_KINDS = ("str", "int", "float", "bool", "null", "timestamp", "merge")


class Mapping(dict[str, Any]):
    """A mapping that knows the line of each key, its own line, and how many values it stands for."""

    def __init__(self, line: int) -> None:
        super().__init__()
        self.line = line
        self.lines: dict[str, int] = {}
        self.merged: set[str] = set()
        self.size = 1


class Sequence(list[Any]):
    """A list that knows the line of each item, its own line, and how many values it stands for."""

    def __init__(self, line: int) -> None:
        super().__init__()
        self.line = line
        self.lines: list[int] = []
        self.size = 1


def read_text(path: Path) -> str:
    """The text of a user's file.

    Raises:
        FileError: it is missing, unreadable, too large, or not UTF-8.
    """
    try:
        with path.open("rb") as file:
            raw = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        raise FileError(f"{path}: {getattr(error, 'strerror', None) or error}") from None
    if len(raw) > MAX_BYTES:
        raise FileError(f"{path}: larger than {MAX_BYTES // 1000} kB, which no robots file needs to be")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise FileError(f"{path}:{line}: not UTF-8 text") from None


def parse(text: str, name: str) -> Mapping:
    """The mapping that a YAML document holds, with lines.

    Args:
        text: the document.
        name: the file's name, for messages.

    Raises:
        FileError: `NAME:LINE: what is wrong` for anything but one mapping of plain data.
    """
    try:
        return _Builder(name).build(text)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        where = f":{mark.line + 1}" if mark else ""
        raise FileError(f"{name}{where}: not valid YAML: {error.problem or error.context}") from None
    except yaml.YAMLError as error:
        raise FileError(f"{name}: not valid YAML: {' '.join(str(error).split())}") from None


class _Builder:
    def __init__(self, name: str) -> None:
        self.name = name
        self.anchors: dict[str, Any] = {}
        self.stack: list[tuple[Mapping | Sequence, str | None]] = []
        # The key, with its line, that waits for its value, in each open mapping.
        self.keys: list[tuple[str, int] | None] = []
        self.root: Any = None
        self.documents = 0

    def fail(self, line: int, problem: str) -> FileError:
        return FileError(f"{self.name}:{line}: {problem}")

    def build(self, text: str) -> Mapping:
        loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
        event: Any
        for event in yaml.parse(text, Loader=loader):
            line = event.start_mark.line + 1
            # By the exact type: most events of a file are scalars, and this loop is most of reading one.
            kind = type(event)
            if kind is yaml.ScalarEvent:
                self.add(self.scalar(event, line), line, event.anchor)
            elif kind is yaml.MappingStartEvent or kind is yaml.SequenceStartEvent:
                if event.tag not in (None, f"{_PREFIX}map", f"{_PREFIX}seq"):
                    raise self.fail(line, f"tag {event.tag} is not allowed; a robots file is plain data")
                if len(self.stack) >= MAX_DEPTH:
                    raise self.fail(line, f"nested deeper than {MAX_DEPTH} levels")
                made = Mapping(line) if kind is yaml.MappingStartEvent else Sequence(line)
                self.stack.append((made, event.anchor))
                self.keys.append(None)
            elif kind is yaml.MappingEndEvent or kind is yaml.SequenceEndEvent:
                value, anchor = self.stack.pop()
                self.keys.pop()
                self.add(value, value.line, anchor)
            elif kind is yaml.AliasEvent:
                if event.anchor not in self.anchors:
                    raise self.fail(line, f"no anchor is named '{event.anchor}'")
                self.add(self.anchors[event.anchor], line, None)
            elif kind is yaml.DocumentStartEvent:
                self.documents += 1
                if self.documents > 1:
                    raise self.fail(line, "a second document; one is expected")
        if not isinstance(self.root, Mapping):
            found = "nothing" if self.root is None else f"a {_name_of(self.root)}"
            raise FileError(f"{self.name}:1: expected a mapping at the top of the file, got {found}")
        return self.root

    def scalar(self, event: yaml.ScalarEvent, line: int) -> Any:
        if _CONTROL.search(event.value):
            raise self.fail(line, f"control characters are not allowed, got {event.value[:40]!r}")
        tag = event.tag
        if tag is None and event.style:
            return str(event.value)
        if tag in (None, "!"):
            tag = _RESOLVER.resolve(yaml.ScalarNode, event.value, event.implicit)  # type: ignore[no-untyped-call]
        kind = tag.removeprefix(_PREFIX)
        if event.tag is None and event.implicit[0]:
            # YAML 1.1 takes 5e1 for text and 1:30 for ninety; a reader of lengths does not.
            kind = "float" if _SCIENTIFIC.fullmatch(event.value) else "str" if ":" in event.value else kind
        if kind not in _KINDS:
            raise self.fail(line, f"tag {tag} is not allowed; a robots file is plain data")
        if kind in ("str", "timestamp", "merge"):
            return _Merge() if kind == "merge" else event.value
        node = yaml.ScalarNode(_PREFIX + kind, event.value)
        try:
            value = _CONSTRUCTOR.construct_object(node)
            # Beyond this an int is no float any more, and from 4300 digits on not even text.
            if isinstance(value, int):
                float(value)
        except (ValueError, LookupError, OverflowError, yaml.YAMLError):
            raise self.fail(line, f"'{event.value[:40]}' is not a valid {kind}") from None
        return value

    def add(self, value: Any, line: int, anchor: str | None) -> None:
        if anchor is not None:
            self.anchors[anchor] = value
        if not self.stack:
            self.root = value
            return
        parent, _ = self.stack[-1]
        if isinstance(parent, Mapping) and self.keys[-1] is None:
            self.keys[-1] = self.key(value, parent, line), line
            return
        parent.size += getattr(value, "size", 1)
        if parent.size > MAX_VALUES:
            raise self.fail(line, f"anchors expand to more than {MAX_VALUES} values")
        if isinstance(parent, Sequence):
            parent.append(value)
            parent.lines.append(line)
            return
        waiting, self.keys[-1] = self.keys[-1], None
        assert waiting is not None
        key, line = waiting
        if key == "<<":
            self.merge(parent, value, line)
        else:
            # What is written here wins over what a merge brought.
            parent[key] = value
            parent.lines[key] = line
            parent.merged.discard(key)

    def key(self, value: Any, parent: Mapping, line: int) -> str:
        if isinstance(value, _Merge):
            return "<<"
        if not isinstance(value, str) or not value:
            raise self.fail(line, f"a key must be a name, got {value!r}"[:80])
        if value in parent and value not in parent.merged:
            raise self.fail(line, f"'{value}' stands here twice; first in line {parent.lines[value]}")
        return value

    def merge(self, parent: Mapping, value: Any, line: int) -> None:
        for source in value if isinstance(value, Sequence) else [value]:
            if not isinstance(source, Mapping):
                raise self.fail(line, f"'<<' takes a mapping, got {_name_of(source)}")
            for key, item in source.items():
                if key not in parent:
                    parent[key] = item
                    parent.lines[key] = source.lines[key]
                    parent.merged.add(key)


class _Merge:
    """The key `<<`."""


def _name_of(value: Any) -> str:
    names = {dict: "mapping", list: "list", str: "text", bool: "yes or no", type(None): "nothing"}
    for kind, name in names.items():
        if isinstance(value, kind):
            return name
    return "number"


_RESOLVER = yaml.resolver.Resolver()
_CONSTRUCTOR = yaml.constructor.SafeConstructor()
_SCIENTIFIC = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)[eE][+-]?\d+")
