"""One visitor's session: a process of its own, which the websocket feeds and listens to."""

import asyncio
import json
from collections.abc import Awaitable, Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from aiohttp import WSMsgType, web
from textual_serve.app_service import AppService
from textual_serve.download_manager import DownloadManager

from kinlab.guests import GUEST

PATIENCE = 3.0  # s for a process to end by itself
DEAF = 30.0  # s without taking in what is typed, after which a process is given up
LARGEST = (400, 150)  # columns and rows; a screen beyond takes memory and no eyes
SMALLEST = (10, 5)


class Session(AppService):
    """The TUI for one visitor.

    Attributes:
        visitor: whose browser it is.
        socket: what leads there.
        over: set when nothing of it is left.
    """

    def __init__(
        self,
        command: Sequence[str],
        visitor: str,
        home: Path,
        socket: web.WebSocketResponse,
    ) -> None:
        """Set up.

        Args:
            command: the program and its arguments.
            home: the visitor's folder.
        """
        super().__init__(
            "",
            write_bytes=_unless_gone(socket.send_bytes),
            write_str=_unless_gone(socket.send_str),
            close=_unless_gone(socket.close),
            download_manager=DownloadManager(),
        )
        self.visitor = visitor
        self.socket = socket
        self.over = asyncio.Event()
        self._words = command
        self._home = home

    def _build_environment(self, width: int = 80, height: int = 24) -> dict[str, str]:
        environment: dict[str, str] = super()._build_environment(width, height)
        environment["TEXTUAL_DRIVER"] = "kinlab.tui.web.driver:GuestDriver"
        # The terminal is the page's, whatever the one is in which the server was started.
        environment |= {"TERM": "xterm-256color", "PYTHONUTF8": "1"}
        return environment | {GUEST: "1", "KINLAB_HOME": str(self._home)}

    async def _open_app_process(self, width: int = 80, height: int = 24) -> asyncio.subprocess.Process:
        # Without a shell; and out of reach of the Ctrl-C that ends the server, which ends its sessions in order.
        self._process = process = await asyncio.create_subprocess_exec(
            *self._words,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            env=self._build_environment(width, height),
            start_new_session=True,
        )
        self._stdin = process.stdin
        return process

    async def run(self) -> None:
        """Pass on what the program shows, until it ends; then the browser hears of it.

        It cannot have the browser open or load anything else. What it has to say at its end goes to the
        server's own standard error.
        """
        with suppress(asyncio.IncompleteReadError, asyncio.LimitOverrunError, ConnectionError, ValueError):
            await self._pass_on()
        await self.remote_close()

    async def _pass_on(self) -> None:
        assert self._process is not None
        assert self._process.stdout is not None
        shown = self._process.stdout
        await shown.readuntil(b"__GANGLION__\n")
        while True:
            kind = await shown.readexactly(1)
            payload = await shown.readexactly(int.from_bytes(await shown.readexactly(4), "big"))
            if kind == b"D":
                await self.remote_write_bytes(payload)
            elif kind == b"M" and json.loads(payload) == {"type": "exit"}:
                return

    async def stop(self) -> None:
        """End the program, by force if it does not go by itself."""
        with suppress(TimeoutError):
            await asyncio.wait_for(super().stop(), PATIENCE)
        process, self._task = self._process, None
        if process is None:
            return
        try:
            with suppress(TimeoutError):
                await asyncio.wait_for(process.wait(), PATIENCE)
        finally:
            if process.returncode is None:
                process.kill()
        await process.wait()
        self.stdin.close()

    async def attend(self) -> None:
        """Pass on what the visitor types and clicks, until the connection ends or the process takes in no more of it.

        What is no message is passed over.
        """
        async for message in self.socket:
            if message.type != WSMsgType.TEXT:
                continue
            try:
                said = message.json()
            except (ValueError, RecursionError):
                continue
            try:
                await asyncio.wait_for(self._hear(said), DEAF)
            except TimeoutError:
                return

    async def _hear(self, said: Any) -> None:
        match said:
            case ["stdin", str(text)]:
                await self.send_bytes(text.encode(errors="replace"))
            case ["resize", {"width": int(width), "height": int(height)}]:
                await self.set_terminal_size(*fitting(width, height))
            case ["ping", str(token)]:
                await self.socket.send_json(["pong", token])
            case ["blur"]:
                await self.blur()
            case ["focus"]:
                await self.focus()


def fitting(width: int, height: int) -> tuple[int, int]:
    """A size that a screen may have, near to the one that was asked for."""
    return (
        min(max(width, SMALLEST[0]), LARGEST[0]),
        min(max(height, SMALLEST[1]), LARGEST[1]),
    )


def _unless_gone(send: Callable[..., Awaitable[object]]) -> Callable[..., Awaitable[None]]:
    """`send`, for which it is no matter that the browser has left meanwhile."""

    async def attempt(*what: Any) -> None:
        with suppress(ConnectionError, RuntimeError):
            await send(*what)

    return attempt
