"""The Robot station: a target or joint angles, and everything that follows from them."""

import asyncio
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal, VerticalScroll
from textual.content import Content
from textual.events import Resize
from textual.widgets import Select, Static

from kinlab.canvas import Canvas
from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb, Robot
from kinlab.robots.load import load_robots, shipped_robots
from kinlab.robots.model import FRAMES
from kinlab.tui.numbers import shown
from kinlab.tui.station import Station
from kinlab.tui.stations.robot.actions import ACTIONS
from kinlab.tui.stations.robot.form import Form
from kinlab.tui.stations.robot.kept import kept_in
from kinlab.tui.stations.robot.question import Question
from kinlab.tui.widgets import Choice, Dial, Picture
from kinlab.tui.widgets.said import retext

BESIDE = 140  # columns that let the print stand beside the path
if TYPE_CHECKING:
    from kinlab.tui.stations.robot.asking import Answer, Asker

STEP = 0.001  # m; how far an arrow key moves the target
SIDE, TOP = "side", "top"  # the pictures


class RobotStation(Station):
    """Choose a robot and a limb, give a target or angles, see the path and its errors."""

    NAME = "robot"
    ACTIONS = ACTIONS
    AUTO_FOCUS = ""  # the form takes the focus itself, once it is laid out
    CSS = """
    RobotStation {
        #choices { height: 1; background: $surface; }
        #robot { width: 22; } #limb { width: 18; } #frame { width: 12; } #begin { width: 12; }
        #top { height: 1fr; }
        Form { width: 30; }
        Picture { width: 1fr; height: 100%; margin-left: 1; }
        #path { height: auto; max-height: 10; padding: 0 1; background: $surface; scrollbar-size-vertical: 1; }
        #path Horizontal { height: auto; }
        #rows, #print { height: auto; width: 1fr; }
    }
    RobotStation #path:focus { background: $panel; }
    RobotStation.-tall #path { max-height: 50%; }
    RobotStation.-wide Form { width: 44; }
    RobotStation.-narrow {
        #robot { width: 18; } #limb { width: 14; }
        #path { max-height: 8; }
        Picture { display: none; }
        Picture.shown { display: block; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self.refused = ""
        try:
            self.robots = load_robots()
        except KinlabError as error:
            self.refused, self.robots = str(error), shipped_robots()
        self.robot: Robot = next(iter(self.robots.values()))
        self.limb: Limb = self.robot.limb()
        # None: where the limb's paper begins, which the first answer tells.
        self.target: Array | None = None
        self.rpy: Array = np.zeros(3)
        self.angles: Array | None = None
        self.frame, self.solution = "limb", ""
        self.powered, self.mirrored, self.ghost, self.bounds = True, False, False, True
        self.answer: Answer | None = None
        self.stood: Array | None = None
        self._asker: Asker | None = None
        self._asked: Question | None = None
        self._busy = False

    def compose_body(self) -> ComposeResult:
        with Horizontal(id="choices"):
            yield Choice(self.robots, self.robot.name, id="robot")
            yield Choice(self.robot.limbs, self.limb.name, id="limb")
            yield Choice(("target", "angles"), "target", id="begin")
            yield Choice(FRAMES, "limb", id="frame")
        with Horizontal(id="top"):
            yield Form()
            yield Picture(
                partial(self._draw, SIDE), self._side_caption, focusable=True, id=SIDE, classes="shown"
            )
            yield Picture(partial(self._draw, TOP), self._top_caption, focusable=True, id=TOP)
        with VerticalScroll(id="path"), Horizontal():
            yield Static(id="rows", markup=False)
            yield Static(id="print", markup=False)

    # Beginning, and the next time.

    def restore(self, state: dict[str, Any]) -> None:
        kept_in(self, state)

    def state(self) -> dict[str, Any]:
        return {
            "robot": self.robot.name,
            "limb": self.limb.name,
            "frame": self.frame,
            "target_m": None if self.target is None else self.target.tolist(),
            "rpy_rad": self.rpy.tolist(),
            "angles_rad": None if self.angles is None else self.angles.tolist(),
            "solution": self.solution,
            "ghost": self.ghost,
            "bounds": self.bounds,
        }

    def ready(self) -> None:
        self.relabel()
        self.query_one(Form).begin()
        # The first frame does not wait for the answer, nor for the rooms that it needs.
        self.call_after_refresh(self.ask)

    def relabel(self) -> None:
        self.query_one("#robot", Choice).offer(self.robots, self.robot.name)
        self.query_one("#limb", Choice).offer(self.robot.limbs, self.limb.name)
        frames = [self.say(f"frame.{name}") for name in FRAMES]
        self.query_one("#frame", Choice).offer(FRAMES, self.frame, frames)
        begins = ("target", "angles")
        names = [self.say(f"begin.{name}") for name in begins]
        self.query_one("#begin", Choice).offer(begins, begins[self.angles is not None], names)
        self._show_form()
        self._paint()

    @on(Resize)
    def _resized(self) -> None:
        if self.answer is not None:
            self.call_after_refresh(self._show_rows)

    # Asking and showing.

    @property
    def asking(self) -> bool:
        """Whether an answer is still to come."""
        return self._busy

    def ask(self) -> None:
        """Walk the path for what is set now. While one question is out, only the latest other one is kept."""
        attitude = self.rpy if len(self.limb.joints) >= 6 else None
        self._asked = Question(
            self.robot, self.limb, self.target, attitude, self.angles, self.frame, self.solution,
            self.powered, self.mirrored,
        )  # fmt: skip
        if not self._busy:
            self._busy = True
            self.run_worker(self._answer_all(), group="path", exit_on_error=True)

    async def _answer_all(self) -> None:
        try:
            while self._asked is not None:
                question, self._asked = self._asked, None
                try:
                    answer = await asyncio.to_thread(self._ask_core, question)
                except KinlabError as error:
                    self.tell("bad", str(error))
                    continue
                self._show(answer)
        finally:
            self._busy = False

    def _ask_core(self, question: Question) -> "Answer":
        from kinlab.tui.stations.robot.asking import Asker

        self._asker = self._asker or Asker()
        return self._asker.ask(question)

    def _show(self, answer: "Answer") -> None:
        """A new answer has come."""
        other = self.answer is None or self.answer.question.limb is not answer.question.limb
        self.answer = answer
        if other or answer.path.pose is not None:
            self.stood = answer.path.pose.q if answer.path.pose is not None else None
        if self._asked is None:
            begins = other or self.target is None
            if self.angles is not None or self.target is None:
                # Where angles lead is the target to go on with.
                self.target = answer.path.answer.target
            # Dials that already stand there may hold what has just been typed, and is on its way.
            if begins:
                self._show_form()
        self._paint()

    def _paint(self) -> None:
        """Show the answer of now, if there is one."""
        if self.answer is None:
            return
        from kinlab.tui.stations.robot.telling import verdict

        self.query_one(Form).offer_solutions(self.answer, self.say)
        self._show_rows()
        self._redraw()
        if self.answer.unmirrored:
            self.mirrored, self.refused = False, self.answer.unmirrored
        refused, self.refused = self.refused, ""
        self.tell(*(("warn", refused) if refused else verdict(self.answer, self.say)))

    def _show_rows(self) -> None:
        if self.answer is None:
            return
        from kinlab.tui.stations.robot.table import path_rows, print_rows

        width, roomy = self.query_one("#path").size.width - 3, self.has_class("-tall")
        beside = width >= BESIDE
        width = max(width // 2 if beside else width, 40)
        path = self.answer.path
        blocks = [path_rows(path, self.say, width), print_rows(path, self.say, width, roomy=roomy)]
        self.query_one("#print").display = beside
        if beside:
            retext(self.query_one("#print", Static), blocks.pop())
        retext(self.query_one("#rows", Static), Content("\n").join(blocks))

    def _show_form(self) -> None:
        form = self.query_one(Form)
        if self.angles is not None:
            form.show_angles(self.limb, self.angles)
        elif self.target is not None and self.answer is not None:
            form.show_target(self.limb, self.target, self.rpy, self.frame, self.answer.box)

    def _redraw(self) -> None:
        for picture in self.query(Picture):
            picture.redraw()

    # Pictures.

    def _draw(self, name: str, columns: int, rows: int, ascii_only: bool) -> Canvas | None:
        if self.answer is None:
            return None
        from kinlab.tui.stations.robot.drawing import draw

        seen = self.answer.top if name == TOP else self.answer.side
        printed = self.say("printed.ghost") if self.ghost else ""
        return draw(
            self.answer, seen, columns, rows,
            stood=self.stood, printed=printed, limits=self.bounds, ascii_only=ascii_only,
        )  # fmt: skip

    def _side_caption(self, canvas: Canvas) -> str:
        return self.say("view.side", cell=shown(canvas.cell_width, 1))

    def _top_caption(self, canvas: Canvas) -> str:
        return self.say("view.top", cell=shown(canvas.cell_width, 1))

    @on(Picture.Pointed)
    def _pointed(self, event: Picture.Pointed) -> None:
        if self.answer is not None and self.target is not None:
            seen = self.answer.top if event.picture.id == TOP else self.answer.side
            self._move_to(seen.point(event.x, event.y, self.target))

    def action_nudge(self, right: int, up: int) -> None:
        """Move the target in the view that has the focus, the one from the side where none has."""
        if self.answer is not None and self.target is not None:
            focused = self.focused.id if self.focused is not None else ""
            seen = self.answer.top if focused == TOP else self.answer.side
            self._move_to(self.target + STEP * (right * seen.across + up * seen.up))

    def _move_to(self, target: Array) -> None:
        """Send the tip to a point (3,); where the path began at angles, it begins at a target from now on."""
        self.target = np.round(target, 4)
        if self.angles is not None:
            self._begin_at_angles(None)
        self._show_form()
        self.ask()

    # The form.

    @on(Dial.Changed)
    def _dialled(self, event: Dial.Changed) -> None:
        form = self.query_one(Form)
        if self.angles is not None:
            self.angles = form.angles(len(self.limb.joints))
        else:
            self.target, self.rpy = form.target(self.limb, self.frame), form.rpy()
        self.ask()

    @on(Select.Changed, "#robot")
    def _choose_robot(self, event: Select.Changed) -> None:
        if event.select.value != self.robot.name:
            self.take(self.robots[str(event.select.value)])

    @on(Select.Changed, "#limb")
    def _choose_limb(self, event: Select.Changed) -> None:
        if event.select.value != self.limb.name:
            self.take(self.robot, self.robot.limbs[str(event.select.value)])

    @on(Select.Changed, "#frame")
    def _choose_frame(self, event: Select.Changed) -> None:
        if event.select.value != self.frame:
            self.frame = str(event.select.value)
            self._show_form()
            self.ask()

    @on(Select.Changed, "#begin")
    def _choose_begin(self, event: Select.Changed) -> None:
        if (event.select.value == "angles") != (self.angles is not None):
            self.action_begin()

    @on(Select.Changed, "#solution")
    def _choose_solution(self, event: Select.Changed) -> None:
        if self.answer and self.answer.path.pose and event.select.value != self.answer.path.pose.name:
            self.solution = str(event.select.value)
            self.ask()

    def _posed(self) -> Array:
        """The angles of now; where the target has none, those in which the limb stands; else the limits' middle."""
        if self.answer is None or self.answer.question.limb is not self.limb or self.stood is None:
            return np.asarray(self.limb.limits.mean(axis=0))
        return self.stood

    def _begin_at_angles(self, angles: Array | None) -> None:
        self.angles = angles
        self.query_one("#begin", Choice).put("target" if angles is None else "angles")
        self._show_form()
        self.ask()

    def take(self, robot: Robot, limb: Limb | None = None) -> None:
        """Go on with another limb, at the place where its paper begins."""
        self.set(robot, limb or robot.limb())
        self.relabel()
        self.ask()

    def set(self, robot: Robot, limb: Limb) -> None:
        """Another limb; shows nothing yet."""
        self.robot, self.limb = robot, limb
        self.target, self.rpy = None, np.zeros(3)
        self.angles, self.solution = None, ""

    # Keys.

    def action_next_robot(self) -> None:
        """Take the next robot."""
        names = list(self.robots)
        self.take(self.robots[names[(names.index(self.robot.name) + 1) % len(names)]])

    def action_next_limb(self) -> None:
        """Take the next limb."""
        names = list(self.robot.limbs)
        self.take(self.robot, self.robot.limbs[names[(names.index(self.limb.name) + 1) % len(names)]])

    def action_next_frame(self) -> None:
        """Show places in the next frame."""
        self.frame = FRAMES[(FRAMES.index(self.frame) + 1) % len(FRAMES)]
        self.relabel()
        self.ask()

    def action_begin(self) -> None:
        """Begin at angles, or at a target again."""
        self._begin_at_angles(self._posed() if self.angles is None else None)

    def action_next_solution(self) -> None:
        """Send the next solution on."""
        if self.answer is not None and self.answer.path.pose is not None:
            names = [pose.name for pose in self.answer.path.answer.poses if pose.within_limits]
            self.solution = names[(names.index(self.answer.path.pose.name) + 1) % len(names)]
            self.ask()

    def action_home(self) -> None:
        """Go back to where the limb began."""
        self.take(self.robot, self.limb)

    def action_ghost(self) -> None:
        """Draw, or don't, where the printed equations bring the limb."""
        self.ghost = not self.ghost
        self._redraw()

    def action_bounds(self) -> None:
        """Draw, or don't, the limits of the joints."""
        self.bounds = not self.bounds
        self._redraw()

    def action_view(self) -> None:
        """Where there is room for one view only, show the other."""
        for picture in self.query(Picture):
            picture.toggle_class("shown")

    def action_power(self) -> None:
        """Switch the supply of the emulated chain."""
        self.powered = not self.powered
        self.ask()

    def action_mirror(self) -> None:
        """Show the limb in a viewer too, or no longer."""
        self.mirrored = not self.mirrored
        self.ask()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Only what can be done now is offered."""
        if action == "view":
            return self.has_class("-narrow")
        if action == "power":
            return self.limb.joints[0].servo is not None and self.limb.joints[0].servo.model.unit == "tick"
        return True
