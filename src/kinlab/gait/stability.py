"""How safely a walk stands: centre of mass, zero moment point, and their margins at every instant."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlab.gait.motion import Motion
from kinlab.gait.schedule import Phase, wave_gait, wave_margin
from kinlab.gait.support import energy_margin, hull, margins
from kinlab.gait.walk import Walk
from kinlab.kinematics.transforms import Array, rotation
from kinlab.robots import Robot

GRAVITY = 9.80665
# Instants at which a phase is looked at where its margin need not be smallest at one of its ends.
WITHIN = 33


def centre_of_mass(robot: Robot, q: Array) -> Array:
    """Where the mass of `robot` is (..., 3), body frame, metres, its legs at `q` (..., L, n) in rad.

    Links weigh in their middle. Limbs that do not walk count with the rest of the body. A robot whose
    links have no masses has all of it in the body's centre: legs without mass, as McGhee and Frank have them.
    """
    legs = [leg for leg in robot.legs if any(joint.mass for joint in leg.joints)]
    if not legs or robot.mass is None:
        return np.broadcast_to(np.array(robot.centre), (*q.shape[:-2], 3))
    moment, parts = np.zeros((*q.shape[:-2], 3)), 0.0
    for i, leg in enumerate(robot.legs):
        ends = leg.from_limb(leg.frames(q[..., i, :])[..., :3, 3], "body")
        masses = np.array([joint.mass or 0.0 for joint in leg.joints])
        moment += masses @ ((ends[..., 1:, :] + ends[..., :-1, :]) / 2)
        parts += masses.sum()
    return np.asarray((moment + (robot.mass - parts) * np.array(robot.centre)) / robot.mass)


def mass_note(robot: Robot) -> str:
    """Where the masses of `robot` come from, in a sentence."""
    if any(joint.mass for leg in robot.legs for joint in leg.joints):
        return "masses of the links are assumed, each in the middle of its link"
    total = next((d for d in robot.dimensions if d.name == "mass"), None)
    known = f"its mass of {total.value:g} g is {total.source.kind}" if total else "no mass is printed"
    return f"{known}; all of it is assumed to lie in the middle of the body, and none in the legs"


@dataclass(frozen=True, eq=False, repr=False)
class Stability:
    """Margins of a motion of F frames (...); places in the level frame, metres.

    Attributes:
        motion: whose.
        down: which legs are taken to stand (..., L).
        centre: the centre of mass (..., 3).
        contacts: what touches the ground (..., P, 2): feet, or the corners of soles.
        static, longitudinal: see `kinlab.gait.support`.
    """

    motion: Motion
    down: Array
    centre: Array
    contacts: Array
    static: Array
    longitudinal: Array

    def __repr__(self) -> str:
        return (
            f"<Stability of {self.motion.walk.robot.name}: least margin {np.min(self.static) * 1000:.1f} mm>"
        )

    def frame(self, number: int) -> "Stability":
        """One of F frames (F,), by its number."""
        return Stability(
            self.motion.frame(number), self.down[number], self.centre[number], self.contacts[number],
            self.static[number], self.longitudinal[number],
        )  # fmt: skip

    @cached_property
    def energy(self) -> Array:
        """The normalised energy stability margin (...), metres."""
        return energy_margin(self.static, self.centre[..., 2])

    @cached_property
    def zmp(self) -> Array:
        """The zero moment point (..., 2): p = c - (z / g) c'', the cart-table model (Kajita et al., 2003).

        The mass is that of a cart which moves with the body: what the legs' own swing adds is left out.
        """
        acceleration = _acceleration(self.motion)
        return np.asarray(self.centre[..., :2] - self.centre[..., 2:] / GRAVITY * acceleration)

    @cached_property
    def zmp_margin(self) -> Array:
        """Its distance to the boundary of the support polygon (...), metres, negative outside."""
        return margins(self.contacts, self.zmp, self.bearing).static

    @cached_property
    def bearing(self) -> Array:
        """Which of the contacts (..., P) stand."""
        return _bearing(self.contacts, self.down)

    @cached_property
    def over_ground(self) -> Array:
        """The centre of mass (..., 3) in the ground frame, metres."""
        return self._over_ground(self.centre, self.motion.t)

    @cached_property
    def zmp_over_ground(self) -> Array:
        """The zero moment point (..., 3) in the ground frame, metres."""
        return self._over_ground(_flat(self.zmp), self.motion.t)

    def support(self, frame: int) -> Array:
        """The corners (k, 3) of the support polygon of frame `frame` of (N,), counter-clockwise, ground frame."""
        corners = hull(self.contacts[frame][self.bearing[frame]])
        return self._over_ground(_flat(corners), self.motion.t[frame])

    def _over_ground(self, level: Array, t: Array) -> Array:
        """Places (..., 3) of the level frame in the ground frame, at times `t` (...) in s."""
        walk = self.motion.walk
        return walk.carried(np.asarray(walk.travel(t)), level)


def stability(motion: Motion, down: ArrayLike | None = None) -> Stability:
    """The margins of `motion`; the legs that stand are those that do not swing, unless `down` (..., L) names them."""
    walk = motion.walk
    stands = ~motion.swing if down is None else np.broadcast_to(np.asarray(down, bool), motion.swing.shape)
    centre = centre_of_mass(walk.robot, motion.q)
    centre = motion.place + (centre @ walk.attitude.T if any(walk.rpy) else centre)
    contacts = _contacts(motion)
    found = margins(contacts, centre[..., :2], _bearing(contacts, stands))
    return Stability(motion, stands, centre, contacts, found.static, found.longitudinal)


def _bearing(contacts: Array, down: Array) -> Array:
    """Which contacts (..., P, 2) stand (..., P), where the legs that stand are `down` (..., L)."""
    each = contacts.shape[-2] // down.shape[-1]
    return down if each == 1 else np.repeat(down, each, axis=-1)


def _flat(places: Array) -> Array:
    """Places (..., 2) on the ground as (..., 3)."""
    return np.concatenate([places, np.zeros((*places.shape[:-1], 1))], axis=-1)


def _contacts(motion: Motion) -> Array:
    """Feet as points, soles as their four corners (..., P, 2), level frame, leg by leg."""
    soles = [leg.sole for leg in motion.walk.robot.legs]
    if motion.soles is None or None in soles:
        return motion.level[..., :2]
    corners = np.array([[[sx * s[0] / 2, sy * s[1] / 2, 0] for sx, sy in CORNERS] for s in soles if s])
    # As they would lie when the foot is down: turned, not pitched.
    ahead = motion.soles[..., :, 0]
    yaw = np.arctan2(ahead[..., 1], ahead[..., 0])
    turned = np.einsum("...lij,lcj->...lci", rotation((0, 0, 1), yaw), corners)
    places = (motion.level[..., None, :] + turned)[..., :2]
    return np.asarray(places.reshape(*places.shape[:-3], -1, 2))


CORNERS = ((1, 1), (1, -1), (-1, -1), (-1, 1))


def _acceleration(motion: Motion) -> Array:
    """Of the body (..., 2), level frame, m/s2: second differences of its exact path over the ground."""
    walk, t = motion.walk, motion.t
    h = 1e-3 * walk.period

    def path(at: Array) -> Array:
        place = np.zeros((*at.shape, 3))
        place[..., 1] = walk.sway_at(at)
        return walk.carried(walk.travel(at), place)

    found = (path(t + h) - 2 * path(t) + path(t - h)) / h**2
    angle = walk.turn * walk.travel(t)
    c, s = np.cos(angle), np.sin(angle)
    x, y = found[..., 0], found[..., 1]
    return np.stack([c * x + s * y, c * y - s * x], axis=-1)


@dataclass(frozen=True)
class Least:
    """The smallest margins of a phase, metres; None where there is none.

    Attributes:
        phase: of the gait.
        static, longitudinal, energy, zmp: margins.
    """

    phase: Phase
    static: float
    longitudinal: float | None
    energy: float
    zmp: float


def least_margins(walk: Walk) -> tuple[Least, ...]:
    """The smallest margins of each phase of a cycle, in the gait's order.

    The margin of a polygon that only moves along is concave: on a straight walk with the mass in one
    place it is smallest at an end of the phase, and exact.
    """
    legs = [leg.name for leg in walk.robot.legs]
    simple = (
        walk.turn == 0
        and not walk.sway
        and not any(joint.mass for leg in walk.robot.legs for joint in leg.joints)
    )
    found = []
    for phase in walk.gait.phases:
        shares = np.linspace(float(phase.start), float(phase.end), 2 if simple else WITHIN)
        state = stability(walk.at(shares * walk.period), [leg in phase.stance for leg in legs])
        ahead = state.longitudinal
        found.append(
            Least(
                phase,
                float(state.static.min()),
                None if np.isnan(ahead).any() else float(ahead.min()),
                float(state.energy.min()),
                float(state.zmp_margin.min()),
            )
        )
    return tuple(found)


def theory(walk: Walk) -> float | None:
    """The wave gait's formula for this walk, metres: see `wave_margin`.

    None where it does not apply: another gait, a turn, a step sideways, legs that do not stand in
    evenly spaced rows, a stroke longer than their pitch, or a centre that is not in the middle.
    """
    robot, gait = walk.robot, walk.gait
    rows = sorted({round(float(x), 9) for x in walk.neutral[:, 0]}, reverse=True)
    left = [i for i in np.argsort(-walk.neutral[:, 0], kind="stable") if walk.neutral[i, 1] > 0]
    right = [i for i in np.argsort(-walk.neutral[:, 0], kind="stable") if walk.neutral[i, 1] < 0]
    pairs = len(rows)
    if not len(left) == len(right) == pairs >= 2 or 2 * pairs * gait.duty < 3:
        return None
    pitches = [a - b for a, b in pairwise(rows)]
    pitch = pitches[0]
    even = max(pitches) - min(pitches) < 1e-9 and abs(sum(rows)) < 1e-9
    if (
        not even
        or walk.turn
        or walk.velocity[1]
        or walk.stroke > pitch * (1 + 1e-9)
        or robot.centre[0]
        or any(walk.rpy)
    ):
        return None
    names = [robot.legs[i].name for pair in zip(left, right, strict=True) for i in pair]
    start = gait.touchdown[names[0]]
    if tuple((gait.touchdown[name] - start) % 1 for name in names) != wave_gait(pairs, gait.duty):
        return None
    return wave_margin(pairs, walk.duty, pitch, walk.stroke)
