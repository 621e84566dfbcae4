"""Speed of the emulated chain, as ratios to what a wire allows: python benchmarks/dynamixel.py [--quick]

The chain runs in a process of its own, as `kinlab emulate` starts it, and ROBOTIS's dynamixel-sdk is the client.
Each ratio is what was measured over what is required; the exit code is 1 where one is below 1. With --quick
the loop with deadlines runs for 5 s in the place of 60.
"""

import argparse
import math
import os
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import dynamixel_sdk as sdk  # type: ignore[import-untyped]

from kinlab.dynamixel import Chain
from kinlab.dynamixel.chain import Receiver
from kinlab.dynamixel.codec.instructions import BROADCAST, BY_NAME, pack
from kinlab.dynamixel.codec.packets import Packet, encode, status
from kinlab.dynamixel.codec.stream import StreamParser

MBPS = 1_000_000
IDS = range(1, 19)
PERIOD = 0.01
TORQUE, GOAL, POSITION, RETURN_DELAY = 64, 116, 132, 9


def main() -> int:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--quick", action="store_true", help="5 s of the loop with deadlines, not 60")
    quick = options.parse_args().quick
    rows = [
        *transactions(2, "XL430-W250", 4000 if quick else 20000),
        *transactions(1, "AX-12A", 4000 if quick else 20000),
        *deadlines(5 if quick else 60),
        *parser_speed(),
        *simulation("XL430-W250", 2),
        *simulation("AX-12A", 1),
        *idle(3 if quick else 20),
    ]
    print(f"{'':<58} {'measured':>14} {'required':>14} {'ratio':>7}")
    for name, measured, required, ratio in rows:
        print(f"{name:<58} {measured:>14} {required:>14} {'' if ratio is None else f'{ratio:7.2f}'}")
    return int(any(ratio is not None and ratio < 1 for *_, ratio in rows))


Row = tuple[str, str, str, float | None]


@contextmanager
def emulated(*servos: str) -> Iterator[tuple[str, int]]:
    """A chain in a process of its own: the link to its pty, and its process id."""
    with tempfile.TemporaryDirectory() as folder:
        link = Path(folder) / "ttyDXL"
        command = [sys.executable, "-m", "kinlab", "emulate", "--pty", str(link)]
        for servo in servos:
            command += ["--servo", servo]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        try:
            while not link.exists():
                time.sleep(0.01)
            time.sleep(0.2)
            yield str(link), process.pid
        finally:
            process.terminate()
            process.wait()


@contextmanager
def client(link: str, protocol: int) -> Iterator[tuple[Any, Any]]:
    """The SDK's port and packet handler."""
    port = sdk.PortHandler(link)
    if not (port.openPort() and port.setBaudRate(MBPS)):
        raise SystemExit(f"cannot open {link}")
    try:
        yield port, sdk.PacketHandler(float(protocol))
    finally:
        port.closePort()


def transactions(protocol: int, model: str, count: int) -> list[Row]:
    """READ of the present position, one after the other, beside what the bytes take at 1 Mbps without delay."""
    with emulated(f"{model}:1-18") as (link, _), client(link, protocol) as (port, packets):
        address, size, delay = (POSITION, 4, RETURN_DELAY) if protocol == 2 else (36, 2, 5)
        packets.write1ByteTxRx(port, 1, delay, 0)
        read = packets.read4ByteTxRx if protocol == 2 else packets.read2ByteTxRx
        failed = 0
        begin = time.perf_counter()
        for _ in range(count):
            failed += read(port, 1, address)[1] != sdk.COMM_SUCCESS
        rate = count / (time.perf_counter() - begin)
    instruction = BY_NAME[protocol]["READ"]
    request = Packet(protocol, 1, instruction.code, pack(instruction, {"address": address, "count": size}))
    bytes_in_all = len(encode(request)) + len(encode(status(protocol, 1, 0, bytes(size))))
    allowed = MBPS / (10 * bytes_in_all)
    name = f"Protocol {protocol}.0 reads of {size} bytes over the pty ({failed} failed)"
    return [(name, f"{rate:.0f} /s", f"{allowed:.0f} /s", rate / allowed)]


def deadlines(seconds: float) -> list[Row]:
    """A 100 Hz loop of sync write and sync read over 18 servos; a round must end before the next begins."""
    bare = late(seconds / 6, compute)
    with emulated("XL430-W250:1-18") as (link, chain), client(link, 2) as (port, packets):
        for servo in IDS:
            packets.write1ByteTxRx(port, servo, RETURN_DELAY, 0)
            packets.write1ByteTxRx(port, servo, TORQUE, 1)
        read = sdk.GroupSyncRead(port, packets, POSITION, 4)
        for servo in IDS:
            read.addParam(servo)
        failures = []
        waits = []

        def turn(n: int) -> None:
            write = sdk.GroupSyncWrite(port, packets, GOAL, 4)
            for servo in IDS:
                goal = 2048 + round(500 * math.sin(0.02 * n + servo))
                write.addParam(servo, goal.to_bytes(4, "little"))
            before = waited(chain)
            if write.txPacket() != sdk.COMM_SUCCESS or read.txRxPacket() != sdk.COMM_SUCCESS:
                failures.append(n)
            waits.append(waited(chain) - before)

        busy = late(seconds, turn)
    missed = set(busy.missed) | set(failures)
    met = 1 - len(missed) / busy.rounds
    # A round that begins late pays for the one before it.
    starved = sum(sum(waits[max(0, n - 1) : n + 1]) > PERIOD / 4 for n in missed)
    noise = f"missed by a loop that only computes for 2 ms, worst round {bare.longest * 1e3:.2f} ms"
    return [
        (
            f"100 Hz sync write + sync read, 18 servos, {seconds:.0f} s",
            f"{met:.2%} met",
            "99.90%",
            met / 0.999,
        ),
        (f"   {len(missed)} of {busy.rounds} missed, worst round {busy.longest * 1e3:.2f} ms", "", "", None),
        (f"   in {starved} of those the two processes waited for a core", "", "", None),
        (f"   {len(bare.missed)} of {bare.rounds} {noise}", "", "", None),
    ]


def compute(n: int) -> None:
    """Need a core for 2 ms, and nothing else."""
    end = time.perf_counter() + 0.002
    while time.perf_counter() < end:
        pass


def waited(other: int) -> float:
    """How long this process and another one were ready to run and had no core, in s, since they began."""
    texts = [Path(f"/proc/{pid}/schedstat").read_text(encoding="utf-8") for pid in ("self", str(other))]
    return sum(int(text.split()[1]) for text in texts) / 1e9


class Lateness:
    """How a periodic loop has kept its time, in s."""

    def __init__(self, rounds: int) -> None:
        self.rounds = rounds
        self.missed: list[int] = []
        self.longest = 0.0


def late(seconds: float, turn: Any) -> Lateness:
    """Run `turn(n)` every period, and note the rounds that were not done when the next began."""
    seen = Lateness(round(seconds / PERIOD))
    start = time.perf_counter() + PERIOD
    for n in range(seen.rounds):
        begin = start + n * PERIOD
        time.sleep(max(0.0, begin - time.perf_counter()))
        turn(n)
        done = time.perf_counter()
        seen.longest = max(seen.longest, done - begin)
        if done > begin + PERIOD:
            seen.missed.append(n)
    return seen


def parser_speed() -> list[Row]:
    """The streaming parser on the short answers of a sync read (its worst case), beside a 4.5 Mbps wire."""
    source = random.Random(1)
    data = b"".join(encode(status(2, 1 + n % 18, 0, source.randbytes(4))) for n in range(40_000))
    best = 0.0
    for _ in range(5):
        parser, found = StreamParser(2), 0
        begin = time.perf_counter()
        for at in range(0, len(data), 4096):
            found += len(parser.feed(data[at : at + 4096]))
        best = max(best, len(data) / (time.perf_counter() - begin))
        assert found == 40_000
    required = 20 * 4_500_000 / 10
    return [
        (
            "Streaming parser, 15-byte answers",
            f"{best / 1e6:.1f} MB/s",
            f"{required / 1e6:.1f} MB/s",
            best / required,
        )
    ]


def simulation(model: str, protocol: int) -> list[Row]:
    """18 servos that follow sines by a sync write every 10 ms, in simulated time."""
    chain = Chain.of([(model, [servo]) for servo in IDS])
    receiver = Receiver(chain)
    instruction = BY_NAME[protocol]["SYNC_WRITE"]
    address, size, centre, swing = (GOAL, 4, 2048, 500) if protocol == 2 else (30, 2, 512, 200)

    def sync_write(address: int, size: int, values: list[int]) -> bytes:
        rows: list[dict[str, int | bytes]] = [
            {"id": i, "data": v.to_bytes(size, "little")} for i, v in zip(IDS, values, strict=True)
        ]
        params = pack(instruction, {"address": address, "length": size}, rows)
        return encode(Packet(protocol, BROADCAST, instruction.code, params))

    receiver.feed(sync_write(TORQUE if protocol == 2 else 24, 1, [1] * 18), 0.0, MBPS)
    wires = [
        sync_write(address, size, [centre + round(swing * math.sin(0.06 * n + servo)) for servo in IDS])
        for n in range(1000)
    ]
    best = 0.0
    for repeat in range(3):
        begin = time.perf_counter()
        for n, wire in enumerate(wires):
            receiver.feed(wire, (repeat * len(wires) + n + 1) * PERIOD, MBPS)
        best = max(best, len(wires) * PERIOD / (time.perf_counter() - begin))
    return [
        (f"18 {model} on a 100 Hz trajectory, simulated time", f"{best:.0f} x real", "50 x real", best / 50)
    ]


def idle(seconds: float) -> list[Row]:
    """Processor time of a chain that nobody talks to."""
    with emulated("XL430-W250:1-18") as (link, pid), client(link, 2) as (port, packets):
        packets.write1ByteTxRx(port, 1, TORQUE, 1)
        before = processor_time(pid)
        time.sleep(seconds)
        share = (processor_time(pid) - before) / seconds
    return [
        ("Idle chain of 18, share of one core", f"{share:.2%}", "2.00%", min(99.0, 0.02 / max(share, 1e-9)))
    ]


def processor_time(pid: int) -> float:
    """What a process has used so far, in s."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    sys.exit(main())
