"""`execute(session, line)`: every line that the sandbox understands."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.packets import encode
from kinlab.dynamixel.sandbox import assembling, bench, expecting, wire
from kinlab.dynamixel.sandbox.display import packet_lines
from kinlab.dynamixel.sandbox.requests import REQUESTS, build_packet
from kinlab.dynamixel.sandbox.session import ExpectationError, Outcome, Session
from kinlab.errors import FileError, KinlabError, UsageError
from kinlab.files import file_named, write_whole
from kinlab.names import suggestion

DEEPEST_LOAD = 8


class Verb(NamedTuple):
    """What a line can begin with. `run` gets the rest of it, as it was typed."""

    usage: str
    meaning: str
    run: Callable[[Session, str], Outcome]


def execute(session: Session, line: str) -> Outcome:
    """Carry out one line.

    Raises:
        UsageError: it cannot be understood.
        ExpectationError: it expects what did not happen.
        KinlabError: the port failed, a file cannot be read.
    """
    text = line.split("#", 1)[0].strip()
    if not text:
        return Outcome()
    if session.assembling is not None and assembling.looks_like_bytes(text):
        text = f"step {text}"
    name, _, rest = text.partition(" ")
    verb = VERBS.get(name.casefold())
    if verb is None:
        raise UsageError(f"no command is named '{name}'{suggestion(name, VERBS)}")
    outcome = verb.run(session, rest.strip())
    outcome.data = {"line": text, "ok": outcome.ok, **outcome.data}
    if name not in ("save", "load", "help"):
        session.history.append(text)
    return outcome


def run_script(session: Session, text: str) -> Iterator[Outcome]:
    """Carry out lines that are separated by newlines or semicolons, one by one.

    An answer that was due and did not come ends the script, unless the next line expects something:
    then that line decides.

    Raises:
        KinlabError: as `execute`, with the number of the line.
    """
    lines = [
        (number, part.strip())
        for number, whole in enumerate(text.splitlines(), 1)
        for part in whole.split("#", 1)[0].split(";")
        if part.strip()
    ]
    many = len(text.splitlines()) > 1
    for index, (number, line) in enumerate(lines):
        try:
            outcome = execute(session, line)
        except KinlabError as error:
            raise (
                type(error)(*_located(error, number, line)) if many and len(error.args) == 1 else error
            ) from None
        yield outcome
        expected = index + 1 < len(lines) and lines[index + 1][1].startswith("expect")
        if not outcome.ok and not expected:
            raise ExpectationError(f"{'line ' + str(number) + ': ' if many else ''}{line}: no intact answer")


def _located(error: KinlabError, number: int, line: str) -> tuple[str]:
    return (f"line {number} ({line}): {error}",)


def _request(name: str) -> Callable[[Session, str], Outcome]:
    def run(session: Session, rest: str) -> Outcome:
        return wire.talk(session, encode(build_packet(session, [name, *rest.split()])))

    return run


def _build(session: Session, rest: str) -> Outcome:
    packet = build_packet(session, rest.split())
    data = encode(packet)
    dissection = wire.taken_apart(session, data)
    lines = packet_lines("=", data, f"{len(data)} bytes, not sent", dissection, session.table)
    return Outcome(lines=lines, data={"packet": show_hex(data), **dissection.as_json()})


def _step(session: Session, rest: str) -> Outcome:
    words = rest.split()
    if words and words[0] in REQUESTS:
        return assembling.walk_through(session, encode(build_packet(session, words)))
    return assembling.step(session, rest)


def _help(session: Session, rest: str) -> Outcome:
    if rest:
        verb = VERBS.get(rest)
        if verb is None:
            raise UsageError(f"no command is named '{rest}'{suggestion(rest, VERBS)}")
        return Outcome(lines=[[("verb", verb.usage)], [("", f"   {verb.meaning}")]])
    width = max(len(verb.usage) for verb in VERBS.values())
    lines = [[("verb", f"{verb.usage:<{width}}"), ("", f"  {verb.meaning}")] for verb in VERBS.values()]
    example = "Try: ping 1; write 1 goal_position 90deg; wait 0.5; read 1 present_position"
    return Outcome(lines=[*lines, [("dim", example)]])


def _save(session: Session, rest: str) -> Outcome:
    if not rest:
        raise UsageError("usage: save FILE")
    path = file_named(rest)
    beginning = [f"chain {session.chain_text}"] if session.chain else []
    write_whole(path, "\n".join([*beginning, *session.history]) + "\n")
    return Outcome(lines=[[("good", f"{len(session.history)} line(s) saved to {rest}")]])


def read_script(name: str) -> str:
    """The lines of a file.

    Raises:
        FileError: it cannot be read.
    """
    try:
        return file_named(name).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise FileError(f"{name}: cannot be read: {getattr(error, 'strerror', None) or error}") from None


def _load(session: Session, rest: str) -> Outcome:
    if not rest:
        raise UsageError("usage: load FILE")
    if session.loading >= DEEPEST_LOAD:
        raise FileError(f"{rest}: files that load each other")
    text = read_script(rest)
    session.loading += 1
    try:
        outcomes = list(run_script(session, text))
    finally:
        session.loading -= 1
    return Outcome(
        lines=[line for outcome in outcomes for line in outcome.lines],
        data={"results": [outcome.data for outcome in outcomes if outcome.data]},
    )


VERBS = {
    **{name: Verb(request.usage, request.meaning, _request(name)) for name, request in REQUESTS.items()},
    "send": Verb("send BYTES", "send bytes as they are (.. at the end: and the right check)", wire.send),
    "build": Verb("build COMMAND", "show the packet of a command without sending it", _build),
    "decode": Verb("decode [status] BYTES", "take a packet apart", wire.decode_bytes),
    "crc": Verb(
        "crc BYTES", "checksum and CRC of bytes, step by step", lambda session, rest: wire.crc_steps(rest)
    ),
    "step": Verb("step [BYTES|COMMAND|back|off]", "assemble a packet byte by byte; then send", _step),
    "scan": Verb("scan", "find all servos", wire.scan),
    "expect": Verb(
        "expect BYTES|silence|error=E|REGISTER=V|count=N", "fail unless that was the answer", expecting.expect
    ),
    "trace": Verb("trace on|off", "show packets, or results alone", wire.trace),
    "table": Verb("table ID|MODEL [REGISTER...]", "show a control table", bench.table),
    "servo": Verb("servo ID", "look inside an emulated servo", bench.servo),
    "set": Verb(
        "set ID REGISTER VALUE", "change a register without a packet, read-only ones too", bench.poke
    ),
    "fault": Verb("fault ID ALARM|stuck|dead|off|baud N", "break a servo, or (off) mend it", bench.fault),
    "push": Verb("push ID NM", "turn at a servo's horn from outside", bench.push),
    "noise": Verb("noise CHANCE [seed=N]", "random bytes on the wire", bench.wire_fault("noise")),
    "drop": Verb("drop CHANCE [seed=N]", "lose bytes on the wire", bench.wire_fault("drop")),
    "flip": Verb("flip CHANCE [seed=N]", "turn bits over on the wire", bench.wire_fault("flip")),
    "delay": Verb("delay MS", "late answers", bench.delay),
    "echo": Verb("echo on|off", "an adapter that hears itself", bench.echo),
    "power": Verb("power on|off|VOLTS", "the supply of the chain", bench.power),
    "baud": Verb("baud BPS", "the speed that you speak at", bench.baud),
    "protocol": Verb("protocol 1|2", "what to speak to ids that are not known", bench.protocol),
    "chain": Verb("chain ROBOT|MODEL:ID,...", "go on with another emulated chain", bench.chain),
    "wait": Verb("wait SECONDS", "let time pass", bench.wait),
    "save": Verb("save FILE", "write the lines so far as a script", _save),
    "load": Verb("load FILE", "carry out a script", _load),
    "help": Verb("help [COMMAND]", "this list", _help),
}
