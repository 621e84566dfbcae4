"""The Lessons station: a list of lessons, and one of them with text, exercise and instrument side by side."""

import asyncio
from collections.abc import Callable
from typing import Any, TypeVar

from textual import on
from textual.app import ComposeResult

from kinlab.errors import KinlabError
from kinlab.lessons import Course, Progress, Sitting, Verdict, load_course
from kinlab.lessons.progress import PROFILE, TRIES_BEFORE_SOLUTION
from kinlab.tui.station import Station
from kinlab.tui.stations.lessons import telling
from kinlab.tui.stations.lessons.actions import ACTIONS, AT_EXERCISE, AT_LIST, IN_LESSON
from kinlab.tui.stations.lessons.bench import Bench, LegBench
from kinlab.tui.stations.lessons.browser import Browser, List, Search
from kinlab.tui.stations.lessons.flow import Flow
from kinlab.tui.stations.lessons.gait_bench import GaitBench
from kinlab.tui.stations.lessons.page import Page
from kinlab.tui.stations.lessons.room import Room
from kinlab.tui.stations.lessons.seat import Seat
from kinlab.tui.stations.lessons.steps import Steps
from kinlab.tui.stations.packet.prompt import Prompt

T = TypeVar("T")


class LessonsStation(Station):
    """The course.

    Attributes:
        course: the lessons; None until they are read.
        progress: of the profile.
        seat: in the open lesson; None at the list.
    """

    NAME = "lessons"
    ACTIONS = ACTIONS
    AUTO_FOCUS = ""
    CSS = """
    LessonsStation {
        &.-lesson Browser { display: none; }
        &.-wide {
            #found { layout: horizontal; }
            #lessons { width: 3fr; height: 100%; }
            #about { width: 2fr; height: 100%; border-top: none; border-left: solid $faint; }
        }
        &.-low.-narrow #about { height: 5; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self.course: Course | None = None
        self.progress: Progress | None = None
        self.seat: Seat | None = None
        self._kept: dict[str, Any] = {}
        self._informed: tuple[str, str, dict[str, object]] = ("note", "reading", {})
        self._order = asyncio.Lock()  # what is asked of the core goes there in the order of asking

    def compose_body(self) -> ComposeResult:
        yield Browser()
        yield Room()

    @property
    def room(self) -> Room:
        """Where the open lesson is shown."""
        return self.query_one(Room)

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
        self.inform("note", "end" if seat.task is None else self._how_to_go_on())
        self._name_damage()

    # A step.

    def go(self, step: int) -> None:
        """Go to a step of the lesson."""
        if self.seat is not None and 0 <= step < len(self.seat.steps):
            self.seat.at = step
            self._arrive()
            self.inform("note", "end" if self.seat.task is None else self._how_to_go_on())

    def _how_to_go_on(self) -> str:
        return "beside" if self.room.beside else "read_first" if self.room.view == "text" else "answer"

    def _arrive(self) -> None:
        seat, course = self.seat, self.course
        if seat is None or course is None:
            return
        self.room.arrive(course, seat)
        if seat.instrument == "chain":
            self.ask(seat.open_bench, lambda _: self.room.chain())
        elif seat.instrument == "leg":
            self.ask(seat.limb, lambda found: self.query_one(LegBench).take(*found))
        elif seat.instrument == "gait":
            self.ask(seat.walk, self.query_one(GaitBench).take)

    # Answers.

    @on(Room.Answered)
    def _answered(self, event: Room.Answered) -> None:
        seat = self.seat
        if seat is None or seat.task is None:
            return
        judged = seat.table.judged
        if judged is not None and judged.reply == event.reply:
            if judged.verdict.ok:
                self.action_next()
            else:
                self.inform("warn", "same")
        else:
            self._judge(lambda: seat.judge(event.reply))

    def _judge(self, work: Callable[[], Verdict | None]) -> None:
        seat = self.seat
        self.ask(work, lambda verdict: self._judged(verdict) if self.seat is seat else None)

    def _judged(self, verdict: Verdict | None) -> None:
        seat = self.seat
        if seat is None or seat.task is None:
            return
        self.room.chain()
        self.room.answered()
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

    @on(GaitBench.Wanted)
    def _walk(self, event: GaitBench.Wanted) -> None:
        seat = self.seat
        if seat is not None:
            self.ask(lambda: seat.walk(event.gait), self.query_one(GaitBench).take)

    @on(Steps.Chosen)
    def _to_step(self, event: Steps.Chosen) -> None:
        self.go(event.step)

    @on(Page.ReadOn)
    def _read_on(self) -> None:
        if self.seat is not None and self.seat.task is None:
            self.action_next()
        else:
            self.room.show("exercise")
            self.room.begin()

    def relabel(self) -> None:
        self._list()
        self.query_one(Bench).relabel()
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
        if self.course is not None:
            self.room.fill(self.course, seat)

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
            return len(self.room.views) > 1
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
        self.room.to_exercise()
        self.room.answered()

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
        self.room.show_next()

    def action_check(self) -> None:
        """Ask what is still missing; counts as a try."""
        if self.seat is not None and self.seat.instrument == "chain":
            self._judge(self.seat.judge_bench)

    def action_again(self) -> None:
        """Set the chain up anew."""
        seat = self.seat
        if seat is not None and seat.instrument == "chain":
            self.ask(lambda: seat.open_bench(fresh=True), lambda _: self._judged(None))
            self.inform("note", "set_up")

    def action_contents(self) -> None:
        """Go back to the list."""
        self._list()
        self.seat = None
        self.remove_class("-lesson")
        self.room.leave()
        self.refresh_bindings()
        self.query_one(List).focus()
        self.inform("note", "welcome")

    def action_scroll(self, pages: int) -> None:
        """Scroll what is read."""
        self.room.scroll_page(pages)

    def action_glossary(self) -> None:
        """Look up a word."""
        from kinlab.tui.stations.lessons.dialogs import Glossary

        if self.course is not None:
            self.app.push_screen(Glossary(self, self.course.glossary.values(), self.lab.tongue))

    def action_search(self) -> None:
        """Look for a lesson."""
        if self.seat is not None:
            self.action_contents()
        self.query_one(Search).focus()

    def action_only_open(self) -> None:
        """List only what is open, or everything again."""
        if self.seat is not None:
            self.action_contents()
        browser = self.query_one(Browser)
        browser.only_open = not browser.only_open
        self._list()
        self.inform("note", "only_open" if browser.only_open else "all_lessons")

    def action_profile(self) -> None:
        """Choose whose progress it is."""
        from kinlab.tui.stations.lessons.dialogs import Profiles

        if self.progress is not None and self.seat is None:
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
