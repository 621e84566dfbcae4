"""The straight line of the arm paper's experiments by resolved motion rate control, with its misprint and without."""

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import KinlabError, UsageError
from kinlab.kinematics.profile import PROFILES
from kinlab.kinematics.resolved_motion import Step, Track, follow, straight_line
from kinlab.kinematics.transforms import Array
from kinlab.names import resolve
from kinlab.papers.receptionist_arm import inverse_jacobian, jacobian
from kinlab.robots import Limb

# Section 4.1.1, in m and the paper's axes: 20 cm along y, 2.5 mm every 16 ms.
FROM, TO = np.array([-0.11322, 0.07653, 0.0]), np.array([-0.11322, 0.27653, 0.0])
CYCLE, DURATION = 0.016, 1.28
LONGEST = 600.0  # s
# How long an arm that goes there and back waits at each end, s.
REST = 0.8
# In the plane theta0 = 0, where J32 is 0, and a line out of it.
LINES = {
    "in the experiment": (tuple(FROM), tuple(TO)),
    "on a line out of its plane": ((-0.11322, 0.22, 0.03), (-0.11322, 0.28, 0.08)),
}


def line(
    limb: Limb,
    profile: str = "steps",
    start: ArrayLike = FROM,
    end: ArrayLike = TO,
    duration: float = DURATION,
) -> Track:
    """A straight line by resolved motion rate control; the experiment's own where nothing is given.

    Args:
        profile: "steps" as in the paper, "trapezoid" or "quintic".
        start, end: in m and the paper's axes.

    Raises:
        UsageError: no such profile, or a duration that is none.
        KinlabError: a place on the way is out of reach.
    """
    if not 0 < duration <= LONGEST:
        raise UsageError(f"a line takes more than 0 s and at most {LONGEST:g}, got {duration:g}")
    law = PROFILES[resolve(profile, PROFILES, "profile")]
    ends = [limb.to_limb(np.asarray(place, float), "paper") for place in (start, end)]
    _, points = straight_line(ends[0], ends[1], law, duration, CYCLE)
    found = limb.ik(points)
    if not found.reachable.all():
        first = int(np.argmin(found.reachable))
        place = np.round(limb.from_limb(points[first], "paper") * 1e3, 3).tolist()
        raise KinlabError(
            f"the line leaves the workspace at {place} mm (paper frame), step {first} of {len(points) - 1}"
        )
    return follow(limb.axes, limb.links, found.q[0], points, CYCLE)


@lru_cache(maxsize=4)
def there_and_back(limb: Limb) -> Track:
    """The experiment's line and back, with a rest at each end: a track that ends where it begins."""
    points = line(limb, "quintic").points
    pause = np.repeat(points[-1:], round(REST / CYCLE), axis=0)
    back = np.repeat(points[:1], round(REST / CYCLE), axis=0)
    whole = np.concatenate([points, pause, points[::-1], back])
    return follow(limb.axes, limb.links, limb.ik(whole[0]).q, whole, CYCLE)


def misprint(limb: Limb, track: Track) -> Track:
    """The same path by the printed inverse of the Jacobian, with the wrong entry J_inv32."""
    lengths = tuple(np.linalg.norm(limb.links, axis=1)[1:].tolist())

    def step(q: Array, dX: Array) -> Step:
        wrong = inverse_jacobian(jacobian(q, lengths), frozenset(["J_inv32"]))
        return Step((wrong @ limb.from_limb(dX, "paper"))[[0, 2, 1]], 0.0, None)

    return follow(limb.axes, limb.links, track.q[0], track.points, CYCLE, step)


def misprint_note(limb: Limb) -> str:
    """What the wrong entry costs: nothing in the plane of the experiment, something out of it."""
    off = {name: (right := line(limb, "steps", *ends), misprint(limb, right)) for name, ends in LINES.items()}
    said = [
        f"{name} {w.off.max() * 1e3:.3f} mm instead of {r.off.max() * 1e3:.3f}"
        for name, (r, w) in off.items()
    ]
    return f"by the printed J_inv32 the hand leaves the line by: {', '.join(said)}"


def singularities(limb: Limb, track: Track) -> list[str]:
    """Where the path passes near a singularity: which joint is lost, and the damping used."""
    found = []
    for joint in sorted(set(track.lost[track.lost >= 0].tolist())):
        steps = np.flatnonzero(track.lost == joint)
        most = float(track.damping[steps].max())
        found.append(
            f"singular from step {steps[0]} to {steps[-1]}: the {limb.joint_names[joint]} cannot move the hand; "
            f"damped with up to k = {most:.2e} m2"
        )
    return found
