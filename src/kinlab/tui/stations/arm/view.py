"""A picture of the arm whose hand can be pulled with the mouse."""

from dataclasses import dataclass

from textual.events import MouseUp
from textual.message import Message

from kinlab.tui.widgets import Picture


class ArmView(Picture):
    """Tells besides when the mouse lets go."""

    @dataclass
    class LetGo(Message):
        """The mouse button is up."""

        view: "ArmView"

    def on_mouse_up(self, event: MouseUp) -> None:
        self.post_message(self.LetGo(self))
