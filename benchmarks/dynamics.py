"""Speed of the dynamics, as ratios: python benchmarks/dynamics.py [--quick]

All ratios are measured in one run on one core. The dynamics stand against a scalar C loop (newton_euler.c,
compiled here) that is timed again right beside each item, the median of many such pairs; the arm on its emulated
bus stands against the clock on the wall. The exit code is 1 where a limit is missed. Pinocchio is compared with
where it is installed.
"""

import os

for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[pool] = "1"

import argparse
import ctypes
import gc
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from kinematics import Array, Result, paired, seconds
from kinlab.dynamics import Mechanism, forward_dynamics, inverse_dynamics
from kinlab.papers.receptionist_experiments import PUSH
from kinlab.papers.receptionist_line import line
from kinlab.rig.arm import ArmServos, Settings, run
from kinlab.robots import load_robot
from kinlab.robots.urdf import to_urdf

COUNT = 100_000


def yardstick(
    folder: Path, compiler: str, arm: Mechanism, motion: list[Array]
) -> tuple[Callable[[], float], Array]:
    """A C loop over all states, timed per state, and where it puts the torques."""
    library, source = folder / "newton_euler.so", Path(__file__).with_name("newton_euler.c")
    flags = ["-O3", "-march=native", "-shared", "-fPIC"]
    subprocess.run([compiler, *flags, str(source), "-o", str(library), "-lm"], check=True)
    loop = ctypes.CDLL(str(library)).inverse_dynamics
    rows = [
        np.concatenate([axis, link, [mass], centre, np.ravel(inertia)])
        for axis, link, mass, centre, inertia, _ in arm.rows
    ]
    parts, out = np.ascontiguousarray(rows), np.empty_like(motion[0])
    pointers = [ctypes.c_void_p(a.ctypes.data) for a in (parts, arm.gravity, *motion, out)]
    first, *rest = pointers

    def run() -> float:
        count = ctypes.c_size_t(len(out))
        return seconds(lambda: loop(first, ctypes.c_size_t(arm.count), *rest, count)) / len(out)

    return run, out


def pinocchio_rnea(motion: list[Array], torque: Array) -> Callable[[], float]:
    """pinocchio's `rnea`, called from Python state by state, on the URDF of the arm; timed per state."""
    import pinocchio as pin

    robot = load_robot("receptionist-arm")
    whole = pin.buildModelFromXML(to_urdf(robot))
    whole.gravity.linear[:] = [0, 0, -9.80665]
    others = [j for j, name in enumerate(whole.names) if j and not name.startswith(robot.limb().name)]
    model = pin.buildReducedModel(whole, others, pin.neutral(whole))
    data = model.createData()
    states = list(zip(*(array[:2000] for array in motion), strict=True))
    for (q, qd, qdd), ours in zip(states[:100], torque, strict=False):
        np.testing.assert_allclose(pin.rnea(model, data, q, qd, qdd), ours, atol=1e-12)
    return lambda: seconds(lambda: [pin.rnea(model, data, *state) for state in states]) / len(states)


def rig(rounds: int) -> Result:
    """How much faster than real time the compliant arm runs on its emulated bus, by the median of its seconds."""
    robot = load_robot("receptionist-arm")
    path, settings = line(robot.limb()), Settings("compliance")
    took = []
    for _ in range(rounds):
        with ArmServos.emulated(robot, robot.limb(), path.q[0].tolist(), [PUSH]) as servos:
            servos.hold()
            clock = servos.bus.port.clock
            began = clock.now()
            spent = seconds(lambda servos=servos: run(servos, path, settings))  # type: ignore[misc]
            took.append((clock.now() - began) / spent)
    note = "a second of the compliant arm, pushed: bus, servos, links and loop"
    return Result("simulated over real time", statistics.median(took), 40.0, note=note, at_least=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    rounds = 7 if parser.parse_args().quick else 41
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    arm = Mechanism.of(load_robot("receptionist-arm").limb())
    motion = list(np.random.default_rng(0).normal(size=(3, COUNT, 3)))
    torque = inverse_dynamics(arm, *motion)
    results: list[Result] = []

    def ours() -> float:
        return seconds(lambda: inverse_dynamics(arm, *motion)) / COUNT

    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler:
        with tempfile.TemporaryDirectory() as folder:
            in_c, out = yardstick(Path(folder), compiler, arm, motion)
            in_c()
            np.testing.assert_allclose(out, torque, atol=1e-12)  # the yardstick computes what we compute
            ratio, own = paired(ours, in_c, rounds)
            note = f"C = 1; ours {own * 1e9:,.0f} ns"
            results.append(Result(f"inverse dynamics of {COUNT:,} arms, per state", ratio, 2.0, note=note))

            def forward() -> float:
                few = [array[:10_000] for array in motion]
                return seconds(lambda: forward_dynamics(arm, *few)) / len(few[0])

            ratio, own = paired(forward, in_c, max(rounds // 4, 3))
            note = f"inverse dynamics in C = 1; ours {own * 1e9:,.0f} ns"
            results.append(Result("forward dynamics of 10,000 arms, per state", ratio, None, note=note))
    else:
        print("no C compiler: not compared with C")
    if find_spec("pinocchio"):
        ratio, own = paired(ours, pinocchio_rnea(motion, torque), rounds)
        results.append(
            Result("inverse dynamics, per state", ratio, 1.0, note="pinocchio's rnea from Python = 1")
        )
    else:
        print("pinocchio is not installed: not compared")
    gc.set_threshold(200_000)  # as `kinlab` runs
    results.append(rig(rounds))
    for result in results:
        print(result)
    return int(any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
