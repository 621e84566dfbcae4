"""The Gait stage: a walk that is played, stopped, stepped, and walked on emulated servos meanwhile."""

import time
from typing import Any

import numpy as np
from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.widgets import Select, Static

from kinlab.canvas import Canvas
from kinlab.errors import KinlabError
from kinlab.gait import Cycle, Walk, cycle_of, find_gait, gaits_for, load_gaits, plan
from kinlab.gait.drawing import draw_support, draw_swing
from kinlab.gait.plan import SPEED
from kinlab.robots import Robot
from kinlab.robots.load import load_robots
from kinlab.tui.actions import Action
from kinlab.tui.facts import fitting
from kinlab.tui.numbers import shown
from kinlab.tui.station import Station
from kinlab.tui.stations.gait.diagram import Diagram
from kinlab.tui.stations.gait.readings import joint_speeds, pace, walking
from kinlab.tui.stations.gait.rig import WalkingRig
from kinlab.tui.stations.gait.transport import Transport
from kinlab.tui.widgets import Choice, Dial, Picture, Plot

EVERY = 0.05  # s between pictures
# A picture that comes late moves the walk on by no more than this, s.
LATEST = 0.2
POWER_EVERY = 5  # pictures from one power curve to the next
POINTS = 120  # of a curve
# How fast people may ask a robot to go where no servo is known, m/s, and to turn, deg/s.
FAST, TURN = 0.1, 45.0
PAGES = ("walk", "servos")


class GaitStation(Station):
    """Choose a robot and a gait, and see it walk."""

    NAME = "gait"
    ACTIONS = (
        Action("play", "space,f9"),
        Action("frame", "left,right", each=("frame(-1)", "frame(1)"), display="←→"),
        Action("phase", "p,n", each=("phase(-1)", "phase(1)"), display="p n"),
        Action("page", "v,f10"),
        Action("next_gait", "g,f8"),
        Action("next_robot", "r,f7"),
        Action("next_leg", "l,f11"),
        Action("speed", "minus,plus", each=("speed(-1)", "speed(1)"), display="- +"),
        Action("turn", "less_than_sign,greater_than_sign", each=("turn(1)", "turn(-1)"), display="< >"),
        Action("begin", "home", shown=False),
    )
    CSS_PATH = "station.tcss"

    def __init__(self) -> None:
        super().__init__()
        self.robots = {name: robot for name, robot in load_robots().items() if _walks(robot)}
        self.robot: Robot = next(iter(self.robots.values()))
        self.gait_name = find_gait(self.robot).name
        self.speed_mm_s, self.turn_deg_s = SPEED * 1000, 0.0
        self.leg = 0
        self.page = PAGES[0]
        self.playing = False
        self.t = 0.0
        self.cycle: Cycle
        self.rig = WalkingRig()
        self._seen = 0.0
        self._facts = ""
        self._pictures = 0

    @classmethod
    def prepare(cls) -> None:
        load_gaits()

    def compose_body(self) -> ComposeResult:
        with Horizontal(classes="row"):
            yield Choice(self.robots, self.robot.name, id="robot")
            yield Choice([self.gait_name], self.gait_name, id="gait")
            yield Choice([self.robot.legs[0].name], self.robot.legs[0].name, id="leg")
            yield Transport()
        with Horizontal(classes="row"):
            yield Dial(unit="mm/s", low=-100, high=100, step=1, number=self.speed_mm_s, id="speed")
            yield Dial(unit="deg/s", low=-TURN, high=TURN, step=1, number=self.turn_deg_s, id="turn")
        yield Static(id="facts", markup=False)
        yield self.rig
        with Horizontal(id="floor"):
            with Vertical(id="left"):
                yield Diagram(id="diagram")
                yield Plot(y="mm", x="s", id="margin")
                yield Picture(self._draw_swing, self._swing_caption, id="swing")
            with Vertical(id="right"):
                yield Picture(self._draw_top, self._top_caption, id="top")
                with Vertical(id="more"):
                    yield Static(id="joints", markup=False)
                    yield Plot(y="W", x="s", id="power")

    def ready(self) -> None:
        self._show_page()
        self.query_one("#diagram").focus()
        self._use(self.robot, self.gait_name)
        self.set_interval(EVERY, self._tick)

    def state(self) -> dict[str, Any]:
        return {
            "robot": self.robot.name, "gait": self.gait_name, "speed_mm_s": self.speed_mm_s,
            "turn_deg_s": self.turn_deg_s, "leg": self.robot.legs[self.leg].name, "page": self.page,
        }  # fmt: skip

    def restore(self, state: dict[str, Any]) -> None:
        robot = self.robots.get(str(state.get("robot")))
        if robot is None:
            return
        speed, turn = state.get("speed_mm_s"), state.get("turn_deg_s")
        if isinstance(speed, int | float) and isinstance(turn, int | float):
            try:
                cycle_of(self._plan(robot, str(state.get("gait")), speed, turn))
            except KinlabError:
                return
            self.speed_mm_s, self.turn_deg_s = speed, turn
            self.robot, self.gait_name = robot, str(state.get("gait"))
        names = [leg.name for leg in robot.legs]
        self.leg = names.index(state["leg"]) if state.get("leg") in names else 0
        self.page = state["page"] if state.get("page") in PAGES else PAGES[0]

    def relabel(self) -> None:
        self.query_one("#speed", Dial).label(self.say("dial.speed"))
        self.query_one("#turn", Dial).label(self.say("dial.turn"))
        self.query_one("#diagram").refresh()
        self.query_one(Transport).refresh()
        self._show_walk()

    # The walk.

    def _plan(self, robot: Robot, gait: str | None, speed: float, turn: float) -> Walk:
        return plan(robot, find_gait(robot, gait), forward=speed / 1000, turn=float(np.radians(turn)))

    def _use(self, robot: Robot, gait: str | None = None) -> None:
        """Take another robot or gait; where it cannot go as fast, at the speed that every robot starts with."""
        problem = ""
        try:
            self._walk(robot, gait, self.speed_mm_s, self.turn_deg_s)
        except KinlabError:
            try:
                self._walk(robot, gait, SPEED * 1000, 0.0)
            except KinlabError as error:
                problem = str(error)
        legs = [leg.name for leg in self.robot.legs]
        self.query_one("#robot", Choice).put(self.robot.name)
        self.query_one("#gait", Choice).offer(gaits_for(self.robot), self.gait_name)
        self.query_one("#leg", Choice).offer(legs, legs[self.leg])
        fastest = self.cycle.limits.fastest or FAST
        self.query_one("#speed", Dial).span(-round(fastest * 1000), round(fastest * 1000), 1)
        self.relabel()
        if problem:
            self.tell("bad", problem)

    def _walk(self, robot: Robot, gait: str | None, speed: float, turn: float) -> None:
        """Show another walk at the same share of its cycle.

        Raises:
            KinlabError: it is beyond the legs or the servos.
        """
        cycle = cycle_of(self._plan(robot, gait, speed, turn))
        share = self.t / self.cycle.walk.period % 1 if hasattr(self, "cycle") else 0.0
        if robot is not self.robot:
            self.leg = 0
        self.robot, self.gait_name, self.cycle = robot, cycle.walk.gait.name, cycle
        self.speed_mm_s, self.turn_deg_s = speed, turn
        self.t = share * cycle.walk.period
        for name, number in (("#speed", speed), ("#turn", turn)):
            dial = self.query_one(name, Dial)
            dial.show(number)
            dial.remove_class("-refused")
        self.query_one("#diagram", Diagram).show(cycle.walk.gait, tuple(leg.name for leg in robot.legs))
        self.rig.take_up(cycle.walk)

    def _show_walk(self) -> None:
        cycle = self.cycle
        margins = (cycle.state.static * 1000).tolist()
        step = cycle.walk.period / len(cycle)
        self._margins = [((i + 0.5) * step, margin) for i, margin in enumerate(margins)]
        source = cycle.walk.gait.source
        kind = self.say(f"kind.{source.kind}")
        self.tell("note", self.say("walk.source", gait=self.gait_name, kind=kind, text=source.text))
        self._show()

    @on(Select.Changed)
    def _chosen(self, event: Select.Changed) -> None:
        event.stop()
        name, box = str(event.value), event.select.id
        self.query_one("#diagram").focus()
        if box == "robot":
            self._use(self.robots[name])
        elif box == "gait":
            self._use(self.robot, name)
        else:
            self.leg = [leg.name for leg in self.robot.legs].index(name)
            self._show()

    @on(Dial.Changed)
    def _dialled(self, event: Dial.Changed) -> None:
        event.stop()
        self._ask(event.dial.id == "speed", event.number)

    def _ask(self, is_speed: bool, number: float) -> None:
        """Go, or turn, at another speed; where that is impossible it is said, and the walk stays as it is."""
        speed = number if is_speed else self.speed_mm_s
        turn = self.turn_deg_s if is_speed else number
        try:
            self._walk(self.robot, self.gait_name, speed, turn)
        except KinlabError as error:
            self.query_one("#speed" if is_speed else "#turn", Dial).add_class("-refused")
            self.tell("bad", str(error))
            return
        self._show_walk()

    # Time.

    def _tick(self) -> None:
        now = time.monotonic()
        passed, self._seen = min(now - self._seen, LATEST), now
        if not self.is_current:
            return
        if self.playing:
            self.t += passed
        if self.rig.tread(self.t) or self.playing:
            self._show()

    def seek(self, t: float) -> None:
        """Stop, and show the instant `t`, s; one before the first cycle is that of the first cycle."""
        self._play(False)
        self.t = t if t >= 0 else t % self.cycle.walk.period
        self.rig.tread(self.t)
        self._show()

    def _play(self, on: bool) -> None:
        self.playing = on
        self.query_one(Transport).show(on)

    def _show(self) -> None:
        """Show the instant `t`."""
        cycle = self.cycle
        frame = cycle.frame_at(self.t)
        self.query_one("#diagram", Diagram).point(self.t / cycle.walk.period % 1)
        for name in ("#top", "#swing"):
            self.query_one(name, Picture).redraw()
        facts = self.query_one("#facts", Static)
        lines = [walking(self.say, cycle, frame), pace(self.say, cycle, frame)]
        text = "\n".join(fitting(line, facts.size.width) for line in lines)
        if text != self._facts:
            self._facts = text
            facts.update(text, layout=False)
        self.rig.show(self.say, self.t)
        self._show_servos(frame)

    def _show_servos(self, frame: int) -> None:
        joints = self.query_one("#joints", Static)
        if joints.region.width:
            speeds = joint_speeds(
                self.say, self.cycle, frame, self.rig.at(self.t), joints.size.width, self.lab.ascii_only
            )
            # Places are worked out anew only where another robot has more legs, or fewer.
            joints.update(speeds, layout=len(speeds.plain.splitlines()) != joints.size.height)
        margin = self.query_one("#margin", Plot)
        if margin.region.width:
            now = self._margins[frame]
            margin.plot(
                {"": self._margins, self.say("plot.now"): [(now[0], 0.0), now]}, self.say("plot.margin")
            )
        self._pictures += 1
        power = self.query_one("#power", Plot)
        power.visible = not self.rig.problem
        if power.region.width and (self._pictures % POWER_EVERY == 0 or not self.playing):
            samples = list(self.rig.mill.samples) if self.rig.mill else []
            thin = samples[:: max(len(samples) // POINTS, 1)]
            power.plot({"": [(s.t, s.power) for s in thin]}, self.say("plot.power"))

    # Pictures.

    def _draw_top(self, columns: int, rows: int, ascii_only: bool) -> Canvas:
        state = self.cycle.state
        return draw_support(
            state.frame(self.cycle.frame_at(self.t)), around=state, columns=columns, rows=rows,
            ascii_only=ascii_only,
        )  # fmt: skip

    def _draw_swing(self, columns: int, rows: int, ascii_only: bool) -> Canvas:
        frame = self.cycle.frame_at(self.t)
        return draw_swing(self.cycle, self.leg, frame, columns=columns, rows=rows, ascii_only=ascii_only)

    def _top_caption(self, canvas: Canvas) -> str:
        return self.say("view.top", cell=shown(canvas.cell_width, 1))

    def _swing_caption(self, canvas: Canvas) -> str:
        walk = self.cycle.walk
        return self.say(
            "view.swing", leg=self.robot.legs[self.leg].name, lift=shown(walk.lift * 1000, 1),
            stroke=shown(walk.stroke * 1000, 1), cell=shown(canvas.cell_width, 1),
        )  # fmt: skip

    # What people do.

    def _show_page(self) -> None:
        self.update_classes({f"page-{page}": page == self.page for page in PAGES})

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Where there is room for both halves nobody turns the page."""
        return not (action == "page" and self.has_class("-wide"))

    def action_page(self) -> None:
        """Show the other half of what there is, where a terminal has no room for both."""
        self.page = PAGES[(PAGES.index(self.page) + 1) % len(PAGES)]
        self._show_page()
        self.call_after_refresh(self._show)

    def action_play(self) -> None:
        """Play, or stop."""
        self._play(not self.playing)
        self._seen = time.monotonic()

    def action_frame(self, frames: int) -> None:
        """Stop, and go on by frames, or back."""
        self.seek(self.cycle.frames_on(self.t, frames))

    def action_phase(self, phases: int) -> None:
        """Stop, and go to the beginning of another phase."""
        self.seek(self.cycle.phases_on(self.t, phases))

    def action_begin(self) -> None:
        """Go to the beginning of the cycle."""
        self.seek(self.t // self.cycle.walk.period * self.cycle.walk.period)

    def action_speed(self, steps: int) -> None:
        """Go faster, or slower, by a mm/s."""
        self._ask(True, round(self.speed_mm_s) + steps)

    def action_turn(self, steps: int) -> None:
        """Turn more to the left, or to the right, by a deg/s."""
        self._ask(False, round(self.turn_deg_s) + steps)

    def action_next_gait(self) -> None:
        """Take the next gait of this kind of robot."""
        names = list(gaits_for(self.robot))
        self._use(self.robot, names[(names.index(self.gait_name) + 1) % len(names)])

    def action_next_robot(self) -> None:
        """Take the next robot that walks."""
        names = list(self.robots)
        robot = self.robots[names[(names.index(self.robot.name) + 1) % len(names)]]
        self._use(robot)

    def action_next_leg(self) -> None:
        """See the swing of the next leg."""
        self.leg = (self.leg + 1) % len(self.robot.legs)
        self.query_one("#leg", Choice).put(self.robot.legs[self.leg].name)
        self._show()

    @on(Diagram.Sought)
    def _sought(self, event: Diagram.Sought) -> None:
        period = self.cycle.walk.period
        self.seek((self.t // period + event.share) * period)

    @on(Diagram.Turned)
    def _turned(self, event: Diagram.Turned) -> None:
        self.action_frame(event.frames)

    @on(WalkingRig.Ready)
    def _taken_up(self, event: WalkingRig.Ready) -> None:
        event.stop()
        self._show()


def _walks(robot: Robot) -> bool:
    """Whether there is a gait for its legs."""
    try:
        find_gait(robot)
    except KinlabError:
        return False
    return True
