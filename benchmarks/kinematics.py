"""Speed, memory and start-up of the kinematics, as ratios: python benchmarks/kinematics.py [--quick]

Everything is measured in one run on one core, against a scalar C loop (reference.c, compiled here) that is
timed again right beside each item, so that a noisy machine slows both. A ratio is the median of many such
pairs. The exit code is 1 where a limit is missed.
"""

import os

for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[pool] = "1"

import argparse
import ctypes
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinlab.kinematics import chain
from kinlab.kinematics.leg import leg_fk, leg_ik
from kinlab.robots import load_robot
from kinlab.robots.body import body_pose

LENGTHS = (0.025, 0.050, 0.070)
AXES = ((0, 0, 1), (0, -1, 0), (0, -1, 0))
LINKS = tuple((length, 0, 0) for length in LENGTHS)
MILLION = 1_000_000

Array = NDArray[Any]


@dataclass
class Result:
    """One line of the table; `limit` is None where nothing is asked, `at_least` where more is better."""

    item: str
    measured: float
    limit: float | None
    unit: str = "x"
    note: str = ""
    at_least: bool = False

    @property
    def missed(self) -> bool:
        if self.limit is None:
            return False
        return self.measured < self.limit if self.at_least else self.measured > self.limit

    def __str__(self) -> str:
        sign = ">=" if self.at_least else "<="
        limit = "" if self.limit is None else f"{sign} {self.limit:g} {self.unit}"
        verdict = "" if self.limit is None else "MISSED" if self.missed else "ok"
        return f"{self.item:<52} {self.measured:>9.3g} {self.unit:<3} {limit:>11}  {verdict:<7} {self.note}".rstrip()


def seconds(work: Callable[[], Any], calls: int = 1) -> float:
    start = time.perf_counter()
    for _ in range(calls):
        work()
    return (time.perf_counter() - start) / calls


def paired(ours: Callable[[], float], theirs: Callable[[], float], rounds: int) -> tuple[float, float]:
    """The median ratio of two timings taken side by side, and the median of the first."""
    pairs = [(ours(), theirs()) for _ in range(rounds)]
    return statistics.median(a / b for a, b in pairs), statistics.median(a for a, _ in pairs)


class Reference:
    """The C loops, timed per leg."""

    def __init__(self, folder: Path, compiler: str, count: int) -> None:
        library = folder / "reference.so"
        source = Path(__file__).with_name("reference.c")
        command = [
            compiler,
            "-O3",
            "-march=native",
            "-shared",
            "-fPIC",
            str(source),
            "-o",
            str(library),
            "-lm",
        ]
        subprocess.run(command, check=True)
        self.library = ctypes.CDLL(str(library))
        self.foot, self.q = targets(count)
        self.reachable = np.empty(count, dtype=np.uint8)
        self.out = np.empty_like(self.q)

    def ik(self) -> float:
        return self._seconds("leg_ik", self.foot, self.out, self.reachable)

    def fk(self) -> float:
        return self._seconds("leg_fk", self.q, self.out)

    def _seconds(self, name: str, *arrays: Array) -> float:
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in arrays]
        count = len(arrays[0])
        numbers = (ctypes.c_size_t(count), *map(ctypes.c_double, LENGTHS))
        return seconds(lambda: getattr(self.library, name)(*pointers, *numbers)) / count

    def check(self) -> None:
        """The yardstick computes what we compute."""
        self.ik()
        q, reachable = leg_ik(self.foot, *LENGTHS)
        np.testing.assert_allclose(self.out, q, atol=1e-9)
        np.testing.assert_array_equal(self.reachable, reachable)
        self.fk()
        np.testing.assert_allclose(self.out, leg_fk(self.q, *LENGTHS), atol=1e-12)


def targets(count: int) -> tuple[Array, Array]:
    """Feet within reach, and the knee-up angles that they come from."""
    rng = np.random.default_rng(0)
    q = rng.uniform([-1, -1, -2.6], [1, 1, -0.4], (count, 3))
    return leg_fk(q, *LENGTHS), q


def against_c(reference: Reference, rounds: int) -> list[Result]:
    foot, q = reference.foot, reference.q
    count = len(foot)
    robot = load_robot("xl430-hexapod")
    xyz, rpy = np.array([0.004, -0.003, 0.005]), np.array([0.03, -0.02, 0.05])
    assert body_pose(robot, xyz, rpy).reachable.all()
    items: list[tuple[str, float, Callable[[], float], Callable[[], float]]] = [
        (
            f"closed-form IK of {count:,} legs, per solve",
            0.5,
            lambda: seconds(lambda: leg_ik(foot, *LENGTHS)) / count,
            reference.ik,
        ),
        (
            f"FK of {count:,} legs, per pose",
            1.6,
            lambda: seconds(lambda: leg_fk(q, *LENGTHS)) / count,
            reference.fk,
        ),
        (
            f"FK of {count:,} poses of any chain, per pose",
            8.0,
            lambda: seconds(lambda: chain.fk(AXES, LINKS, q)) / count,
            reference.fk,
        ),
        (
            "one body pose, all six legs, against six solves",
            150.0,
            lambda: seconds(lambda: body_pose(robot, xyz, rpy), 500),
            lambda: 6 * reference.ik(),
        ),
    ]
    results = []
    for item, limit, ours, theirs in items:
        ours(), theirs()  # the first run pays for pages and caches
        ratio, own = paired(ours, theirs, rounds)
        results.append(Result(item, ratio, limit, note=f"C = 1; ours {own * 1e9:,.0f} ns"))
    return results


def memory() -> Result:
    foot, _ = targets(MILLION)
    tracemalloc.start()
    leg_ik(foot, *LENGTHS)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return Result(f"peak memory of IK of {MILLION:,} legs, over the input", peak / 1e6, 200.0, "MB")


def start_up(rounds: int) -> list[Result]:
    command = [sys.executable, "-m", "kinlab", "ik", "xl430-hexapod", "75", "10", "-46", "--json"]
    bare = [sys.executable, "-c", "import numpy, typer"]

    # Numpy and typer come with their bytecode; ours is written by the first run.
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}

    def run(args: list[str]) -> float:
        return seconds(lambda: subprocess.run(args, check=True, stdout=subprocess.DEVNULL, env=environment))

    run(command), run(bare)
    ratio, own = paired(lambda: run(command), lambda: run(bare), rounds)
    return [
        Result(
            "cold start of `kinlab ik ... --json`",
            ratio,
            1.5,
            note=f"import numpy, typer = 1; {own * 1e3:.0f} ms",
        ),
        Result(
            "heavy modules that `kinlab --help` imports",
            len(heavy_modules()),
            0,
            "",
            ", ".join(heavy_modules()),
        ),
    ]


def heavy_modules() -> list[str]:
    script = (
        "import sys\n"
        "from kinlab.cli import main\n"
        "try: main(['--help'])\n"
        "except SystemExit: pass\n"
        "print([m for m in ('numpy', 'textual', 'rerun', 'yaml', 'rich') if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    return [m for m in ("numpy", "textual", "rerun") if f"'{m}'" in done.stderr]


def against_peers(rounds: int) -> list[Result]:
    """Numeric IK of peers per solve, to 1e-9 m from one fixed start, in units of our closed form by the batch."""
    foot, _ = targets(MILLION)
    feet, start = foot[:200], np.array([0.0, 0.3, -1.5])
    peers = {"roboticstoolbox": (toolbox_solver, 500.0), "pinocchio": (pinocchio_solver, None)}
    results = []
    for name, (build, limit) in peers.items():
        if find_spec(name) is None:
            print(f"{name} is not installed: not compared")
            continue
        item, solve = build(start)
        solved = np.mean([np.linalg.norm(leg_fk(solve(p), *LENGTHS) - p) < 1.1e-9 for p in feet])
        ratio, own = paired(
            lambda solve=solve: seconds(lambda: [solve(p) for p in feet]) / len(feet),  # type: ignore[misc]
            lambda: seconds(lambda: leg_ik(foot, *LENGTHS)) / len(foot),
            rounds,
        )
        note = f"ours = 1; {own * 1e6:.1f} us, {solved:.0%} solved to 1e-9 m"
        results.append(Result(item, ratio, limit, note=note, at_least=True))
    return results


def toolbox_solver(start: Array) -> tuple[str, Callable[[Array], Array]]:
    import roboticstoolbox as rtb

    c, f, t = LENGTHS
    leg = (
        rtb.ET.Rz() * rtb.ET.tx(c) * rtb.ET.Ry(flip=True) * rtb.ET.tx(f) * rtb.ET.Ry(flip=True) * rtb.ET.tx(t)
    )
    mask = np.array([1.0, 1, 1, 0, 0, 0])
    T = np.eye(4)

    def solve(foot: Array) -> Array:
        T[:3, 3] = foot
        # Its tolerance is half the squared error, so this is 1e-9 m.
        return np.asarray(leg.ik_LM(T, q0=start, mask=mask, tol=5e-19, joint_limits=False)[0])

    return "roboticstoolbox ik_LM (C++), per solve", solve


def pinocchio_solver(start: Array) -> tuple[str, Callable[[Array], Array]]:
    import pinocchio as pin

    model = pin.Model()
    joint, offset = 0, np.zeros(3)
    for axis, link in zip(AXES, LINKS, strict=True):
        placement = pin.SE3(np.eye(3), offset)
        joint = model.addJoint(
            joint, pin.JointModelRevoluteUnaligned(np.array(axis, float)), placement, f"j{joint}"
        )
        offset = np.array(link)
    tip = model.addFrame(pin.Frame("tip", joint, pin.SE3(np.eye(3), offset), pin.FrameType.OP_FRAME))
    data = model.createData()

    def solve(foot: Array) -> Array:
        q = start.copy()
        for _ in range(200):
            pin.framesForwardKinematics(model, data, q)
            gap = foot - data.oMf[tip].translation
            if gap @ gap < 1e-18:
                break
            J = pin.computeFrameJacobian(model, data, q, tip, pin.LOCAL_WORLD_ALIGNED)[:3]
            q = q + J.T @ np.linalg.solve(J @ J.T + 1e-6 * np.eye(3), gap)
        return q

    return "pinocchio, damped steps in Python, per solve", solve


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds and fewer legs")
    quick = parser.parse_args().quick
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    count, rounds = (100_000, 7) if quick else (MILLION, 21)

    results: list[Result] = []
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler:
        with tempfile.TemporaryDirectory() as folder:
            reference = Reference(Path(folder), compiler, count)
            reference.check()
            results += against_c(reference, rounds)
    else:
        print("no C compiler: not compared with C")
    results.append(memory())
    results += start_up(rounds)
    results += against_peers(max(rounds // 3, 3))

    for result in results:
        print(result)
    return int(any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
