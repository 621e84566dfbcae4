"""The exercise: the question, a place for the answer, and what is said to it."""

from collections.abc import Sequence

from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.content import Content
from textual.widgets import Static

from kinlab.dynamixel.sandbox import Session
from kinlab.dynamixel.sandbox.session import Line
from kinlab.tui.stations.lessons.flow import Block, Flow
from kinlab.tui.stations.lessons.reply import Marks, Options, Reply, Span
from kinlab.tui.stations.packet.prompt import Prompt
from kinlab.tui.stations.packet.sheet import Sheet


class Desk(Vertical):
    """From top to bottom: question, options, help; what a chain said; the line to type on; the verdict."""

    DEFAULT_CSS = """
    Desk {
        height: 1fr;
        #asked { height: 1fr; padding: 0 1; scrollbar-size-vertical: 1; scrollbar-color: $faint;
            scrollbar-background: $background; }
        #help { margin: 1 0; }
        #talk { height: 1fr; min-height: 4; border-top: solid $faint; display: none; }
        #typing { height: 1; padding: 0 1; background: $surface; }
        #sign { width: auto; color: $orange; text-style: bold; }
        Marks { padding: 0 1; background: $surface; }
        #verdict { padding: 0 1; max-height: 6; }
        Prompt { display: none; }
        &.-state {
            Prompt, #talk { display: block; }
            Reply { display: none; }
            #asked { height: auto; max-height: 50%; }
        }
        &.-choice #typing { display: none; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self.question, self.help, self.verdict = Flow(id="question"), Flow(id="help"), Flow(id="verdict")
        self.options, self.marks = Options(), Marks()
        self.reply = Reply(id="reply")
        self.prompt = Prompt(Session(), id="line")
        self.talk = Sheet(id="talk")

    def compose(self) -> ComposeResult:
        with VerticalScroll(id="asked", can_focus=False):
            yield self.question
            yield self.options
            yield self.help
        yield self.talk
        with Horizontal(id="typing"):
            yield Static(id="sign", markup=False)
            yield self.reply
            yield self.prompt
        yield self.marks
        yield self.verdict

    def ask(self, kind: str, sign: str) -> None:
        """Make room for an exercise of a kind; `sign` stands before the line."""
        self.update_classes({"-state": kind == "state", "-choice": kind in ("choice", "mistake")})
        self.options.display = kind in ("choice", "mistake", "order")
        self.query_one("#sign", Static).update(Content(sign))
        self.query_one("#asked", VerticalScroll).scroll_home(animate=False)

    def mark(self, faults: Sequence[Span]) -> None:
        """Point at what is at fault in the answer."""
        shown = [span for span in faults if span[1] <= self.reply.size.width]
        self.marks.put(len(str(self.query_one("#sign", Static).content)), shown)

    def judge(self, *blocks: Block) -> None:
        """Say something to the answer; nothing where there is no block."""
        self.verdict.put(*blocks)
        self.verdict.display = bool(blocks)

    def aid(self, *blocks: Block) -> None:
        """Show hints and solution, and bring them into sight."""
        before = self.help.blocks
        self.help.put(*blocks)
        self.help.display = bool(blocks)
        if blocks and tuple(blocks) != tuple(before):
            self.query_one("#asked", VerticalScroll).call_after_refresh(
                self.query_one("#asked", VerticalScroll).scroll_end, animate=False
            )

    def answer(self, lines: Sequence[Line]) -> None:
        """What the chain said, down to its last line."""
        self.talk.put(lines, to_end=True)

    def begin(self) -> None:
        """Wait for an answer."""
        if self.has_class("-state"):
            self.prompt.focus()
        elif self.has_class("-choice") or (self.options.display and not self.reply.value):
            self.options.focus()
        else:
            self.reply.focus()
