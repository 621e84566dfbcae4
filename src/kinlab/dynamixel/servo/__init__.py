"""The emulated servo: registers, firmware, motor."""

from kinlab.dynamixel.servo.ax import AxServo
from kinlab.dynamixel.servo.firmware import MOST_VOLTS, Servo, Supply
from kinlab.dynamixel.servo.x import XServo
from kinlab.dynamixel.tables import load_table
from kinlab.errors import UsageError

__all__ = ["MOST_VOLTS", "AxServo", "Servo", "Supply", "XServo", "build_servos"]


def build_servos(model: str, ids: list[int], baud: int, supply: Supply) -> list[Servo]:
    """The servos of one module, factory-fresh but for their ids and the bus speed.

    Args:
        ids: one for each axis of the module.
        baud: speed in bps; the nearest one that the model has is set.

    Raises:
        UsageError: no such model, or the wrong number of ids.
    """
    table = load_table(model)
    if len(ids) != table.axes:
        raise UsageError(
            f"{table.model} has {table.axes} axis/axes, so it takes {table.axes} id(s), got {ids}"
        )
    kind = AxServo if table.find("id").address == 3 else XServo
    axes: list[Servo] = [kind(table, servo, supply) for servo in ids]
    for axis in axes:
        axis.module = axes
        axis.set_baud(baud)
    return axes
