"""Robots files that mean harm, and files that are merely broken, in every way that chance finds."""

import random
import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinlab.errors import FileError
from kinlab.robots import load_robots
from kinlab.robots.yaml_source import MAX_BYTES, parse
from kinlab.shipped import shipped

SHIPPED = shipped("robots.yaml").read_text(encoding="utf-8")
TOKENS = re.findall(r"\w+|\s+|[^\w\s]", SHIPPED)
NASTY = [
    "", "null", "yes", "-1", "0", "1e999", "1.0e+999", ".nan", "-.inf", "0x" + "f" * 40, "9" * 400, "[]", "{}", "[1]",
    "{a: 1}", "'", '"', "<<", "*x", "&x", "!!int", "!!python/object:os.system", "!!set", "\t", "\n", ":", "-", "?",
    "|", ">", "#", "---", "\0", "\u2028", "é", "x" * 200, "!!float _", "2001-01-01", "=", "~", "%TAG ! x",
]  # fmt: skip


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("hostile") / "robots.yaml"


def load(path: Path, text: str) -> None:
    """A file is loaded or refused by name; nothing else may come out."""
    path.write_text(text, encoding="utf-8", errors="surrogatepass", newline="")
    try:
        load_robots(path)
    except FileError as error:
        message = str(error)
        assert message.startswith(f"{path}:")
        assert len(message) < 2000
        assert "\x1b" not in message
        assert "$." not in message, "the validator's own words"


@settings(max_examples=150)
@given(
    st.lists(
        st.tuples(
            st.sampled_from(["cut", "swap", "double", "put"]),
            st.integers(0, len(TOKENS) - 1),
            st.integers(1, 12),
            st.sampled_from(NASTY),
        ),
        min_size=1,
        max_size=4,
    )
)
def test_mutations_of_the_shipped_file_are_loaded_or_refused(path, mutations):
    tokens = list(TOKENS)
    for kind, at, length, nasty in mutations:
        piece = tokens[at : at + length]
        if kind == "cut":
            del tokens[at : at + length]
        elif kind == "swap":
            tokens[at : at + length] = reversed(piece)
        elif kind == "double":
            tokens[at:at] = piece
        else:
            tokens[at : at + 1] = [nasty]
    load(path, "".join(tokens))


def values(text):
    """The places of the values in one robot's lines."""
    return [m.span(1) for m in re.finditer(r"(?<=[:\[,] )([\w.+-]+|\"[^\"\n]*\")(?=[,}\]\n])", text)]


@settings(max_examples=150)
@given(st.integers(0, 10_000), st.sampled_from(NASTY))
def test_any_value_may_be_replaced_by_anything(path, place, nasty):
    spans = values(SHIPPED)
    start, end = spans[place % len(spans)]
    load(path, SHIPPED[:start] + nasty + SHIPPED[end:])


@settings(max_examples=100)
@given(st.text(max_size=60))
def test_any_text_at_all_is_loaded_or_refused(path, text):
    load(path, text)


def test_bytes_of_chance_are_refused_by_name(path):
    rng = random.Random(1)
    for size in (1, 10, 1000):
        path.write_bytes(rng.randbytes(size) + b"\xff")
        with pytest.raises(FileError, match="not UTF-8 text"):
            load_robots(path)


@pytest.mark.parametrize(
    "value",
    ["!!python/object/apply:os.system ['echo no']", "!!python/name:os.system", "!!python/module:os", "!!binary aGk=",
     "!!set {a}", "!!omap [a: 1]", "!mine 5", "!!int abc", "!!int ''", "!!float _", "!!bool x", "0x" + "f" * 6000],
)  # fmt: skip
def test_tags_call_nothing_and_are_refused_with_their_line(value):
    with pytest.raises(FileError, match=r"^f:2: (tag .* is not allowed|'.*' is not a valid )"):
        parse(f"robots:\n  a: {value}\n", "f")


def test_a_redefined_tag_prefix_calls_nothing_either():
    with pytest.raises(FileError, match=r"f:3: tag .*python/object.* is not allowed"):
        parse("%TAG ! tag:yaml.org,2002:python/\n---\nrobots: !object {}\n", "f")


def bomb(line):
    return "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
        line.format(new=chr(98 + i), old=chr(97 + i)) for i in range(22)
    )


@pytest.mark.parametrize(
    "text",
    [
        bomb("{new}: &{new} [*{old}, *{old}, *{old}, *{old}, *{old}, *{old}, *{old}, *{old}, *{old}]\n"),
        bomb("{new}: &{new} {{p: *{old}, q: *{old}, r: *{old}}}\n"),
        "a: &a {" + ", ".join(f"k{i}: 1" for i in range(30_000)) + "}\n" + "b: {<<: *a}\n" * 2000,
    ],
    ids=["lists", "mappings", "merges"],
)
def test_anchors_do_not_explode(text):
    with pytest.raises(FileError, match=r"more than 100000 values|stands here twice"):
        parse(text, "f")


@pytest.mark.parametrize(
    "text", ["robots: &a {x: *a}", "robots: &a [*a]", "robots: &a {<<: *a}", "robots: *no"]
)
def test_an_anchor_cannot_hold_itself_or_nothing(text):
    with pytest.raises(FileError, match="no anchor is named"):
        parse(text, "f")


@pytest.mark.parametrize("text", ["[" * 5000 + "]" * 5000, "\n".join(" " * i + "a:" for i in range(500))])
def test_nesting_has_an_end(text):
    with pytest.raises(FileError, match="nested deeper than 20 levels"):
        parse("robots:\n " + text if text.startswith("[") else text, "f")


def test_a_huge_file_is_refused_before_it_is_read(path):
    path.write_bytes(b"#" * (MAX_BYTES + 1))
    with pytest.raises(FileError, match="larger than 1000 kB"):
        load_robots(path)


@pytest.mark.parametrize("key", ["5", "[1]", "{a: 1}", "null", "''"])
def test_keys_are_names(key):
    with pytest.raises(FileError, match=r"f:1: a key must be a name"):
        parse(f"? {key}\n: 1\n", "f")


def test_what_a_terminal_would_obey_is_refused():
    with pytest.raises(FileError, match="control characters are not allowed"):
        parse('robots: {a: {title: "\\e[2J"}}', "f")
