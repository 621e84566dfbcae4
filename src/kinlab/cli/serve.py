"""`kinlab serve`: the laboratory in a browser."""

import os
import sys
from contextlib import suppress
from typing import Annotated

import typer

from kinlab.cli.command import JsonOption, NumericCommand, RobotsOption, command_app, print_json

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab serve --sessions 30 --host 0.0.0.0")
def serve(
    host: Annotated[
        str,
        typer.Option(
            help="Address to listen on. The default is for this machine alone; 0.0.0.0 lets in everybody "
            "who reaches it over the network, without a password and without encryption."
        ),
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="0: any that is free.")] = 8000,
    sessions: Annotated[
        int, typer.Option(help="How many there may be at a time; each takes about 75 MB.")
    ] = 8,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """The laboratory in a browser: for oneself, or for a class.

    Each visitor gets a session of their own, with progress and settings in a
    folder of its own, which the same browser finds again. The command says
    where these folders lie; they stay until you delete them. Sessions reach
    no serial port, no network, and no file outside their folder. Needs the
    extra kinlab[serve]. Ctrl-C ends all of them.
    """
    import asyncio

    from kinlab.errors import FileError, KinlabError, UsageError
    from kinlab.files import own_folder
    from kinlab.language import language
    from kinlab.robots import robot_names
    from kinlab.shipped import install_line

    try:
        from kinlab.tui.web.server import LabServer
    except ImportError as error:
        if (error.name or "").startswith("kinlab"):
            raise
        raise KinlabError(f"this needs textual-serve; {install_line('serve')}") from None
    if not host:
        raise UsageError("--host is an address: 127.0.0.1 for this machine alone, 0.0.0.0 for everybody")
    if sessions < 1:
        raise UsageError(f"--sessions is a number from 1 on, not {sessions}")
    if not 0 <= port <= 65535:
        raise UsageError(f"--port is a number from 0 to 65535, not {port}")
    robot_names(robots)
    if robots:
        os.environ["KINLAB_ROBOTS"] = str(robots.resolve())
    folders = own_folder().resolve() / "visitors"
    try:
        # Their names are what visitors come under: nobody else on this machine is to read them.
        folders.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(
            f"{folders}: cannot be made: {error.strerror}; $KINLAB_HOME can name another folder"
        ) from None

    def ready(number: int) -> None:
        if json:
            print_json({"url": _address(host, number), "sessions": sessions, "folders": str(folders)})
        else:
            _announce(host, number, sessions)
            typer.echo(f"Progress and settings of each visitor, until you delete them: {folders}/NAME")
            typer.echo("Ctrl-C ends all sessions.")
        _warn(host)
        sys.stdout.flush()

    def say(text: str) -> None:
        # A class goes on though nobody reads along any more.
        with suppress(OSError):
            typer.echo(text, err=True)

    server = LabServer(
        # -P: nothing that lies where the server was started is taken for a module.
        [sys.executable, "-P", "-m", "kinlab.tui"],
        host=host,
        port=port,
        places=sessions,
        folders=folders,
        language=language(),
        say=say,
    )
    with suppress(KeyboardInterrupt):
        asyncio.run(server.run(ready))


def _address(host: str, port: int) -> str:
    """What to type into a browser."""
    if host in ("0.0.0.0", "::"):
        host = _own_number(host)
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def _own_number(host: str) -> str:
    """This machine's address in its network, as other machines seldom know its name; its name where it has none."""
    import socket

    # Nothing is sent: the system only chooses the way to there. Nobody has these addresses (RFC 5737, RFC 3849).
    family, far = (socket.AF_INET6, "2001:db8::1") if host == "::" else (socket.AF_INET, "203.0.113.1")
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as way:
            way.connect((far, 9))
            return str(way.getsockname()[0])
    except OSError:
        return socket.gethostname()


def _announce(host: str, port: int, sessions: int) -> None:
    """Where it is, and for whom."""
    from kinlab.tui.web.gate import is_loopback

    people = "one visitor" if sessions == 1 else f"{sessions} visitors"
    alone = ", on this machine alone" if is_loopback(host) else ""
    typer.echo(f"KinLab is at {_address(host, port)} for {people} at a time{alone}.")


def _warn(host: str) -> None:
    """Say what an address exposes that others can reach."""
    from kinlab.tui.web.gate import is_loopback

    if not is_loopback(host):
        typer.echo(
            "Everybody who reaches this machine over the network can use it: there is no password, and nothing\n"
            "is encrypted. They run KinLab on this machine, as you, but reach no serial port and only files of\n"
            "their own. Do this in a network that you trust; from outside, let people in through ssh.",
            err=True,
        )
