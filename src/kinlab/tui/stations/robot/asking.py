"""What the station asks the core, and what it gets: in a thread of its own, one question at a time."""

from dataclasses import dataclass

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers.path import WholePath, whole_path
from kinlab.rig.bench import LimbBench, bench_of
from kinlab.robots import Limb, Robot
from kinlab.robots.views import SIDE, TOP, View, size_of, view


@dataclass(frozen=True, eq=False)
class Question:
    """What a person has set.

    Attributes:
        target: (3,), metres, limb frame.
        rpy: attitude (3,), rad; None for limbs that cannot choose it.
        q: joint angles (n,), rad, where the path begins at them; else None.
        frame: in which places are shown.
        solution: the name of the wished one.
        powered: whether the emulated chain has its supply.
    """

    robot: Robot
    limb: Limb
    target: Array
    rpy: Array | None
    q: Array | None
    frame: str
    solution: str
    powered: bool


@dataclass(frozen=True, eq=False)
class Answer:
    """The path, and the planes in which it is seen."""

    question: Question
    path: WholePath
    side: View
    top: View


class Asker:
    """Keeps the limb's emulated servos, and the size of its pictures, from one question to the next."""

    def __init__(self) -> None:
        self._limb: Limb | None = None
        self._bench: LimbBench | None = None
        self._no_bench = ""
        self.box = np.zeros((2, 3))

    def ask(self, question: Question) -> Answer:
        """Walk the path."""
        limb = question.limb
        if limb is not self._limb:
            self._limb, self.box = limb, size_of(limb)
            self._bench, self._no_bench = bench_of(question.robot, limb)
        if self._bench is not None and self._bench.powered != question.powered:
            self._bench.power(question.powered)
        # The frame of the target is the limb's; `frame` is how the answer is shown.
        target = limb.from_limb(question.target, question.frame)
        path = whole_path(
            question.robot,
            limb,
            target=target,
            rpy=question.rpy,
            q=question.q,
            frame=question.frame,
            solution=question.solution,
            bench=self._bench,
            no_bench=self._no_bench,
        )
        place, attitude = path.answer.target, path.answer.rotation
        side, top = (view(limb, name, place, self.box, attitude) for name in (SIDE, TOP))
        return Answer(question, path, side, top)
