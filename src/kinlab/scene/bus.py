"""Packets as a text log, each at the instant in which its last byte had passed."""

from collections.abc import Sequence
from functools import cache
from itertools import pairwise

import numpy as np

from kinlab.dynamixel.bus import Passage
from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.dissection import Dissection
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.instructions import BROADCAST
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.tables import load_table
from kinlab.robots import Robot
from kinlab.scene import colours
from kinlab.scene.recording import Recording, Times

BUS = "bus"


def log_packets(
    recording: Recording, robot: Robot, heard: Sequence[Passage], times: Times, path: str = BUS
) -> None:
    """Log what went over a robot's bus.

    Args:
        heard: whole packets, see `kinlab.dynamixel.bus.packets`.
        times: when, one for each of them.
    """
    if not heard:
        return
    tables = {servo.id: load_table(servo.model.name) for servo in robot.servos}

    # A walk says the same things again and again.
    @cache
    def told(data: bytes, request: Packet | None, sent: bool) -> tuple[str, bool, Packet | None]:
        found = dissect(data, status=None if sent else True, tables=tables.get, request=request)
        text = f"{'->' if sent else '<-'} {_head(found, sent)}  [{show_hex(data)}]  {_values(found)}"
        return text.rstrip(), found.ok, found.packet if sent else request

    request: Packet | None = None
    texts, levels, shades = [], [], []
    for packet, t in zip(heard, times.t.tolist(), strict=True):
        text, ok, request = told(packet.data, None if packet.sent else request, packet.sent)
        # The viewer's own column of times may be too narrow to be read. At 1 Mbps a byte takes 10 us.
        texts.append(f"{t:.5f} s  {text}")
        levels.append(("sent" if packet.sent else "heard") if ok else "damaged")
        shades.append((colours.SENT if packet.sent else colours.HEARD) if ok else colours.BROKEN)
    rr = recording.rr
    recording.over(path, times, rr.TextLog, text=texts, level=levels, color=np.array(shades, np.uint8))


def _head(found: Dissection, sent: bool) -> str:
    """A packet in few words: what, and to or from whom."""
    who = "all" if found.id == BROADCAST else f"servo {found.id}"
    return f"{found.instruction} {who}" if sent else f"{who} {', '.join(found.errors) or 'ok'}"


def _values(found: Dissection) -> str:
    """What it is about, or what is wrong with it."""
    if not found.ok:
        return "; ".join(problem.message for problem in found.complaints)
    said: list[str] = []
    # Header and id apart: the packet's own id stands in its head.
    for before, part in pairwise(found.fields[1:]):
        if part.name == "data" and before.name == "id":
            said[-1] += f" {part.meaning}"
        elif part.name in ("id", "data", "count"):
            said.append(part.meaning)
    return "; ".join(said)
