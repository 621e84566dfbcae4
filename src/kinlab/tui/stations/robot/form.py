"""The dials: a target, or the joints' angles; and which solution is sent on."""

from typing import TYPE_CHECKING

import numpy as np
from textual.app import ComposeResult
from textual.containers import VerticalScroll

from kinlab.kinematics.transforms import Array
from kinlab.robots import Limb
from kinlab.tui.stations.robot.naming import Say, short, solution_name
from kinlab.tui.widgets import Choice, Dial
from kinlab.units import FARTHEST, to_metres, to_mm

if TYPE_CHECKING:
    from kinlab.tui.stations.robot.asking import Answer

POSED = 6  # joints of a limb that can choose its attitude, and dials that most limbs can do with
PLACES = ("x", "y", "z")
TURNS = ("roll", "pitch", "yaw")
FARTHEST_MM = FARTHEST * 1000


def _dial(i: int) -> Dial:
    return Dial(id=f"dial{i}", widest=(-FARTHEST_MM, FARTHEST_MM))


class Form(VerticalScroll, can_focus=False):
    """As many dials as there are numbers to give."""

    DEFAULT_CSS = """
    Form {
        height: 100%; padding: 0 1; scrollbar-size-vertical: 1;
        Dial .name { width: 3; }
        Dial Slider { min-width: 5; margin-right: 1; }
        Dial NumberField { width: 8; margin: 0 1 0 0; }
        Dial .unit { width: 3; }
        &.-named Dial .name { width: 9; }
        #solution { width: 100%; margin-top: 1; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self._dials = [_dial(i) for i in range(POSED)]

        for dial, name in zip(self._dials, PLACES, strict=False):
            dial.label(name)

    def compose(self) -> ComposeResult:
        # Most limbs have three numbers to give: the other dials are there when they are needed.
        yield from self._dials[: len(PLACES)]
        yield Choice(("-",), "-", id="solution")

    def _dress(self, i: int, name: str, unit: str, span: tuple[float, float], number: float) -> None:
        if i == len(self._dials):
            self._dials.append(_dial(i))
        dial = self._dials[i]
        dial.label(short(name, 8))
        dial.span(*span, 1.0, unit)
        dial.show(number)

    def begin(self) -> None:
        """Wait for the first number."""
        self._use(len(PLACES))
        self._dials[0].field.focus()

    def _use(self, count: int) -> None:
        new = [dial for dial in self._dials[:count] if dial.parent is None]
        if new:
            self.mount(*new, before="#solution")
        for i, dial in enumerate(self._dials):
            dial.display = i < count

    def show_target(self, limb: Limb, target: Array, rpy: Array, frame: str, box: Array) -> None:
        """A dial for each coordinate in `frame`, and for each turn where the limb can choose its attitude."""
        corners = np.array(np.meshgrid(*box.T)).reshape(3, -1).T
        within = to_mm(limb.from_limb(corners, frame))
        place = to_mm(limb.from_limb(target, frame))
        for i, name in enumerate(PLACES):
            span = (float(np.floor(within[:, i].min())), float(np.ceil(within[:, i].max())))
            self._dress(i, name, "mm", span, float(place[i]))
        posed = len(limb.joints) >= POSED
        for i, name in enumerate(TURNS, 3):
            self._dress(i, name, "deg", (-90.0, 90.0), float(np.degrees(rpy[i - 3])))
        self._use(6 if posed else 3)
        self.set_class(posed, "-named")

    def show_angles(self, limb: Limb, angles: Array) -> None:
        """A dial for each joint."""
        low, high = np.degrees(limb.limits)
        for i, name in enumerate(limb.joint_names):
            self._dress(i, name, "deg", (float(low[i]), float(high[i])), float(np.degrees(angles[i])))
        self._use(len(limb.joints))
        self.add_class("-named")

    def target(self, limb: Limb, frame: str) -> Array:
        """The place that the dials give (3,), metres, limb frame."""
        place = to_metres([dial.number for dial in self._dials[:3]])
        return limb.to_limb(place, frame)

    def rpy(self) -> Array:
        """The attitude that they give (3,), rad."""
        return np.radians([dial.number for dial in self._dials[3:6]])

    def angles(self, count: int) -> Array:
        """The joint angles that they give (n,), rad."""
        return np.radians([dial.number for dial in self._dials[:count]])

    def offer_solutions(self, answer: "Answer", say: Say) -> None:
        """The solutions to choose from."""
        poses = [pose for pose in answer.path.answer.poses if pose.within_limits]
        choice = self.query_one("#solution", Choice)
        choice.display = bool(poses)
        if poses and answer.path.pose is not None:
            names = [pose.name for pose in poses]
            labels = [solution_name(name, say) for name in names]
            if (names, labels) != (choice.names, choice.labels):
                choice.offer(names, answer.path.pose.name, labels)
            elif choice.value != answer.path.pose.name:
                choice.put(answer.path.pose.name)
