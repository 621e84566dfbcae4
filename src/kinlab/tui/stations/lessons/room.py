"""An open lesson: text, exercise and instrument, side by side or one at a time. It shows; the station asks the core."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from textual import on
from textual.app import ComposeResult
from textual.containers import Container, Horizontal, Vertical, VerticalScroll
from textual.content import Content
from textual.events import Resize
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Static

from kinlab.lessons import Course
from kinlab.lessons.kinds import offers
from kinlab.lessons.marking import marked
from kinlab.tui.stations.lessons import telling
from kinlab.tui.stations.lessons.bench import Bench, BytesBench, ChainBench, LegBench
from kinlab.tui.stations.lessons.desk import Desk
from kinlab.tui.stations.lessons.page import Page
from kinlab.tui.stations.lessons.reply import Options, Reply
from kinlab.tui.stations.lessons.seat import Seat, placed
from kinlab.tui.stations.lessons.steps import Steps
from kinlab.tui.stations.packet.registers import COLUMNS, Registers
from kinlab.tui.stations.packet.sheet import Sheet
from kinlab.tui.stations.packet.tabs import Tabs
from kinlab.tui.stations.packet.traffic import Traffic

if TYPE_CHECKING:
    from kinlab.tui.stations.lessons.station import LessonsStation

VIEWS = ("text", "exercise", "bench")
WIDE, TALL = 120, 30  # from here on all stands side by side; text and exercise one above the other


class Room(Vertical):
    """A lesson.

    Attributes:
        seat: in the lesson; None where none is open.
        wished: the view that a person has chosen; there may be no room, or no need, for it.
    """

    DEFAULT_CSS = """
    Room {
        height: 100%; display: none;
        &.-open { display: block; }
        #title { height: 1; padding: 0 1; text-style: bold; text-wrap: nowrap; text-overflow: ellipsis; }
        #ways { height: 1; }
        Tabs { width: auto; }
        #panes, #work { height: 1fr; width: 1fr; }
        Page { width: 1fr; }
        Page, Desk, Bench, #work { display: none; }
        &.view-text Page, &.-end Page { display: block; }
        &.view-exercise #work, &.view-exercise Desk, &.view-bench #work, &.view-bench Bench { display: block; }
        &.-stacked {
            #panes { layout: vertical; }
            #work { height: 1fr; display: block; border-top: solid $faint; }
            Desk { display: block; }
            &.view-exercise Page { display: block; }
        }
        &.-beside {
            #panes { layout: horizontal; }
            Page, #work, Desk { display: block; }
            Page { width: 6fr; }
            #work { width: 5fr; border-left: solid $faint; }
            &.-benched { Bench { display: block; border-top: solid $faint; } }
        }
        &.-end { #work { display: none; } Tabs { display: none; } }
        &.-beside Tabs { display: none; }
    }
    """

    @dataclass
    class Answered(Message):
        """An answer is to be judged."""

        reply: str

    def __init__(self) -> None:
        super().__init__()
        self.seat: Seat | None = None
        self.wished = VIEWS[0]

    @property
    def station(self) -> "LessonsStation":
        """Whose room it is."""
        return cast("LessonsStation", self.screen)

    def compose(self) -> ComposeResult:
        yield Static(id="title", markup=False)
        with Horizontal(id="ways"):
            yield Steps()
            yield Tabs(VIEWS)
        with Container(id="panes"):
            yield Page()
            with Vertical(id="work"):
                yield Desk()
                yield Bench()

    # Views.

    @property
    def beside(self) -> bool:
        """Whether all stands side by side."""
        return self.has_class("-beside")

    @property
    def views(self) -> list[str]:
        """Those among which one can choose here; one where all are seen."""
        seat = self.seat
        if seat is None or seat.task is None or self.beside:
            return ["text"]
        bench = ["bench"] if seat.instrument else []
        return [*([] if self.has_class("-stacked") else ["text"]), "exercise", *bench]

    @property
    def view(self) -> str:
        """What is shown where there is no room for everything."""
        return self.wished if self.wished in self.views else self.views[0]

    def show(self, view: str) -> None:
        """Show a view, the first one where there is no such."""
        self.wished = view
        self.update_classes({f"view-{each}": each == self.view for each in VIEWS})
        self.query_one(Tabs).choose(self.view)
        self.screen.refresh_bindings()

    def show_next(self) -> None:
        """Show the next view."""
        self.show(self.views[(self.views.index(self.view) + 1) % len(self.views)])
        self.begin()

    def begin(self) -> None:
        """Give the keys to what is read, or to what is answered."""
        if self.seat is None or self.seat.task is None or (self.view == "text" and not self.beside):
            self.query_one(Page).focus()
        else:
            self.query_one(Desk).begin()

    def to_exercise(self) -> None:
        """Let the exercise be seen."""
        if self.view == "text" and not self.beside:
            self.show("exercise")

    def scroll_page(self, pages: int) -> None:
        """Scroll the part of the instrument that has the keys, else what is read, else what is asked."""
        focused = self.screen.focused
        page: Widget = self.query_one(Page)
        if isinstance(focused, Registers | Traffic | Sheet):
            page = focused
        elif not page.is_on_screen:
            page = self.query_one("#asked", VerticalScroll)
        page.scroll_relative(y=pages * max(page.size.height - 1, 1), animate=False)

    def on_resize(self, event: Resize) -> None:
        if self._lay_out():
            self._name_views()
            self.show(self.wished)

    def _lay_out(self) -> bool:
        """Choose what stands beside what; whether that is something else now."""
        wide = self.screen.size.width >= WIDE
        stacked = not wide and self.screen.size.height >= TALL
        before = self.beside, self.has_class("-stacked")
        self.update_classes({"-beside": wide, "-stacked": stacked})
        return before != (wide, stacked)

    def _name_views(self) -> None:
        say = self.station.say
        self.query_one(Tabs).name_them({view: say(f"tab.{view}") for view in self.views}, self.view)

    # Contents.

    def leave(self) -> None:
        """Show nothing."""
        self.seat = None
        self.remove_class("-open")

    def arrive(self, course: Course, seat: Seat) -> None:
        """Show the step of now from its beginning."""
        self.seat = seat
        self.add_class("-open")
        self._lay_out()
        self.update_classes({"-end": seat.task is None, "-benched": bool(seat.instrument)})
        self.show("text" if seat.steps[seat.at].parts or seat.task is None else "exercise")
        self.fill(course, seat)
        self.query_one(Page).scroll_home(animate=False)
        self.begin()

    def fill(self, course: Course, seat: Seat) -> None:
        """All texts of the step of now."""
        self.seat = seat
        say, desk, task = self.station.say, self.query_one(Desk), seat.task
        self.query_one("#title", Static).update(Content(seat.sitting.lesson.title(seat.sitting.language)))
        self.query_one(Page).flow.put(*telling.page(course, seat, say), fresh=True)
        kind = task.exercise.kind if task else ""
        desk.ask(kind, say("sign.chain" if kind == "state" else "sign.answer"))
        desk.reply.placeholder = say(f"placeholder.{kind}") if kind else ""
        desk.reply.put(seat.table.reply)
        self.query_one(Bench).use(seat.instrument)
        self._name_views()
        self.answered()
        self.chain()

    def answered(self) -> None:
        """How the exercise stands, what was said to the answer, and what helps."""
        seat, desk, ascii_only = self.seat, self.query_one(Desk), self.station.lab.ascii_only
        if seat is None:
            return
        self.query_one(Steps).put(seat.standings, seat.at, ascii_only=ascii_only)
        if seat.task is None:
            return
        desk.question.put(*telling.question(seat, self.station.say))
        judged, faults = seat.table.judged, []
        desk.judge(*([telling.verdict(judged.verdict, seat.sitting, ascii_only)] if judged else []))
        if judged is not None and judged.reply == seat.table.reply:
            faults = marked(seat.task, judged.reply, judged.verdict)
            desk.reply.put(judged.reply, faults)
        desk.mark(faults)
        desk.aid(*telling.aid(seat, seat.table, self.station.say))
        self._offer()
        self._take_apart()
        self.screen.refresh_bindings()

    def _offer(self) -> None:
        """What there is to choose from."""
        seat = self.seat
        offered = offers(seat.task) if seat is not None and seat.task is not None else {}
        if seat is None or seat.task is None or not offered:
            return
        kind = seat.task.exercise.kind
        said = placed(seat.table.reply, offered) if kind == "order" else seat.table.tried
        options = self.query_one(Desk).options
        options.put(offered, said, plain=kind == "mistake", ascii_only=self.station.lab.ascii_only)

    def _take_apart(self) -> None:
        """The bytes that are typed."""
        seat = self.seat
        if seat is not None and seat.instrument == "bytes":
            done = seat.sitting.standing(seat.name).done
            empty = self.station.say("bytes.empty")
            self.query_one(BytesBench).show(seat.table.reply, whole=done, empty=empty)

    def chain(self) -> None:
        """The chain as it is now, and what was said to it."""
        seat = self.seat
        if seat is None or seat.table.bench is None:
            return
        desk, table, say = self.query_one(Desk), seat.table, self.station.say
        desk.prompt.session = seat.table.bench.session
        desk.answer(table.talk or [[("dim", say("chain_waits"))]])
        names = {name: say(f"column.{name}") for name in COLUMNS}
        ascii_only = self.station.lab.ascii_only
        self.query_one(ChainBench).show(seat.table.bench, table.servo, ascii_only, names)

    # What the widgets tell.

    @on(Reply.Typed)
    def _typed(self, event: Reply.Typed) -> None:
        event.stop()
        seat = self.seat
        if seat is None or seat.task is None:
            return
        seat.table.reply = event.text
        self.query_one(Desk).mark(())
        if seat.task.exercise.kind == "order":
            self._offer()
        self._take_apart()
        pose = seat.typed_angles(event.text)
        if pose is not None:
            self.query_one(LegBench).pose(pose)

    @on(Reply.Given)
    def _given(self, event: Reply.Given) -> None:
        event.stop()
        self.post_message(self.Answered(event.text))

    @on(Options.Chosen)
    def _chosen(self, event: Options.Chosen) -> None:
        event.stop()
        seat, desk = self.seat, self.query_one(Desk)
        if seat is None or seat.task is None:
            return
        if seat.task.exercise.kind != "order":
            self.post_message(self.Answered(event.label))
            return
        words = seat.table.reply.split()
        words = [w for w in words if w != event.label] if event.label in words else [*words, event.label]
        desk.reply.value = " ".join(words)
        if len(words) == len(offers(seat.task)):
            desk.reply.focus()

    @on(Tabs.Chosen)
    def _to_view(self, event: Tabs.Chosen) -> None:
        event.stop()
        self.show(event.name)
        self.begin()
