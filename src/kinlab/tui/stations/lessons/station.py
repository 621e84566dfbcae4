"""The Lessons station: a list of lessons, and one of them with text, exercise and instrument side by side."""

import asyncio
from collections.abc import Callable
from typing import Any, TypeVar

from textual import on
from textual.app import ComposeResult
from textual.containers import Container, Horizontal, Vertical, VerticalScroll
from textual.content import Content
from textual.events import Resize
from textual.widgets import Static

from kinlab.errors import KinlabError
from kinlab.lessons import Course, Progress, Sitting, Verdict, load_course
from kinlab.lessons.kinds import offers
from kinlab.lessons.marking import marked
from kinlab.lessons.progress import PROFILE, TRIES_BEFORE_SOLUTION
from kinlab.tui.station import Station
from kinlab.tui.stations.lessons import telling
from kinlab.tui.stations.lessons.actions import ACTIONS, AT_EXERCISE, AT_LIST, IN_LESSON
from kinlab.tui.stations.lessons.bench import Bench, BytesBench, ChainBench, LegBench
from kinlab.tui.stations.lessons.browser import Browser, List, Search
from kinlab.tui.stations.lessons.desk import Desk
from kinlab.tui.stations.lessons.flow import Flow
from kinlab.tui.stations.lessons.page import Page
from kinlab.tui.stations.lessons.reply import Options, Reply
from kinlab.tui.stations.lessons.seat import Seat, Table, placed
from kinlab.tui.stations.lessons.steps import Steps
from kinlab.tui.stations.packet.prompt import Prompt
from kinlab.tui.stations.packet.registers import COLUMNS
from kinlab.tui.stations.packet.tabs import Tabs

VIEWS = ("text", "exercise", "bench")
T = TypeVar("T")


class LessonsStation(Station):
    """The course.

    Attributes:
        course: the lessons; None until they are read.
        progress: of the profile.
        seat: in the open lesson; None at the list.
        view: what is shown where there is no room for everything.
    """

    NAME = "lessons"
    ACTIONS = ACTIONS
    AUTO_FOCUS = ""
    CSS = """
    LessonsStation {
        #lesson { display: none; height: 100%; }
        &.-lesson { Browser { display: none; } #lesson { display: block; } }
        &.-wide {
            #found { layout: horizontal; }
            #lessons { width: 3fr; height: 100%; }
            #about { width: 2fr; height: 100%; border-top: none; border-left: solid $faint; }
        }
        &.-low.-narrow #about { height: 5; }
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

    def __init__(self) -> None:
        super().__init__()
        self.course: Course | None = None
        self.progress: Progress | None = None
        self.seat: Seat | None = None
        self.view = VIEWS[0]
        self._kept: dict[str, Any] = {}
        self._informed: tuple[str, str, dict[str, object]] = ("note", "reading", {})
        self._order = asyncio.Lock()  # what is asked of the core goes there in the order of asking

    def compose_body(self) -> ComposeResult:
        yield Browser()
        with Vertical(id="lesson"):
            yield Static(id="title", markup=False)
            with Horizontal(id="ways"):
                yield Steps()
                yield Tabs(VIEWS)
            with Container(id="panes"):
                yield Page()
                with Vertical(id="work"):
                    yield Desk()
                    yield Bench()

    # Beginning, and the next time.

    def restore(self, state: dict[str, Any]) -> None:
        self._kept = state

    def state(self) -> dict[str, Any]:
        if self.progress is None:
            return self._kept
        seat = self.seat
        place = {"lesson": seat.sitting.lesson.id, "step": seat.at} if seat else {}
        return {"profile": self.progress.profile, **place}

    def ready(self) -> None:
        self.relabel()
        self.ask(self._begin, self._begun)

    def _begin(self) -> tuple[Course, Progress]:
        profile = self._kept.get("profile")
        try:
            progress = Progress(profile if isinstance(profile, str) else PROFILE)
        except KinlabError:
            progress = Progress()
        return load_course(), progress

    def _begun(self, found: tuple[Course, Progress]) -> None:
        self.course, self.progress = found
        self._list()
        lesson, step = self._kept.get("lesson"), self._kept.get("step")
        if lesson in self.course.lessons:
            self.open_lesson(str(lesson), step if isinstance(step, int) and step >= 0 else None)
        else:
            self.inform("note", "welcome")
            self.query_one(List).focus()
        self._name_damage()

    def ask(self, work: Callable[[], T], then: Callable[[T], None]) -> None:
        """Have the core do something away from the event loop, in turn; then show what it gave."""

        async def run() -> None:
            async with self._order:
                try:
                    found = await asyncio.to_thread(work)
                except KinlabError as error:
                    self.tell("bad", str(error))
                    return
            then(found)

        self.run_worker(run(), group="lessons")

    def inform(self, kind: str, key: str, **values: object) -> None:
        """Put a text of the words on the message line; it follows the language."""
        self._informed = kind, key, values
        self.tell(kind, self.say(key, **values))

    def _name_damage(self) -> None:
        """Say, once, where a damaged file of progress went."""
        if self.progress is not None and self.progress.set_aside is not None:
            self.inform("warn", "damaged", aside=self.progress.set_aside, count=len(self.progress.events))
            self.progress.set_aside = None

    # The list.

    def _list(self) -> None:
        if self.course is None or self.progress is None:
            return
        rows = telling.rows(self.course, self.progress, self.lab.tongue, self.say)
        chosen = self.seat.sitting.lesson.id if self.seat else ""
        self.query_one(Browser).put(rows, telling.tally(self.course, self.progress, self.say), chosen)

    @on(Browser.Opened)
    def _chosen_lesson(self, event: Browser.Opened) -> None:
        if event.id:
            self.open_lesson(event.id)

    def open_lesson(self, name: str, step: int | None = None) -> None:
        """Go into a lesson, to its first open exercise or to a step of it."""
        course, progress, tongue = self.course, self.progress, self.lab.tongue
        if course is None or progress is None:
            return
        self.ask(lambda: Seat(Sitting(course.lesson(name), progress, tongue), step), self._sit)

    def _sit(self, seat: Seat) -> None:
        self.seat = seat
        self.add_class("-lesson")
        self._arrive()
        lesson = seat.sitting.lesson
        done = len(seat.sitting.tasks) - len(seat.sitting.open)
        self.inform("note", "head", minutes=lesson.minutes, count=len(seat.sitting.tasks), solved=done)
        self._name_damage()

    # A step.

    def go(self, step: int) -> None:
        """Go to a step of the lesson."""
        if self.seat is not None and 0 <= step < len(self.seat.steps):
            self.seat.at = step
            self._arrive()
            self.inform("note", "end" if self.seat.task is None else "read_first")

    def _arrive(self) -> None:
        """Show the step of now from its beginning."""
        seat = self.seat
        if seat is None:
            return
        self.set_class(seat.task is None, "-end")
        self.set_class(bool(seat.instrument), "-benched")
        self._show("text" if seat.steps[seat.at].parts or seat.task is None else "exercise")
        self._fill()
        self.query_one(Page).scroll_home(animate=False)
        self._focus()
        if seat.task is not None and seat.task.exercise.kind == "state":
            self.ask(seat.open_bench, lambda _: self._show_chain())
        elif seat.instrument == "leg":
            self.ask(seat.limb, lambda found: self.query_one(LegBench).take(*found))

    def _fill(self) -> None:
        """All texts of the step of now."""
        seat, course = self.seat, self.course
        if seat is None or course is None:
            return
        desk, table, task = self.query_one(Desk), seat.table, seat.task
        self.query_one("#title", Static).update(Content(seat.sitting.lesson.title(seat.sitting.language)))
        self.query_one(Page).flow.put(*telling.page(course, seat, self.say), fresh=True)
        kind = task.exercise.kind if task else ""
        desk.ask(kind, self._sign(table))
        desk.reply.placeholder = (
            self.say(f"placeholder.{kind}") if task and not desk.has_class("-state") else ""
        )
        desk.reply.put(table.reply)
        if table.bench is not None:
            desk.prompt.session = table.bench.session
        self.query_one(Bench).use(seat.instrument)
        self.query_one(Tabs).name_them({v: self.say(f"tab.{v}") for v in self._views()}, self.view)
        self._show_offers()
        self._show_answer()
        self._show_bytes()

    def _sign(self, table: Table) -> str:
        return self.say("sign.chain" if table.bench else "sign.answer")

    def _views(self) -> list[str]:
        """Those among which one can choose here."""
        stacked = self.has_class("-stacked")
        bench = ["bench"] if self.has_class("-benched") else []
        return ["exercise", *bench] if stacked else ["text", "exercise", *bench]

    def _show(self, view: str) -> None:
        """Show a view, the next best where there is no such one."""
        self.view = view if view in self._views() else self._views()[0]
        for each in VIEWS:
            self.set_class(each == self.view, f"view-{each}")
        self.query_one(Tabs).choose(self.view)
        self.refresh_bindings()

    def _focus(self) -> None:
        """Give the keys to what is read, or to what is answered."""
        if self.seat is None:
            self.query_one(List).focus()
        elif self.seat.task is None or (self.view == "text" and not self.has_class("-beside")):
            self.query_one(Page).focus()
        else:
            self.query_one(Desk).begin()

    def _show_offers(self) -> None:
        seat, desk = self.seat, self.query_one(Desk)
        if seat is None or seat.task is None:
            return
        offered = offers(seat.task)
        order = seat.task.exercise.kind == "order"
        said = placed(seat.table.reply, offered) if order else seat.table.tried
        plain = seat.task.exercise.kind == "mistake"
        if offered:
            desk.options.put(offered, said, plain=plain, ascii_only=self.lab.ascii_only)

    def _show_answer(self) -> None:
        """How the exercise stands, and what was said to the answer."""
        seat, desk = self.seat, self.query_one(Desk)
        if seat is None:
            return
        self.query_one(Steps).put(seat.standings, seat.at, ascii_only=self.lab.ascii_only)
        desk.question.put(*telling.question(seat, self.say))
        judged = seat.table.judged
        faults = []
        if judged is not None and seat.task is not None:
            desk.judge(telling.verdict(judged.verdict, seat.sitting, self.lab.ascii_only))
            if judged.reply == seat.table.reply:
                faults = marked(seat.task, judged.reply, judged.verdict)
                desk.reply.put(judged.reply, faults)
        else:
            desk.judge()
        desk.mark(faults)
        if seat.task is not None:
            desk.aid(*telling.aid(seat, seat.table, self.say))
        self.refresh_bindings()

    def _show_bytes(self) -> None:
        seat = self.seat
        if seat is not None and seat.instrument == "bytes":
            done = seat.sitting.standing(seat.name).done
            empty = self.say("bytes.empty")
            self.query_one(BytesBench).show(seat.table.reply, whole=done, empty=empty)

    def _show_chain(self) -> None:
        """The chain as it is now, and what was said to it."""
        seat = self.seat
        if seat is None or seat.table.bench is None:
            return
        desk, table = self.query_one(Desk), seat.table
        desk.prompt.session = seat.table.bench.session
        desk.ask("state", self.say("sign.chain"))
        desk.answer(table.talk or [[("dim", self.say("chain_waits"))]])
        names = {name: self.say(f"column.{name}") for name in COLUMNS}
        self.query_one(ChainBench).show(seat.table.bench, table.servo, self.lab.ascii_only, names)

    # Answers.

    @on(Reply.Given)
    def _given(self, event: Reply.Given) -> None:
        seat = self.seat
        if seat is None or seat.task is None:
            return
        right = seat.table.judged is not None and seat.table.judged.verdict.ok
        if right and seat.table.judged and seat.table.judged.reply == event.text:
            self.action_next()
        else:
            self._judge(lambda: seat.judge(event.text))

    def _judge(self, work: Callable[[], Verdict | None]) -> None:
        seat = self.seat
        self.ask(work, lambda verdict: self._judged(verdict) if self.seat is seat else None)

    def _judged(self, verdict: Verdict | None) -> None:
        seat = self.seat
        if seat is None or seat.task is None:
            return
        self._show_chain()
        self._show_offers()
        self._show_answer()
        self._show_bytes()
        if verdict is None:
            return
        now = seat.sitting.standing(seat.name)
        if verdict.ok:
            self.inform("good", "go_on")
        elif not verdict.counts:
            self.inform("warn", "no_try")
        elif now.may_see_solution:
            self.inform("bad", "offer_solution", tries=now.tries)
        elif now.hints < len(seat.task.hints):
            self.inform("bad", "offer_hint", tries=now.tries, left=TRIES_BEFORE_SOLUTION - now.tries)
        else:
            self.inform("bad", "again_please", tries=now.tries, left=TRIES_BEFORE_SOLUTION - now.tries)
        self._name_damage()

    @on(Reply.Typed)
    def _typed(self, event: Reply.Typed) -> None:
        seat = self.seat
        if seat is None or seat.task is None:
            return
        seat.table.reply = event.text
        self.query_one(Desk).mark(())
        if seat.task.exercise.kind == "order":
            self._show_offers()
        self._show_bytes()
        pose = seat.typed_angles(event.text)
        if pose is not None:
            self.query_one(LegBench).pose(pose)

    @on(Options.Chosen)
    def _chosen(self, event: Options.Chosen) -> None:
        seat, desk = self.seat, self.query_one(Desk)
        if seat is None or seat.task is None:
            return
        if seat.task.exercise.kind != "order":
            judged = seat.table.judged
            if judged is not None and judged.verdict.ok and judged.reply == event.label:
                self.action_next()
                return
            self._judge(lambda: seat.judge(event.label))
            return
        words = seat.table.reply.split()
        words = [w for w in words if w != event.label] if event.label in words else [*words, event.label]
        desk.reply.value = " ".join(words)
        if len(words) == len(offers(seat.task)):
            desk.reply.focus()

    @on(Prompt.Entered)
    def _line(self, event: Prompt.Entered) -> None:
        seat = self.seat
        if seat is None or seat.task is None:
            return
        if not event.line.strip():
            if seat.sitting.standing(seat.name).done:
                self.action_next()
        elif event.line.strip().casefold() in ("done", "selesai"):
            self.action_check()
        else:
            self._judge(lambda: seat.talk_to_chain(event.line))

    # What the widgets tell.

    @on(Flow.Wanted)
    def _draw(self, event: Flow.Wanted) -> None:
        seat = self.seat
        if seat is None:
            return
        for figure in event.figures:

            def draw(figure: Any = figure) -> Any:
                return seat.sitting.picture(figure, event.columns, ascii_only=self.lab.ascii_only)

            self.ask(draw, lambda picture, figure=figure: event.flow.draw(figure, event.columns, picture))  # type: ignore[misc]

    @on(Steps.Chosen)
    def _to_step(self, event: Steps.Chosen) -> None:
        self.go(event.step)

    @on(Tabs.Chosen)
    def _to_view(self, event: Tabs.Chosen) -> None:
        self._show(event.name)
        self._focus()

    @on(Page.ReadOn)
    def _read_on(self) -> None:
        if self.seat is not None and self.seat.task is None:
            self.action_next()
        else:
            self._show("exercise")
            self._focus()

    @on(Resize)
    def _laid_out(self) -> None:
        wide, tall = self.size.width >= 120, self.size.height >= 30
        before = (self.has_class("-beside"), self.has_class("-stacked"))
        self.set_class(wide, "-beside")
        self.set_class(tall and not wide, "-stacked")
        if before != (wide, tall and not wide) and self.seat is not None:
            self._fill()
            self._show(self.view)

    def relabel(self) -> None:
        self._list()
        kind, key, values = self._informed
        self.inform(kind, key, **values)
        seat = self.seat
        if seat is None:
            return
        if seat.sitting.language != self.lab.tongue:
            course, progress, tongue = self.course, self.progress, self.lab.tongue
            name, at, tables = seat.sitting.lesson.id, seat.at, seat.tables
            if course is not None and progress is not None:
                self.ask(
                    lambda: Seat(Sitting(course.lesson(name), progress, tongue), at, tables), self._translated
                )

    def _translated(self, seat: Seat) -> None:
        self.seat = seat
        if seat.table.bench is not None and seat.task is not None:
            seat.table.bench.task = seat.task
        self._fill()
        self._show_chain()

    # What a person does.

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Only what can be done now is offered."""
        seat = self.seat
        if action in AT_LIST:
            return seat is None
        if action in IN_LESSON and seat is None:
            return False
        if action in AT_EXERCISE:
            if seat is None or seat.task is None:
                return False
            if action in ("check", "again"):
                return seat.task.exercise.kind == "state"
            if action == "solution":
                return True if seat.sitting.standing(seat.name).may_see_solution else None
        if action == "view":
            return not self.has_class("-end") and len(self._views()) > 1 and not self.has_class("-beside")
        return True

    def action_hint(self) -> None:
        """Show the next hint; after the last one begin again with the first."""
        seat = self.seat
        if seat is None or seat.task is None:
            return
        table, known = seat.table, len(seat.sitting.hints(seat.name))
        if not seat.task.hints:
            self.inform("note", "no_hints")
            return

        def shown(_: object) -> None:
            count = len(seat.sitting.hints(seat.name))
            table.hint = (table.hint + 1) % count
            self._aided()

        if table.hint + 1 < known:
            shown(None)
        else:
            self.ask(lambda: seat.sitting.hint(seat.name), shown)

    def action_earlier_hint(self) -> None:
        """Go back to the hint before."""
        if self.seat is not None and self.seat.table.hint > 0:
            self.seat.table.hint -= 1
            self._aided()

    def _aided(self) -> None:
        if self.view == "text" and not self.has_class("-beside"):
            self._show("exercise")
        self._show_answer()

    def action_solution(self) -> None:
        """Show the solution, where enough was tried; the exercise then counts as shown."""
        seat = self.seat
        if seat is None or seat.task is None:
            return

        def shown(text: str | None) -> None:
            now = seat.sitting.standing(seat.name)
            if text is None:
                left = TRIES_BEFORE_SOLUTION - now.tries
                self.inform("warn", "no_solution", tries=TRIES_BEFORE_SOLUTION, left=left)
                return
            seat.table.solution = text
            self._aided()
            self.inform("note", "marked_shown" if now.shown else "solved_before")

        self.ask(lambda: seat.sitting.solution(seat.name), shown)

    def action_next(self) -> None:
        """Go to the next step; from the end, and from the list, to the next lesson that is open."""
        seat = self.seat
        if seat is not None and seat.at + 1 < len(seat.steps):
            self.go(seat.at + 1)
            return
        if self.course is None or self.progress is None:
            return
        if seat is not None and seat.sitting.open:
            self.go(list(seat.sitting.tasks).index(seat.sitting.open[0]))
            return
        following = self.course.next_for(self.progress)
        if following is None:
            self.action_contents()
            self.inform("good", "course_finished")
        else:
            self.open_lesson(following.id)

    def action_previous(self) -> None:
        """Go back a step."""
        if self.seat is not None:
            self.go(self.seat.at - 1)

    def action_view(self) -> None:
        """Show the next view."""
        views = self._views()
        self._show(views[(views.index(self.view) + 1) % len(views)])
        self._focus()

    def action_check(self) -> None:
        """Ask what is still missing; counts as a try."""
        if self.seat is not None:
            self._judge(self.seat.judge_bench)

    def action_again(self) -> None:
        """Set the chain up anew."""
        seat = self.seat
        if seat is not None:
            self.ask(lambda: seat.open_bench(fresh=True), lambda _: self._judged(None))
            self.inform("note", "set_up")

    def action_contents(self) -> None:
        """Go back to the list."""
        self._list()
        self.seat = None
        self.remove_class("-lesson", "-end", "-benched")
        self.refresh_bindings()
        self._focus()
        self.inform("note", "welcome")

    def action_scroll(self, pages: int) -> None:
        """Scroll what is read."""
        page: VerticalScroll = self.query_one(Page)
        if not page.display:
            page = self.query_one("#asked", VerticalScroll)
        page.scroll_relative(y=pages * max(page.size.height - 1, 1), animate=False)

    def action_search(self) -> None:
        """Look for a lesson."""
        self.query_one(Search).focus()

    def action_only_open(self) -> None:
        """List only what is open, or everything again."""
        browser = self.query_one(Browser)
        browser.only_open = not browser.only_open
        self._list()
        self.inform("note", "only_open" if browser.only_open else "all_lessons")

    def action_profile(self) -> None:
        """Choose whose progress it is."""
        from kinlab.tui.stations.lessons.dialogs import Profiles

        if self.progress is not None:
            self.app.push_screen(Profiles(self, self.progress.profile), self._as_profile)

    def _as_profile(self, name: str | None) -> None:
        if name:
            self.ask(lambda: Progress(name), self._with_progress)

    def _with_progress(self, progress: Progress) -> None:
        self.progress = progress
        self._list()
        self.inform("good", "profile_is", profile=progress.profile)
        self._name_damage()

    def action_reset(self) -> None:
        """Begin a lesson anew, after a question."""
        from kinlab.tui.stations.lessons.dialogs import Sure

        course, progress = self.course, self.progress
        name = self.seat.sitting.lesson.id if self.seat else self.query_one(Browser).chosen
        if course is None or progress is None or not name:
            return
        lesson = course.lesson(name)
        each = [progress.standing(lesson.id, lesson.version, e.id) for e in lesson.exercises]
        text = self.say(
            "reset_sure", title=lesson.title(self.lab.tongue), count=sum(now.done for now in each)
        )
        self.app.push_screen(Sure(self, text), lambda sure: self._reset(name) if sure else None)

    def _reset(self, name: str) -> None:
        course, progress, tongue = self.course, self.progress, self.lab.tongue
        if course is None or progress is None:
            return

        def reset() -> Seat:
            sitting = Sitting(course.lesson(name), progress, tongue)
            sitting.reset()
            return Seat(sitting)

        def done(seat: Seat) -> None:
            if self.seat is not None:
                self._sit(seat)
            self._list()
            self.inform("good", "reset_done")

        self.ask(reset, done)
