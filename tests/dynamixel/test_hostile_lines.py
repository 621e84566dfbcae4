"""Whatever is typed at the sandbox is answered in words."""

from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.dynamixel import load_table
from kinlab.dynamixel.quantity import to_ticks
from kinlab.dynamixel.sandbox import Session, execute
from kinlab.errors import KinlabError

CHAIN = "AX-12A:1,2,XL430-W250:3"
LINES = [
    "read 1 @9999", "write 1 @9999 1", "write 1 @300 1", "read 3 @70000", "read 1 goal_position 9999",
    "read 1 @30:300", "read 1 @-1", "bulkread 3:@99999", "syncread @99999 3", "syncwrite @9999 1=1",
    "bulkwrite 3:@99999=1", "write 1 @30 1e999", "write 1 goal_position 1e999", "chain AX-12A:5-1",
    "backup 3 restroe", "ping 1 1", "build write 1 @300 1",
]  # fmt: skip
WORDS = st.sampled_from(
    ["ping", "read", "write", "build", "decode", "bulkread", "syncwrite", "1", "3", "all", "@30", "@-5", "@1e9",
     "goal_position", "90deg", "90,5deg", "-1", "1e999", "nan", "FF", "1=2", "3:@1", "fast", "0x", "=", ":"]
)  # fmt: skip


@pytest.mark.parametrize("line", LINES)
def test_a_line_that_cannot_be_is_refused_in_words(line):
    with pytest.raises(KinlabError):
        execute(Session(CHAIN), line)


@given(st.lists(WORDS, min_size=1, max_size=6))
def test_no_line_of_known_words_ends_in_anything_else(words):
    with suppress(KinlabError):
        execute(Session(CHAIN), " ".join(words))


def test_a_comma_is_a_decimal_mark_with_a_unit_too():
    register = load_table("AX-12A").find("goal_position")
    assert to_ticks("90,5deg", register) == to_ticks("90.5deg", register)
