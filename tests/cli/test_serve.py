"""`kinlab serve`, as it is started."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import urllib.error
import urllib.request
from urllib.parse import urlsplit

import pytest

from kinlab.cli.serve import _address, _warn
from kinlab.shipped import install_line
from kinlab.tui.web.gate import Gate


@pytest.fixture
def started(tmp_path, monkeypatch):
    """A function that starts `kinlab serve` with a free port; gives the process and its address."""
    monkeypatch.setenv("KINLAB_HOME", str(tmp_path))
    monkeypatch.setenv("KINLAB_LANG", "en")
    running = []

    def start(*args):
        process = subprocess.Popen(
            [sys.executable, "-m", "kinlab", "serve", "--port", "0", *args],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        running.append(process)
        line = process.stdout.readline()
        if line == "{\n":
            line += process.stdout.readline()
        found = re.search(r"http://[^\s\"]+", line)
        assert found, line + process.stderr.read()
        return process, found[0], line

    yield start
    for process in running:
        process.kill()
        process.wait()
        process.stdout.close()
        process.stderr.close()


def rest(process):
    """What else it prints until it ends; lines may wait in the buffer that the first one came from."""
    out, err = process.stdout.read(), process.stderr.read()
    process.wait(timeout=60)
    return out, err


def test_it_says_where_it_is_answers_there_and_ends_at_ctrl_c(started, tmp_path):
    process, place, line = started("--sessions", "3")
    assert "3 visitors" in line
    assert "this machine alone" in line
    assert os.name != "posix" or (tmp_path / "visitors").stat().st_mode & 0o077 == 0
    with urllib.request.urlopen(place, timeout=60) as page:
        assert page.status == 200
        assert 'class="textual-terminal"' in page.read().decode()
    process.send_signal(signal.SIGINT)
    out, err = rest(process)
    assert process.returncode == 0
    assert f"{tmp_path / 'visitors'}" in out
    assert err == ""


def test_a_class_goes_on_though_nobody_reads_along(started):
    process, place, _ = started("--sessions", "1")
    process.stderr.close()
    key = {"Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": "a" * 22 + "=="}
    ask = urllib.request.Request(f"{place}/ws", headers={"Origin": place, "Upgrade": "websocket", **key})
    for _ in range(2):  # the first leaves its place to the second
        # No whole handshake, as urllib asks for every connection to be closed.
        with pytest.raises(urllib.error.HTTPError) as refused:
            urllib.request.urlopen(ask, timeout=60)
        assert refused.value.code == 400
        refused.value.close()


def test_a_foreign_name_is_refused(started):
    _, place, _ = started()
    request = urllib.request.Request(place, headers={"Host": "evil.example"})
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(request, timeout=60)
    assert refused.value.code == 403
    refused.value.close()


def test_a_port_that_is_taken_is_named(kinlab):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        run = kinlab("serve", "--port", port)
    assert run.code == 1
    assert f"another program has port {port}" in run.err
    assert f"--port {port + 1}" in run.err


@pytest.mark.parametrize(
    ("args", "text"),
    [
        (["--host", "", "--sessions", 0], "0.0.0.0 for everybody"),
        (["--sessions", 0], "from 1 on"),
        (["--port", 65536], "0 to 65535"),
        (["--port", -1], "0 to 65535"),
        (["--port", "x"], "whole number"),
        (["--robots", "none.yaml"], "none.yaml"),
    ],
)
def test_what_cannot_be_is_refused(kinlab, args, text):
    run = kinlab("serve", *args)
    assert run.code == 2
    assert text in run.err


@pytest.mark.parametrize(
    ("host", "text"), [("203.0.113.7", "cannot listen on 203.0.113.7"), ("a..b", "a..b is no address")]
)
def test_an_address_that_is_not_here_is_told(kinlab, host, text):
    run = kinlab("serve", "--host", host, "--port", 0)
    assert run.code == 1
    assert text in run.err


def test_a_folder_for_visitors_that_cannot_be_made_is_told_before_anybody_comes(
    kinlab, monkeypatch, tmp_path
):
    (tmp_path / "file").touch()
    monkeypatch.setenv("KINLAB_HOME", str(tmp_path / "file"))
    run = kinlab("serve", "--host", "a..b")
    assert "visitors: cannot be made: Not a directory; $KINLAB_HOME" in run.err


def test_an_open_address_says_what_it_exposes(capsys):
    _warn("0.0.0.0")
    told = capsys.readouterr()
    assert "no password" in told.err
    assert "no serial port" in told.err
    _warn("127.0.0.1")
    assert capsys.readouterr().err == ""


def test_an_address_can_be_typed_into_a_browser():
    assert _address("127.0.0.1", 8000) == "http://127.0.0.1:8000"
    assert _address("::1", 8000) == "http://[::1]:8000"
    # For everybody: the machine's number in its network, or its name where it is in none.
    number = urlsplit(_address("0.0.0.0", 8000)).hostname
    assert Gate.of("0.0.0.0").objection(f"{number}:8000", None, needs_origin=False) == ""
    if number != socket.gethostname().casefold():
        with socket.socket() as mine:
            mine.bind((number, 0))  # It is this machine's own.
        assert number not in ("0.0.0.0", "127.0.0.1")


def test_where_it_is_as_json(started, tmp_path):
    process, _, line = started("--json", "--sessions", "2")
    process.send_signal(signal.SIGINT)
    document = json.loads(line + rest(process)[0])
    assert document["url"].startswith("http://127.0.0.1:")
    assert document["sessions"] == 2
    assert document["folders"] == str(tmp_path / "visitors")


def test_without_the_extra_the_line_that_installs_it_is_given(kinlab, monkeypatch):
    monkeypatch.setitem(sys.modules, "textual_serve.server", None)
    monkeypatch.delitem(sys.modules, "kinlab.tui.web.server", raising=False)
    run = kinlab("serve", "--port", 0)
    assert run.code == 1
    assert install_line("serve") in run.err
