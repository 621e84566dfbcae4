"""The Arm lab: gains, law and a hand that change while the arm moves, and what its observers make of it."""

import time
from dataclasses import replace
from functools import partial
from typing import Any

from textual import on
from textual.app import ComposeResult
from textual.containers import Grid, Horizontal, Vertical
from textual.widgets import Button, Select, Static

from kinlab.canvas import Canvas
from kinlab.control import Environment, PositionGains
from kinlab.errors import KinlabError
from kinlab.papers.receptionist_line import there_and_back
from kinlab.rig.arm import GAIN_SETS, LAWS, Lab, Settings
from kinlab.rig.arm.drawing import VIEWS, draw_arm
from kinlab.robots import load_robot
from kinlab.tui.actions import Action
from kinlab.tui.facts import fitting
from kinlab.tui.numbers import shown
from kinlab.tui.station import Station
from kinlab.tui.stations.arm.curves import PLOTS, curves, facts
from kinlab.tui.stations.arm.hand import Hand
from kinlab.tui.stations.arm.view import ArmView
from kinlab.tui.widgets import Choice, Dial, Picture, Plot

ROBOT = "receptionist-arm"
EVERY = 0.05  # s between pictures
LATEST = 0.2  # s that a late picture makes up for
PLOT_EVERY = 2  # pictures
TRAIL = 1.2  # s of the hand's way that are drawn
# Gains and the force of the keys: unit, the slider's end and step, the least that can be typed.
DIALS = {
    "kp": ("1/s2", 60.0, 1.0, 0.0),
    "kv": ("1/s", 30.0, 0.5, 0.0),
    "kf": ("", 0.5, 0.01, 0.0),
    "kenv": ("", 20.0, 0.5, 0.0),
    "denv": ("s", 20.0, 0.5, 0.0),
    "menv": ("s2", 10.0, 0.1, 0.001),
    "push": ("N", 10.0, 0.5, 0.0),
}


class ArmStation(Station):
    """Let the arm go its line, push it, and change what holds it."""

    NAME = "arm"
    ACTIONS = (
        Action("play", "space,f9"),
        Action(
            "push", "left,right,up,down", each=tuple(f"push('{way}')" for way in ("left", "right", "up", "down")),
            display="←→↑↓",
        ),
        Action("compliance", "c,f8"),
        Action("reset", "r,f12"),
        Action("gains", "g,f7"),
        Action("joint", "j,f11"),
        Action("plot", "v,f10"),
        Action("push_across", "comma,full_stop", each=("push('in')", "push('out')"), display=", ."),
        Action("cycle", "s", shown=False),
        Action("law", "w", shown=False),
        Action("next_limb", "l", shown=False),
    )  # fmt: skip
    CSS_PATH = "station.tcss"

    def __init__(self) -> None:
        super().__init__()
        self.robot = load_robot(ROBOT)
        self.limb = self.robot.limb()
        gains, environment = GAIN_SETS["firm"]
        self.settings = Settings("position", gains, environment)
        self.newtons = 3.0
        self.joint = len(self.limb.joints) - 1
        self.plot = next(iter(PLOTS))
        self.playing = False
        self.fault = ""
        self.bench: Lab
        self.hand = Hand()
        self._seen = self._owed = 0.0
        self._pictures = 0

    @classmethod
    def prepare(cls) -> None:
        there_and_back(load_robot(ROBOT).limb())

    def compose_body(self) -> ComposeResult:
        joints = self.limb.joint_names
        with Horizontal(classes="row"):
            yield Choice(self.robot.limbs, self.limb.name, id="limb")
            yield Choice(LAWS, self.settings.law, id="law")
            yield Choice(joints, joints[self.joint], id="joint")
            for name in ("play", "reset"):
                button = Button(id=name, compact=True)
                button.active_effect_duration = 0  # while it lasts, a click is not heard
                yield button
        with Grid(id="dials"):
            for name, (unit, high, step, least) in DIALS.items():
                yield Dial(name, unit, low=0, high=high, step=step, widest=(least, 1e6), id=name)
        yield Static(id="facts", markup=False)
        with Horizontal(id="floor"):
            with Vertical(id="views"):
                for view in VIEWS:
                    yield ArmView(
                        partial(self._draw, view),
                        partial(self._caption, view),
                        focusable=view == "side",
                        id=view,
                    )
            with Vertical(id="plots"):
                for plot, (unit, *_) in PLOTS.items():
                    yield Plot(x="s", y=unit, zero=plot != "position", id=plot)

    def ready(self) -> None:
        self._put_back()
        self.query_one("#side").focus()
        self._show_plot()
        self.set_interval(EVERY, self._tick)

    def state(self) -> dict[str, Any]:
        settings = self.settings
        return {
            "limb": self.limb.name, "law": settings.law, "joint": self.joint, "plot": self.plot,
            "newtons": self.newtons, "gains": [*settings.gains, *settings.environment],
        }  # fmt: skip

    def restore(self, state: dict[str, Any]) -> None:
        self.limb = self.robot.limbs.get(str(state.get("limb")), self.limb)
        if str(state.get("plot")) in PLOTS:
            self.plot = str(state["plot"])
        if state.get("joint") in range(len(self.limb.joints)):
            self.joint = state["joint"]
        if isinstance(state.get("newtons"), int | float) and 0 <= state["newtons"] <= DIALS["push"][1]:
            self.newtons = float(state["newtons"])
        try:
            kp, kv, *environment = map(float, state["gains"])
            self.settings = Settings(state["law"], PositionGains(kp, kv), Environment(*environment))
        except (KeyError, TypeError, ValueError, KinlabError):
            return

    def relabel(self) -> None:
        self.query_one("#push", Dial).label(self.say("dial.push"))
        self.query_one("#play", Button).label = self.say("button.pause" if self.playing else "button.play")
        self.query_one("#reset", Button).label = self.say("button.reset")
        for plot in PLOTS:
            self.query_one(f"#{plot}", Plot).title = self.say(f"plot.{plot}")
        self._summarise()
        self._show(plots=True)

    # The arm.

    def _put_back(self) -> None:
        """The arm at the beginning of its line, with the gains of now."""
        if hasattr(self, "bench"):
            self.bench.close()
        self.bench = Lab(self.robot, self.limb, there_and_back(self.limb), self.settings)
        self.fault, self._owed = "", 0.0
        self.hand.let_go()
        self._show_settings()
        self.relabel()

    def _set(self, settings: Settings) -> None:
        self.settings = self.bench.settings = settings
        self._show_settings()
        self._summarise()
        self._show()

    def _show_settings(self) -> None:
        """Stand the dials and lists where the settings are."""
        settings = self.settings
        numbers = settings.gains._asdict() | settings.environment._asdict() | {"push": self.newtons}
        for name, number in numbers.items():
            dial = self.query_one(f"#{name}", Dial)
            dial.show(number)
            dial.remove_class("-refused")
        self.query_one("#law", Choice).put(settings.law)
        self.query_one("#limb", Choice).put(self.limb.name)
        self.query_one("#joint", Choice).put(self.limb.joint_names[self.joint])

    def _summarise(self) -> None:
        """What the arm does now, on the message line."""
        if self.fault:
            self.tell("bad", self.say("arm.fault", why=self.fault))
        else:
            self.tell("note", self.say(f"law.{self.settings.law}"))

    # Time.

    def _tick(self) -> None:
        now = time.monotonic()
        passed, self._seen = min(now - self._seen, LATEST), now
        if not (self.playing and self.is_current):
            return
        self._owed += passed
        cycles, dt = int(self._owed / self.settings.dt), self.settings.dt
        self._owed -= cycles * dt
        self._run(cycles)
        self._pictures += 1
        self._show(plots=self._pictures % PLOT_EVERY == 0 or not self.playing)

    def _run(self, cycles: int) -> None:
        """Let the arm go on by cycles; when it runs away it is stopped, and says so."""
        lab = self.bench
        for _ in range(cycles):
            self.hand.act(lab)
            try:
                lab.cycle()
            except KinlabError as error:
                self.fault = str(error)
                lab.close()
                self._play(False)
                self._summarise()
                return

    def _play(self, on: bool) -> None:
        self.playing = on and not self.fault
        self._seen = time.monotonic()
        self.query_one("#play", Button).label = self.say("button.pause" if self.playing else "button.play")

    def _show(self, plots: bool = False) -> None:
        """Show the arm as it is."""
        for view in self.query(ArmView):
            view.redraw()
        line = self.query_one("#facts", Static)
        line.update(fitting(facts(self.say, self.bench), line.size.width), layout=False)
        if not plots:
            return
        for name in PLOTS:
            plot = self.query_one(f"#{name}", Plot)
            if plot.region.width:
                plot.plot(curves(self.say, self.bench, name, self.joint))

    # Pictures.

    def _draw(self, view: str, columns: int, rows: int, ascii_only: bool) -> Canvas:
        lab = self.bench
        angles = (
            lab.moments[-1].angles if lab.moments else {"real": lab.track.q[0], "reference": lab.track.q[0]}
        )
        return draw_arm(
            self.limb, angles["real"], lab.track, view=view, reference=angles["reference"], trail=lab.trail(TRAIL),
            force=self.hand.force, columns=columns, rows=rows, ascii_only=ascii_only,
        )  # fmt: skip

    def _caption(self, view: str, canvas: Canvas) -> str:
        return self.say(f"view.{view}", cell=shown(canvas.cell_width, 1))

    # What people do.

    @on(Button.Pressed)
    async def _pressed(self, event: Button.Pressed) -> None:
        event.stop()
        await self.run_action(event.button.id or "")
        self.query_one("#side").focus()

    @on(Select.Changed)
    def _chosen(self, event: Select.Changed) -> None:
        event.stop()
        name, box = str(event.value), event.select.id
        self.query_one("#side").focus()
        if box == "limb":
            self.limb = self.robot.limbs[name]
            self._put_back()
        elif box == "law":
            self._set(replace(self.settings, law=name))
        else:
            self.joint = self.limb.joint_names.index(name)
            self._show(plots=True)

    @on(Dial.Changed)
    def _dialled(self, event: Dial.Changed) -> None:
        event.stop()
        name, number, settings = event.dial.id or "", event.number, self.settings
        if name == "push":
            self.newtons = number
            return
        try:
            if name in settings.gains._fields:
                settings = replace(settings, gains=settings.gains._replace(**{name: number}))
            else:
                settings = replace(settings, environment=settings.environment._replace(**{name: number}))
        except KinlabError as error:
            event.dial.add_class("-refused")
            self.tell("bad", str(error))
            return
        self._set(settings)

    @on(Picture.Pointed)
    def _pointed(self, event: Picture.Pointed) -> None:
        event.stop()
        if isinstance(event.picture, ArmView):
            self.hand.hold(event.picture.id or "", (event.x, event.y))
            self._play(True)

    @on(ArmView.LetGo)
    def _let_go(self, event: ArmView.LetGo) -> None:
        event.stop()
        self.hand.let_go()

    def action_play(self) -> None:
        """Let the arm go on, or hold time."""
        if self.fault:
            self._summarise()
        self._play(not self.playing)

    def action_push(self, way: str) -> None:
        """Push the hand for a moment; the arm goes on."""
        moments = self.bench.moments
        self.hand.push(way, self.newtons, moments[-1].t if moments else 0.0)
        if not self.playing:
            self.action_play()

    def action_compliance(self) -> None:
        """Switch compliance on or off."""
        law = "position" if self.settings.law == "compliance" else "compliance"
        self._set(replace(self.settings, law=law))

    def action_law(self) -> None:
        """Take the next control law."""
        self._set(replace(self.settings, law=LAWS[(LAWS.index(self.settings.law) + 1) % len(LAWS)]))

    def action_gains(self) -> None:
        """Take the next set of gains."""
        sets = list(GAIN_SETS.values())
        now = (self.settings.gains, self.settings.environment)
        gains, environment = sets[(sets.index(now) + 1) % len(sets) if now in sets else 0]
        self._set(replace(self.settings, gains=gains, environment=environment))

    def action_reset(self) -> None:
        """Put the arm back."""
        self._play(False)
        self._put_back()

    def action_joint(self) -> None:
        """Plot the next joint."""
        self.joint = (self.joint + 1) % len(self.limb.joints)
        self.query_one("#joint", Choice).put(self.limb.joint_names[self.joint])
        self._show(plots=True)

    def action_next_limb(self) -> None:
        """Take the other arm."""
        names = list(self.robot.limbs)
        self.limb = self.robot.limbs[names[(names.index(self.limb.name) + 1) % len(names)]]
        self._put_back()

    def action_cycle(self) -> None:
        """Hold time, and go on by one cycle of the loop."""
        self._play(False)
        if not self.fault:
            self._run(1)
        self._show(plots=True)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Where there is room for all plots nobody chooses one."""
        return not (action == "plot" and not self.has_class("-narrow"))

    def action_plot(self) -> None:
        """Show the next plot."""
        names = list(PLOTS)
        self.plot = names[(names.index(self.plot) + 1) % len(names)]
        self._show_plot()

    def _show_plot(self) -> None:
        for name in PLOTS:
            self.query_one(f"#{name}", Plot).set_class(name == self.plot, "chosen")
        self.call_after_refresh(self._show, plots=True)

    def on_unmount(self) -> None:
        self.bench.close()
