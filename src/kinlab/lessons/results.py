"""What an answer function gives where a number, a list, bytes or a name does not say enough."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from kinlab.robots import Limb


@dataclass(frozen=True)
class Reach:
    """A place that a limb is to reach, and with which attitude; any angles that bring it there are right.

    Attributes:
        target_mm: the place.
        solution_deg: one right answer, as an example.
        tip_mm: where the tip lies for angles in degrees.
        lower_deg, upper_deg: limits of the joints; none where they are empty.
        tip: what it is, "foot", "hand" or "tip".
        limb: to be drawn; None where there is none.
        tilt_deg: how far angles turn the tip from the attitude that is asked for; None where the place alone counts.
    """

    target_mm: tuple[float, ...]
    solution_deg: tuple[float, ...]
    tip_mm: Callable[[Sequence[float]], tuple[float, ...]]
    lower_deg: tuple[float, ...] = ()
    upper_deg: tuple[float, ...] = ()
    tip: str = "foot"
    limb: "Limb | None" = None
    tilt_deg: Callable[[Sequence[float]], float] | None = None


def limb_reach(limb: "Limb", target_mm: Sequence[float]) -> Reach:
    """The task of bringing the tip of a robot's limb to a place of the limb frame, mm.

    Raises:
        ValueError: it cannot get there.
    """
    found = limb.ik(np.asarray(target_mm, float) / 1000)
    if not found.reachable:
        raise ValueError(f"{limb.name} does not reach {tuple(target_mm)} mm")
    lower, upper = np.degrees(limb.limits)
    return Reach(
        tuple(float(v) for v in target_mm),
        tuple(np.degrees(found.q).tolist()),
        lambda angles: tuple((limb.fk(np.radians(angles))[:3, 3] * 1000).tolist()),
        tuple(lower.tolist()),
        tuple(upper.tolist()),
        "foot" if limb.stance is not None else "hand",
        limb,
    )


@dataclass(frozen=True)
class Holds:
    """What a register of an emulated servo is to hold: a value, or one from `low` to `high`."""

    servo: int
    register: str
    low: int
    high: int


@dataclass(frozen=True)
class TipNear:
    """Where the tip of a robot's limb is to be, by the present positions of its servos.

    Attributes:
        robot, limb: whose; its servos are on the chain.
        target_mm: limb frame.
        within_mm: how near is near enough.
    """

    robot: str
    limb: str
    target_mm: tuple[float, float, float]
    within_mm: float


@dataclass(frozen=True)
class Goal:
    """A state that an emulated chain is to be brought into, by lines of the packet sandbox.

    Attributes:
        chain: as `kinlab packet --chain` takes it.
        setup: lines that are carried out beforehand, unseen; they may break things.
        wanted: all of it must be so in the end, after a second has passed.
        lines: one way to get there.
        protocol, baud: that the student begins with; None: those of the chain, and 1 Mbps.
        forbidden: verbs of the sandbox that would make it too easy, besides those that change a servo from behind.
        as_real: the chain is talked to as a real bus, of which nothing is known but what it answers.
    """

    chain: str
    wanted: tuple[Holds | TipNear, ...]
    lines: tuple[str, ...]
    setup: tuple[str, ...] = ()
    protocol: int | None = None
    baud: int = 1_000_000
    forbidden: tuple[str, ...] = ()
    as_real: bool = False


def _number(value: Any) -> bool:
    return isinstance(value, Real) and bool(np.isfinite(float(value)))


def _all(value: Any, each: Callable[[Any], bool]) -> bool:
    return isinstance(value, list | tuple | np.ndarray) and all(map(each, value))


# What an answer function gives, by the kind of exercise: in words, and whether a value is that.
GIVES: Mapping[str, tuple[str, Callable[[Any], bool]]] = {
    "number": ("a number", _number),
    "vector": ("a list of numbers", lambda value: _all(value, _number)),
    "joints": ("a Reach", lambda value: isinstance(value, Reach) or _all(value, _number)),
    "bytes": ("bytes", lambda value: isinstance(value, bytes | bytearray)),
    "order": ("a list of keys", lambda value: _all(value, lambda key: isinstance(key, str))),
    "choice": ("the key of an option", lambda value: isinstance(value, str)),
    "mistake": ("the number of a line", lambda value: isinstance(value, Integral)),
    "state": ("a Goal", lambda value: isinstance(value, Goal)),
}
