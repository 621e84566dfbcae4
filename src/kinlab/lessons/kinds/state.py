"""An emulated chain that is to be brought into a state, by lines of the packet sandbox."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from kinlab.dynamixel.sandbox import VERBS, Outcome, Session, execute
from kinlab.errors import KinlabError, UsageError
from kinlab.lessons.replies import LONGEST_SCRIPT, UnreadableError, clean, quote
from kinlab.lessons.results import Goal, Holds, TipNear
from kinlab.lessons.robots import load_robot
from kinlab.lessons.task import Task, Verdict, did_you_mean

# What reaches beyond the session, or changes a servo from behind.
FILES = frozenset({"save", "load"})
FROM_BEHIND = frozenset({"set", "fault", "push", "noise", "drop", "flip", "delay", "echo", "chain"})
MOST_LINES = 300
LONGEST_WAIT = 60.0
# A servo that has been told to move gets this long, in s, before it is looked at.
SETTLING = 1.0


class Workbench:
    """A chain as an exercise sets it up, for a student to talk to.

    Attributes:
        session: the sandbox.
        chain: the servos behind it.
        lines: those that were carried out.
    """

    def __init__(self, task: Task) -> None:
        self.task = task
        self.goal = goal_of(task)
        self.session = Session(self.goal.chain, baud=1_000_000)
        self.chain = self.session.emulated
        for line in self.goal.setup:
            if line.split()[:1] and line.split()[0] in FILES:
                raise task.exercise.place.error(f"a setup reads and writes no files: {line}")
            execute(self.session, line)
        self.session.history.clear()
        self.session.exchanges.clear()
        if self.goal.as_real:
            self.session = Session(port=self.session.port)
        self.session.port.baud = self.goal.baud
        if self.goal.protocol:
            self.session.protocol = self.goal.protocol
        self.lines: list[str] = []
        self._waited = 0.0

    @property
    def verbs(self) -> list[str]:
        """What a line may begin with here."""
        return [v for v in VERBS if v not in FILES | FROM_BEHIND | set(self.goal.forbidden)]

    def execute(self, line: str) -> Outcome:
        """Carry out one line; several may stand in it, separated by semicolons.

        Raises:
            UsageError: it cannot be understood, or is not allowed here.
            KinlabError: it expects what did not happen.
        """
        outcome = Outcome()
        for part in line.split("#", 1)[0].split(";"):
            text = part.strip()
            if not text:
                continue
            if len(self.lines) >= MOST_LINES:
                raise UsageError(self.task.say("state.many-lines", most=MOST_LINES))
            self._check(text)
            done = self._help() if text.casefold() == "help" else execute(self.session, text)
            outcome.lines += done.lines
            outcome.ok = outcome.ok and done.ok
            self.lines.append(text)
        return outcome

    def _help(self) -> Outcome:
        """What a line may begin with here, and no more than that."""
        width = max(len(VERBS[name].usage) for name in self.verbs)
        return Outcome(
            lines=[
                [("verb", f"{VERBS[name].usage:<{width}}"), ("", f"  {VERBS[name].meaning}")]
                for name in self.verbs
            ]
        )

    def _check(self, text: str) -> None:
        name, _, rest = text.casefold().partition(" ")
        assembling = self.session.assembling is not None
        if name in VERBS and name not in self.verbs:
            raise UsageError(self.task.say("state.not-here", name=name))
        if name not in VERBS and not assembling:
            raise UsageError(
                self.task.say(
                    "state.no-command",
                    name=quote(name),
                    near=did_you_mean(self.task.language, name, self.verbs),
                )
            )
        if name == "wait":
            try:
                waited = self._waited + float(rest)
            except ValueError:
                return
            if not waited <= LONGEST_WAIT:
                raise UsageError(self.task.say("state.long-wait", most=f"{LONGEST_WAIT:g}"))
            self._waited = waited

    def reached(self) -> bool:
        """Whether everything is as wanted now."""
        return next(self._lacking(), None) is None

    def lacking(self) -> str:
        """The first thing that is not as wanted, in words; "" where all is."""
        return next(self._lacking(), "")

    def _lacking(self) -> Iterator[str]:
        for wanted in self.goal.wanted:
            if isinstance(wanted, Holds):
                value = self._register(wanted.servo, wanted.register)
                if not wanted.low <= value <= wanted.high:
                    # A real bus would not tell whose register it is.
                    key = "state.holds-real" if self.goal.as_real else "state.holds"
                    yield self.task.say(key, servo=wanted.servo, register=wanted.register, value=value)
            else:
                off = self._distance_mm(wanted)
                if not off <= wanted.within_mm:
                    yield self.task.say("state.tip", distance=f"{off:.1f}", within=f"{wanted.within_mm:g}")

    def _register(self, servo: int, register: str) -> int:
        found = self.chain.servo(servo)
        found.advance(self.session.port.clock.now())
        found.measure()
        return int(found.memory[found.table.find(register).name])

    def _distance_mm(self, wanted: TipNear) -> float:
        limb = load_robot(wanted.robot).limb(wanted.limb)
        angles = [
            float(joint.servo.joint(self._register(joint.servo.id, "present_position")))
            for joint in limb.joints
            if joint.servo
        ]
        tip = limb.fk(np.array(angles))[:3, 3] * 1000
        return math.dist(tip.tolist(), wanted.target_mm)


def goal_of(task: Task) -> Goal:
    """What is to be reached."""
    goal: Goal = task.answer
    return goal


def shape(task: Task) -> str:
    """Whom one talks to, and how."""
    goal = goal_of(task)
    return task.say("state.shape-real") if goal.as_real else task.say("state.shape", chain=goal.chain)


def right(task: Task) -> str:
    """Lines that lead there."""
    return "\n".join(goal_of(task).lines)


def wrong(task: Task) -> Sequence[str]:
    """Doing nothing, and leaving off before the end."""
    kept = list(goal_of(task).lines)
    while kept and kept[-1].split()[0] in ("wait", "read", "expect", "ping", "scan"):
        kept.pop()
    return ["wait 0.1", *(["\n".join(kept[:-1])] if len(kept) > 1 else [])]


def judge(task: Task, reply: str) -> Verdict:
    """By what the chain holds after the lines."""
    bench = Workbench(task)
    for number, line in enumerate(clean(reply, LONGEST_SCRIPT).splitlines(), 1):
        try:
            bench.execute(line)
        except KinlabError as error:
            if not isinstance(error, UsageError):
                continue
            raise UnreadableError("line", number=number, text=quote(line), error=str(error)) from None
    if not bench.reached():
        bench.session.port.clock.wait(SETTLING)
    lacking = bench.lacking()
    if lacking:
        return task.verdict(False, "wrong", lacking=lacking)
    return task.verdict(True, "right", count=len(bench.lines))
