"""How quickly the laboratory answers a key, and how fast it opens, as ratios: python benchmarks/tui.py [--quick]

Headless, in one run. A key's time ends when the update of the screen that it leads to has been drawn, at the Robot
station the one with the core's answer on it; the yardstick is the same of an empty Textual application, measured in
turn with ours, so that a noisy machine slows both.
The exit code is 1 where a limit is missed.
"""

import os

for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[pool] = "1"
os.environ["TEXTUAL_ANIMATIONS"] = "none"

import argparse
import asyncio
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from textual.app import App, ComposeResult
from textual.events import Key
from textual.widgets import Static

from kinematics import Result
from kinlab.tui.app import KinlabApp

SIZE = (120, 40)
PATIENCE = 0.5  # s until a key counts as one that changes nothing
# Keys that change what is seen, pressed over and over; first what takes the focus away from a field.
KEYS: dict[str, tuple[Sequence[str], Sequence[str]]] = {
    "robot": (("escape",), ("up", "right", "down", "left")),
    "gait": (("escape",), ("right", "right", "right", "left")),
    "packet": ((), ("p", "i", "n", "g", "backspace", "backspace", "backspace", "backspace")),
    "arm": (("escape",), ("c", "j")),
    "lessons": ((), ("down", "down", "up", "up")),
}
PLAYING = 5.0


class Empty(App[None]):
    """A screen of one line, which each key changes."""

    count = 0

    def compose(self) -> ComposeResult:
        yield Static("0")

    def on_key(self) -> None:
        self.count += 1
        self.query_one(Static).update(str(self.count))


class Watch:
    """When the screen was drawn last, and how often."""

    def __init__(self, app: App[Any]) -> None:
        self.app, self.drawn, self.frames = app, 0.0, 0
        self._new = asyncio.Event()
        display = app._display

        def displayed(*args: Any) -> None:
            display(*args)
            self.drawn = time.perf_counter()
            self.frames += 1
            self._new.set()

        app._display = displayed  # type: ignore[method-assign,assignment]

    async def press(self, key: str) -> float:
        """From the key to the update of the screen that it leads to, s; NaN where it leads to none."""
        start = time.perf_counter()
        self.app.post_message(Key(key, key if len(key) == 1 else None))
        with suppress(TimeoutError):
            while True:
                self._new.clear()
                await asyncio.wait_for(self._new.wait(), PATIENCE)
                if not getattr(self.app.screen, "asking", False):
                    return self.drawn - start
        return float("nan")


async def presses(
    app: App[Any], first: Sequence[str], keys: Sequence[str], count: int
) -> tuple[list[float], float]:
    """The times of that many keys, s, and the processor's time for one of them, what runs by itself included."""
    async with app.run_test(size=SIZE) as pilot:
        await pilot.pause(0.5)
        for key in first:
            await pilot.press(key)
        await pilot.pause(0.3)
        watch = Watch(app)
        times, cpu = [], time.process_time()
        for i in range(count + 8):
            times.append(await watch.press(keys[i % len(keys)]))
            await asyncio.sleep(0.03)
        cpu = (time.process_time() - cpu) / len(times)
    return [t for t in times[8:] if t == t], cpu


def answers(rounds: int) -> list[Result]:
    """Median and 99th percentile of every station, and the median as a ratio to an empty application's."""
    results = []
    for name, (first, keys) in KEYS.items():
        ours: list[float] = []
        theirs: list[float] = []
        for _ in range(3):
            found, cpu = asyncio.run(presses(KinlabApp(name), first, keys, rounds // 3))
            ours += found
            theirs += asyncio.run(presses(Empty(), (), ("a",), rounds // 6))[0]
        ours.sort()
        middle, slow = statistics.median(ours), ours[int(0.99 * (len(ours) - 1))]
        ratio = middle / statistics.median(theirs)
        note = f"{ratio:.0f} x an empty application's; {cpu * 1e3:.0f} ms of the processor"
        results.append(Result(f"key to screen, {name}, median", middle * 1e3, 30.0, "ms", note))
        results.append(Result(f"key to screen, {name}, 99th percentile", slow * 1e3, 100.0, "ms"))
    return results


async def _play() -> tuple[float, float]:
    app = KinlabApp("gait")
    async with app.run_test(size=SIZE) as pilot:
        await pilot.pause(0.5)
        await pilot.press("escape", "space")
        await pilot.pause(1.0)
        watch = Watch(app)
        begun, cpu = time.perf_counter(), time.process_time()
        await asyncio.sleep(PLAYING)
        took = time.perf_counter() - begun
        return (time.process_time() - cpu) / took, watch.frames / took


def playing() -> list[Result]:
    """The share of one core that a gait takes while it is played."""
    share, rate = asyncio.run(_play())
    return [Result("a gait played, share of one core", share, 0.5, "", f"{rate:.0f} frames a second")]


OURS = """
import os, sys
from kinlab.tui.app import KinlabApp
from kinlab.tui.stations.robot.station import RobotStation
app = KinlabApp("robot")
display = app._display
def displayed(screen, drawn):
    display(screen, drawn)
    if isinstance(screen, RobotStation) and (sys.argv[1] == "screen" or screen.answer):
        os._exit(0)
app._display = displayed
app.run(headless=True, size=(80, 24))
"""
EMPTY = """
import os
from textual.app import App
from textual.widgets import Static
class Empty(App):
    def compose(self):
        yield Static("0")
app = Empty()
display = app._display
def displayed(screen, drawn):
    display(screen, drawn)
    os._exit(0)
app._display = displayed
app.run(headless=True, size=(80, 24))
"""


def opening(rounds: int) -> list[Result]:
    """From the start of Python to the first screen, and to the first answer on it."""
    runs = {"empty": EMPTY, "screen": OURS, "answer": OURS}
    times: dict[str, list[float]] = {name: [] for name in runs}
    # Both are started as installed programs are: compiled.
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    with tempfile.TemporaryDirectory() as home:
        for i in range(rounds + 1):
            for name, script in runs.items():
                start = time.perf_counter()
                subprocess.run(
                    [sys.executable, "-c", script, name],
                    check=True,
                    env=environment | {"KINLAB_HOME": home, "PYTHONPYCACHEPREFIX": home},
                    stdout=subprocess.DEVNULL,
                )
                if i:  # The first one compiles.
                    times[name].append(time.perf_counter() - start)
    empty, screen, answer = (statistics.median(found) for found in times.values())
    return [
        Result("first screen", screen / empty, 2.5, note=f"empty = 1; {screen * 1e3:.0f} ms"),
        Result("first screen with the whole path", answer / empty, None, note=f"{answer * 1e3:.0f} ms"),
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    quick = parser.parse_args().quick
    with tempfile.TemporaryDirectory() as home:
        os.environ["KINLAB_HOME"] = home
        results = [*answers(60 if quick else 300), *playing(), *opening(3 if quick else 9)]
    for result in results:
        print(result)
    return int(any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
