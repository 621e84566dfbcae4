"""Who may connect."""

import pytest

from kinlab.tui.web.gate import Gate, is_loopback

OWN = Gate.of("127.0.0.1")
OPEN = Gate.of("0.0.0.0")


@pytest.mark.parametrize(
    ("host", "origin"),
    [
        ("127.0.0.1:8000", "http://127.0.0.1:8000"),
        ("localhost:8000", "http://localhost:8000"),
        ("LOCALHOST:8000", "http://localhost:8000"),
        ("[::1]:8000", "http://[::1]:8000"),
        ("localhost:9000", "http://localhost:9000"),  # through ssh -L 9000:localhost:8000
        ("localhost", "http://localhost"),
    ],
)
def test_the_machine_itself_may_connect(host, origin):
    assert OWN.objection(host, origin, needs_origin=True) == ""


@pytest.mark.parametrize(
    "host",
    [
        None,
        "",
        "evil.example",
        "evil.example:8000",
        "127.0.0.1.evil.example",
        "192.168.1.5:8000",
        "[::1",
        "[::1]evil.example",
        "a b",
        "localhost.:8000",
        "localhost:x",
        "localhost:8000; script-src *",
        "evil.example@localhost:8000",
        "localhost/..",
        "localhost\n",
    ],
)
def test_a_name_that_is_not_its_own_is_refused(host):
    assert OWN.objection(host, f"http://{host}", needs_origin=True) == "foreign_host"


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example",
        "https://127.0.0.1:8000",
        "http://127.0.0.1:3000",
        "http://localhost:8000",
        "http://127.0.0.1:8000.evil.example",
        "null",
        "",
    ],
)
def test_a_page_of_somebody_else_is_refused(origin):
    assert OWN.objection("127.0.0.1:8000", origin, needs_origin=False) == "foreign_origin"


def test_a_session_needs_an_origin_and_a_page_does_not():
    assert OWN.objection("127.0.0.1:8000", None, needs_origin=True) == "no_origin"
    assert OWN.objection("127.0.0.1:8000", None, needs_origin=False) == ""


def test_a_server_for_a_network_goes_by_any_number_and_no_foreign_name():
    assert OPEN.objection("192.168.1.5:8000", "http://192.168.1.5:8000", needs_origin=True) == ""
    assert OPEN.objection("evil.example", "http://evil.example", needs_origin=True) == "foreign_host"


def test_a_server_answers_to_the_name_it_was_given():
    gate = Gate.of("Lab.school.example")
    assert (
        gate.objection("lab.school.example:8000", "http://lab.school.example:8000", needs_origin=True) == ""
    )


@pytest.mark.parametrize(
    ("host", "own"),
    [
        ("127.0.0.1", True),
        ("localhost", True),
        ("LOCALHOST", True),
        ("::1", True),
        ("127.8.8.8", True),
        ("0.0.0.0", False),
        ("::", False),
    ],
)
def test_which_addresses_are_for_this_machine_alone(host, own):
    assert is_loopback(host) == own
