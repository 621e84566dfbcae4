"""Gaits that are broken in every way that chance finds: loaded, or refused by file, line and field."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinlab.errors import FileError
from kinlab.gait import load_gaits
from kinlab.shipped import shipped

GAITS = "gaits:" + shipped("robots.yaml").read_text(encoding="utf-8").split("\ngaits:")[1]
TOKENS = re.findall(r"\w+|\s+|[^\w\s]", GAITS)
NASTY = [
    "", "null", "yes", "-1", "0", "1", "1/2", "1/0", "-1/2", "2/1", "1e999", "1e99", "1e-9", ".nan", "0x" + "f" * 40,
    "9" * 400, "1/" + "9" * 400, "1e999999999", "1/2/3", "½", "[]", "{}", "[1]", "{a: 1}", "'", '"', "<<", "*x", "&x",
    "!!float 1/2", "\t", "\n", ":", "x" * 200, "\0", "L1",
]  # fmt: skip


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("hostile") / "gaits.yaml"


@settings(max_examples=200)
@given(st.lists(st.tuples(st.integers(0, len(TOKENS) - 1), st.sampled_from(NASTY)), min_size=1, max_size=3))
def test_any_gait_is_loaded_or_refused(path, changes):
    tokens = list(TOKENS)
    for at, nasty in changes:
        tokens[at] = nasty
    path.write_text("".join(tokens), encoding="utf-8", errors="surrogatepass", newline="")
    try:
        gaits = load_gaits(path)
    except FileError as error:
        message = str(error)
        assert message.startswith(f"{path}:")
        assert len(message) < 2000
    else:
        for gait in gaits.values():
            assert 0 < gait.duty < 1
            assert all(0 <= phase < 1 for phase in gait.touchdown.values())
            assert all(phase.stance for phase in gait.phases)


def test_a_gait_that_is_no_mapping_is_refused(path):
    for text in ("gaits: tripod", "gaits: {a: 1}", "gaits: {a: [1]}", "gaits: {a: null}"):
        path.write_text(text)
        with pytest.raises(FileError, match=r"gaits.yaml:1: gaits.*expected a mapping"):
            load_gaits(path)
