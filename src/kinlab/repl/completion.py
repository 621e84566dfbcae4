"""Completion at the prompt."""

from collections.abc import Iterable

from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document

from kinlab.dynamixel.sandbox import Session
from kinlab.dynamixel.sandbox.prompting import candidates


class LineCompleter(Completer):
    """Completes the word under the cursor from what may stand there."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def get_completions(self, document: Document, complete_event: CompleteEvent) -> Iterable[Completion]:
        """What the word may become."""
        word = document.text_before_cursor.rpartition(";")[2].rpartition(" ")[2]
        for text, note in candidates(self._session, document.text_before_cursor):
            yield Completion(text, start_position=-len(word), display_meta=note)
