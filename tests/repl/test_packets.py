"""The prompt, driven through a pipe as a terminal would."""

import re

import pytest
from prompt_toolkit.completion import CompleteEvent
from prompt_toolkit.data_structures import Size
from prompt_toolkit.document import Document
from prompt_toolkit.input import create_pipe_input
from prompt_toolkit.output.vt100 import Vt100_Output

from kinlab.dynamixel.sandbox import Session, execute
from kinlab.dynamixel.sandbox.prompting import hint
from kinlab.repl.completion import LineCompleter
from kinlab.repl.lexing import styled
from kinlab.repl.packets import run


@pytest.fixture
def session():
    return Session("AX-12A:1,2")


class Screen:
    """Takes what a terminal would show."""

    encoding = "utf-8"

    def __init__(self):
        self.text = ""

    def write(self, text):
        self.text += text

    def flush(self):
        pass

    def isatty(self):
        return False

    def fileno(self):
        raise OSError


def typed(session, *lines):
    """What the screen shows after these lines and Ctrl-D."""
    screen = Screen()
    output = Vt100_Output(screen, lambda: Size(rows=40, columns=120), term="dumb")
    with create_pipe_input() as keys:
        for line in lines:
            keys.send_text(line + "\r")
        keys.send_text("\x04")
        run(session, keys, output)
    return re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", screen.text)


def test_a_packet_byte_by_byte(session):
    screen = typed(session, "step", "FF FF 01", "02", "01", "FB", "send")
    assert "it should be FB" in screen
    assert "the packet is whole" in screen
    assert "FF FF 01 02 00 FC" in screen


def test_errors_are_shown_and_the_prompt_goes_on(session):
    screen = typed(session, "pong", "send GG", "ping 1")
    assert "did you mean ping" in screen
    assert "no hexadecimal digit" in screen
    assert "servo 1: ok" in screen


def test_quit_leaves(session):
    assert "servo 2" not in typed(session, "quit", "ping 2")


def texts(session, line):
    completer = LineCompleter(session)
    return [c.text for c in completer.get_completions(Document(line), CompleteEvent())]


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("pi", ["ping"]),
        ("ping ", ["1", "2"]),
        ("read 1 goal", ["goal_position"]),
        ("build write 1 pun", ["punch"]),
        ("step re", ["read", "regwrite", "reset", "reboot"]),
        ("ping 1; wri", ["write"]),
        ("chain krs", ["krsri-hexapod"]),
        ("power o", ["on", "off"]),
        ("syncwrite tor", ["torque_enable", "torque_limit"]),
        ("table RX", ["RX-24F"]),
        ("read 99 x", []),
    ],
)
def test_completion(session, line, found):
    assert texts(session, line) == found


def test_bytes_are_coloured_by_field_while_typing(session):
    fragments = [(style, text) for style, text in styled(session, "send FF FF 01 02 01 FB") if text.strip()]
    assert fragments == [
        ("class:verb", "send"),
        ("class:header", "FF"),
        ("class:header", "FF"),
        ("class:id", "01"),
        ("class:length", "02"),
        ("class:instruction", "01"),
        ("class:check", "FB"),
    ]


def test_bytes_that_follow_assembled_ones_are_coloured_too(session):
    execute(session, "step FF FF")
    assert ("class:id", "01") in styled(session, "01")


def test_an_unknown_command_is_coloured_as_wrong(session):
    assert styled(session, "pong 1")[1] == ("class:bad", "pong")


@pytest.mark.parametrize(
    "line", ["", "send", "send GG", "   ", "# note", "send FF FF # note", "decode status FF"]
)
def test_colouring_loses_no_character(session, line):
    assert "".join(text for _, text in styled(session, line)) == line


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("send FF FF 01 02 01", "next: checksum, which would be FB"),
        ("send FF FF 01 02 01 FA", "the checksum is FA"),
        ("send FF FF 01", "3 bytes; next: length"),
        ("send GG", "no hexadecimal digit"),
        ("write", "write ID REGISTER VALUE"),
        ("pi", "ping"),
        ("", ""),
    ],
)
def test_the_toolbar_helps(session, line, text):
    assert text in hint(session, line)


def test_the_toolbar_follows_the_packet_that_is_assembled(session):
    execute(session, "step FF FF 01 02")
    assert hint(session, "") == "4 bytes; next: instruction"
    assert "which would be FB" in hint(session, "01")
