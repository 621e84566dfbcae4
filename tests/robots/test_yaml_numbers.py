"""Numbers in a robots file are what a reader of lengths takes them for."""

import pytest

from kinlab.robots.yaml_source import parse


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("25", 25),
        ("-25.5", -25.5),
        ("5e1", 50.0),
        ("-1.5E-3", -0.0015),
        (".5", 0.5),
        ('"5e1"', "5e1"),
        ("1:30", "1:30"),
    ],
)
def test_a_plain_number_is_a_number_and_a_time_is_text(written, meant):
    found = parse(f"a: {written}", "f.yaml")["a"]
    assert found == meant
    assert type(found) is type(meant)
