"""How a foot flies: places in mm, times in s, speeds in mm/s; s is the progress of the swing, from 0 to 1."""

from functools import cache

import numpy as np

from kinlab.gait import Walk, find_curve, plan
from kinlab.gait.swing import CURVES
from kinlab.lessons.robots import find_gait, load_robot
from kinlab.papers.footsteps import krsri_printed

CURVE = "line-sine"


def point(stroke: float, lift: float, s: float) -> list[float]:
    """Way and height of the foot: krsri-hexapod, (24) and (26) corrected."""
    curve, at = CURVES[CURVE], np.array([s])
    return [stroke * float(curve.along.value(at)[0]), lift * float(curve.height.value(at)[0])]


def point_in_degrees(stroke: float, lift: float, s: float) -> list[float]:
    """As `point`, on a calculator that takes pi s for degrees."""
    return [stroke * s, lift * float(np.sin(np.radians(np.pi * s)))]


def point_on_a_triangle(stroke: float, lift: float, s: float) -> list[float]:
    """As `point`, up and down in straight lines."""
    return [stroke * s, lift * (1 - abs(2 * s - 1))]


def early_height(lift: float, s: float) -> str:
    """Whether the foot is below, near or above half of its lift: "less", "half" or "more"."""
    share = point(0.0, lift, s)[1] / lift
    return "half" if abs(share - 0.5) < 0.04 else "less" if share < 0.5 else "more"


def misprint(equations: list[str], stroke: float, lift: float) -> int:
    """Which of krsri-hexapod's `equations`, letter for letter, leaves the corrected way farthest behind.

    (24) and (26) are compared with what they must mean; (25) is (24) to the side, (27) a time.
    """
    s = np.linspace(0.0, 1.0, 9)
    curve = CURVES[CURVE]
    printed = krsri_printed(s, stroke, lift)
    off = {
        "24": np.abs(printed[:, 0] - stroke * curve.along.value(s)).max(),
        "26": np.abs(printed[:, 1] - lift * curve.height.value(s)).max(),
    }
    return equations.index(max(equations, key=lambda number: off.get(number, 0.0))) + 1


def usual(robot: str, gait: str) -> dict[str, float]:
    """KinLab's usual walk of a robot: stroke, lift, speed, times, and how fast a foot comes down with line and sine."""
    walk = _walk(robot, gait)
    lift = walk.lift * 1000
    return {
        "stroke": walk.stroke * 1000, "lift": lift, "speed": walk.speed * 1000, "duty": walk.duty,
        "period": walk.period, "swing": walk.swing_time, "knock": knock(lift, walk.swing_time),
    }  # fmt: skip


def stance_time(stroke: float, speed: float) -> float:
    """How long a foot stands."""
    return stroke / speed


def period(stroke: float, speed: float, duty: float) -> float:
    """How long a cycle takes."""
    return stance_time(stroke, speed) / duty


def swing_time(stroke: float, speed: float, duty: float) -> float:
    """How long a foot is in the air."""
    return period(stroke, speed, duty) * (1 - duty)


def swing_time_by_stroke(stroke: float, speed: float, duty: float) -> float:
    """As `swing_time`, as if the foot flew at the speed of the body."""
    return stroke / speed * (1 - duty)


def knock(lift: float, time: float, curve: str = CURVE) -> float:
    """How fast a foot comes down."""
    rate = float(find_curve(curve).height.rate(np.array([1.0]))[0])
    return -lift * rate / time


def knock_without_pi(lift: float, time: float) -> float:
    """As `knock`, pi forgotten."""
    return lift / time


def knock_on_a_triangle(lift: float, time: float) -> float:
    """As `knock`, straight down from the middle of the swing."""
    return 2 * lift / time


def slide(stroke: float, speed: float, duty: float, curve: str) -> float:
    """How fast a foot slides over the ground at touch-down, forwards."""
    shape = find_curve(curve)
    rate, time = float(shape.along.rate(np.array([1.0]))[0]), swing_time(stroke, speed, duty)
    if shape.over == "ground":
        return (stroke + speed * time) * rate / time
    return stroke * rate / time + speed


def slide_key(stroke: float, speed: float, duty: float, curve: str) -> str:
    """The same as the key of an option: "rest", "along" with the body, or "twice" as fast."""
    share = slide(stroke, speed, duty, curve) / speed
    return "rest" if share < 0.1 else "along" if share < 1.5 else "twice"


@cache
def _walk(robot: str, gait: str) -> Walk:
    one = load_robot(robot)
    return plan(one, find_gait(one, gait))
