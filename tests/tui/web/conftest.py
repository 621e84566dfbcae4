"""A server in this process, and visitors who look at their screens through a terminal emulator."""

import asyncio
import json
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path

import aiohttp
import pyte
import pytest

from kinlab.tui.web.server import LabServer

LAB = (sys.executable, "-m", "kinlab.tui")
# Starts at once, shows where it keeps its things, and says when it leaves in order.
SMALL = """
import os
from pathlib import Path
from textual.app import App
from textual.widgets import Input, Static
class Small(App):
    def compose(self):
        yield Input()
        yield Static(f"at home in {Path(os.environ['KINLAB_HOME']).name}", markup=False)
    def exit(self):
        home = Path(os.environ["KINLAB_HOME"])
        home.mkdir(parents=True, exist_ok=True)
        (home / "left").write_text("in order")
        super().exit()
Small().run()
"""
PATIENCE = 60.0  # s for a program to start on a busy machine


class Served:
    """A server that runs.

    Attributes:
        told: what it told whoever runs it.
    """

    def __init__(self, server: LabServer, port: int, folders: Path, told: list[str]) -> None:
        self.server, self.port, self.folders, self.told = server, port, folders, told
        self.place = f"127.0.0.1:{port}"

    async def ask(self, path: str = "/", **headers: str) -> tuple[int, str]:
        """Status and text of a page."""
        async with (
            aiohttp.ClientSession() as client,
            client.get(f"http://{self.place}{path}", headers=headers) as answer,
        ):
            return answer.status, await answer.text(errors="replace")

    async def knock(self, **headers: str) -> int:
        """The status with which a websocket is refused; 101 where it is not."""
        try:
            async with self.visit(**headers):
                return 101
        except aiohttp.WSServerHandshakeError as refusal:
            return refusal.status

    async def until_empty(self) -> None:
        """Wait until every session is over."""
        async with asyncio.timeout(PATIENCE):
            while self.server.sessions:
                await asyncio.sleep(0.01)

    @asynccontextmanager
    async def visit(
        self, cookie: str = "", size: tuple[int, int] = (80, 24), **headers: str
    ) -> AsyncIterator["Visitor"]:
        """A session, as the page opens it."""
        headers = {"Origin": f"http://{self.place}", **headers}
        if cookie:
            headers["Cookie"] = f"kinlab={cookie}"
        url = f"ws://{self.place}/ws?width={size[0]}&height={size[1]}"
        async with aiohttp.ClientSession() as client, client.ws_connect(url, headers=headers) as line:
            yield Visitor(line, size)


class Visitor:
    """One who types, and sees what a terminal would show."""

    def __init__(self, line: aiohttp.ClientWebSocketResponse, size: tuple[int, int]) -> None:
        self.line = line
        self.screen = pyte.Screen(*size)
        self._stream = pyte.ByteStream(self.screen)

    @property
    def rows(self) -> list[str]:
        """The screen."""
        return [row.rstrip() for row in self.screen.display]

    async def type(self, text: str) -> None:
        """Send keys."""
        await self.line.send_str(json.dumps(["stdin", text]))

    async def see(self, *texts: str) -> str:
        """Wait until all of these stand on the screen; the screen."""
        with suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE):
                while not all(text in "\n".join(self.rows) for text in texts):
                    message = await self.line.receive()
                    if message.type in (aiohttp.WSMsgType.CLOSED, aiohttp.WSMsgType.CLOSE):
                        break
                    if message.type == aiohttp.WSMsgType.BINARY:
                        self._stream.feed(message.data)
        seen = "\n".join(self.rows)
        missing = [text for text in texts if text not in seen]
        assert not missing, f"{missing} not on the screen:\n{seen}"
        return seen

    async def until_closed(self) -> None:
        """Wait until the other end hangs up."""
        async with asyncio.timeout(PATIENCE):
            async for _ in self.line:
                pass


Script = Callable[[Served], Awaitable[None]]


@pytest.fixture
def serve(tmp_path: Path) -> Callable[..., None]:
    """`serve(script, places=2, small=True)`: a script against a server, whose program is small or the laboratory."""

    def run(script: Script, places: int = 2, small: bool = True) -> None:
        async def life() -> None:
            told: list[str] = []
            folders = tmp_path / "visitors"
            command = (sys.executable, "-c", SMALL) if small else LAB
            server = LabServer(
                command,
                host="127.0.0.1",
                port=0,
                places=places,
                folders=folders,
                language="en",
                say=told.append,
            )
            port: asyncio.Future[int] = asyncio.get_running_loop().create_future()
            task = asyncio.create_task(server.run(port.set_result))
            await asyncio.wait({port, task}, return_when=asyncio.FIRST_COMPLETED)
            try:
                await script(Served(server, port.result(), folders, told))
            finally:
                task.cancel()
                with suppress(asyncio.CancelledError):
                    await task

        asyncio.run(life())

    return run
