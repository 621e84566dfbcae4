"""What several of these tests need: chains in other processes, buses in memory, the verified packets."""

import csv
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from kinlab.dynamixel import Bus, Chain, MemoryPort, SimulatedClock
from kinlab.dynamixel.servo import Servo, Supply, build_servos

HERE = Path(__file__).parent
PATIENCE = 60.0  # s that a busy machine may take to start a program, or to let it answer


@pytest.fixture
def emulate(tmp_path: Path, eventually: Callable[..., None]):
    """Starts `kinlab emulate` with arguments; gives the link to its pty once that is there."""
    running: list[subprocess.Popen[str]] = []

    def start(*arguments: str) -> Path:
        link = tmp_path / f"ttyDXL{len(running)}"
        command = [sys.executable, "-m", "kinlab", "emulate", *arguments, "--pty", str(link)]
        running.append(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
        eventually(link.exists)
        return link

    start.running = running
    yield start
    for process in running:
        if process.poll() is None:
            process.terminate()
            process.communicate(timeout=PATIENCE)


@pytest.fixture
def bus_of() -> Callable[..., Bus]:
    """A bus on a chain in memory, in simulated time."""

    def make(*modules: tuple[str, list[int]], baud: int = 1_000_000) -> Bus:
        return Bus(MemoryPort(Chain.of(modules, baud), SimulatedClock(), baud))

    return make


class Probe:
    """A servo, and hands to set and read its registers and to let time pass."""

    def __init__(self, servo: Servo) -> None:
        self._servo = servo

    def __getattr__(self, name: str) -> Any:
        return getattr(self._servo, name)

    def put(self, name: str, value: int) -> int:
        register = self.table.find(name)
        return self.write(register.address, register.encode(value))

    def get(self, name: str) -> int:
        self.measure()
        return self.memory[name]

    def wait(self, seconds: float) -> None:
        self.advance(self.time + seconds)


@pytest.fixture
def probes() -> Callable[..., list[Probe]]:
    """Makes the servos of a module."""
    return lambda model, ids: [Probe(s) for s in build_servos(model, ids, 1_000_000, Supply())]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Packets that manuals print, as arguments: all of them, or the intact ones of a kind."""
    wanted = {
        "printed": lambda row: True,
        "intact": lambda row: row["check"] == "ok" and row["kind"] != "fast",
        "instruction": lambda row: row["check"] == "ok" and row["kind"] == "inst",
    }
    for name, fits in wanted.items():
        if name in metafunc.fixturenames:
            with (HERE / "packets.csv").open(encoding="utf-8", newline="") as file:
                rows = [row for row in csv.DictReader(file) if fits(row)]
            metafunc.parametrize(name, rows, ids=[row["description"] for row in rows])
