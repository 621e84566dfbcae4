"""A recording: what stands still, and what changes over time, column by column."""

import os
from dataclasses import dataclass
from typing import Any
from uuid import uuid4

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import KinlabError
from kinlab.kinematics.transforms import Array, quaternion, rotation_vector
from kinlab.shipped import install_line
from kinlab.units import to_mm

APPLICATION = "kinlab"
TIME, PHASE = "time", "phase"
# Of a cycle: rerun's own times are seconds or whole numbers.
PHASE_STEPS = 1000


def load_rerun() -> Any:
    """The module `rerun`, imported now.

    Raises:
        KinlabError: it is not installed.
    """
    # What goes wrong we say ourselves; what rerun would say about it is for its makers.
    chosen = os.environ.get("RUST_LOG")
    os.environ["RUST_LOG"] = chosen or "off"
    try:
        import rerun
        import rerun.blueprint
    except ImportError:
        raise KinlabError(
            f"rerun is not installed: it is the extra `view`, half a gigabyte; {install_line('view')}"
        ) from None
    finally:
        if chosen is None:
            del os.environ["RUST_LOG"]
    return rerun


def part(*names: str) -> str:
    """An entity path: the names of its parts, as people may have chosen them."""
    return str(load_rerun().new_entity_path(list(names))).removeprefix("/")


@dataclass(frozen=True, eq=False)
class Times:
    """When F rows are.

    Attributes:
        t: s (F,).
        phase: cycles of the gait since the first began (F,); None where nothing walks.
    """

    t: Array
    phase: Array | None = None

    def at(self, rows: Array) -> "Times":
        """Some of them, by a mask or by number."""
        return Times(self.t[rows], None if self.phase is None else self.phase[rows])

    @property
    def steps(self) -> Array | None:
        """The phase as rerun counts it (F,)."""
        return None if self.phase is None else np.rint(self.phase * PHASE_STEPS).astype(int)


class Recording:
    """What is to be seen, kept in memory until it is saved or shown.

    Attributes:
        rr: the module `rerun`.
        stream: rerun's own recording, with our timelines alone.
    """

    def __init__(self, name: str) -> None:
        """An empty recording.

        Raises:
            KinlabError: rerun is not installed.
        """
        self.rr = load_rerun()
        # Two recordings of one name would become one in a viewer that has both.
        own = f"{name} {uuid4().hex[:8]}"
        self.stream = self.rr.RecordingStream(APPLICATION, recording_id=own, send_properties=False)
        self.stream.set_log_tick_enabled(False)
        self.stream.set_log_time_enabled(False)
        self._kept: Any = None

    def keep(self) -> None:
        """Keep in memory what is logged from now on, for `data`."""
        self._kept = self.rr.binary_stream(self.stream)

    def data(self) -> bytes:
        """The .rrd file of all that was logged since `keep`."""
        return bytes(self._kept.read())

    def still(self, path: str, *what: Any) -> None:
        """Log archetypes that never change."""
        self.stream.log(path, *what, static=True)

    def over(self, path: str, times: Times, kind: Any, each: ArrayLike = 1, **fields: Any) -> None:
        """Log columns of an archetype, a row for each time.

        Args:
            kind: the archetype.
            each: how many instances each row has, or every row; the fields hold all of them.
        """
        counts = np.broadcast_to(each, times.t.shape)
        self.stream.send_columns(path, self._index(times), kind.columns(**fields).partition(counts))

    def _index(self, times: Times) -> list[Any]:
        found = [self.rr.TimeColumn(TIME, duration=times.t)]
        if times.steps is not None:
            found.append(self.rr.TimeColumn(PHASE, sequence=times.steps))
        return found

    def series(self, path: str, times: Times, values: Array, names: list[str] | None = None) -> None:
        """Log curves: values (F, k), whose names are logged once; rows that nobody knows are left out."""
        if names:
            self.still(path, self.rr.SeriesLines(names=names))
        known = np.asarray(np.isfinite(values).all(axis=-1))
        if known.any():
            rows = values[known]
            self.over(path, times.at(known), self.rr.Scalars, rows.shape[-1], scalars=rows.ravel())

    def pose(self, path: str, T: Array, times: Times | None = None) -> None:
        """Log a transform (4, 4) that stays, or one for each time (F, 4, 4), metres."""
        place, turn = to_mm(T[..., :3, 3]), quaternion(rotation_vector(T[..., :3, :3]))
        if times is None:
            self.still(path, self.rr.Transform3D(translation=place, quaternion=self.rr.Quaternion(xyzw=turn)))
        else:
            self.over(path, times, self.rr.Transform3D, translation=place, quaternion=turn)

    def points(self, path: str, places: ArrayLike, **how: Any) -> None:
        """Log places (k, 3), in metres, that stay."""
        self.still(path, self.rr.Points3D(to_mm(np.atleast_2d(places)), **how))


class Live(Recording):
    """A recording that logs row by row: for what happens now, where a column would be one row long."""

    def over(self, path: str, times: Times, kind: Any, each: ArrayLike = 1, **fields: Any) -> None:
        """Log an archetype once for each time; see `Recording.over`."""
        ends = np.cumsum(np.broadcast_to(each, times.t.shape)).tolist()
        steps = times.steps
        for row, (t, end) in enumerate(zip(times.t.tolist(), ends, strict=True)):
            first = ends[row - 1] if row else 0
            self.stream.set_time(TIME, duration=t)
            if steps is not None:
                self.stream.set_time(PHASE, sequence=int(steps[row]))
            own = {name: values[first:end] for name, values in fields.items()}
            if kind is self.rr.Transform3D:
                own = {name: values[0] for name, values in own.items()}
            self.stream.log(path, kind(**own))
