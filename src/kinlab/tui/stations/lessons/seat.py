"""A student's table in one lesson: where one is, what was typed, what was said to it. Nothing here is on the disk."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from kinlab.dynamixel.sandbox.session import Line
from kinlab.errors import KinlabError
from kinlab.gait import Cycle, cycle_of, gaits_for, plan
from kinlab.kinematics.transforms import Array
from kinlab.lessons import Sitting, Task, Verdict
from kinlab.lessons.kinds import rehearse
from kinlab.lessons.kinds.joints import angles_deg
from kinlab.lessons.kinds.state import Workbench
from kinlab.lessons.replies import LONGEST_SCRIPT, UnreadableError, clean
from kinlab.lessons.results import Holds, Reach
from kinlab.lessons.robots import find_gait, load_robot
from kinlab.lessons.sitting import Step
from kinlab.papers.tour import first_target
from kinlab.robots import Limb


@dataclass(frozen=True)
class Judged:
    """An answer and what was said to it."""

    reply: str
    verdict: Verdict


@dataclass
class Table:
    """What lies there for one exercise.

    Attributes:
        reply: what stands on the line.
        judged: the last verdict; None before the first.
        tried: of a choice, what is known of its options.
        hint: which hint is shown, from 0; -1 for none.
        solution: the solution, where it was asked for.
        bench: the chain of an exercise that has one.
        talk: what was said to the chain, and by it.
        servo: whose registers are shown.
    """

    reply: str = ""
    judged: Judged | None = None
    tried: dict[str, str] = field(default_factory=dict)
    hint: int = -1
    solution: str = ""
    bench: Workbench | None = None
    talk: list[Line] = field(default_factory=list)
    servo: int = 0


class Seat:
    """A student at a lesson.

    Attributes:
        sitting: the lesson as the core has it.
        steps: its pieces.
        at: which of them is open.
    """

    def __init__(
        self, sitting: Sitting, at: int | None = None, tables: dict[str, Table] | None = None
    ) -> None:
        """Sit down.

        Args:
            sitting: the lesson.
            at: the step to open; default the first exercise that is open, and the beginning of a finished lesson.
            tables: of the same lesson, in another language.

        Raises:
            LessonError: something of the lesson cannot be filled in or computed.
        """
        self.sitting = sitting
        self.steps: list[Step] = sitting.steps()
        # What fails is better said here than in the middle of the lesson.
        for task in sitting.tasks.values():
            rehearse(task)
        begin = next(
            (i for i, s in enumerate(self.steps) if s.task and s.task.exercise.id in sitting.open), 0
        )
        self.at = begin if at is None else min(at, len(self.steps) - 1)
        self.tables = tables or {}
        for table in self.tables.values():
            # What was said was said in the other language.
            table.judged, table.solution = None, ""

    @property
    def task(self) -> Task | None:
        """The exercise of now; None at the end."""
        return self.steps[self.at].task

    @property
    def name(self) -> str:
        """The id of the exercise of now; "" at the end."""
        return self.task.exercise.id if self.task else ""

    @property
    def table(self) -> Table:
        """What lies there for the exercise of now."""
        return self.tables.setdefault(self.name, Table())

    @property
    def standings(self) -> list[str]:
        """How each step stands."""
        return [self.sitting.standing(s.task.exercise.id).status if s.task else "end" for s in self.steps]

    # Answers. These take their time, or wait for the disk: not for the event loop.

    def judge(self, reply: str) -> Verdict:
        """What the core says to an answer; kept.

        Raises:
            KinlabError: it cannot be judged, or not be kept.
        """
        verdict = self.sitting.check(self.name, reply)
        self.table.judged = Judged(reply, verdict)
        if verdict.counts:
            self.table.tried[reply] = "solved" if verdict.ok else "broken"
        return verdict

    def open_bench(self, *, fresh: bool = False) -> Workbench:
        """The chain of an exercise, as it was left, or set up anew.

        Raises:
            LessonError: it cannot be set up.
        """
        table = self.table
        if table.bench is None or fresh:
            table.bench = self.sitting.workbench(self.name)
            table.talk, table.judged = [], None
            wanted = [each.servo for each in table.bench.goal.wanted if isinstance(each, Holds)]
            table.servo = wanted[0] if wanted else next(iter(table.bench.session.ids()), 0)
        return table.bench

    def talk_to_chain(self, line: str) -> Verdict | None:
        """Carry out a line; the verdict, where the state is reached by it.

        Raises:
            KinlabError: the answer cannot be judged, or not be kept.
        """
        table, bench = self.table, self.open_bench()
        table.talk.append([("arrow", "> "), ("verb", line)])
        try:
            table.talk += bench.execute(clean(line, LONGEST_SCRIPT)).lines
        except UnreadableError as error:
            table.talk.append([("bad", bench.task.say(f"unreadable.{error.code}", **error.values))])
        except KinlabError as error:
            table.talk += [[("bad", part)] for part in str(error).split("\n")]
        table.talk.append([("", "")])
        done = self.sitting.standing(self.name).done
        if bench.lines and not done and self.sitting.reached(self.name, bench.lines):
            return self.judge_bench()
        return None

    def judge_bench(self) -> Verdict:
        """What the core says to all lines so far.

        Raises:
            KinlabError: it cannot be judged, or not be kept.
        """
        return self.judge("\n".join(self.open_bench().lines))

    # Instruments.

    @property
    def instrument(self) -> str:
        """What belongs beside the exercise of now: "leg", "gait", "chain", "bytes"; "" for nothing."""
        if self.task is None:
            return ""
        if self.task.exercise.kind == "state":
            return "chain"
        if self.task.exercise.kind == "bytes":
            # A value by itself has no fields.
            return "bytes" if bytes(self.task.answer).startswith(b"\xff\xff") else ""
        return self.sitting.lesson.instrument

    def limb(self) -> tuple[Limb, Array, Array | None]:
        """The limb that the exercise is about, a pose (n,), rad, and a target (3,), metres, if there is one."""
        answer = self.task.answer if self.task else None
        if isinstance(answer, Reach) and answer.limb is not None:
            limb, target = answer.limb, np.array(answer.target_mm) / 1000
        else:
            limb, target = load_robot(self.sitting.lesson.robot).limb(), None
        typed = self.typed_angles(self.table.reply)
        if typed is not None:
            return limb, typed, target
        robot = load_robot(self.sitting.lesson.robot)
        found = limb.ik(first_target(robot, limb))
        return limb, found.q if found.reachable else limb.limits.mean(axis=0), target

    def walk(self, gait: str = "") -> Cycle:
        """The lesson's robot in a gait; default that which the student's numbers name, else its usual one.

        Raises:
            KinlabError: it does not walk.
        """
        robot = load_robot(self.sitting.lesson.robot)
        drawn = self.task.values.get("gait") if self.task else None
        known = [gait, drawn] if isinstance(drawn, str) else [gait]
        return cycle_of(
            plan(robot, find_gait(robot, next((g for g in known if g in gaits_for(robot)), None)))
        )

    def typed_angles(self, reply: str) -> Array | None:
        """The pose (n,), rad, that an answer gives; None where it gives none."""
        if self.task is None or self.task.exercise.kind != "joints":
            return None
        try:
            return np.radians(angles_deg(self.task, reply))
        except UnreadableError:
            return None


def placed(reply: str, offered: Mapping[str, str]) -> dict[str, str]:
    """Of an order that is typed: the place of each item, from 1."""
    known = {label.casefold(): label for label in offered}
    words = [known.get(word.strip(",;>").casefold(), "") for word in reply.split()]
    return {word: str(i) for i, word in enumerate((w for w in words if w), 1)}
