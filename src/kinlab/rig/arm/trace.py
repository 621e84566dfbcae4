"""The packets of one cycle of the loop, as a script that the packet sandbox reads."""

from kinlab.dynamixel.bus import packets
from kinlab.rig.arm.record import Record


def script(record: Record, cycle: int, robot: str) -> str:
    """The packets of cycle `cycle`, from 0, each to be taken apart by `kinlab packet`; times since the first of them.

    Args:
        robot: whose chain the sandbox is to have, so that it knows the registers' names.
    """
    start = record.began + record.t[cycle]
    heard = [p for p in packets(record.packets) if start < p.at <= start + record.busy[cycle] + 1e-9]
    lines = [f"chain {robot}"]
    for packet in heard:
        lines.append(f"# {(packet.at - heard[0].at) * 1e3:.3f} ms")
        lines.append(f"{'decode' if packet.sent else 'decode status'} {packet.data.hex(' ').upper()}")
    return "\n".join(lines) + "\n"
