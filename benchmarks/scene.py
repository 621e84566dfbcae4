"""Speed of filling rerun, as ratios: python benchmarks/scene.py [--quick]

A walk of an 18-joint robot is logged by columns, as KinLab does, and row by row, as rerun's examples do: the same
entities, the same values, frame by frame. Both are logged again in turn, and the ratio is the median of such pairs.
The exit code is 1 where a limit is missed.
"""

import os

for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[pool] = "1"

import argparse
import statistics
import subprocess
import sys
from collections import defaultdict
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinematics import Result, seconds
from kinlab.gait import find_gait, plan
from kinlab.robots import load_robot
from kinlab.scene import Recording, gait_scene
from kinlab.scene.recording import PHASE, TIME, Times

FRAMES, CYCLES = 100, 5
# Each draws nothing; rerun and what it is written in stay out.
COMMANDS = (
    "--help",
    "ik xl430-hexapod 75 10 -46",
    "gait krsri-hexapod",
    "walk krsri-hexapod --distance 20",
    "arm track",
    "packet -c help",
    "view --help",
)


class RowByRow(Recording):
    """A recording that logs the same values row by row: at each time all entities that have a row then."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self._rows: dict[float, list[tuple[str, Any, dict[str, Any]]]] = defaultdict(list)
        self._phases: dict[float, int] = {}

    def over(self, path: str, times: Times, kind: Any, each: ArrayLike = 1, **fields: Any) -> None:
        ends = np.cumsum(np.broadcast_to(each, times.t.shape)).tolist()
        for row, (t, end) in enumerate(zip(times.t.tolist(), ends, strict=True)):
            first = ends[row - 1] if row else 0
            own = {name: values[first:end] for name, values in fields.items()}
            if kind is self.rr.Transform3D:
                own = {name: values[0] for name, values in own.items()}
            self._rows[t].append((path, kind, own))
        if times.steps is not None:
            self._phases.update(zip(times.t.tolist(), times.steps.tolist(), strict=True))

    def replay(self) -> None:
        """Log what was handed over."""
        for t in sorted(self._rows):
            self.stream.set_time(TIME, duration=t)
            self.stream.set_time(PHASE, sequence=self._phases[t])
            for path, kind, fields in self._rows[t]:
                self.stream.log(path, kind(**fields))


class Columns(Recording):
    """A recording that logs by columns what was handed over, when it is told to."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self._held: list[tuple[Any, ...]] = []

    def over(self, path: str, times: Times, kind: Any, each: ArrayLike = 1, **fields: Any) -> None:
        self._held.append((path, times, kind, each, fields))

    def replay(self) -> None:
        """Log what was handed over."""
        for path, times, kind, each, fields in self._held:
            super().over(path, times, kind, each, **fields)


def logged(kind: type[RowByRow] | type[Columns], name: str) -> tuple[float, int]:
    """How long it takes to log a walk and to write its file, s, and the file's size, bytes."""
    robot = load_robot("krsri-hexapod")
    recording = kind(name)
    gait_scene(plan(robot, find_gait(robot, "wave")), each=FRAMES, cycles=CYCLES, into=recording)
    size = 0

    def work() -> None:
        nonlocal size
        recording.replay()
        size = len(recording.data())

    return seconds(work), size


def recordings(rounds: int) -> list[Result]:
    """By columns against row by row: time, and size of the file."""
    logged(Columns, "warm"), logged(RowByRow, "warm")
    pairs = [(logged(RowByRow, f"rows {i}"), logged(Columns, f"columns {i}")) for i in range(rounds)]
    speed = statistics.median(rows[0] / columns[0] for rows, columns in pairs)
    rows, columns = pairs[0]
    note = f"{FRAMES * CYCLES} frames of 18 joints; by columns {columns[0] * 1e3:.0f} ms"
    size_note = f"rows {rows[1] / 1000:.0f} kB, columns {columns[1] / 1000:.0f} kB"
    return [
        Result("row by row over by columns", speed, 10.0, note=note, at_least=True),
        Result(
            "file by columns over the smaller", columns[1] / min(rows[1], columns[1]), 1.5, note=size_note
        ),
    ]


def imports() -> Result:
    """How many commands that do not draw import rerun."""
    guilty = 0
    for command in COMMANDS:
        code = (
            "import sys, atexit\n"
            "atexit.register(lambda: sys.stderr.write('rerun' * ('rerun' in sys.modules)))\n"
            f"from kinlab.cli import main\nmain({command.split()!r})\n"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
        guilty += done.stderr.endswith("rerun")
    return Result(f"of {len(COMMANDS)} commands import rerun", guilty, 0, " ")


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    rounds = 3 if parser.parse_args().quick else 11
    results = [*recordings(rounds), imports()]
    for result in results:
        print(result)
    return int(any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
