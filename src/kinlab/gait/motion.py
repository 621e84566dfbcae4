"""What a walk is at given times: body, feet, joint angles, and whether a standing foot slips."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from kinlab.kinematics.transforms import Array, homogeneous, rotation

if TYPE_CHECKING:
    from kinlab.gait.walk import Walk


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """A walk at times (...), for its robot's L legs of n joints.

    Attributes:
        walk: whose.
        t: the times, s.
        swing: which legs are in the air (..., L).
        hold: the number of the foothold that a leg stands on, or comes from (..., L).
        level: the feet in the level frame (..., L, 3), metres.
        place: of the body in the level frame (..., 3), metres.
        feet: in the body frame (..., L, 3), metres.
        q: joint angles (..., L, n) in rad, NaN where a foot is out of reach.
        reachable: for each leg (..., L).
        soles: attitudes of the soles in the level frame (..., L, 3, 3); None for legs that cannot choose them.
    """

    walk: "Walk"
    t: Array
    swing: Array
    hold: Array
    level: Array
    place: Array
    feet: Array
    q: Array
    reachable: Array
    soles: Array | None

    def __repr__(self) -> str:
        return f"<Motion of {self.walk.robot.name}: {self.t.size} frames>"

    def frame(self, number: int) -> "Motion":
        """One of N frames (N,), by its number."""
        return Motion(
            self.walk, self.t[number], self.swing[number], self.hold[number], self.level[number],
            self.place[number], self.feet[number], self.q[number], self.reachable[number],
            None if self.soles is None else self.soles[number],
        )  # fmt: skip

    @cached_property
    def body(self) -> Array:
        """Poses of the body in the ground frame (..., 4, 4), metres."""
        travel = self.walk.travel(self.t)
        turned = rotation((0, 0, 1), self.walk.turn * travel)
        return homogeneous(turned @ self.walk.attitude, self.walk.carried(travel, self.place))

    @cached_property
    def ground(self) -> Array:
        """The feet in the ground frame (..., L, 3), metres: where the joint angles put them."""
        legs = self.walk.robot.legs
        tips = np.stack([leg.fk(self.q[..., i, :], frame="body") for i, leg in enumerate(legs)], axis=-3)
        return np.asarray((self.body[..., None, :, :] @ tips)[..., :3, 3])

    def slip(self) -> float:
        """The farthest that a standing foot moves over the ground in one stance, metres; frames (N,) in time order."""
        farthest = 0.0
        for leg in range(self.swing.shape[-1]):
            stands = np.flatnonzero(~self.swing[:, leg])
            if not stands.size:
                continue
            holds, places = self.hold[stands, leg], self.ground[stands, leg]
            first = np.maximum.accumulate(
                np.where(np.diff(holds, prepend=-1) != 0, np.arange(len(stands)), 0)
            )
            farthest = max(farthest, float(np.linalg.norm(places - places[first], axis=-1).max()))
        return farthest
