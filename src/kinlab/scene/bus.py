"""Packets as a text log, each at the instant in which its last byte had passed."""

from collections.abc import Sequence
from functools import cache

import numpy as np

from kinlab.dynamixel.bus import Passage
from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.tables import load_table
from kinlab.robots import Robot
from kinlab.scene import colours
from kinlab.scene.recording import Recording, Times

BUS = "bus"


def log_packets(
    recording: Recording, robot: Robot, packets: Sequence[Passage], times: Times, path: str = BUS
) -> None:
    """Log what went over a robot's bus.

    Args:
        times: when, one for each packet.
    """
    if not packets:
        return
    tables = {servo.id: load_table(servo.model.name) for servo in robot.servos}

    # A walk says the same things again and again.
    @cache
    def told(data: bytes, request: Packet | None, sent: bool) -> tuple[str, bool, Packet | None]:
        found = dissect(data, status=None if sent else True, tables=tables.get, request=request)
        subject = found.instruction if sent else ", ".join(found.errors) or "answer"
        said = "; ".join(part.meaning for part in found.fields if part.name in ("address", "data", "error"))
        wrong = "; ".join(problem.message for problem in found.complaints)
        who = "all" if found.id == 254 else f"servo {found.id}"
        arrow = "->" if sent else "<-"
        text = f"{arrow} {subject} {who}: {wrong or said or 'no data'}   [{show_hex(data)}]"
        return text, found.ok, found.packet if sent else request

    request: Packet | None = None
    texts, levels, shades = [], [], []
    for packet in packets:
        text, ok, request = told(packet.data, None if packet.sent else request, packet.sent)
        texts.append(text)
        levels.append(("sent" if packet.sent else "heard") if ok else "damaged")
        shades.append((colours.SENT if packet.sent else colours.HEARD) if ok else colours.BROKEN)
    rr = recording.rr
    recording.over(path, times, rr.TextLog, text=texts, level=levels, color=np.array(shades, np.uint8))
