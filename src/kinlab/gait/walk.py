"""Walking: a gait, a command and a robot as feet and joint angles at any times.

The body follows its command exactly, along an arc where it turns. Each foothold is the place of the
standing foot under the body at the middle of its stance; between lift-off and touch-down the foot
goes from one foothold to the next. Nothing is integrated, so that any time can be asked for.

Level frame: on the ground below the standing body, x along its heading, carried along by the walk.
Ground frame: the level frame at time 0.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import UsageError
from kinlab.gait.motion import Motion
from kinlab.gait.pace import Pace, fade
from kinlab.gait.schedule import Gait
from kinlab.gait.swing import Curve
from kinlab.kinematics.transforms import Array, rotation, rpy_to_rotation
from kinlab.robots import Robot
from kinlab.robots.body import legs_ik

# A time this share of a cycle before an event counts as that event.
EVENT_SLACK = 1e-9
# Numbers of the footholds on which a walk begins and ends.
FIRST, LAST = -1.0, 1e9


@dataclass(frozen=True, eq=False)
class Walk:
    """A walk. Without a pace it goes on for ever, each cycle like the last.

    Attributes:
        robot, gait: who walks, and how.
        velocity: forwards and sideways (x, y), m/s, in the level frame.
        turn: to the left, rad/s.
        period: of one cycle, s.
        lift: of a foot in the middle of its swing, m.
        curve: a foot's way through the air.
        height: of the body above its standing height, m.
        rpy: attitude of the body, rad.
        sway: of the body towards the standing foot, m, for robots of two legs.
        heel: pitch of a swinging sole per height above the ground, rad/m: toe down first, then up.
        pace: from standing and back to it; None for ever on.
    """

    robot: Robot
    gait: Gait
    velocity: tuple[float, float]
    turn: float
    period: float
    lift: float
    curve: Curve
    height: float = 0.0
    rpy: tuple[float, float, float] = (0.0, 0.0, 0.0)
    sway: float = 0.0
    heel: float = 0.0
    pace: Pace | None = None

    def __repr__(self) -> str:
        return f"<Walk of {self.robot.name}, {self.gait.name}: {self.speed * 1000:.4g} mm/s>"

    @property
    def speed(self) -> float:
        """Of the body, m/s."""
        return float(np.hypot(*self.velocity))

    @cached_property
    def duty(self) -> float:
        """The duty factor."""
        return float(self.gait.duty)

    @property
    def stride(self) -> float:
        """The body's way in one cycle, m."""
        return self.speed * self.period

    @property
    def stroke(self) -> float:
        """A foot's way in the body's frame during its stance, m, on a straight walk."""
        return self.stride * self.duty

    @property
    def swing_time(self) -> float:
        """How long a foot is in the air, s."""
        return (1 - self.duty) * self.period

    @cached_property
    def neutral(self) -> Array:
        """Where the feet stand (L, 3), level frame, metres."""
        feet = self.robot.standing_feet
        return np.asarray(feet - [0.0, 0.0, feet[:, 2].min()])

    @cached_property
    def lags(self) -> Array:
        """The touch-down phases of the robot's legs (L,)."""
        return self.gait.lags(leg.name for leg in self.robot.legs)

    @cached_property
    def attitude(self) -> Array:
        """Of the body in the level frame (3, 3)."""
        return rpy_to_rotation(self.rpy)

    @property
    def duration(self) -> float:
        """How long until all feet stand as at the start, s; endless walks have no end.

        Infinite without a pace.
        """
        return self.pace.end + (2 if self.sway else 1) * self.period if self.pace else np.inf

    def over(self, distance: float) -> "Walk":
        """The same walk over `distance` metres of the body's way (rad, where it only turns), from standing and to it.

        A robot of two legs sways for one cycle before its first step, and for one after its last.

        Raises:
            UsageError: a distance that is not a number from 0 up.
        """
        if not 0 <= distance < np.inf:
            raise UsageError(f"a walk's distance must be 0 or more, got {distance:g}")
        pace = distance / (self.speed or abs(self.turn) or 1 / self.period)
        begin = self.period if self.sway else 0.0
        return replace(self, pace=Pace(begin, self.period, pace))

    def phase(self, t: ArrayLike) -> Array:
        """Cycles since the first began, at times `t` (...)."""
        begin = self.pace.begin if self.pace else 0.0
        return (np.asarray(t, float) - begin) / self.period

    def sway_at(self, t: ArrayLike) -> Array:
        """The body's place to the left at times `t` (...), m.

        eros-humanoid, (38) and (39) joined: at a duty factor of 1/2 the quarter circles of both legs make
        one sine; for longer stances the sine is kept, which a body can follow.
        """
        t = np.asarray(t, float)
        if not self.sway:
            return np.zeros(t.shape)
        right = int(np.argmin(self.neutral[:, 1]))
        angle = 2 * np.pi * (self.phase(t) - self.lags[right] + (1 - self.duty) / 2)
        full = fade(t, self.period, self.duration) if self.pace else 1.0
        return np.asarray(self.sway * full * np.cos(angle))

    def travel(self, t: ArrayLike) -> Array:
        """How far the walk has come at times `t` (...), in s at full command."""
        return self.pace.travel(t) if self.pace else np.asarray(t, float)

    def carried(self, travel: Array, points: Array) -> Array:
        """Points (..., 3) that the walk has carried along for `travel` (...) seconds, in the frame they started in."""
        vx, vy = self.velocity
        out = np.empty(np.broadcast_shapes((*travel.shape, 3), points.shape))
        if self.turn == 0.0:
            np.multiply(travel, vx, out=out[..., 0])
            np.multiply(travel, vy, out=out[..., 1])
            out[..., :2] += points[..., :2]
        else:
            # A chord of the arc: as long as the way times sinc of half the angle, turned by half the angle.
            half = self.turn / 2 * travel
            c, s = np.cos(half), np.sin(half)
            chord = travel * np.sinc(half / np.pi)
            cc, ss = c * c - s * s, 2 * c * s
            x, y = points[..., 0], points[..., 1]
            out[..., 0] = cc * x - ss * y + chord * (c * vx - s * vy)
            out[..., 1] = ss * x + cc * y + chord * (s * vx + c * vy)
        out[..., 2] = points[..., 2]
        return out

    def at(self, t: ArrayLike) -> Motion:
        """Feet and joint angles at times `t` (...), s."""
        t = np.asarray(t, float)
        step = _steps(self, t)
        level = self.carried(step.before, self.neutral)
        level[step.swing] = _airborne(self, step, level)
        place = np.zeros((*t.shape, 3))
        place[..., 1] = self.sway_at(t)
        place[..., 2] = self.height - self.robot.standing_feet[:, 2].min()
        feet = level - place[..., None, :]
        if any(self.rpy):
            feet = (feet.reshape(-1, 3) @ self.attitude).reshape(feet.shape)
        soles = _soles(self, step) if len(self.robot.legs[0].joints) >= 6 else None
        pose = legs_ik(self.robot, feet, self.attitude, soles)
        return Motion(self, t, step.swing, step.hold, level, place, feet, pose.q, pose.reachable, soles)


@dataclass(frozen=True)
class _Steps:
    """Where each leg is in its cycle, (..., L): travel from now to its foothold and to the next one."""

    swing: Array
    hold: Array
    progress: Array
    before: Array
    after: Array
    lifted: Array | float
    landed: Array | float


def _steps(walk: Walk, t: Array) -> _Steps:
    """Which foothold each leg has, how far its swing is, and what travel separates it from both footholds."""
    duty, period = walk.duty, walk.period
    cycles = walk.phase(t)[..., None] - walk.lags
    count = np.floor(cycles + EVENT_SLACK)
    into = cycles - count
    swing = into >= duty - EVENT_SLACK
    progress = np.clip((into[swing] - duty) / (1 - duty), 0.0, 1.0)
    if walk.pace is None:
        before = (duty / 2 - into) * period
        half = duty * period / 2
        return _Steps(swing, count, progress, before, before + period, -half, half)
    pace = walk.pace
    landed = pace.begin + (count + walk.lags) * period
    hold, following = _hold(walk, landed), _hold(walk, landed + period)
    # A leg that stands where it would step to stays down.
    moves = following > hold
    progress = progress[moves[swing]]
    # However many steps are not taken, the first foothold and the last are one each.
    number = np.where(hold == 0.0, FIRST, np.where(hold == pace.travel(pace.end), LAST, count))
    swing = swing & moves
    now = pace.travel(t)[..., None]
    lifted = hold - pace.travel(landed + duty * period)
    return _Steps(
        swing, number, progress, hold - now, following - now, lifted, following - pace.travel(landed + period)
    )


def _hold(walk: Walk, landed: Array) -> Array:
    """The travel at which the body is right over the foothold of a stance that begins at `landed`, s."""
    pace = walk.pace
    assert pace is not None
    middle = pace.travel(landed + walk.duty * walk.period / 2)
    # Nobody is in the air at the beginning: a step that should have begun earlier is not taken.
    stepped = landed - walk.swing_time >= pace.begin - EVENT_SLACK * walk.period
    return np.where(stepped, middle, 0.0)


def _airborne(walk: Walk, step: _Steps, stood: Array) -> Array:
    """Places (k, 3) of the swinging feet, level frame; had they stayed down, they would be at `stood` (..., L, 3)."""
    if walk.curve.over == "ground":
        legs = np.nonzero(step.swing)[-1]
        first, last = stood[step.swing], walk.carried(step.after[step.swing], walk.neutral[legs])
    else:
        # As the body saw them at lift-off, and will at touch-down.
        first, last = (
            np.broadcast_to(walk.carried(np.asarray(travel), walk.neutral), stood.shape)[step.swing]
            for travel in (step.lifted, step.landed)
        )
    places = first + (last - first) * walk.curve.along.value(step.progress)[:, None]
    places[:, 2] += walk.lift * walk.curve.height.value(step.progress)
    return np.asarray(places)


def _soles(walk: Walk, step: _Steps) -> Array:
    """Attitudes of the soles (..., L, 3, 3), level frame: fixed to the ground in stance, turning in swing."""
    yaw, pitch = walk.turn * step.before, np.zeros(step.before.shape)
    s = step.progress
    share = walk.curve.along.value(s)
    yaw[step.swing] += walk.turn * (step.after - step.before)[step.swing] * share
    pitch[step.swing] = walk.heel * walk.lift * walk.curve.height.value(s) * np.cos(np.pi * s)
    return rotation((0, 0, 1), yaw) @ rotation((0, 1, 0), pitch)
