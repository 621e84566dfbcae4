"""The server of `kinlab serve`: a page, and behind it a process for each visitor."""

import asyncio
import logging
import re
import secrets
import signal
from collections.abc import Awaitable, Callable, Sequence
from contextlib import suppress
from html import escape
from pathlib import Path
from string import Template

from aiohttp import WSCloseCode, web
from aiohttp.http_exceptions import HttpProcessingError
from textual_serve.server import Server, to_int

from kinlab.endings import endings
from kinlab.errors import KinlabError
from kinlab.language import words_of
from kinlab.tui.web.gate import Gate
from kinlab.tui.web.session import PATIENCE, Session, fitting

PAGE = Path(__file__).parent / "page"
COOKIE = "kinlab"
A_YEAR = 365 * 86_400
# The browser itself sees to it that a page asks for nothing from elsewhere, and stands in no other page.
POLICY = (
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; "
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
)
HEADERS = {
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-cache",
}

LOG = logging.getLogger(__name__)
# What is no HTTP (a browser that tries https, somebody who scans for servers) is no failure of this one.
LOG.addFilter(lambda line: not (line.exc_info and isinstance(line.exc_info[1], HttpProcessingError)))

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


class LabServer(Server):
    """The TUI in browsers: textual-serve's server with a gate, a limit, and a folder for each visitor.

    Attributes:
        sessions: those that are open, the oldest first.
    """

    def __init__(
        self,
        command: Sequence[str],
        *,
        host: str,
        port: int,
        places: int,
        folders: Path,
        language: str,
        say: Callable[[str], None],
    ) -> None:
        """Set up.

        Args:
            command: the program that a visitor uses, and its arguments.
            port: 0 for any that is free.
            places: how many sessions there may be at a time.
            folders: where each visitor's folder lies.
            say: for lines that tell whoever runs the server what happens.
        """
        super().__init__("", host, port, title="KinLab")
        self.sessions: list[Session] = []
        self._words = command
        self._gate = Gate.of(host)
        self._places = places
        self._folders = folders
        self._language = language
        self._tell = say

    # Life and end.

    async def run(self, ready: Callable[[int], None]) -> None:
        """Serve until a signal comes; `ready` is told the port.

        Raises:
            KinlabError: the port cannot be had.
        """
        runner = web.AppRunner(await self._make_app(), logger=LOG, shutdown_timeout=2 * PATIENCE)
        await runner.setup()
        try:
            site = web.TCPSite(runner, self.host, self.port)
            try:
                await site.start()
            except (OSError, OverflowError, UnicodeError) as error:
                raise KinlabError(_no_port(self.host, self.port, error)) from None
            over = asyncio.Event()
            for ending in (signal.SIGINT, *endings()):
                # Where a loop takes no signals, Ctrl-C cancels this task.
                with suppress(NotImplementedError):
                    asyncio.get_running_loop().add_signal_handler(ending, over.set)
            ready(runner.addresses[0][1])
            await over.wait()
        finally:
            await runner.cleanup()

    async def _make_app(self) -> web.Application:
        app = web.Application(middlewares=[self._guard])
        app.add_routes(
            [
                web.get("/", self.handle_index),
                web.get("/ws", self.handle_websocket),
                web.static("/page", PAGE),
                web.static("/static", self.statics_path),
            ]
        )
        app.on_response_prepare.append(_add_headers)
        app.on_shutdown.append(self.on_shutdown)
        return app

    async def on_shutdown(self, app: web.Application) -> None:
        """End all sessions."""
        await asyncio.gather(
            *(s.socket.close(code=WSCloseCode.GOING_AWAY) for s in self.sessions), return_exceptions=True
        )

    # The gate.

    @web.middleware
    async def _guard(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        headers = request.headers
        wrong = self._gate.objection(
            headers.get("Host"), headers.get("Origin"), needs_origin=request.path == "/ws"
        )
        if wrong:
            return self._notice(403, wrong, host=headers.get("Host", "?"), origin=headers.get("Origin", "?"))
        return await handler(request)

    def _has_room_for(self, visitor: str) -> bool:
        return len(self.sessions) < self._places or any(s.visitor == visitor for s in self.sessions)

    # Pages.

    def _say(self, key: str, **values: object) -> str:
        return words_of("kinlab.tui.web").say(self._language, key, **values)

    def _fill(self, name: str, **values: str) -> str:
        text = (PAGE / name).read_text(encoding="utf-8")
        return Template(text).substitute(
            {key: escape(value) for key, value in values.items()}, language=self._language
        )

    def _notice(self, status: int, reason: str, **values: str) -> web.Response:
        text = self._fill(
            "notice.html",
            title=self._say(f"{reason}.title"),
            text=self._say(f"{reason}.text", **values),
            again=self._say("retry"),
        )
        headers = {"Retry-After": "30"} if status == 503 else {}
        return web.Response(status=status, text=text, content_type="text/html", headers=headers)

    async def handle_index(self, request: web.Request) -> web.StreamResponse:
        """The page, or word that there is no room."""
        visitor = _visitor(request)
        if not self._has_room_for(visitor):
            return self._notice(503, "full", places=str(self._places))
        size = min(max(to_int(request.query.get("fontsize", "16"), 16), 6), 60)
        text = self._fill(
            "index.html",
            websocket=f"ws://{request.host}/ws",
            size=str(size),
            opening=self._say("opening"),
            ended=self._say("ended"),
            again=self._say("again"),
        )
        # Not every browser counts a websocket to the page's own server among 'self'.
        policy = f"{POLICY}; connect-src 'self' ws://{request.host}"
        response = web.Response(
            text=text, content_type="text/html", headers={"Content-Security-Policy": policy}
        )
        _remember(response, visitor)
        return response

    # Sessions.

    def _report(self, key: str, visitor: str, **values: object) -> None:
        # Part of a name: whoever reads all of it over a shoulder could come under it.
        places = {"count": len(self.sessions), "places": self._places}
        self._tell(self._say(key, visitor=visitor[:8], **places, **values))

    async def handle_websocket(self, request: web.Request) -> web.WebSocketResponse:
        """A session, from the first byte to the last."""
        visitor = _visitor(request)
        while len(self.sessions) >= self._places:
            # A page that is loaded anew takes the place of its former self, once that has left it.
            own = [session for session in self.sessions if session.visitor == visitor]
            if not own:
                raise web.HTTPServiceUnavailable(text=self._say("full.title"))
            former = next((session for session in own if session.socket.closed), own[0])
            await former.socket.close()
            await former.over.wait()
        socket = web.WebSocketResponse(heartbeat=15, timeout=PATIENCE, max_msg_size=1 << 20)
        _remember(socket, visitor)
        session = Session(self._words, visitor, self._folders / visitor, socket)
        self.sessions.append(session)
        try:
            self._report("begins", visitor)
            await socket.prepare(request)
            query = request.query
            size = fitting(to_int(query.get("width", ""), 80), to_int(query.get("height", ""), 24))
            try:
                await session.start(*size)
            except OSError as error:
                self._report("fails", visitor, cause=error.strerror or error)
            else:
                await session.attend()
        finally:
            # A place is free when the process is gone: else whoever comes and goes in haste piles them up.
            try:
                await session.stop()
            finally:
                self.sessions.remove(session)
                session.over.set()
            self._report("ends", visitor)
        return socket


def _visitor(request: web.Request) -> str:
    """Whose browser it is: what its cookie says, or a new name that nobody can guess."""
    known = request.cookies.get(COOKIE, "")
    return known if re.fullmatch("[0-9a-f]{24}", known) else secrets.token_hex(12)


def _remember(response: web.StreamResponse, visitor: str) -> None:
    # Not "Strict": by a link on another page a visitor would come as somebody new, and find nothing of theirs.
    response.set_cookie(COOKIE, visitor, max_age=A_YEAR, httponly=True, samesite="Lax")


async def _add_headers(request: web.Request, response: web.StreamResponse) -> None:
    response.headers.update(HEADERS)
    response.headers.setdefault("Content-Security-Policy", POLICY)


def _no_port(host: str, port: int, error: Exception) -> str:
    import errno

    number = getattr(error, "errno", None)
    if number == errno.EADDRINUSE:
        return f"another program has port {port}; take another: kinlab serve --port {port + 1}"
    if number == errno.EACCES:
        return f"port {port} is for the system's own servers; take one above 1023: kinlab serve --port 8000"
    if isinstance(error, UnicodeError):
        return f"{host} is no address"
    return f"cannot listen on {host}, port {port}: {getattr(error, 'strerror', None) or error}"
