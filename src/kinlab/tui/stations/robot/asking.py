"""What the station gets from the core: in a thread of its own, one question at a time."""

from dataclasses import dataclass

import numpy as np

from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array
from kinlab.papers.path import WholePath, whole_path
from kinlab.papers.tour import first_target
from kinlab.rig.bench import LimbBench, bench_of
from kinlab.robots import Limb
from kinlab.robots.views import SIDE, TOP, View, size_of, view
from kinlab.tui.stations.robot.mirroring import Reflection
from kinlab.tui.stations.robot.question import Question


@dataclass(frozen=True, eq=False)
class Answer:
    """The path, the planes in which it is seen, and the box (2, 3), metres, limb frame, that holds the limb.

    `unmirrored` says why it is not in a viewer, where it was to be.
    """

    question: Question
    path: WholePath
    side: View
    top: View
    box: Array
    unmirrored: str = ""


class Asker:
    """Keeps the limb's emulated servos, and the size of its pictures, from one question to the next."""

    def __init__(self) -> None:
        self._limb: Limb | None = None
        self._bench: LimbBench | None = None
        self._no_bench = ""
        self._reflection = Reflection()
        self._box = np.zeros((2, 3))

    def ask(self, question: Question) -> Answer:
        """Walk the path."""
        limb = question.limb
        if limb is not self._limb:
            self._limb, self._box = limb, size_of(limb)
            self._bench, self._no_bench = bench_of(question.robot, limb)
        if self._bench is not None and self._bench.powered != question.powered:
            self._bench.power(question.powered)
        # The frame of the target is the limb's; `frame` is how the answer is shown.
        begin = first_target(question.robot, limb) if question.target is None else question.target
        target = limb.from_limb(begin, question.frame)
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
        side, top = (view(limb, name, place, self._box, attitude) for name in (SIDE, TOP))
        return Answer(question, path, side, top, self._box, self._reflect(question, path))

    def _reflect(self, question: Question, path: WholePath) -> str:
        try:
            if not question.mirrored:
                self._reflection.close()
            else:
                # What the servos report is where the limb is; without servos, where it would be.
                q = path.pose.q if path.pose is not None else None
                reported = path.arrival.q if path.arrival is not None and path.arrival.answered else q
                self._reflection.show(question.robot, question.limb, reported)
        except KinlabError as error:
            return str(error)
        return ""
