"""`kinlab emulate`: a chain of emulated servos for other programs."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kinlab.cli.command import JsonOption, NumericCommand, RobotsOption, command_app, print_json

if TYPE_CHECKING:
    from kinlab.dynamixel.chain import Chain
    from kinlab.dynamixel.serving import Server
    from kinlab.dynamixel.serving.pty import PtyLink

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab emulate xl430-hexapod --pty ./ttyDXL")
def emulate(
    robot: Annotated[
        str | None, typer.Argument(help="Whose chain: its servos with their ids and models.")
    ] = None,
    servo: Annotated[
        list[str] | None,
        typer.Option(metavar="MODEL:ID", help="A servo: AX-12A:1, AX-12A:1-18, 2XL430-W250:1,2."),
    ] = None,
    pty: Annotated[
        Path | None, typer.Option(help="Link to the pty [./ttyDXL, unless --tcp is given].")
    ] = None,
    tcp: Annotated[
        str | None, typer.Option(metavar="[HOST:]PORT", help="Serve TCP; loopback without HOST.")
    ] = None,
    baud: Annotated[int, typer.Option(help="The speed that all servos are set to, in bps.")] = 1_000_000,
    byte_times: Annotated[
        bool, typer.Option("--byte-times", help="Take as long as the bytes on a wire.")
    ] = False,
    eeprom: Annotated[
        Path | None, typer.Option(help="File that keeps the EEPROM from one run to the next.")
    ] = None,
    traffic: Annotated[bool, typer.Option("--traffic", help="Show what goes over the wire.")] = False,
    noise: Annotated[float, typer.Option(help="Chance of a random byte before each byte.")] = 0.0,
    drop: Annotated[float, typer.Option(help="Chance that a byte is lost.")] = 0.0,
    flip: Annotated[float, typer.Option(help="Chance that a byte has a bit turned over.")] = 0.0,
    delay_ms: Annotated[float, typer.Option("--delay", help="By how many ms answers are late.")] = 0.0,
    echo: Annotated[
        bool, typer.Option("--echo", help="Send back what comes in, like a bad adapter.")
    ] = False,
    fault: Annotated[
        list[str] | None,
        typer.Option(metavar="ID:FAULT", help="Break a servo: 1:overload, 2:stuck, 3:dead, '4:baud 57600'."),
    ] = None,
    volts: Annotated[float, typer.Option(help="What the supply gives.")] = 12.0,
    seed: Annotated[int, typer.Option(help="Of the accidents: the same ones each time.")] = 0,
    robots: RobotsOption = None,
    json: JsonOption = False,
) -> None:
    """Servos that other programs take for real ones, until Ctrl-C."""
    from kinlab.dynamixel.chain import Chain, Faults
    from kinlab.dynamixel.chain.eeprom import load_eeprom, save_eeprom
    from kinlab.dynamixel.outfit import modules_of, parse_servo, robot_modules
    from kinlab.dynamixel.sandbox.requests import one_id
    from kinlab.dynamixel.serving import Server
    from kinlab.dynamixel.serving.tcp import TcpListener
    from kinlab.dynamixel.servo.breaking import break_servo
    from kinlab.errors import UsageError

    modules = robot_modules(robot, robots) if robot else []
    modules += modules_of([parse_servo(text) for text in servo or ()])
    if not modules:
        raise UsageError(
            "name a robot, or servos: kinlab emulate xl430-hexapod, kinlab emulate --servo AX-12A:1"
        )
    _check(baud, volts, delay_ms, {"noise": noise, "drop": drop, "flip": flip})
    chain = Chain.of(modules, baud, byte_times)
    chain.faults = Faults(drop, flip, noise, delay_ms / 1000, echo, seed)
    chain.supply.volts = volts
    if eeprom:
        load_eeprom(chain, eeprom)
        # Before anybody relies on it: a file that cannot be written is refused here.
        save_eeprom(chain, eeprom)
    for text in fault or ():
        broken, _, kind = text.partition(":")
        break_servo(chain.servo(one_id(broken)), kind)
    listener = TcpListener(tcp) if tcp else None
    server = Server(
        chain,
        listener,
        watch=_show_traffic if traffic else None,
        after_change=(lambda: _keep(chain, eeprom)) if eeprom else None,
    )
    # The signals first and last: whoever sees the link may end the chain, and then the link goes.
    with _ended_by_signals(server), server:
        link = None
        if pty or not listener:
            link = _link(pty or Path("ttyDXL"), baud)
            server.add(link)
        where = {"pty": str(link.link) if link else None, "tcp": listener.address if listener else None}
        if json:
            servos = [
                {"id": s.id, "model": s.table.model, "protocol": s.protocol, "baud": s.baud}
                for s in chain.servos
            ]
            print_json({"robot": robot, **where, "servos": servos})
        else:
            _announce(chain, where)
        sys.stdout.flush()
        server.run()


@contextmanager
def _ended_by_signals(server: "Server") -> Iterator[None]:
    """Let Ctrl-C, SIGTERM and a closed terminal end the server in its own time, with nothing left half done."""
    from kinlab.endings import endings

    before = {
        number: signal.signal(number, lambda *_: server.stop()) for number in (signal.SIGINT, *endings())
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _link(path: Path, baud: int) -> "PtyLink":
    """A pty with that name, where the system has ptys."""
    from kinlab.errors import UsageError

    try:
        from kinlab.dynamixel.serving.pty import PtyLink
    except ImportError:
        raise UsageError("this system has no ptys; serve TCP: --tcp 5000") from None
    return PtyLink(path, baud)


def _check(baud: int, volts: float, delay_ms: float, chances: dict[str, float]) -> None:
    """Refuse numbers that no bus has."""
    from kinlab.dynamixel.servo import MOST_VOLTS
    from kinlab.errors import UsageError

    if baud <= 0:
        raise UsageError(f"a speed is more than 0 bps, not {baud}")
    for name, chance in chances.items():
        if not 0.0 <= chance <= 1.0:
            raise UsageError(f"--{name} is a chance from 0 to 1, not {chance}")
    if not 0.0 <= volts <= MOST_VOLTS:
        raise UsageError(f"--volts is a supply from 0 to {MOST_VOLTS:g} V, not {volts}")
    if not 0.0 <= delay_ms < float("inf"):
        raise UsageError(f"--delay is a time from 0 ms, not {delay_ms}")


def _keep(chain: "Chain", eeprom: Path) -> None:
    """Keep the EEPROM; the servos go on where that fails, as real ones would."""
    from kinlab.dynamixel.chain.eeprom import save_eeprom
    from kinlab.errors import FileError

    try:
        save_eeprom(chain, eeprom)
    except FileError as error:
        typer.echo(f"kinlab: {error}", err=True)


def _announce(chain: "Chain", where: dict[str, str | None]) -> None:
    """What is there, and how a program gets at it."""
    by_model: dict[str, list[int]] = {}
    for servo in chain.servos:
        by_model.setdefault(servo.table.model, []).append(servo.id)
    for model, ids in by_model.items():
        typer.echo(f"{model:<14} id {', '.join(map(str, ids))}")
    first = chain.servos[0]
    protocols = " and ".join(f"{p}.0" for p in sorted(chain.protocols))
    typer.echo(f"Protocol {protocols}, {first.baud} bps")
    if where["pty"]:
        typer.echo(f'Serial port {where["pty"]}: PortHandler("{where["pty"]}"), setBaudRate({first.baud})')
        typer.echo(f"            or: kinlab bus scan --port {where['pty']} --baud {first.baud}")
    if where["tcp"]:
        typer.echo(f"TCP {where['tcp']}: kinlab bus scan --port {where['tcp']}")
    typer.echo("Ctrl-C ends it.")


def _show_traffic(arrow: str, data: bytes, now: float) -> None:
    typer.echo(f"{now:14.6f} {arrow} {data.hex(' ').upper()}", err=True)
