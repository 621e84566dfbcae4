"""Speed of walking, as ratios: python benchmarks/gait.py [--quick]

Everything is measured in one run on one core. The yardstick is the closed-form inverse kinematics of the same
number of feet, timed again right beside each item, so that a noisy machine slows both. A ratio is the median of
many such pairs. The exit code is 1 where a limit is missed.
"""

import os

for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[pool] = "1"

import argparse
import sys

import numpy as np

from kinematics import Result, paired, seconds
from kinlab.gait import find_gait, plan, stability
from kinlab.gait.report import report
from kinlab.kinematics.leg import leg_ik
from kinlab.robots import load_robot

FRAMES = 100_000


def batches(rounds: int) -> list[Result]:
    """Feet, joint angles and stability of many frames in one call, against the closed-form IK of their feet."""
    robot = load_robot("krsri-hexapod")
    assert robot.equal_legs is not None
    lengths = robot.equal_legs
    t = np.linspace(0.0, 20.0, FRAMES)
    results = []
    for name, turn in (("tripod", 0.0), ("wave", 0.0), ("tripod", 0.1), ("wave", 0.1)):
        walk = plan(robot, find_gait(robot, name), turn=turn)
        feet = robot.to_legs(walk.at(t).feet)
        ratio, own = paired(
            lambda walk=walk: seconds(lambda: stability(walk.at(t))),  # type: ignore[misc]
            lambda feet=feet: seconds(lambda: leg_ik(feet, *lengths)),  # type: ignore[misc]
            rounds,
        )
        how = "turning" if turn else "straight"
        note = f"IK alone = 1; {own * 1e3:.0f} ms"
        results.append(Result(f"{FRAMES:,} frames of 18 joints, {name}, {how}", ratio, 12.0, note=note))
    return results


def single(rounds: int) -> list[Result]:
    """One phase as a face asks for it: feet, joint angles and margins of one frame."""
    results = []
    for name in ("xl430-hexapod", "krsri-hexapod", "udiebot", "eros"):
        robot = load_robot(name)
        answer = report(plan(robot, find_gait(robot)))
        phase = answer.walk.gait.phases[0]
        own = min(seconds(lambda: answer.still(phase), 20) for _ in range(rounds))  # noqa: B023
        results.append(Result(f"one phase of {name}", own * 1e3, 2.0, "ms"))
    return results


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    rounds = 5 if parser.parse_args().quick else 21
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    results = [*batches(rounds), *single(rounds)]
    for result in results:
        print(result)
    return int(any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
