"""Speed of the lessons: python benchmarks/lessons.py [--quick]

A reply is judged, and kept on the disk behind a history of 2000 events. The exit code is 1 where a limit is missed.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from kinematics import Result, seconds
from kinlab.lessons import Progress, Sitting, load_course
from kinlab.lessons.kinds import judge, kind_of
from kinlab.lessons.lint import lint
from kinlab.lessons.progress import Event

HISTORY = 2000


def checking(home: Path, rounds: int) -> list[Result]:
    """The slowest reply of each kind: all of it, and what of it is not the core's own computation."""
    progress = Progress("ani", home)
    for i in range(HISTORY):
        progress.add(Event.now("try", "some-lesson", 1, f"exercise-{i}", reply="12.5 mm"))
    slowest: dict[str, tuple[float, float]] = {}
    for lesson in load_course().lessons.values():
        sitting = Sitting(lesson, progress, "en")
        for name, task in sitting.tasks.items():
            reply = kind_of(task).right(task)
            core = min(seconds(partial(judge, task, reply)) for _ in range(rounds))
            whole = min(seconds(partial(sitting.check, name, reply)) for _ in range(rounds))
            slowest[task.exercise.kind] = max(
                (whole, whole - core), slowest.get(task.exercise.kind, (0.0, 0.0))
            )
    return [
        Result(
            f"check a reply, slowest '{kind}'", 1e3 * whole, 50.0, "ms", f"{1e3 * keeping:.1f} ms to keep it"
        )
        for kind, (whole, keeping) in sorted(slowest.items())
    ]


def listing(rounds: int) -> Result:
    """The list of lessons, in a process of its own, without numpy."""
    command = [sys.executable, "-m", "kinlab", "learn"]
    took = min(
        seconds(lambda: subprocess.run(command, check=True, capture_output=True)) for _ in range(rounds)
    )
    return Result("kinlab learn, from a cold start", 1e3 * took, None, "ms")


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    rounds = 3 if parser.parse_args().quick else 9
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    with tempfile.TemporaryDirectory() as home:
        os.environ["KINLAB_HOME"] = home
        course = load_course()
        count = sum(len(lesson.exercises) for lesson in course.lessons.values())
        results = [
            *checking(Path(home), rounds),
            listing(rounds),
            Result(f"lint of {count} exercises, 1000 seeds", seconds(lambda: lint(course)), 20.0, "s"),
        ]
    for result in results:
        print(result)
    return int(any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
