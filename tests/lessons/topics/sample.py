"""Answers for the lessons of these tests, one for each kind of exercise."""

import numpy as np

from kinlab.dynamixel.codec.packets import Packet, encode
from kinlab.lessons.results import Goal, Holds, Reach, TipNear, limb_reach
from kinlab.robots import load_robot


def double(x: float) -> float:
    return 2 * x


def square(x: float) -> float:
    return float(x * x)


def corner(x: float, y: float) -> list[float]:
    return [x, -y, x + y]


def reach(x: float, y: float) -> Reach:
    return limb_reach(load_robot("xl430-hexapod").limb("R1"), (x, y, -46))


def write_goal(servo: int, goal: int, protocol: int = 1) -> bytes:
    if protocol == 2:
        return encode(Packet(2, servo, 3, (116).to_bytes(2, "little") + goal.to_bytes(4, "little")))
    return encode(Packet(1, servo, 3, bytes([30]) + goal.to_bytes(2, "little")))


def big_endian(servo: int, goal: int) -> bytes:
    return encode(Packet(1, servo, 3, bytes([30]) + goal.to_bytes(2, "big")))


def wave(pairs: int = 2) -> list[str]:
    return ["L2", "L1", "R2", "R1"] if pairs == 2 else ["L1+R2", "R1+L2"]


def stations() -> list[str]:
    return ["target", "angles", "ticks"]


def larger(x: float, y: float) -> str:
    return "first" if x > y else "second"


def broken_line(x: float) -> int:
    lines = [np.sin(x) ** 2 + np.cos(x) ** 2 - 1, np.sin(2 * x) - np.sin(x) * np.cos(x)]
    return 1 + int(np.argmax(np.abs(lines)))


def turn(goal: int) -> Goal:
    return Goal(
        "AX-12A:1",
        (Holds(1, "present_position", goal - 2, goal + 2),),
        (f"write 1 goal_position {goal}", "wait 2"),
    )


def hidden(goal: int) -> Goal:
    return Goal(
        "AX-12A:1",
        (Holds(1, "goal_position", goal, goal),),
        ("baud 57600", f"write 1 goal_position {goal}"),
        setup=("fault 1 baud 57600",),
    )


def arm(x: float) -> Goal:
    limb = load_robot("receptionist-arm").limb("right")
    target = (x, 210.0, -310.0)
    q = limb.ik(np.array(target) / 1000).q
    lines = [
        f"write {joint.servo.id} goal_position {int(joint.servo.command(angle))}"
        for joint, angle in zip(limb.joints, q, strict=True)
    ]
    return Goal("receptionist-arm", (TipNear("receptionist-arm", "right", target, 2.0),), (*lines, "wait 3"))


def fails() -> float:
    raise RuntimeError("this one always fails")


def positive(x: float) -> bool:
    return x > 0
