"""The line where the sandbox's commands are typed: colours, completion, history."""

from dataclasses import dataclass
from typing import ClassVar

from rich.highlighter import Highlighter
from rich.text import Text
from textual import on
from textual.binding import Binding, BindingType
from textual.events import Key
from textual.message import Message
from textual.suggester import Suggester
from textual.widgets import Input

from kinlab.dynamixel.sandbox import Session
from kinlab.dynamixel.sandbox.prompting import candidates, coloured
from kinlab.tui.stations.packet.styles import rich_style

REMEMBERED = 200
LONGEST = 1000  # characters; the longest packet that a servo takes is half of it
# Keys that must not be overtaken by the letters after them, as in lines that arrive in one piece.
IN_TURN = {
    "enter": "submit",
    "tab": "complete",
    "backspace": "delete_left",
    "delete": "delete_right",
    "up": "older",
    "down": "newer",
}


class Prompt(Input):
    """A line for the sandbox. Up and Down go through what was typed before, Tab completes, Escape gives up.

    Attributes:
        history: what was entered, the oldest first.
    """

    DEFAULT_CSS = "Prompt { width: 1fr; background: transparent; }"
    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "give_up", show=False)]

    @dataclass
    class Entered(Message):
        """A line is to be carried out; an empty one as well."""

        line: str

    @dataclass
    class Back(Message):
        """Backspace on an empty line."""

    @dataclass
    class Offered(Message):
        """What the word may become, where it is not clear what is meant; the chosen one, if any."""

        found: list[str]
        chosen: str

    def __init__(self, session: Session, *, id: str | None = None) -> None:
        super().__init__(
            compact=True,
            highlighter=_Colours(self),
            suggester=_Ghost(self),
            select_on_focus=False,
            max_length=LONGEST,
            id=id,
        )
        self.cursor_blink = False
        self.session = session
        self.history: list[str] = []
        self._at = 0
        self._draft = ""
        self._cycle: list[str] = []

    async def on_key(self, event: Key) -> None:
        """Carry out such a key in its turn; Textual would come to it after the letters that follow it."""
        if action := IN_TURN.get(event.key):
            event.stop()
            event.prevent_default()
            await self.run_action(action)

    def remember(self, line: str) -> None:
        """Add a line to those that Up brings back."""
        if line.strip() and self.history[-1:] != [line]:
            self.history = [*self.history, line][-REMEMBERED:]
        self._at = len(self.history)

    def put(self, line: str, select: int = 0) -> None:
        """Put a line there to be finished, the last `select` characters selected, so that typing replaces them."""
        self.focus()
        self._set(line)
        if select:
            self.selection = type(self.selection)(len(line) - select, len(line))

    def action_older(self) -> None:
        """Bring back the line before."""
        if self._at == len(self.history):
            self._draft = self.value
        self._go(self._at - 1)

    def action_newer(self) -> None:
        """Bring back the line after."""
        self._go(self._at + 1)

    def _go(self, at: int) -> None:
        if 0 <= at <= len(self.history):
            self._at = at
            self._set([*self.history, self._draft][at])

    def _set(self, line: str) -> None:
        self.value = line
        self.cursor_position = len(line)

    def action_complete(self) -> None:
        """Complete the word as far as it is clear; after that, go through what it may be. Else to the next widget."""
        start = self.value[: max(self.value.rfind(" "), self.value.rfind(";")) + 1]
        word = self.value[len(start) :]
        if self._cycle and word in self._cycle:
            chosen = self._cycle[(self._cycle.index(word) + 1) % len(self._cycle)]
            self._offer(start, chosen)
            return
        found = [text for text, _ in candidates(self.session, self.value)] if self.value.strip() else []
        if not found or found == [word]:
            self.screen.focus_next()
        elif len(found) == 1:
            self._set(f"{start}{found[0]}" + ("" if found[0].endswith("=") else " "))
        else:
            common = _common_start(found)
            self._cycle = found
            self._offer(start, common if len(common) > len(word) else found[0])

    def _offer(self, start: str, chosen: str) -> None:
        with self.prevent(Input.Changed):
            self._set(start + chosen)
        self.post_message(self.Offered(self._cycle, chosen))

    async def action_submit(self) -> None:
        """Hand the line over, and begin another."""
        line, self.value = self.value, ""
        self.remember(line)
        self.post_message(self.Entered(line))

    def action_give_up(self) -> None:
        """Empty the line; an empty one gives the keys to the station."""
        if self.value:
            self.value = ""
        else:
            self.screen.set_focus(self.screen.query_one("Sheet"))

    def action_delete_left(self) -> None:
        """Delete a character; where there is none, ask for a byte to be taken back."""
        if self.value:
            super().action_delete_left()
        else:
            self.post_message(self.Back())

    @on(Input.Changed)
    def _typed(self) -> None:
        self._cycle = []


def _common_start(texts: list[str]) -> str:
    """What all of them begin with: two of them, the first and the last in order, say it for the others."""
    first, last = min(texts), max(texts)
    return first[: next((i for i, (a, b) in enumerate(zip(first, last, strict=False)) if a != b), len(first))]


class _Colours(Highlighter):
    """Each part of the line in the style of what the sandbox takes it for."""

    def __init__(self, prompt: Prompt) -> None:
        self._prompt = prompt

    def highlight(self, text: Text) -> None:
        theme, at = self._prompt.app.theme_variables, 0
        for style, part in coloured(self._prompt.session, text.plain):
            if style:
                text.stylize(rich_style(style, theme), at, at + len(part))
            at += len(part)


class _Ghost(Suggester):
    """What the line will probably become: what was typed before, else the first way to go on."""

    def __init__(self, prompt: Prompt) -> None:
        super().__init__(use_cache=False, case_sensitive=True)
        self._prompt = prompt

    async def get_suggestion(self, value: str) -> str | None:
        for line in reversed(self._prompt.history):
            if line.startswith(value) and line != value:
                return line
        if value.endswith(" "):
            return None
        word = value[max(value.rfind(" "), value.rfind(";")) + 1 :]
        found = next((text for text, _ in candidates(self._prompt.session, value)), None) if word else None
        return value[: len(value) - len(word)] + found if found else None
