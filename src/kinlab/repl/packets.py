"""The prompt of the packet sandbox: history, completion, bytes coloured by their field while one types."""

import os

from prompt_toolkit import PromptSession, print_formatted_text
from prompt_toolkit.auto_suggest import AutoSuggestFromHistory
from prompt_toolkit.formatted_text import FormattedText
from prompt_toolkit.history import FileHistory, History, InMemoryHistory
from prompt_toolkit.input import Input
from prompt_toolkit.output import ColorDepth, Output
from prompt_toolkit.styles import Style

from kinlab.dynamixel.sandbox import Session, execute
from kinlab.dynamixel.sandbox.prompting import hint
from kinlab.errors import KinlabError
from kinlab.files import own_folder
from kinlab.repl.completion import LineCompleter
from kinlab.repl.lexing import LineLexer

STYLE = Style.from_dict(
    {
        "arrow": "bold",
        "header": "ansibrightblack",
        "id": "ansicyan",
        "length": "ansiblue",
        "instruction": "ansimagenta",
        "address": "ansiyellow",
        "data": "ansigreen",
        "check": "ansibrightblue",
        "good": "ansigreen",
        "bad": "ansired",
        "odd": "ansiyellow",
        "dim": "ansibrightblack",
        "verb": "bold",
        "bottom-toolbar": "noreverse ansibrightblack",
    }
)
WELCOME = "Dynamixel packets byte by byte. Try: ping 1, step, help. Ctrl-D leaves."
KEYS = "Tab completes, help lists the commands, Ctrl-D leaves"


def run(session: Session, source: Input | None = None, sink: Output | None = None) -> None:
    """Prompt until the user leaves. Errors are shown, and the prompt goes on.

    Args:
        source, sink: terminals other than the program's own, for tests.
    """
    prompt: PromptSession[str] = PromptSession(
        history=_history() if source is None else InMemoryHistory(),
        auto_suggest=AutoSuggestFromHistory(),
        completer=LineCompleter(session),
        lexer=LineLexer(session),
        bottom_toolbar=lambda: hint(session, prompt.default_buffer.text) or KEYS,
        style=STYLE,
        color_depth=ColorDepth.DEPTH_1_BIT if os.environ.get("NO_COLOR") else None,
        complete_while_typing=False,
        input=source,
        output=sink,
    )

    def show(spans: list[tuple[str, str]]) -> None:
        formatted = FormattedText([(f"class:{style}" if style else "", text) for style, text in spans])
        print_formatted_text(formatted, style=STYLE, output=sink)

    ids = ", ".join(map(str, session.ids())) if session.chain else session.port.name
    show([("dim", f"{WELCOME}\nServos: {ids}")])
    while True:
        try:
            line = prompt.prompt(lambda: _prompt(session))
        except KeyboardInterrupt:
            continue
        except EOFError:
            return
        if line.strip() in ("quit", "exit"):
            return
        try:
            for part in line.split(";"):
                for spans in execute(session, part).lines:
                    show(spans)
        except KinlabError as error:
            show([("bad", str(error))])
        except KeyboardInterrupt:
            show([("dim", "interrupted")])


def _prompt(session: Session) -> str:
    return "dxl> " if session.assembling is None else f"step {len(session.assembling)}> "


def _history() -> History:
    """A file of one's own in the user's state folder; none where that cannot be written."""
    path = own_folder() / "packet-history"
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        os.close(os.open(path, os.O_CREAT | os.O_APPEND | os.O_WRONLY, 0o600))
    except OSError:
        return InMemoryHistory()
    return FileHistory(str(path))
