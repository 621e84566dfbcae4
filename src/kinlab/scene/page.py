"""rerun's page for the browser, passed on with a header that keeps it on this machine.

The page asks for fonts and news, and reports its use, unless it is told to reach nothing but loopback.
"""

import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from http.client import HTTPConnection, HTTPResponse
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread

LOOPBACK = "127.0.0.1"
POLICY = (
    "default-src 'self' 'unsafe-inline' 'unsafe-eval' data: blob:; "
    f"connect-src 'self' http://{LOOPBACK}:* ws://{LOOPBACK}:* data: blob:"
)
PASSED = ("Content-Type", "Content-Length", "Content-Encoding")
# How long the viewer may take to answer at first, s, how often it is tried, s, and what is passed on at once, bytes.
STARTING, AGAIN, PIECE = 30.0, 0.1, 1 << 16


@contextmanager
def passed_on(behind: int, port: int) -> Iterator[None]:
    """Serve on `port` what another server on this machine has behind port `behind`."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            with closing(HTTPConnection(LOOPBACK, behind, timeout=STARTING)) as connection:
                try:
                    answer = _asked(connection, self.path)
                except OSError as error:
                    self.send_error(502, f"the viewer does not answer: {error}")
                    return
                self.send_response(answer.status)
                for name in PASSED:
                    if value := answer.getheader(name):
                        self.send_header(name, value)
                self.send_header("Content-Security-Policy", POLICY)
                self.end_headers()
                # The browser may go away at any time.
                with suppress(ConnectionError):
                    while piece := answer.read(PIECE):
                        self.wfile.write(piece)

        def log_message(self, format: str, *args: object) -> None:  # noqa: A002
            """Nothing: the page is for one person, who sees it."""

    server = ThreadingHTTPServer((LOOPBACK, port), Handler)
    thread = Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield
    finally:
        server.shutdown()
        server.server_close()


def _asked(connection: HTTPConnection, path: str) -> HTTPResponse:
    """The answer of the server behind, which may just be starting."""
    deadline = time.monotonic() + STARTING
    while True:
        try:
            connection.request("GET", path)
            return connection.getresponse()
        except ConnectionRefusedError:
            connection.close()
            if time.monotonic() > deadline:
                raise
            time.sleep(AGAIN)
