"""What the chain is exposed to, in a few words."""

from collections.abc import Callable

from kinlab.dynamixel.sandbox import Session
from kinlab.dynamixel.sandbox.inspection import faults
from kinlab.dynamixel.sandbox.wire import speed


def conditions(session: Session, servo: int, say: Callable[..., str], *, held: bool) -> list[str]:
    """What is out of the ordinary comes first: time that stands still, faults; then supply and speed.

    Args:
        servo: whose faults count.
        say: gives a text of the station's words.
        held: whether time stands still.
    """
    wrong = [
        f"{say(f'short.{fault.name}')} {fault.detail}".strip()
        for fault in faults(session, servo)
        if fault.on and fault.name != "power"
    ]
    return [
        *([say("held")] if held else []),
        *(wrong or [say("clean")]),
        f"{session.emulated.supply.volts:g} V",
        speed(session.port.baud),
    ]
