"""`kinlab bus`: scan, read, write and monitor the servos on a port."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kinlab.cli.command import JsonOption, NumericCommand, command_app, print_json

if TYPE_CHECKING:
    from kinlab.dynamixel import Bus

Port = Annotated[
    str,
    typer.Option(
        help="/dev/ttyUSB0, ./ttyDXL, HOST:PORT, or emu:ROBOT for a chain in memory.", show_default=False
    ),
]
Baud = Annotated[int, typer.Option(help="Speed in bps.")]
Unit = Annotated[str | None, typer.Option(help="deg, rad, rpm, %, V, degC; without: ticks.")]

app = command_app()


@app.callback(no_args_is_help=True, epilog="Example: kinlab bus scan --port /dev/ttyUSB0 --baud 57600")
def _bus() -> None:
    """Talk to servos on a serial port, a pty, TCP, or an emulated chain in memory.

    Every command takes --json.
    """


def _open(port: str, baud: int) -> "Bus":
    from kinlab.dynamixel import Bus
    from kinlab.errors import UsageError

    if baud <= 0:
        raise UsageError(f"a speed is more than 0 bps, not {baud}")
    return Bus(port, baud)


@app.command("scan", cls=NumericCommand, epilog="Example: kinlab bus scan --port emu:krsri-hexapod")
def _scan(
    port: Port,
    baud: Baud = 1_000_000,
    ids: Annotated[str, typer.Option(help="Which ids to ask.")] = "0-253",
    json: JsonOption = False,
) -> None:
    """Find the servos; exit code 1 if there are none."""
    from kinlab.dynamixel.outfit import parse_ids

    with _open(port, baud) as bus:
        _say_searching(baud)
        found = bus.scan(parse_ids(ids))
    rows = [
        {
            "id": f.id,
            "model": f.model,
            "model_number": f.number,
            "protocol": f.protocol,
            "firmware": f.firmware,
        }
        for f in found
    ]
    if json:
        print_json({"port": port, "baud": baud, "servos": rows})
    else:
        for f in found:
            typer.echo(f"{f.id:>4}  {f.model:<14} Protocol {f.protocol}.0  firmware {f.firmware}")
    if not found:
        typer.echo(f"nobody answers on {port} at {baud} bps", err=True)
        raise typer.Exit(1)


@app.command(
    "read",
    cls=NumericCommand,
    epilog="Example: kinlab bus read 1 present_position --unit deg --port ./ttyDXL",
)
def _read(
    servo: Annotated[int, typer.Argument(help="The servo's id.")],
    register: Annotated[str, typer.Argument(help="A register's name, or its address.")],
    port: Port,
    baud: Baud = 1_000_000,
    unit: Unit = None,
    json: JsonOption = False,
) -> None:
    """One register of one servo."""
    with _open(port, baud) as bus:
        value = bus.read(servo, register, unit)
        found = bus.register(servo, register)
        alarms = bus.alarms.get(servo, [])
    if json:
        print_json({"id": servo, "register": found.name, "value": value, "unit": unit, "alarms": alarms})
    else:
        typer.echo(f"{value:.6g} {unit}" if unit else found.describe(int(value)))
        if alarms:
            typer.echo(f"servo {servo} reports: {', '.join(alarms)}", err=True)


@app.command(
    "write", cls=NumericCommand, epilog="Example: kinlab bus write 1 goal_position 90deg --port ./ttyDXL"
)
def _write(
    servo: Annotated[int, typer.Argument(help="The servo's id.")],
    register: Annotated[str, typer.Argument(help="A register's name, or its address.")],
    value: Annotated[str, typer.Argument(help="Ticks (512, 0x200) or an amount (90deg, 60rpm).")],
    port: Port,
    baud: Baud = 1_000_000,
    json: JsonOption = False,
) -> None:
    """Set one register of one servo."""
    from kinlab.dynamixel.quantity import to_ticks

    with _open(port, baud) as bus:
        found = bus.register(servo, register)
        bus.write(servo, register, value)
    if json:
        print_json({"id": servo, "register": found.name, "value": to_ticks(value, found)})
    else:
        typer.echo(f"{found.name} of servo {servo}: {found.describe(to_ticks(value, found))}")


@app.command(
    "monitor",
    cls=NumericCommand,
    epilog="Example: kinlab bus monitor 1,2 --register present_position --port ./ttyDXL",
)
def _monitor(
    port: Port,
    ids: Annotated[str | None, typer.Argument(help="Which servos, as in 1,2,5-7 [all that answer].")] = None,
    register: Annotated[
        list[str] | None, typer.Option(help="What to watch [position, speed, load, voltage, temperature].")
    ] = None,
    baud: Baud = 1_000_000,
    rate: Annotated[float, typer.Option(help="Rounds per second.")] = 10.0,
    count: Annotated[int | None, typer.Option(help="Rounds after which to end [Ctrl-C].")] = None,
    csv: Annotated[Path | None, typer.Option(help="File that each round is added to.")] = None,
    json: Annotated[bool, typer.Option("--json", help="Print the last round as JSON.")] = False,
) -> None:
    """Live registers in a table."""
    from contextlib import ExitStack, suppress

    from kinlab.cli.live import shown
    from kinlab.dynamixel import Bus, RealClock, open_port
    from kinlab.dynamixel.monitor import CsvLog, Monitor
    from kinlab.dynamixel.outfit import parse_ids

    with ExitStack() as stack:
        bus = stack.enter_context(Bus(open_port(port, baud, RealClock())))
        if not ids:
            _say_searching(baud)
        servos = parse_ids(ids) if ids else [found.id for found in bus.scan()]
        monitor = Monitor(bus, servos, register, rate)
        log = stack.enter_context(CsvLog(csv, monitor)) if csv else None
        show = None if json else stack.enter_context(shown(monitor))
        last = None
        with suppress(KeyboardInterrupt):
            for last in monitor.rounds(count):
                if log:
                    log.add(last)
                if show:
                    show(last)
        if json and last:
            print_json(last.as_json())


def _say_searching(baud: int) -> None:
    """A search asks every id in both protocols, and waits for each that is not there."""
    if sys.stderr.isatty():
        typer.echo(f"looking for servos at {baud} bps ...", err=True)
