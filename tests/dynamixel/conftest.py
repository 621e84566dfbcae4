"""What several of these tests need: chains in other processes, buses in memory, the verified packets."""

import csv
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from kinlab.dynamixel import Bus, Chain, MemoryPort, SimulatedClock

HERE = Path(__file__).parent


@pytest.fixture
def emulate(tmp_path: Path) -> Iterator[Callable[..., Path]]:
    """Starts `kinlab emulate` with arguments; gives the link to its pty once that is there."""
    running: list[subprocess.Popen[str]] = []

    def start(*arguments: str) -> Path:
        link = tmp_path / f"ttyDXL{len(running)}"
        command = [sys.executable, "-m", "kinlab", "emulate", *arguments, "--pty", str(link)]
        running.append(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
        wait_until(link.exists)
        return link

    yield start
    for process in running:
        process.terminate()
        process.communicate(timeout=10)


def wait_until(holds: Callable[[], bool], seconds: float = 20.0) -> None:
    """Come back when that holds, fail if it never does."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.01)


@pytest.fixture
def bus_of() -> Callable[..., Bus]:
    """A bus on a chain in memory, in simulated time."""

    def make(*modules: tuple[str, list[int]], baud: int = 1_000_000) -> Bus:
        return Bus(MemoryPort(Chain.of(modules, baud), SimulatedClock(), baud))

    return make


def verified_packets() -> list[dict[str, str]]:
    """Packets that manuals print, each with what it is."""
    with (HERE / "packets.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def no_such_process(pid: int) -> bool:
    """Whether a process has ended."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return True
    return False
