"""An emulated rig that walks along with what is shown, and the line that says what it measures."""

from dataclasses import dataclass
from functools import partial

from textual import work
from textual.content import Content
from textual.message import Message
from textual.timer import Timer
from textual.widgets import Static
from textual.worker import get_current_worker

from kinlab.errors import KinlabError
from kinlab.gait import Walk
from kinlab.rig import Sample, Treadmill
from kinlab.tui.facts import fitting
from kinlab.tui.stations.gait.readings import Say, costs

# How long nothing may change before the rig takes up a walk, s: a slider that is dragged makes many.
QUIET = 0.2
# Ticks that one picture may wait for.
TICKS = 10


class WalkingRig(Static):
    """Power, energy, and cost per metre as the rig walks; of a robot that no rig can walk, why."""

    DEFAULT_CSS = "WalkingRig { height: auto; max-height: 2; }"

    @dataclass
    class Ready(Message):
        """The rig has taken up the walk, or has said why it cannot."""

    def __init__(self) -> None:
        super().__init__(markup=False)
        self.mill: Treadmill | None = None
        self.problem = ""
        self._walk: Walk | None = None
        self._settling: Timer | None = None
        self._said = ""

    def take_up(self, walk: Walk) -> None:
        """Walk another walk, from its beginning."""
        self._leave()
        self.problem, self._walk = "", walk
        if self._settling is not None:
            self._settling.stop()
        self._settling = self.set_timer(QUIET, partial(self._open, walk))

    def tread(self, t: float) -> bool:
        """Walk on towards the instant `t`, s, as far as a picture can wait; whether there was a way to go."""
        if self.mill is None or (self.mill.samples and self.mill.samples[-1].t >= t):
            return False
        self.mill.tread(t, TICKS)
        return True

    def at(self, t: float) -> Sample | None:
        """What was measured at the instant `t`, s; None where nothing was, or is no longer kept."""
        return self.mill.at(t) if self.mill is not None else None

    def show(self, say: Say, t: float) -> None:
        """Say what was measured at the instant `t`, s."""
        sample = self.at(t)
        if self.problem:
            said = say("facts.no_rig", why=self.problem)
        elif self.mill is None or sample is None:
            said = say("facts.measuring")
        else:
            said = fitting(costs(say, self.mill, sample), self.size.width)
        if said != self._said:
            self._said = said
            self.update(Content(said), layout=bool(self.problem) or self.size.height != 1)

    @work(thread=True, exclusive=True, exit_on_error=False)
    def _open(self, walk: Walk) -> None:
        worker = get_current_worker()
        mill, problem = None, ""
        try:
            mill = Treadmill(walk)
        except KinlabError as error:
            problem = str(error)
        if not worker.is_cancelled:
            self.app.call_from_thread(self._take, walk, mill, problem)
        elif mill is not None:
            mill.close()

    def _take(self, walk: Walk, mill: Treadmill | None, problem: str) -> None:
        if walk is not self._walk:
            if mill is not None:
                mill.close()
            return
        self.mill, self.problem = mill, problem
        self.post_message(self.Ready())

    def _leave(self) -> None:
        if self.mill is not None:
            self.mill.close()
            self.mill = None

    def on_unmount(self) -> None:
        self._leave()
