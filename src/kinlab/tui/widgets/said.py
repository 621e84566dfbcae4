"""A text from the words, in the language of now."""

from typing import TYPE_CHECKING, Any, cast

from textual.content import Content
from textual.dom import DOMNode
from textual.widgets import Static

from kinlab.language import words_of

if TYPE_CHECKING:
    from kinlab.tui.app import KinlabApp

SHELL_WORDS = "kinlab.tui"


def say(node: DOMNode, key: str, **values: object) -> str:
    """A text of the shell's words, in the language of now."""
    return words_of(SHELL_WORDS).say(cast("KinlabApp", node.app).tongue, key, **values)


def retext(widget: Static, text: str | Content) -> None:
    """Show another text in a widget; the screen is laid out anew only where the widget's size may change.

    Laying out costs several times what drawing does, and most texts change in place.
    """
    content = Content(text) if isinstance(text, str) else text
    before = widget.content
    if isinstance(before, Content) and before.plain == content.plain and before.spans == content.spans:
        return
    width, height = widget.size
    lines = content.split("\n")
    fits = len(lines) == height and all(line.cell_length <= width for line in lines)
    own_width = widget.styles.width is not None and widget.styles.width.is_auto
    widget.update(content, layout=own_width or not fits)


class Said(Static):
    """A text of the words: of the station's where they have it, else of the shell's."""

    DEFAULT_CSS = "Said { width: auto; height: auto; }"

    def __init__(
        self, key: str, *, id: str | None = None, classes: str | None = None, **values: object
    ) -> None:
        super().__init__(markup=False, id=id, classes=classes)
        self.key, self.values = key, values

    def on_mount(self) -> None:
        self.speak()

    def fill(self, key: str = "", **values: object) -> None:
        """Say it with other values, or say something else."""
        self.key, self.values = key or self.key, values
        if self.is_mounted:
            self.speak()

    def speak(self) -> None:
        """Show the text in the language of now."""
        speaker: Any = self.screen
        text = (
            speaker.say(self.key, **self.values)
            if hasattr(speaker, "say")
            else say(self, self.key, **self.values)
        )
        self.update(Content(text))
