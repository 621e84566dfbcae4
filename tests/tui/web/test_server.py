"""`kinlab serve`, spoken to as a browser speaks to it."""

import asyncio
import json
import sys
from contextlib import suppress

import aiohttp
import numpy as np
import pytest
from aiohttp import web
from textual.driver import Driver
from textual.events import Key, Resize
from textual.geometry import Size

from kinlab import load_robot
from kinlab.canvas import without_braille
from kinlab.tui.stations import STATIONS
from kinlab.tui.web.driver import GuestDriver
from kinlab.tui.web.session import LARGEST, SMALLEST, Session, fitting


def test_a_visitor_types_a_target_and_reads_the_angles(serve):
    """The whole way: websocket, process, Robot station, and back onto a terminal's screen."""
    limb = load_robot("xl430-hexapod").limbs["R1"]
    wanted = np.degrees(limb.ik([0.08, 0.01, -0.046]).q)

    async def script(served):
        async with served.visit(size=(110, 30)) as visitor:
            await visitor.see("xl430-hexapod", "Reached", "x 75")
            # The first field has the focus. Keys that come in one burst may overtake each other.
            await visitor.type("\x05\x15")
            await visitor.see("A number is wanted here")
            await visitor.type("80")
            seen = await visitor.see("x 80", *(f"{angle:.3f}".rstrip("0") for angle in wanted))
            # The line of keys names none that the browser keeps for itself.
            assert "^p commands" in seen
            assert "^n" not in seen
            await visitor.type("\x11")
            await visitor.until_closed()
        (folder,) = served.folders.iterdir()
        assert json.loads((folder / "tui.json").read_text())["station"] == "robot"

    serve(script, small=False)


def test_a_session_reaches_no_serial_port_and_no_file_of_the_machine(serve, tmp_path):
    outside = tmp_path / "outside.dxl"
    outside.write_text("ping 1\n")

    async def script(served):
        async with served.visit(size=(120, 30)) as visitor:
            await visitor.see("Reached")
            await visitor.type(f"\x1b[1{list(STATIONS).index('packet') + 2}~")
            await visitor.see("dxl>")
            await visitor.type(f"load {outside}\r")
            await visitor.see("give a plain name")
            # Lines that come in one piece are carried out one by one.
            await visitor.type("ping 1\rping 2\rsave mine\r")
            # Where that is on the machine is no guest's business.
            await visitor.see("saved to mine")
        (folder,) = served.folders.iterdir()
        assert (folder / "files" / "mine").read_text().splitlines()[-2:] == ["ping 1", "ping 2"]

    serve(script, small=False)


def test_a_foreign_page_and_a_foreign_name_are_refused_everywhere(serve):
    async def script(served):
        evil = {"Origin": "http://evil.example"}
        assert await served.knock(**evil) == 403
        assert await served.knock(Host="evil.example", Origin="http://evil.example") == 403
        for path in ("/", "/ws", "/static/js/textual.js", "/page/page.css", "/download/x"):
            for headers in (evil, {"Host": "evil.example"}):
                status, text = await served.ask(path, **headers)
                assert status == 403, path
                assert "evil.example" in text
        assert not served.told

    serve(script)


def test_a_session_without_an_origin_is_refused(serve):
    async def script(served):
        status, text = await served.ask("/ws")
        assert status == 403
        assert "which page it comes from" in text

    serve(script)


def test_what_is_no_http_is_turned_away_without_a_word(serve, caplog):
    async def script(served):
        for nonsense in (b"\x16\x03\x01\x02\x00\r\n\r\n", b"GET /" + b"a" * 20_000 + b" HTTP/1.1\r\n\r\n"):
            reader, writer = await asyncio.open_connection("127.0.0.1", served.port)
            writer.write(nonsense)
            assert b" 400 " in await reader.readline()
            writer.close()

    serve(script)
    assert not caplog.records


def test_what_a_foreign_name_says_is_shown_as_text(serve):
    async def script(served):
        _, text = await served.ask(Host="<script>alert(1)</script>")
        assert "<script>" not in text

    serve(script)


def test_beyond_the_limit_a_page_says_so_and_the_next_one_finds_the_place_free(serve):
    async def script(served):
        async with served.visit() as first:
            await first.see("at home")
            status, text = await served.ask()
            assert status == 503
            assert "All places are taken" in text
            assert await served.knock() == 503
        await served.until_empty()
        assert (await served.ask())[0] == 200

    serve(script, places=1)


def test_a_page_loaded_anew_takes_the_place_of_its_former_self(serve):
    cookie = "0123456789abcdef01234567"

    async def script(served):
        async with served.visit(cookie) as first:
            await first.see("at home")
            assert (await served.ask(Cookie=f"kinlab={cookie}"))[0] == 200
            async with served.visit(cookie) as second:
                await second.see(f"at home in {cookie}")
                await first.until_closed()
                assert len(served.server.sessions) == 1

    serve(script, places=1)


def test_a_page_loaded_anew_leaves_the_visitors_other_pages_alone(serve):
    cookie = "0123456789abcdef01234567"

    async def script(served):
        async with served.visit(cookie) as other:
            await other.see("at home")
            async with served.visit(cookie) as first:
                await first.see("at home")
            async with served.visit(cookie) as second:
                await second.see("at home")
            await other.type("still here")
            await other.see("still here")

    serve(script)


def test_each_visitor_has_a_folder_and_the_same_browser_finds_it_again(serve):
    async def script(served):
        async with served.visit() as one, served.visit("0123456789abcdef01234567") as two:
            first = (await one.see("at home in")).partition("at home in ")[2].split()[0]
            await two.see("at home in 0123456789abcdef01234567")
            assert len(first) == 24
            assert first != "0123456789abcdef01234567"
        async with served.visit(first) as again:
            await again.see(f"at home in {first}")
        # A name is as good as a key, and whoever runs the server may show its terminal to a class.
        assert served.told
        assert not any(first in line for line in served.told)

    serve(script)


@pytest.mark.parametrize("cookie", ["../../etc", "0123456789ABCDEF01234567", "x" * 5000, "..%2f"])
def test_a_cookie_that_was_not_given_out_names_no_folder(serve, cookie):
    async def script(served):
        async with served.visit(cookie) as visitor:
            seen = (await visitor.see("at home in")).partition("at home in ")[2].split()[0]
            assert seen != cookie
            assert len(seen) == 24

    serve(script)


def test_an_end_lets_every_session_leave_in_order(serve):
    async def script(served):
        visits = [served.visit(f"{i:024x}") for i in range(2)]
        for i, visit in enumerate(visits):
            await (await visit.__aenter__()).see(f"at home in {i:024x}")
        await served.server.on_shutdown(None)
        for visit in visits:
            await visit.__aexit__(None, None, None)
        async with asyncio.timeout(60):
            while len(served.told) < 4:
                await asyncio.sleep(0.01)
        assert [(served.folders / f"{i:024x}" / "left").read_text() for i in range(2)] == ["in order"] * 2

    serve(script)


def test_a_program_that_fails_ends_the_session_and_not_the_server(serve, capfd):
    async def script(served):
        served.server._words = (sys.executable, "-c", "import sys; sys.exit('broken')")
        async with served.visit() as visitor:
            await visitor.until_closed()
        assert (await served.ask())[0] == 200

    serve(script)
    # Standard output is the server's own, which may be a JSON document.
    assert capfd.readouterr() == ("", "broken\n")


def test_a_program_that_cannot_be_started_is_told_and_the_place_is_free_again(serve, caplog):
    async def script(served):
        served.server._words = ("/no/such/program",)
        async with served.visit("0123456789abcdef01234567") as visitor:
            await visitor.until_closed()
        assert "a session cannot begin: No such file or directory (01234567)" in served.told
        await served.until_empty()

    serve(script)
    assert not caplog.records


def test_what_is_no_message_is_passed_over(serve):
    async def script(served):
        async with served.visit() as visitor:
            for nonsense in (
                "x",
                "1",
                "{}",
                "[]",
                '["stdin"]',
                '["stdin", 1]',
                '["resize", {"width": "x"}]',
                "[[]]",
                "[" * 100_000,
            ):
                await visitor.line.send_str(nonsense)
            await visitor.line.send_bytes(b"\xff")
            await visitor.line.send_str(json.dumps(["resize", {"width": 10**9, "height": 10**9}]))
            await visitor.line.send_str(json.dumps(["resize", {"width": 80, "height": 24}]))
            await visitor.type("\ud800still here")
            await visitor.see("still here", "at home")

    serve(script)


def test_a_screen_has_a_size_that_a_screen_may_have():
    assert fitting(10**9, 10**9) == LARGEST
    assert fitting(-1, 0) == SMALLEST
    assert fitting(80, 24) == (80, 24)


def test_the_size_of_a_screen_comes_from_the_server_alone(monkeypatch):
    """Terminals may tell their size among the keys as well; from a guest that would be one without bounds."""
    passed = []
    monkeypatch.setattr(Driver, "process_message", lambda self, message: passed.append(message))
    driver = GuestDriver.__new__(GuestDriver)
    key = Key("a", "a")
    driver.process_message(Resize(Size(10**5, 10**5), Size(10**5, 10**5)))
    driver.process_message(key)
    assert passed == [key]


def test_a_session_draws_as_the_page_can_whatever_terminal_the_server_has(monkeypatch, tmp_path):
    monkeypatch.setenv("TERM", "linux")
    monkeypatch.setenv("PYTHONUTF8", "0")
    monkeypatch.delenv("KINLAB_ASCII", raising=False)
    environment = Session((), "visitor", tmp_path, web.WebSocketResponse())._build_environment(80, 24)
    assert environment["PYTHONUTF8"] == "1"
    monkeypatch.setenv("TERM", environment["TERM"])
    assert not without_braille()


def test_the_cookie_is_the_browsers_own_secret_and_comes_along_by_a_link_from_elsewhere(serve):
    async def script(served):
        async with aiohttp.ClientSession() as client, client.get(f"http://{served.place}/") as answer:
            cookie = answer.cookies["kinlab"]
        assert cookie["httponly"]
        assert cookie["samesite"] == "Lax"

    serve(script)


@pytest.mark.parametrize("path", ["/", "/page/page.js", "/ws", "/nowhere"])
def test_the_browser_is_told_to_ask_nobody_else_and_to_show_no_page_within_another(serve, path):
    async def script(served):
        async with aiohttp.ClientSession() as client, client.get(f"http://{served.place}{path}") as answer:
            policy = answer.headers["Content-Security-Policy"]
            assert answer.headers["X-Content-Type-Options"] == "nosniff"
        assert policy.startswith("default-src 'self';")
        assert "frame-ancestors 'none'" in policy
        assert "http" not in policy

    serve(script)


def test_no_folder_is_listed_and_nothing_beside_it_is_given_out(serve):
    async def script(served):
        for path in ("/static/", "/static", "/page/", "/static/%2e%2e/server.py", "/page/..%2fserver.py"):
            status, text = await served.ask(path)
            assert status in (403, 404)
            assert "import" not in text

    serve(script)


def test_the_page_names_nothing_outside_and_lets_nothing_in(serve):
    async def script(served):
        status, page = await served.ask()
        _, style = await served.ask("/page/page.css")
        _, script_ = await served.ask("/page/page.js")
        assert status == 200
        assert "//" not in (page + style + script_).replace(f"ws://{served.place}/ws", "").replace(
            "// Keys", ""
        )

    serve(script)


def test_a_program_that_does_not_go_is_ended_by_force_and_holds_its_place_until_then(serve, monkeypatch):
    monkeypatch.setattr("kinlab.tui.web.session.PATIENCE", 0.2)

    async def script(served):
        stubborn = "import sys, time; print('__GANGLION__', flush=True)\nwhile True: time.sleep(1)"
        served.server._words = (sys.executable, "-c", stubborn)
        async with served.visit() as visitor:
            async with asyncio.timeout(60):
                while not served.server.sessions:
                    await asyncio.sleep(0.01)
            (session,) = served.server.sessions
            assert not visitor.line.closed
        await served.until_empty()
        assert session._process.returncode is not None

    serve(script)


def test_a_program_that_takes_in_nothing_does_not_hold_its_place_for_ever(serve, monkeypatch):
    monkeypatch.setattr("kinlab.tui.web.session.PATIENCE", 0.2)
    monkeypatch.setattr("kinlab.tui.web.session.DEAF", 0.2)

    async def script(served):
        deaf = "import time; print('__GANGLION__', flush=True)\nwhile True: time.sleep(1)"
        served.server._words = (sys.executable, "-c", deaf)
        async with served.visit() as visitor:
            with suppress(ConnectionError):
                for _ in range(6):  # more than a pipe holds
                    await visitor.type("x" * 50_000)
            await visitor.until_closed()
        await served.until_empty()

    serve(script)
