"""The Robot station: a target, and everything that follows from it."""

from typing import Any

import numpy as np
from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.widgets import Select

from kinlab.canvas import Canvas
from kinlab.robots import load_robot
from kinlab.robots.drawing import draw_limb
from kinlab.robots.load import robot_names
from kinlab.robots.target import solve_target
from kinlab.tui.actions import Action
from kinlab.tui.numbers import shown
from kinlab.tui.station import Station
from kinlab.tui.widgets import Choice, Dial, Picture
from kinlab.units import to_metres


class RobotStation(Station):
    """Choose a robot and a limb, give a target, see the path."""

    NAME = "robot"
    ACTIONS = (
        Action("next_robot", "r,f7"),
        Action("next_limb", "l,f8"),
    )
    CSS = """
    RobotStation {
        #choices { height: 1; }
        #form { width: 34; }
        #views Picture { width: 1fr; height: 100%; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self.robot = load_robot(robot_names()[0])
        self.limb = self.robot.limb()
        self.target_mm = np.array([75.0, 10.0, -46.0])

    def compose_body(self) -> ComposeResult:
        with Horizontal(id="choices"):
            yield Choice(robot_names(), self.robot.name, id="robot")
            yield Choice(self.robot.limbs, self.limb.name, id="limb")
        with Horizontal():
            with Vertical(id="form"):
                for i, axis in enumerate("xyz"):
                    yield Dial(axis, "mm", low=-200, high=200, number=float(self.target_mm[i]), id=axis)
            with Horizontal(id="views"):
                yield Picture(lambda *size: self._draw(0, *size), self._side, id="side")
                yield Picture(lambda *size: self._draw(1, *size), self._top, id="top")

    def ready(self) -> None:
        self.solve()

    def state(self) -> dict[str, Any]:
        return {"robot": self.robot.name, "limb": self.limb.name, "target_mm": self.target_mm.tolist()}

    def solve(self) -> None:
        """Ask the core, and show the answer."""
        self.answer = solve_target(self.robot, self.limb, to_metres(self.target_mm))
        for picture in self.query(Picture):
            picture.redraw()
        if self.answer.chosen is None:
            self.tell("bad", self.answer.reason)
        else:
            pose = self.answer.poses[self.answer.chosen]
            angles = ", ".join(shown(a) for a in np.degrees(pose.q))
            self.tell("good", f"{pose.name}: {angles} deg")

    def relabel(self) -> None:
        for picture in self.query(Picture):
            picture.redraw()

    @on(Dial.Changed)
    def _turned(self, event: Dial.Changed) -> None:
        self.target_mm["xyz".index(event.dial.id or "x")] = event.number
        self.solve()

    @on(Select.Changed, "#robot")
    def _other_robot(self, event: Select.Changed) -> None:
        self.robot = load_robot(str(event.value))
        self.query_one("#limb", Choice).offer(self.robot.limbs, self.robot.limb().name)
        self._use(self.robot.limb().name)

    @on(Select.Changed, "#limb")
    def _other_limb(self, event: Select.Changed) -> None:
        self._use(str(event.value))

    def _use(self, limb: str) -> None:
        self.limb = self.robot.limbs[limb]
        self.solve()

    def action_next_robot(self) -> None:
        """Take the next robot."""
        names = robot_names()
        self.query_one("#robot", Choice).value = names[(names.index(self.robot.name) + 1) % len(names)]

    def action_next_limb(self) -> None:
        """Take the next limb."""
        names = list(self.robot.limbs)
        self.query_one("#limb", Choice).value = names[(names.index(self.limb.name) + 1) % len(names)]

    def _side(self, canvas: Canvas) -> str:
        return self.say("view.side", cell=shown(canvas.cell_width, 1))

    def _top(self, canvas: Canvas) -> str:
        return self.say("view.top", cell=shown(canvas.cell_width, 1))

    def _draw(self, which: int, columns: int, rows: int, ascii_only: bool) -> Canvas:
        pose = (
            self.answer.poses[self.answer.chosen or 0].q
            if self.answer.poses
            else self.limb.limits.mean(axis=0)
        )
        return draw_limb(
            self.limb, pose, self.answer.target, columns=columns, rows=rows, ascii_only=ascii_only
        )[which]
