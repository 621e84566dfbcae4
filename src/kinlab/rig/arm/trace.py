"""The packets of one cycle of the loop, as a script that the packet sandbox reads."""

from kinlab.dynamixel.bus import packets
from kinlab.dynamixel.codec.stream import StreamParser
from kinlab.rig.arm.record import Record


def script(record: Record, cycle: int, robot: str) -> str:
    """The packets of cycle `cycle`, from 0, each to be taken apart by `kinlab packet`; times since the first of them.

    What was damaged on its way stands in a comment: the sandbox ends a script at a packet that is none.

    Args:
        robot: whose chain the sandbox is to have, so that it knows the registers' names.
    """
    start = record.began + record.t[cycle]
    heard = [p for p in packets(record.packets) if start < p.at <= start + record.busy[cycle] + 1e-9]
    lines = [f"chain {robot}"]
    for packet in heard:
        lines.append(f"# {(packet.at - heard[0].at) * 1e3:.3f} ms")
        whole = StreamParser(1).feed(packet.data) == [packet.data]
        verb = ("decode" if packet.sent else "decode status") if whole else "# damaged:"
        lines.append(f"{verb} {packet.data.hex(' ').upper()}")
    return "\n".join(lines) + "\n"
