"""What legs and servos allow: feet within reach, joints slower than their servos without load."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from kinlab.errors import KinlabError
from kinlab.gait.motion import Motion
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array
from kinlab.robots.target import solve_target

# Instants of a cycle that are looked at, beside its events.
SAMPLES = 360
# Of a second: the step for rates of joint angles, as a share of the cycle.
TICK = 1e-6
# A walk this much slower that is still not possible is possible at no speed.
SMALLEST = 1e-9


@dataclass(frozen=True, eq=False)
class Limits:
    """How near a walk comes to what its servos can do.

    Attributes:
        walk: whose.
        speeds: the highest speed of each joint (L, n), rad/s.
        allowed: what its servo does without load (L, n), rad/s; infinite where no servo is known.
    """

    walk: Walk
    speeds: Array
    allowed: Array

    @property
    def used(self) -> float:
        """The largest share of its servo's speed that a joint needs."""
        return float((self.speeds / self.allowed).max())

    @property
    def tightest(self) -> tuple[str, str]:
        """The leg and the joint that need it; where no servo is known, the fastest joint."""
        share = self.speeds / self.allowed if self.used else self.speeds
        leg, joint = np.unravel_index(int(np.argmax(share)), share.shape)
        limb = self.walk.robot.legs[leg]
        return limb.name, limb.joint_names[joint]

    @property
    def speed(self) -> float:
        """Of that joint, rad/s."""
        leg, joint = self.tightest
        row = [limb.name for limb in self.walk.robot.legs].index(leg)
        return float(self.speeds[row, self.walk.robot.limbs[leg].joint_names.index(joint)])

    @property
    def model(self) -> str | None:
        """The servo there."""
        leg, joint = self.tightest
        servo = self.walk.robot.limbs[leg].joints[self.walk.robot.limbs[leg].joint_names.index(joint)].servo
        return servo.model.name if servo else None

    @property
    def fastest(self) -> float | None:
        """The highest speed of the body at this stride, m/s; None where no servo is known, or the body goes nowhere.

        The path of each joint stays the same, only quicker.
        """
        return self.walk.speed / self.used if self.used and self.walk.speed else None


def assess(walk: Walk, *, keep_period: bool = False) -> Limits:
    """How near `walk` comes to the limits of its robot.

    Args:
        walk: one that goes on for ever.
        keep_period: whether a slower walk is one of shorter strides; else one of longer cycles.

    Raises:
        KinlabError: a foot is out of reach (its leg, phase and time are named), or a joint would have
            to turn faster than its servo can; the fastest possible speed is named.
    """
    times = _instants(walk)
    motion = walk.at(times)
    if not motion.reachable.all():
        raise KinlabError(f"{_missed(motion)}; {_instead(walk, keep_period=True)}")
    limits = Limits(walk, np.abs(joint_rates(walk, times)).max(axis=0), _allowed(walk))
    if limits.used > 1:
        leg, joint = limits.tightest
        i, j = np.unravel_index(int(np.argmax(limits.speeds / limits.allowed)), limits.speeds.shape)
        raise KinlabError(
            f"the {joint} of {leg} would turn at {np.degrees(limits.speeds[i, j]):.0f} deg/s, and its {limits.model} "
            f"does {np.degrees(limits.allowed[i, j]):.0f} deg/s without load; {_instead(walk, keep_period)}"
        )
    return limits


def _instants(walk: Walk) -> Array:
    """Times of one cycle, s, between the events, where every rate exists."""
    edges = np.array([float(event.at) for event in walk.gait.events])
    even = (np.arange(SAMPLES) + 0.5) / SAMPLES
    near = np.concatenate([edges + 10 * TICK, edges - 10 * TICK])
    return np.sort(np.concatenate([even, near]) % 1) * walk.period


def joint_rates(walk: Walk, times: Array) -> Array:
    """How fast the joints turn (..., L, n), rad/s, at times (...) in s that are no events of the gait."""
    h = TICK * walk.period
    return np.asarray((walk.at(times + h).q - walk.at(times - h).q) / (2 * h))


def _allowed(walk: Walk) -> Array:
    return np.array(
        [
            [joint.servo.model.speed if joint.servo else np.inf for joint in leg.joints]
            for leg in walk.robot.legs
        ]
    )


def _missed(motion: Motion) -> str:
    """The first foot out of reach: leg, phase, time and why."""
    walk = motion.walk
    frame, leg = np.argwhere(~motion.reachable)[0]
    limb = walk.robot.legs[leg]
    found = solve_target(walk.robot, limb, motion.feet[frame, leg], frame="body")
    # Of several ways to get there the first is the one that the leg walks with.
    reason = ", ".join(found.poses[0].beyond) if found.poses else found.reason
    at = float(walk.phase(motion.t[frame]) % 1)
    where = "swing" if motion.swing[frame, leg] else "stance"
    return f"{limb.name} cannot follow at phase {at:.3f} ({motion.t[frame]:.3f} s, {where}): {reason}"


def _instead(walk: Walk, keep_period: bool) -> str:
    """The fastest walk of this kind that is possible, in words."""
    stands = not (walk.speed or walk.turn)
    keep_period &= not stands

    def possible(share: float) -> bool:
        slower = _slower(walk, share, keep_period)
        times = _instants(slower)
        if not slower.at(times).reachable.all():
            return False
        return bool((np.abs(joint_rates(slower, times)) <= _allowed(slower)).all())

    share = _largest(possible)
    kept = f"a period of {walk.period:.3g} s" if keep_period else f"a stride of {walk.stride * 1000:.4g} mm"
    if share == 0:
        return f"no speed is possible with {kept}"
    if stands:
        return f"the shortest possible period is {np.ceil(walk.period / share * 100) / 100:g} s"
    if walk.speed and walk.turn:
        slower = _slower(walk, share, keep_period)
        turn = np.degrees(abs(slower.turn))
        return f"the fastest possible with {kept} is {slower.speed * 1000:.4g} mm/s while turning {turn:.4g} deg/s"
    if walk.speed:
        return f"the fastest possible speed with {kept} is {share * walk.speed * 1000:.4g} mm/s"
    fastest = np.degrees(share * abs(walk.turn))
    return f"the fastest possible turn with {kept if keep_period else 'this stride'} is {fastest:.4g} deg/s"


def _slower(walk: Walk, share: float, keep_period: bool) -> Walk:
    vx, vy = walk.velocity
    period = walk.period if keep_period else walk.period / share
    return replace(walk, velocity=(vx * share, vy * share), turn=walk.turn * share, period=period)


def _largest(possible: Callable[[float], bool]) -> float:
    """The largest share of 1 that is possible, to a millionth of itself; 0 where none is."""
    low, high = SMALLEST, 1.0
    if not possible(low):
        return 0.0
    while high > low * (1 + 1e-6):
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if possible(middle) else (low, middle)
    return low
