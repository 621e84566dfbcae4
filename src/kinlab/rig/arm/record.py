"""What a run of the loop leaves behind: every cycle, as arrays, CSV and JSON."""

import csv
from dataclasses import dataclass, field, replace
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinlab.dynamixel.bus import Passage
from kinlab.files import write_whole
from kinlab.kinematics.resolved_motion import Track
from kinlab.kinematics.transforms import Array
from kinlab.rig.arm.push import Push
from kinlab.rig.arm.world import World
from kinlab.robots import Limb

if TYPE_CHECKING:
    from kinlab.rig.arm.loop import Machine

ANGLES = ("command", "real", "reference", "given_way")
TORQUES = ("load", "filtered", "dynamic", "external", "disturbance", "reaction", "pushed")


@dataclass(frozen=True, eq=False, repr=False)
class Moment:
    """One cycle of n joints: a row of the columns that `Record` describes.

    Attributes:
        t, busy, damping: of it.
        missed: (n,).
        angles, torques: by name (n,).
    """

    t: float
    busy: float
    damping: float
    missed: Array
    angles: dict[str, Array]
    torques: dict[str, Array]

    @classmethod
    def of(cls, t: float, busy: float, missed: Array, machine: "Machine", world: World | None) -> "Moment":
        """What a cycle that has just been run leaves behind."""
        none = np.zeros_like(machine.load)
        return cls(
            t, busy, machine.damping, missed,
            {
                "command": machine.command, "real": machine.real.copy(), "reference": machine.reference,
                "given_way": none + machine.yielding.angle,
            },
            {
                "load": machine.load.copy(), "filtered": machine.filtered, "dynamic": machine.dynamic,
                "external": machine.external,
                "disturbance": machine.disturbance.estimate if machine.disturbance else none,
                "reaction": machine.reaction.estimate if machine.reaction else none,
                "pushed": np.array(world.pushed(t)) if world else np.full_like(none, np.nan),
            },
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Record:
    """N cycles of n joints.

    Attributes:
        limb: whose.
        track: what was asked for.
        dt: the cycle that was asked for, s.
        t: (N,) when each cycle began, s.
        busy: (N,) how long its packets took, s.
        missed: (N, n) where a READ or WRITE had no answer.
        damping: (N,) of the inverse Jacobian in the loop, m2.
        angles: by name (N, n), rad: command, real (read), reference (written), given_way.
        torques: by name (N, n), N m: load (read), filtered, dynamic (Newton-Euler), external (2.23),
            disturbance and reaction (the observers), pushed (what hands really do; NaN where nobody knows).
            All but pushed count as the servo does: positive is what it gives, or what resists it.
        causes: why answers were missed, and how often.
        began: when the motion began, s on the bus's clock.
        packets: what went over the bus meanwhile.
        pushes: the hands that pushed; empty too where the arm is real, and nobody knows.
    """

    limb: Limb
    track: Track
    dt: float
    t: Array
    busy: Array
    missed: Array
    damping: Array
    angles: dict[str, Array]
    torques: dict[str, Array]
    causes: dict[str, int] = field(default_factory=dict)
    began: float = 0.0
    packets: list[Passage] = field(default_factory=list)
    pushes: tuple[Push, ...] = ()

    @classmethod
    def empty(
        cls, limb: Limb, track: Track, dt: float, began: float = 0.0, pushes: tuple[Push, ...] = ()
    ) -> "Record":
        """A record to be filled by `note`."""
        count, n = track.q.shape
        return cls(
            limb, track, dt, np.zeros(count), np.zeros(count), np.zeros((count, n), bool), np.zeros(count),
            {name: np.zeros((count, n)) for name in ANGLES}, {name: np.zeros((count, n)) for name in TORQUES},
            began=began, pushes=pushes,
        )  # fmt: skip

    def note(self, k: int, moment: Moment) -> None:
        """Write down cycle `k`."""
        self.t[k], self.busy[k], self.damping[k] = moment.t, moment.busy, moment.damping
        self.missed[k] = moment.missed
        for name, values in (moment.angles | moment.torques).items():
            (self.angles if name in self.angles else self.torques)[name][k] = values

    def until(self, k: int) -> "Record":
        """The first `k` cycles."""
        return replace(
            self,
            t=self.t[:k],
            busy=self.busy[:k],
            missed=self.missed[:k],
            damping=self.damping[:k],
            angles={name: values[:k] for name, values in self.angles.items()},
            torques={name: values[:k] for name, values in self.torques.items()},
        )

    @property
    def error(self) -> Array:
        """(N, n) command less real, rad: what the paper plots."""
        return np.asarray(self.angles["command"] - self.angles["real"])

    @property
    def torque_error(self) -> Array:
        """(N, n) measured through the filter less computed, N m: what the paper plots in free motion."""
        return np.asarray(self.torques["filtered"] - self.torques["dynamic"])

    @property
    def overruns(self) -> int:
        """How many cycles did not fit into `dt`."""
        return int(np.sum(self.busy > self.dt + 1e-9))

    def columns(self) -> dict[str, Array]:
        """Every column by its name with its unit: deg and N m, joint by joint."""
        names = self.limb.joint_names
        found = {"t_s": self.t, "busy_ms": self.busy * 1e3}
        for kind, values in (self.angles | {"error": self.error}).items():
            found |= {f"{kind}_{j}_deg": np.degrees(values[:, i]) for i, j in enumerate(names)}
        for kind, values in self.torques.items():
            found |= {f"{kind}_{j}_nm": values[:, i] for i, j in enumerate(names)}
        return found | {f"missed_{j}": self.missed[:, i].astype(float) for i, j in enumerate(names)}

    def to_csv(self, path: Path) -> None:
        """Write all columns, a row for each cycle.

        Raises:
            FileError: the file cannot be written.
        """
        columns = self.columns()
        text = StringIO()
        rows = csv.writer(text, lineterminator="\n")
        rows.writerow(columns)
        rows.writerows([f"{v:.6g}" for v in row] for row in np.transpose(list(columns.values())))
        write_whole(path, text.getvalue())

    def to_json(self) -> dict[str, Any]:
        """As the command line prints it; NaN, where nobody knows, is null."""
        columns = {
            name: [None if np.isnan(v) else round(float(v), 6) for v in values]
            for name, values in self.columns().items()
        }
        return {
            "limb": self.limb.name,
            "cycle_ms": round(self.dt * 1e3, 6),
            "busy_ms": {
                "mean": round(float(self.busy.mean()) * 1e3, 4),
                "max": round(float(self.busy.max()) * 1e3, 4),
            },
            "overruns": self.overruns,
            "missed": int(self.missed.sum()),
            "causes": self.causes,
            "columns": columns,
        }
