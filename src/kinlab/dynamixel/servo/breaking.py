"""Faults of a single servo, on purpose."""

from kinlab.dynamixel.servo.firmware import Servo
from kinlab.dynamixel.servo.motor import GearMotor
from kinlab.errors import UsageError
from kinlab.names import resolve


def break_servo(servo: Servo, fault: str) -> str:
    """Break a servo, or mend it; what was done, in words.

    Args:
        fault: an alarm that its Shutdown register knows ("overload"), "stuck" (the horn cannot turn), "dead"
            (it neither hears nor answers), "baud 57600" (it is set to another speed), or "off" (mend it).

    Raises:
        UsageError: no such fault; the nearest names are given.
    """
    kind, _, rest = fault.partition(" ")
    alarms = {name.replace(" ", "_"): name for _, name in servo.table.by_name["shutdown"].values}
    kind = resolve(kind, [*alarms, "stuck", "dead", "off", "baud"], "fault")
    match kind:
        case "off":
            servo.forced.clear()
            servo.dead = motor_of(servo).held = False
        case "dead":
            servo.dead = True
        case "stuck":
            motor_of(servo).held = True
        case "baud":
            if not rest.isdecimal() or int(rest) == 0:
                raise UsageError(f"'{rest}' is no speed; write baud 57600")
            servo.set_baud(int(rest))
            return f"set to {servo.baud} bps"
        case _:
            servo.forced.add(alarms[kind])
    return kind


def motor_of(servo: Servo) -> GearMotor:
    """The servo's motor.

    Raises:
        UsageError: something else has taken its place.
    """
    if not isinstance(servo.plant, GearMotor):
        raise UsageError(f"the plant of servo {servo.id} takes no force from here")
    return servo.plant
