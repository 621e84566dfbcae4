"""`kinlab packet`: the packet sandbox, as a prompt, as a script, and its parts as single commands."""

import sys
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from kinlab.cli.command import JsonOption, NumericCommand, command_app, converted_plainly, print_json
from kinlab.cli.printing import print_lines

Model = Annotated[
    str | None, typer.Option(help="Whose control table explains the bytes [AX-12A or XL430-W250-T].")
]


class ScriptGroup(TyperGroup):
    """A group whose first word may also be a script file."""

    def get_params(self, ctx: Any) -> list[Any]:
        return converted_plainly(super().get_params(ctx))

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        from pathlib import Path

        if args[0] not in self.commands and (Path(args[0]).exists() or args[0].endswith(".dxl")):
            args = ["run", *args]
        return super().resolve_command(ctx, args)


app = command_app()


@app.callback(
    cls=ScriptGroup,
    invoke_without_command=True,
    epilog="Example: kinlab packet -c 'ping 1; write 1 goal_position 90deg; wait 0.5; read 1 present_position'",
)
def _packet(
    ctx: typer.Context,
    command: Annotated[str | None, typer.Option("--command", "-c", help="Lines to carry out.")] = None,
    chain: Annotated[
        str | None, typer.Option(help="A robot or servos: krsri-hexapod, or AX-12A:1,2,XL430-W250:3.")
    ] = None,
    port: Annotated[str | None, typer.Option(help="A real bus in the place of an emulated chain.")] = None,
    baud: Annotated[int, typer.Option(help="Speed in bps.")] = 1_000_000,
    json: JsonOption = False,
) -> None:
    """Packets byte by byte, on an emulated chain or a real bus.

    Without a command: a prompt (help tells what it understands). With a file
    name: the lines of that file. Every command takes --json.
    """
    ctx.obj = (chain, port, baud)
    if ctx.invoked_subcommand:
        return
    session = _session(ctx)
    if command is None and sys.stdin.isatty() and not json:
        from kinlab.repl.packets import run

        run(session)
    else:
        _run(session, sys.stdin.read() if command is None else command, json)


def _session(ctx: typer.Context) -> Any:
    from kinlab.dynamixel.ports import open_port
    from kinlab.dynamixel.sandbox import Session

    chain, port, baud = ctx.obj
    return Session(chain, open_port(port, baud) if port else None, baud)


def _run(session: Any, text: str, json: bool) -> None:
    from kinlab.dynamixel.sandbox import run_script

    results = []
    try:
        for outcome in run_script(session, text):
            results.append(outcome.data)
            if not json:
                print_lines(outcome.lines)
    finally:
        if json:
            print_json({"results": results})


@app.command("run", cls=NumericCommand, hidden=True)
def _script(ctx: typer.Context, file: str, json: JsonOption = False) -> None:
    """Carry out the lines of a file."""
    from pathlib import Path

    from kinlab.errors import FileError

    try:
        text = Path(file).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise FileError(f"{file}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    _run(_session(ctx), text, json)


@app.command("build", cls=NumericCommand, epilog="Example: kinlab packet build write 1 goal_position 90deg")
def _build(
    words: Annotated[
        list[str], typer.Argument(metavar="COMMAND...", help="As at the prompt: write 1 led 1.")
    ],
    model: Annotated[str, typer.Option(help="What servo it is for.")] = "AX-12A",
    json: JsonOption = False,
) -> None:
    """The packet of a command, and what each of its bytes is for."""
    from kinlab.dynamixel.codec.dissect import dissect
    from kinlab.dynamixel.codec.hextext import show_hex
    from kinlab.dynamixel.codec.packets import encode
    from kinlab.dynamixel.sandbox.display import packet_lines
    from kinlab.dynamixel.sandbox.requests import OneModel, build_packet
    from kinlab.dynamixel.tables import load_table

    servos = OneModel(load_table(model))
    data = encode(build_packet(servos, words))
    dissection = dissect(data, status=False, tables=servos.table)
    if json:
        print_json({"packet": show_hex(data), **dissection.as_json()})
    else:
        print_lines(packet_lines("=", data, f"{len(data)} bytes", dissection, servos.table))


@app.command("decode", cls=NumericCommand, epilog="Example: kinlab packet decode FF FF 01 05 03 1E 00 02 D6")
def _decode(
    words: Annotated[
        list[str], typer.Argument(metavar="BYTE...", help="FF FF 01, 0xFF,0xFF, \\xff, FFFF01.")
    ],
    status: Annotated[bool, typer.Option("--status", help="It is an answer, not an instruction.")] = False,
    model: Model = None,
    json: JsonOption = False,
) -> None:
    """A packet taken apart, byte by byte; exit code 1 if it is damaged."""
    from kinlab.dynamixel.codec.dissect import dissect
    from kinlab.dynamixel.codec.hextext import parse_hex
    from kinlab.dynamixel.sandbox.display import packet_lines
    from kinlab.dynamixel.tables import load_table

    data = parse_hex(" ".join(words))
    protocol = dissect(data).protocol
    table = load_table(model or ("AX-12A" if protocol == 1 else "XL430-W250-T"))
    dissection = dissect(data, protocol, True if status else None, lambda servo: table)
    if json:
        print_json(dissection.as_json())
    else:
        print_lines(packet_lines("=", data, f"{len(data)} bytes", dissection, lambda servo: table))
    if not dissection.ok:
        raise typer.Exit(1)


@app.command("crc", cls=NumericCommand, epilog="Example: kinlab packet crc FF FF FD 00 01 03 00 01")
def _crc(
    words: Annotated[list[str], typer.Argument(metavar="BYTE...", help="All bytes before the check.")],
    json: JsonOption = False,
) -> None:
    """Checksum (Protocol 1.0) and CRC-16 (Protocol 2.0) of bytes, step by step."""
    from kinlab.dynamixel.sandbox.wire import crc_steps

    outcome = crc_steps(" ".join(words))
    if json:
        print_json(outcome.data)
    else:
        print_lines(outcome.lines)


@app.command("table", cls=NumericCommand, epilog="Example: kinlab packet table RX-24F goal_position")
def _table(
    model: Annotated[str, typer.Argument(help="AX-12A, RX-24F, XL430-W250-T, 2XL430-W250-T.")],
    registers: Annotated[list[str] | None, typer.Argument(metavar="REGISTER...", help="Only these.")] = None,
    json: JsonOption = False,
) -> None:
    """A model's control table."""
    from kinlab.dynamixel.sandbox.display import table_lines
    from kinlab.dynamixel.tables import load_table

    table = load_table(model)
    shown = [table.find(name) for name in registers or ()] or list(table.registers)
    if json:
        print_json(
            {
                "model": table.model,
                "model_number": table.number,
                "protocol": table.protocol,
                "registers": [register.as_json() for register in shown],
            }
        )
    else:
        print_lines(table_lines(table, shown))
