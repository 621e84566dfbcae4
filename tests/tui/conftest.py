"""The laboratory without a terminal: opened at a size, driven by keys and mouse, looked at as rows of text."""

import asyncio
import gc
import html
import os
import re
from collections.abc import Awaitable, Callable, Iterator
from itertools import count
from pathlib import Path
from typing import Any

import pytest
from textual._context import active_app
from textual.pilot import Pilot

from kinlab.tui.app import KinlabApp

SCREENS = Path(__file__).parent / "screens"
RENEW = "KINLAB_RENEW_SCREENS"
# A run of text in the picture: its place in the line, its line, and the text; and how wide a character is.
TEXT = re.compile(r'<text [^>]*?x="([\d.]+)"[^>]*?-line-(\d+)\)"[^>]*>(.*?)</text>')
CHARACTER = 12.2

LABS = count(1)
ROUNDS = 100  # until an application that never comes to rest is looked at as it is

Script = Callable[[Pilot[None]], Awaitable[Any]]


async def at_rest(*_: float) -> None:
    """Until every message has been dealt with, and the screen is drawn.

    Textual's own way is to wait until the processor rests, which a busy machine seems to do too early, and a screen
    on which something plays never does.
    """
    loop, app = asyncio.get_running_loop(), active_app.get()
    for _ in range(ROUNDS):
        while loop._ready:  # type: ignore[attr-defined]
            await asyncio.sleep(0)
        screen = app.screen_stack[-1] if app.screen_stack else None
        if screen is None:
            return
        if app._resize_event is not None:
            app._check_resize()
        elif not (
            screen._layout_required
            or screen._scroll_required
            or screen._repaint_required
            or screen._recompose_required
            or screen._dirty_widgets
            or screen._callbacks
        ):
            return
        else:
            screen._on_timer_update()
        await asyncio.sleep(0)


@pytest.fixture(autouse=True)
def _no_needless_waiting(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("app", "pilot"):
        monkeypatch.setattr(f"textual.{module}.wait_for_idle", at_rest)


@pytest.fixture(autouse=True)
def _own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Nothing that a person keeps is read or written, and what is seen does not depend on who runs the tests."""
    monkeypatch.setenv("KINLAB_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("KINLAB_LANG", "en")
    monkeypatch.setenv("TEXTUAL_ANIMATIONS", "none")
    for name in ("KINLAB_ROBOTS", "KINLAB_LESSONS", "KINLAB_ASCII", "NO_COLOR"):
        monkeypatch.delenv(name, raising=False)
    yield
    # An application keeps what it has brought for good; here it was one of many.
    gc.unfreeze()
    gc.enable()
    # Left to itself, the search for what they left behind comes when they fill a gigabyte.
    if next(LABS) % 20 == 0:
        gc.collect()


class Lab:
    """What the tests of a station need; the fixture `lab` is one."""

    sizes = ((60, 20), (80, 24), (120, 40))

    @staticmethod
    def drive(script: Script, station: str = "robot", size: tuple[int, int] = (80, 24)) -> KinlabApp:
        """Open a station, let `script` press and click, and leave; anything that fails inside fails the test."""
        app = KinlabApp(station)

        async def run() -> None:
            async with app.run_test(size=size) as pilot:
                await pilot.pause()
                await script(pilot)

        asyncio.run(run())
        return app

    @staticmethod
    async def until(pilot: Pilot[None], true: Callable[[], Any]) -> None:
        """Wait for what other threads and timers bring; what never comes fails the test."""
        async with asyncio.timeout(60):
            while not true():
                await pilot.pause(0.01)

    @staticmethod
    def rows(app: KinlabApp) -> list[str]:
        """The screen as rows of text, from Textual's own exported screenshot."""
        width, height = app.size
        grid = [[" "] * width for _ in range(height)]
        for x, clip, body in TEXT.findall(app.export_screenshot()):
            column = round(float(x) / CHARACTER)
            for i, char in enumerate(html.unescape(body).replace("\xa0", " ")):
                if column + i < width:
                    grid[int(clip)][column + i] = char
        return ["".join(row).rstrip() for row in grid]

    @classmethod
    def text(cls, app: KinlabApp) -> str:
        """The screen as one text."""
        return "\n".join(cls.rows(app))

    @classmethod
    def check_screen(cls, name: str, app: KinlabApp) -> None:
        """Compare the screen with `screens/NAME-WIDTHxHEIGHT.txt`; with $KINLAB_RENEW_SCREENS set, write that file."""
        path = SCREENS / f"{name}-{app.size.width}x{app.size.height}.txt"
        seen = cls.text(app) + "\n"
        if os.environ.get(RENEW):
            SCREENS.mkdir(exist_ok=True)
            path.write_text(seen, encoding="utf-8")
        expected = path.read_text(encoding="utf-8")
        assert seen == expected, f"{path.name} differs; {RENEW}=1 pytest tests/tui writes it anew"


@pytest.fixture
def lab() -> type[Lab]:
    """`lab.drive(script, station, size)`, `lab.rows(app)`, `lab.check_screen(name, app)`."""
    return Lab
