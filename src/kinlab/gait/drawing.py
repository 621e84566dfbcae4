"""A gait in characters: bars over the cycle, the feet from above, a margin over the cycle."""

from fractions import Fraction
from itertools import pairwise

import numpy as np

from kinlab.canvas import Canvas, Point
from kinlab.gait.cycle import Cycle
from kinlab.gait.motion import Motion
from kinlab.gait.plan import foot_velocities
from kinlab.gait.schedule import Gait
from kinlab.gait.stability import Stability
from kinlab.gait.support import hull
from kinlab.kinematics.transforms import Array


def bars(gait: Gait, columns: int, *, ascii_only: bool = False) -> dict[str, str]:
    """For each leg one cycle, `columns` characters wide: blocks where it swings, dots where it stands.

    krsri-hexapod, figure 7. Events are rounded to a character; none disappears in a cycle of as many.
    """
    air, ground = ("#", ".") if ascii_only else ("█", "·")
    middles = [Fraction(2 * i + 1, 2 * columns) for i in range(columns)]
    return {leg: "".join(air if gait.swings(leg, at) else ground for at in middles) for leg in gait.legs}


def draw_support(
    state: Stability,
    *,
    columns: int = 36,
    rows: int = 14,
    ascii_only: bool = False,
    around: Stability | None = None,
) -> Canvas:
    """The feet of one frame from above, x up and y to the left: what stands, what swings, what they carry.

    Args:
        around: frames that have the same scale, so that the picture stands still while it is played. Body
            and legs are drawn, too, the legs dashed.
    """
    motion = state.motion
    legs = motion.walk.robot.legs
    feet = [_above(p) for p in motion.level]
    bearing = state.contacts[state.bearing]
    corners = [_above(p) for p in hull(bearing)] if len(bearing) else []
    sight = state if around is None else around
    places = np.concatenate(
        [part.reshape(-1, part.shape[-1])[:, :2] for part in (sight.motion.level, sight.contacts)]
    )
    if around is not None:
        # Room for the names beside the outermost feet.
        cells = max(len(leg.name) for leg in legs) + 2
        room = np.array([0.0, np.ptp(places[:, 1]) * cells / max(columns - 2 * cells, 8)])
        places = np.vstack([places, places.min(axis=0) - room, places.max(axis=0) + room])
    canvas = Canvas(columns, rows, [_above(p) for p in places], ascii_only=ascii_only)
    down, up, centre = ("V", "o", "+") if ascii_only else ("■", "□", "✚")
    if around is not None:
        chains = _chains(motion)
        body = [_above(place) for place in hull(np.array([chain[0, :2] for chain in chains]))]
        for start, end in zip(body, [*body[1:], *body[:1]], strict=True):
            canvas.line(start, end, "axis")
        for chain, stands in zip(chains, state.down, strict=True):
            for start, end in pairwise(map(_above, chain)):
                canvas.line(start, end, "link2" if stands else "link1", dashed=True)
    for start, end in zip(corners, [*corners[1:], *corners[:1]], strict=True):
        canvas.line(start, end, "link0")
    for foot, stands in zip(feet, state.down, strict=True):
        canvas.mark(foot, down if stands else up, "tip")
    canvas.mark(_above(state.centre), centre, "target")
    for leg, foot in zip(legs, feet, strict=True):
        canvas.label(foot, leg.name, "joint", left=foot[0] < 0)
    return canvas


def draw_swing(
    cycle: Cycle, leg: int, frame: int, *, columns: int = 36, rows: int = 8, ascii_only: bool = False
) -> Canvas:
    """A foot from the side, along its way: the loop that it makes under the body, and where it is in `frame`.

    Right is where the walk takes the foot through the air; height counts from the ground.

    Args:
        leg: by number.
    """
    motion = cycle.state.motion
    way = foot_velocities(cycle.walk)[leg]
    speed = float(np.hypot(*way))
    along = way / speed if speed else np.array([1.0, 0.0])
    ground = float(motion.level[:, leg, 2].min())

    def flat(place: Array) -> Point:
        return float(place[:2] @ along) * 1000, (float(place[2]) - ground) * 1000

    loop = [flat(place) for place in motion.level[:, leg]]
    swings = motion.swing[:, leg]
    canvas = Canvas(columns, rows, loop, ascii_only=ascii_only)
    reach = max(x for x, _ in loop) - min(x for x, _ in loop) + 100 * canvas.cell_width
    middle = loop[frame][0]
    canvas.line((middle - reach, 0.0), (middle + reach, 0.0), "axis", dashed=True)
    for i, (start, end) in enumerate(zip(loop, [*loop[1:], *loop[:1]], strict=True)):
        canvas.line(start, end, "link1" if swings[i] else "link0")
    chain = [flat(place) for place in _chains(motion.frame(frame))[leg]]
    canvas.line(chain[-1], chain[-2], "link2")
    down, up = ("V", "o") if ascii_only else ("■", "□")
    canvas.mark(loop[frame], up if swings[frame] else down, "tip")
    return canvas


def _chains(motion: Motion) -> list[Array]:
    """For each leg of one frame the places of its joints and its tip (n + 1, 3), level frame, metres."""
    walk = motion.walk
    return [
        leg.from_limb(leg.frames(motion.q[i])[:, :3, 3], "body") @ walk.attitude.T + motion.place
        for i, leg in enumerate(walk.robot.legs)
    ]


def _above(place: Array) -> Point:
    return -float(place[1]) * 1000, float(place[0]) * 1000
