"""The text of a lesson, up to the next exercise."""

from dataclasses import dataclass
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import VerticalScroll
from textual.message import Message

from kinlab.tui.stations.lessons.flow import Flow


class Page(VerticalScroll, can_focus=True):
    """Text to read. Enter and Space read on, and at its end ask for what comes then."""

    DEFAULT_CSS = """
    Page { height: 1fr; padding: 0 1; scrollbar-size-vertical: 1; scrollbar-color: $faint;
        scrollbar-background: $background; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [Binding("enter,space", "read_on", show=False)]

    @dataclass
    class ReadOn(Message):
        """All of it has been read."""

    def __init__(self) -> None:
        super().__init__()
        self.flow = Flow(id="page-text")

    def compose(self) -> ComposeResult:
        yield self.flow

    def action_read_on(self) -> None:
        """Go a screen further; at the end, on to the exercise."""
        if self.scroll_offset.y >= self.max_scroll_y:
            self.post_message(self.ReadOn())
        else:
            self.scroll_relative(y=max(self.size.height - 1, 1), animate=False)
