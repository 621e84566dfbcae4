"""Completion at the prompt: commands, ids, registers with their address, models."""

from collections.abc import Iterable

from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document

from kinlab.dynamixel.sandbox import VERBS, Session
from kinlab.dynamixel.sandbox.requests import REQUESTS
from kinlab.dynamixel.tables import ControlTable, models

WITH_ID = frozenset({"servo", "table", "set", "fault", "push", *REQUESTS}) - {"syncwrite", "syncread"}
WITH_REGISTER = frozenset({"read", "write", "regwrite", "table", "set"})
WORDS = {
    "fault": ("overload", "overheating", "input_voltage", "stuck", "dead", "off", "baud"),
    "trace": ("on", "off"),
    "echo": ("on", "off"),
    "power": ("on", "off"),
    "expect": ("silence", "error=", "count="),
    "step": ("back", "off", *REQUESTS),
    "build": tuple(REQUESTS),
    "help": tuple(VERBS),
}


class LineCompleter(Completer):
    """Completes the word under the cursor from what may stand there."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def get_completions(self, document: Document, complete_event: CompleteEvent) -> Iterable[Completion]:
        """What the word may become."""
        words = document.text_before_cursor.rsplit(";", 1)[-1].lstrip().split(" ")
        word = words[-1]
        for text, note in self._candidates([w for w in words[:-1] if w]):
            if text.startswith(word):
                yield Completion(text, start_position=-len(word), display_meta=note)

    def _candidates(self, before: list[str]) -> Iterable[tuple[str, str]]:
        if before and before[0] in ("build", "step", "help") and len(before) > 1:
            before = before[1:]
        if not before:
            return [(name, verb.meaning) for name, verb in VERBS.items()]
        verb, place = before[0], len(before)
        if verb in ("syncwrite", "syncread") and place == 1:
            return self._registers(next(iter(self._session.ids()), 0))
        if place == 1 and verb in WITH_ID:
            ids = [
                (str(i), table.model if (table := self._session.table(i)) else "")
                for i in self._session.ids()
            ]
            return [*ids, *((m, "") for m in models())] if verb == "table" else ids
        if place >= 2 and verb in WITH_REGISTER and before[1].isdecimal() and (place == 2 or verb == "table"):
            return self._registers(int(before[1]))
        return [(text, "") for text in WORDS.get(verb, ())]

    def _registers(self, servo: int) -> list[tuple[str, str]]:
        table: ControlTable | None = self._session.table(servo)
        registers = table.registers if table else ()
        return [(r.name, f"@{r.address} {r.size}B {r.access}") for r in registers]
