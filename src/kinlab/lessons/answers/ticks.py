"""From a joint's angle to a servo's ticks, and what rounding costs. Angles in degrees, places in millimetres."""

import numpy as np

from kinlab.lessons.results import Goal, TipNear, limb_reach
from kinlab.lessons.robots import load_robot
from kinlab.papers.tables import printed_table
from kinlab.robots import Limb
from kinlab.robots.servo import Servo
from kinlab.robots.target import read_servos

# What a reader can picture, mm: up to the first a hair, up to the second the thickness of a coin.
HAIR, COIN = 0.3, 4.0
# How near a foot on the bench is to come, mm.
NEAR_MM = 2.0


def arc(robot: str, limb: str, joint: str, length: float) -> float:
    """How far the end of a leg of that length moves when the joint's servo makes one step, mm."""
    return length * float(np.radians(_servo(robot, limb, joint).model.deg_per_step))


def picture(robot: str, limb: str, joint: str, length: float) -> str:
    """The same as something to picture: "hair", "coin" or "finger"."""
    mm = arc(robot, limb, joint, length)
    return "hair" if mm < HAIR else "coin" if mm < COIN else "finger"


def servo_angle(robot: str, limb: str, joint: str, angle: float) -> float:
    """The servo's angle for a joint's."""
    return float(_servo(robot, limb, joint).degrees(np.radians(angle)))


def servo_angle_unmirrored(robot: str, limb: str, joint: str, angle: float) -> float:
    """As `servo_angle`, the sign of the mounting turned round."""
    servo = _servo(robot, limb, joint)
    return servo.zero_deg - servo.sign * angle


def tick(robot: str, limb: str, joint: str, angle: float) -> int:
    """The command for a joint's angle."""
    return int(_servo(robot, limb, joint).command(np.radians(angle)))


def tick_of_joint(robot: str, limb: str, joint: str, angle: float) -> float:
    """As `tick`, the mounting forgotten."""
    return angle / _servo(robot, limb, joint).model.deg_per_step


def tick_by_1023(robot: str, limb: str, joint: str, angle: float) -> int:
    """As `tick`, with the largest tick in the place of their number."""
    servo = _servo(robot, limb, joint)
    steps = round(servo.model.range_deg[1] / servo.model.deg_per_step)
    return round(servo_angle(robot, limb, joint, angle) * steps / ((steps + 1) * servo.model.deg_per_step))


def differs_by_1023(robot: str, limb: str, joint: str, angle: float) -> bool:
    """Whether dividing by 1023 gives another tick."""
    return tick(robot, limb, joint, angle) != tick_by_1023(robot, limb, joint, angle)


def steps(robot: str) -> dict[str, float]:
    """How far the foot moves from its stance, mm, when one servo makes one step; by joint."""
    leg = load_robot(robot).limb()
    assert leg.stance is not None
    J = leg.jacobian(leg.ik(leg.stance).q)[:3] * 1000
    return {
        name: float(np.linalg.norm(J[:, i]) * np.radians(_servo_of(leg, i).model.deg_per_step))
        for i, name in enumerate(leg.joint_names)
    }


def rounded(robot: str, alpha: float, beta: float, gamma: float) -> float:
    """How far the foot is from where it should be when each servo takes its nearest tick, mm."""
    leg = load_robot(robot).limb()
    q = np.radians([alpha, beta, gamma])
    tip = read_servos(leg, q)[1]
    assert tip is not None
    return float(np.linalg.norm(tip - leg.fk(q)[:3, 3])) * 1000


def rounds_much(robot: str, alpha: float, beta: float, gamma: float) -> bool:
    """Whether rounding moves the foot far enough to be found with a calculator."""
    return rounded(robot, alpha, beta, gamma) > 0.2


def joint_ticks(robot: str, alpha: float, beta: float, gamma: float) -> list[int]:
    """The three commands of a leg."""
    readings = read_servos(load_robot(robot).limb(), np.radians([alpha, beta, gamma]))[0]
    return [reading.command for reading in readings.values() if reading.command is not None]


def mounting(robot: str, limb: str, joint: str) -> dict[str, float]:
    """How a joint's servo is mounted: its zero, its sign, its step."""
    servo = _servo(robot, limb, joint)
    return {"zero": servo.zero_deg, "sign": servo.sign, "step": servo.model.deg_per_step}


def zeros(robot: str) -> list[float]:
    """The zeros of the servos of a robot's first leg, from the body to the foot."""
    return [joint.servo.zero_deg for joint in load_robot(robot).limb().joints if joint.servo]


def servos(robot: str, limb: str) -> dict[str, list[float]]:
    """The servos of a leg from the body to the foot: ids, zeros, signs."""
    leg = load_robot(robot).limb(limb)
    found = [_servo_of(leg, i) for i in range(len(leg.joints))]
    return {
        "ids": [servo.id for servo in found],
        "zeros": [servo.zero_deg for servo in found],
        "signs": [servo.sign for servo in found],
    }


def stand_at(robot: str, limb: str, x: float, y: float, z: float) -> Goal:
    """Bring the foot to a place of the limb frame with three goals, in ticks."""
    leg = load_robot(robot).limb(limb)
    q = limb_reach(leg, (x, y, z)).solution_deg
    found = [_servo_of(leg, i) for i in range(len(leg.joints))]
    goals = [int(servo.command(np.radians(angle))) for servo, angle in zip(found, q, strict=True)]
    return Goal(
        f"{found[0].model.name}:{','.join(str(servo.id) for servo in found)}",
        (TipNear(robot, limb, (x, y, z), NEAR_MM),),
        (*(f"write {s.id} goal_position {goal}" for s, goal in zip(found, goals, strict=True)), "wait 2"),
    )


def measured() -> dict[str, float]:
    """The average errors of xl430-hexapod's Table 4, mm, by axis, as its rows give them."""
    printed = printed_table("xl430-hexapod", "4")
    return {axis: float(printed.column(axis).mean()) for axis in "xyz"}


def worst(robot: str) -> float:
    """The farthest that rounding can put the foot from its stance, mm: half a step of every joint at once."""
    return float(sum(steps(robot).values())) / 2


def larger(robot: str) -> str:
    """Whether the servos' resolution or the mechanics make the larger part of what was measured."""
    return "mechanics" if worst(robot) < measured()["x"] else "resolution"


def _servo(robot: str, limb: str, joint: str) -> Servo:
    leg = load_robot(robot).limb(limb)
    return _servo_of(leg, leg.joint_names.index(joint))


def _servo_of(leg: Limb, i: int) -> Servo:
    servo = leg.joints[i].servo
    assert servo is not None
    return servo
