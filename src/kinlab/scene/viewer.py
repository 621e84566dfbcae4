"""rerun's own viewer, in a window or in the browser, on this machine alone."""

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from kinlab.errors import KinlabError, UsageError
from kinlab.files import write_whole
from kinlab.guests import refuse_to_guests
from kinlab.scene.page import LOOPBACK, passed_on
from kinlab.scene.recording import Recording, load_rerun

# rerun's own: where a viewer takes data, and where the browser finds its page.
PORT, PAGE_PORT = 9876, 9090


@dataclass(frozen=True)
class View:
    """How a recording is looked at.

    Attributes:
        browser: a page for the browser, or a window.
        port: where the viewer takes more data, as from a `Mirror`.
        page_port: of the page.
    """

    browser: bool = False
    port: int = PORT
    page_port: int = PAGE_PORT

    @property
    def page(self) -> str:
        """What to open in the browser."""
        return (
            f"http://{LOOPBACK}:{self.page_port}/?url=rerun%2Bhttp%3A%2F%2F{LOOPBACK}%3A{self.port}%2Fproxy"
        )

    @property
    def ports(self) -> dict[str, int]:
        """By the option that chooses them."""
        return {"--port": self.port} | ({"--page-port": self.page_port} if self.browser else {})


def has_display() -> bool:
    """Whether a window can be opened here."""
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def check_viewer(view: View) -> None:
    """Refuse what would not open, before the work that is to be looked at.

    Raises:
        UsageError: a port that is none, or the same one twice.
        KinlabError: rerun or its program is missing, there is no display, a port is taken.
    """
    for option, port in view.ports.items():
        if not 1 <= port <= 65535:
            raise UsageError(f"{option} is a number from 1 to 65535, got {port}")
    if view.browser and view.port == view.page_port:
        raise UsageError(f"--port and --page-port must differ, both are {view.port}")
    load_rerun()
    program()
    if not view.browser and not has_display():
        raise KinlabError(
            "there is no display to open a window on; --serve shows it in a browser, --save FILE.rrd keeps it"
        )
    for option, port in view.ports.items():
        with closing(socket.socket()) as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                probe.bind((LOOPBACK, port))
            except OSError as error:
                raise KinlabError(
                    f"port {port} cannot be used: {error.strerror}; choose another with {option}"
                ) from None


def program() -> Path:
    """The viewer's program, which comes with rerun and need not be on the path.

    Raises:
        KinlabError: it is missing.
    """
    found = find_spec("rerun_cli")
    for folder in (found.submodule_search_locations or []) if found else []:
        for name in ("rerun", "rerun.exe", "Rerun.app/Contents/MacOS/Rerun"):
            if (path := Path(folder, name)).is_file():
                return path
    raise KinlabError(
        f"rerun's viewer is missing; {sys.executable} -m pip install --force-reinstall rerun-sdk brings it back"
    )


@contextmanager
def viewing(what: Recording | Path, view: View) -> Iterator["subprocess.Popen[bytes]"]:
    """A viewer with a recording in it, or with the file of one, closed at the end; its page answers at once.

    Raises:
        UsageError: the user is a guest, who sits elsewhere.
        KinlabError: as `check_viewer`, the viewer has ended with an error, or there is no room for its file.
    """
    refuse_to_guests("a viewer")
    check_viewer(view)
    decline_reports()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(TemporaryDirectory(prefix="kinlab-")))
        file, complaints = folder / "scene.rrd", folder / "complaints"
        if isinstance(what, Path):
            file = what
        else:
            write_whole(file, what.data())
        options = ["--bind", LOOPBACK, "--port", str(view.port), "--hide-welcome-screen"]
        if view.browser:
            inner = free_port()
            options += ["--serve-web", "--web-viewer-port", str(inner)]
            stack.enter_context(passed_on(inner, view.page_port))
        with complaints.open("wb") as said:
            viewer = subprocess.Popen(
                [program(), file, *options], env={"RUST_LOG": "error", **os.environ},
                stdin=subprocess.DEVNULL, stdout=said, stderr=said,
            )  # fmt: skip
        try:
            yield viewer
            # Ctrl-C reaches the viewer too: how it ended then is no complaint.
            ended = viewer.poll()
        finally:
            viewer.terminate()
            viewer.wait()
        if ended:
            lines = [line for line in complaints.read_text(errors="replace").splitlines() if line.strip()]
            # Where a window cannot be drawn, a page often can.
            instead = "" if view.browser else "; --serve shows it in a browser"
            reason = lines[-1].rstrip(".") if lines else "no reason given"
            raise KinlabError(f"the viewer ended with code {ended}: {reason}{instead}")


def free_port() -> int:
    """A port of this machine that nobody uses now."""
    with closing(socket.socket()) as probe:
        probe.bind((LOOPBACK, 0))
        return int(probe.getsockname()[1])


def decline_reports() -> None:
    """Decline, where nobody has chosen yet, that the viewer reports its use to its makers; it does unless told."""
    from platformdirs import user_config_path

    choice = user_config_path("rerun", appauthor=False, roaming=True) / "analytics.json"
    if sys.platform == "win32":
        choice = choice.parent / "config" / choice.name
    if not choice.exists():
        subprocess.run([program(), "analytics", "disable"], capture_output=True, check=False)
