"""Torque off, however a run ends."""

from collections.abc import Iterable
from contextlib import suppress

from kinlab.dynamixel import Bus, BusError, PortError

ROUNDS = 5  # in which a servo that does not confirm is told again


def torque_off(bus: Bus, servos: Iterable[int]) -> tuple[int, ...]:
    """Switch servos off, all in one packet, then each until its register says so; those that did not."""
    servos = tuple(servos)
    try:
        return _switch_off(bus, servos)
    except KeyboardInterrupt:
        # Whoever presses Ctrl-C twice wants it the more.
        return _switch_off(bus, servos)


def _switch_off(bus: Bus, servos: tuple[int, ...]) -> tuple[int, ...]:
    left = servos
    with suppress(PortError):
        bus.sync_write("torque_enable", dict.fromkeys(servos, 0))
        for _ in range(ROUNDS):
            left = tuple(servo for servo in left if not _is_off(bus, servo))
    return left


def _is_off(bus: Bus, servo: int) -> bool:
    with suppress(BusError):
        bus.write(servo, "torque_enable", 0)
        return bus.read(servo, "torque_enable") == 0
    return False
