"""The six-joint leg and walking on two: angles in degrees, lengths in mm, accelerations in m/s2."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinlab.gait.stability import GRAVITY
from kinlab.kinematics.humanoid_leg import humanoid_leg_ik
from kinlab.kinematics.transforms import Array, homogeneous
from kinlab.lessons.results import Reach, limb_reach
from kinlab.lessons.robots import find_gait, load_robot
from kinlab.robots import Limb

LEG = "right_leg"


def links(robot: str) -> dict[str, float]:
    """Thigh, shank and foot (the ankle's height), and the length and width of the sole, mm."""
    leg = _leg(robot)
    lengths = [float(np.linalg.norm(link)) * 1000 for link in leg.links]
    thigh, shank, foot = (round(length, 6) for length in lengths if length > 1e-9)
    sole = leg.sole or (0.0, 0.0)
    return {
        "thigh": thigh,
        "shank": shank,
        "foot": foot,
        "long": round(sole[0] * 1000, 6),
        "wide": round(sole[1] * 1000, 6),
    }


def needed(sole: str) -> str:
    """How many joints a leg needs for its sole: "three" for its place alone, "six" with its attitude."""
    return {"place": "three", "place and attitude": "six"}[sole]


def knee(robot: str, line: float) -> float:
    """The bend of the knee, 0 when straight, with the ankle `line` mm from the hip."""
    return float(np.degrees(_solve(robot, 0.0, line)[3]))


def knee_inside(robot: str, line: float) -> float:
    """As `knee`, the angle inside the triangle."""
    return 180 - knee(robot, line)


def half_knee(robot: str, line: float) -> float:
    """As `knee`, half of it."""
    return knee(robot, line) / 2


def level_ankle(hip: float, bend: float) -> float:
    """The ankle's pitch that keeps the sole level."""
    return -(hip + bend)


def level_ankle_without_hip(hip: float, bend: float) -> float:
    """As `level_ankle`, the hip forgotten."""
    return -bend


def level_ankle_turned_round(hip: float, bend: float) -> float:
    """As `level_ankle`, with the other sign."""
    return hip + bend


def step(robot: str, ahead: float, down: float) -> list[float]:
    """Hip pitch, knee and ankle pitch with the ankle `ahead` and `down` of the hip, the sole level."""
    return [float(v) for v in np.degrees(_solve(robot, ahead, down)[[2, 3, 4]])]


def step_as_if_below(robot: str, ahead: float, down: float) -> list[float]:
    """As `step`, the ankle taken to be right below the hip, as far away."""
    return step(robot, 0.0, float(np.hypot(ahead, down)))


def whole_leg(robot: str, ahead: float, aside: float, down: float) -> Reach:
    """The six angles with the ankle `ahead`, `aside` (to the left) and `down` of the hip, the sole level and ahead."""
    leg = _leg(robot)
    reach = limb_reach(leg, (ahead, aside, -down - links(robot)["foot"]))

    def tilt_deg(angles: Sequence[float]) -> float:
        turn = leg.fk(np.radians(angles))[:3, :3]
        return float(np.degrees(np.arccos(np.clip((np.trace(turn) - 1) / 2, -1.0, 1.0))))

    return replace(reach, tilt_deg=tilt_deg)


def whole_leg_in_the_plane(robot: str, ahead: float, aside: float, down: float) -> Reach:
    """As `whole_leg`, the way aside forgotten."""
    bent = step(robot, ahead, down)
    return _instead(whole_leg(robot, ahead, aside, down), [0.0, 0.0, *bent, 0.0])


def whole_leg_askew(robot: str, ahead: float, aside: float, down: float) -> Reach:
    """As `whole_leg`, the ankle not rolled back."""
    reach = whole_leg(robot, ahead, aside, down)
    return _instead(reach, [*reach.solution_deg[:5], 0.0])


def _instead(reach: Reach, angles: Sequence[float]) -> Reach:
    return replace(reach, solution_deg=tuple(float(v) for v in angles))


def zero_moment_point(high: float, place: float, acceleration: float) -> float:
    """Where the ground must push, ahead of the ankle: p = c - (z / g) c'', mm."""
    return place - high / GRAVITY * acceleration


def zero_moment_point_turned_round(high: float, place: float, acceleration: float) -> float:
    """As `zero_moment_point`, with the other sign."""
    return place + high / GRAVITY * acceleration


def falls(robot: str, high: float, place: float, acceleration: float) -> str:
    """What the robot on one sole does: "stands", "forwards" or "backwards"."""
    p, edge = zero_moment_point(high, place, acceleration), links(robot)["long"] / 2
    return "forwards" if p > edge else "backwards" if p < -edge else "stands"


def clear(robot: str, high: float, place: float, acceleration: float) -> bool:
    """Whether that is not decided by a few millimetres."""
    return abs(abs(zero_moment_point(high, place, acceleration)) - links(robot)["long"] / 2) > 6


def steps(robot: str) -> list[str]:
    """What happens in a cycle, in order, beginning anywhere."""
    found = []
    for event in find_gait(load_robot(robot)).events:
        found += [f"{leg}-lands" for leg in event.lands] + [f"{leg}-lifts" for leg in event.lifts]
    return found


def _solve(robot: str, ahead: float, down: float) -> Array:
    size = links(robot)
    place = np.array([ahead, 0.0, -down - size["foot"]]) / 1000
    pose = homogeneous(np.eye(3), place)
    return np.asarray(
        humanoid_leg_ik(pose, size["thigh"] / 1000, size["shank"] / 1000, size["foot"] / 1000)[0][0]
    )


def _leg(robot: str) -> Limb:
    return load_robot(robot).limb(LEG)
