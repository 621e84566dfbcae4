"""What is asked of a walking robot, as a walk that its servos and legs allow, and the walk on the rig."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from kinlab.errors import UsageError
from kinlab.gait import Gait, Limits, Walk, assess, plan
from kinlab.names import resolve
from kinlab.rig.follow import Sample, follow
from kinlab.rig.path import path_of
from kinlab.rig.rig import Rig
from kinlab.robots import Robot
from kinlab.units import finite

# Ticks that a walk, or a sweep, may have: all of them are kept, and an hour at the usual rate is enough.
MOST_TICKS = 200_000
MOST_RUNS = 1000
# Below this the sum of I V dt is more than a twentieth off, as the load falls between two commands.
SLOWEST_RATE = 20.0
FASTEST_RATE = 1000.0


@dataclass(frozen=True)
class Order:
    """A walk as people ask for it.

    Attributes:
        speed: forwards, m/s.
        turn: to the left, rad/s.
        distance: of the body's way, m; a robot that only turns goes once round.
        rate: commands and readings per second.
    """

    robot: Robot
    gait: Gait
    speed: float
    turn: float
    distance: float
    rate: float

    @property
    def way(self) -> float:
        """What is to be covered: m, or rad where the robot only turns."""
        return self.distance if self.speed else 2 * np.pi


@dataclass(frozen=True, eq=False)
class Errand:
    """An order that can be carried out.

    Attributes:
        order: what was asked.
        walk: from standing and back to it.
        limits: how near it comes to what the servos can do.
    """

    order: Order
    walk: Walk
    limits: Limits


def prepare(order: Order) -> Errand:
    """The walk that an order asks for.

    Raises:
        UsageError: numbers that make no walk.
        KinlabError: beyond the legs or the servos; the joint at its limit and the fastest possible
            speed are named.
    """
    for name, value, unit in (("distance", order.distance * 1000, "mm"), ("rate", order.rate, "Hz")):
        finite(value, f"a walk's {name}")
        if value <= 0:
            raise UsageError(f"a walk's {name} must be above 0, got {value:g} {unit}")
    if order.rate < SLOWEST_RATE:
        raise UsageError(
            f"expected at least {SLOWEST_RATE:g} commands a second, got {order.rate:g}: power is read once a command, "
            "at its peak, and with fewer of them their sum is no energy"
        )
    if order.rate > FASTEST_RATE:
        raise UsageError(f"no bus takes more than {FASTEST_RATE:g} commands a second, got {order.rate:g}")
    forever = plan(order.robot, order.gait, forward=order.speed, turn=order.turn)
    if not order.speed and not order.turn:
        raise UsageError("a walk needs a speed or a turn")
    walk = forever.over(order.way)
    _check_length([walk.duration], order.rate)
    return Errand(order, walk, assess(forever))


def walk_on(rig: Rig, errand: Errand, tempo: Callable[[], float] = lambda: 1.0) -> Iterator[Sample]:
    """Take up the first pose, walk, and stand; tick by tick, see `follow`.

    Raises:
        KinlabError: a servo does not answer at the start, or cannot turn that far.
        PortError: the port is gone.
    """
    path = path_of(errand.walk, rig.wiring, errand.order.rate)
    rig.hold()
    rig.approach(path.q[0])
    yield from follow(rig, path, errand.order.rate, tempo)


class Throttle:
    """How fast a walk goes, while it is walked: never faster than its servos can without load.

    Attributes:
        tempo: 1 for the order's own speed.
        stopped: whether to stop at once.
    """

    STEP = 0.05

    def __init__(self, errand: Errand) -> None:
        self.tempo = 1.0
        self.stopped = False
        self._highest = 1 / errand.limits.used if errand.limits.used else 1.0

    def change(self, steps: int) -> None:
        """Go faster, or slower, by steps of a twentieth of the order's speed."""
        self.tempo = min(max(0.0, self.tempo + steps * self.STEP), self._highest)


# What a sweep may set of an order: a name, and how much one of its unit for people is.
QUANTITIES = {"speed": 1e-3, "turn": np.pi / 180, "distance": 1e-3, "rate": 1.0}


def span(text: str) -> list[float]:
    """The numbers of "10:40:3" (first, last, step), of "10:40" (step 1), or of "10,20,40".

    Raises:
        UsageError: no such list, or one that is endless.

    >>> span("10:16:3")
    [10.0, 13.0, 16.0]
    """
    parts = re.split(r"[:,]", text)
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        raise UsageError(f"'{text}' is no range; write first:last:step, as in 10:40:3, or 10,20,40") from None
    finite(numbers, "a range")
    if ":" not in text:
        return numbers
    if "," in text or len(numbers) > 3:
        raise UsageError(f"'{text}' is no range; write first:last:step, as in 10:40:3")
    first, last, step = numbers if len(numbers) == 3 else (*numbers, 1.0)
    if step == 0 or (last - first) / step < 0:
        raise UsageError(f"'{text}' never comes from {first:g} to {last:g}")
    # A last number that rounding puts beside the grid still belongs to it.
    count = np.floor((last - first) / step + 1e-9) + 1
    if count > MOST_RUNS:
        raise UsageError(f"'{text}' would be {count:.0f} walks; at most {MOST_RUNS}")
    return [first + i * step for i in range(int(count))]


def sweep(order: Order, name: str, values: list[float]) -> list[Errand]:
    """One errand for each value of a quantity, in its unit for people; all are checked before any is walked.

    Raises:
        UsageError, KinlabError: as `prepare`.
    """
    name = resolve(name, QUANTITIES, "quantity to sweep")
    changes: list[dict[str, Any]] = [{name: value * QUANTITIES[name]} for value in values]
    errands = [prepare(replace(order, **change)) for change in changes]
    _check_length([errand.walk.duration for errand in errands], max(errand.order.rate for errand in errands))
    return errands


def _check_length(durations: list[float], rate: float) -> None:
    whole = sum(durations)
    if whole * rate > MOST_TICKS:
        raise UsageError(
            f"this would take {whole / 3600:.1f} h of walking; with {rate:g} commands a second at most "
            f"{MOST_TICKS / rate / 3600:.1f} h are kept"
        )


def check_steady(errand: Errand) -> None:
    """Refuse a walk too short to tell what a metre costs.

    Raises:
        UsageError: it has no whole cycle at full speed.
    """
    order, stride = errand.order, errand.walk.stride
    if not order.speed or order.distance < 2 * stride:
        raise UsageError(
            f"a comparison needs a whole cycle at full speed: at least {2000 * stride:.0f} mm at this stride, "
            f"got {order.distance * 1000:g} mm"
        )
