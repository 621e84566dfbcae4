"""Support polygons and their margins, on arrays alone: the convex hull of the contacts, and a point over it."""

from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlab.kinematics.transforms import Array

BLOCK = 4096
# Three points that span less than this (m2) lie on one line.
FLAT = 1e-14


class Margins(NamedTuple):
    """Margins (...) in metres.

    Attributes:
        static: the distance to the boundary of the support polygon, negative outside (McGhee and
            Iswandhi, 1979).
        longitudinal: the smaller of the distances to the boundary forwards and backwards along x,
            negative outside, NaN where that line misses the polygon (McGhee and Frank, 1968).
    """

    static: Array
    longitudinal: Array


def margins(contacts: ArrayLike, point: ArrayLike, down: ArrayLike | None = None) -> Margins:
    """How safely `point` (..., 2) lies above the convex hull of contacts (..., P, 2), metres.

    Two contacts are a line, one is a point: there the static margin is zero at most.

    Args:
        contacts: places on the ground.
        point: the centre of mass, or the zero moment point.
        down: which contacts count (..., P); all where not given. Where none does, both margins are NaN.

    >>> found = margins([[0, 0], [4, 0], [4, 4], [0, 4]], [1, 2])
    >>> float(found.static), float(found.longitudinal)
    (1.0, 1.0)
    """
    contacts, point = np.asarray(contacts, float), np.asarray(point, float)
    mask = np.ones(contacts.shape[-2], bool) if down is None else np.asarray(down, bool)
    lead = np.broadcast_shapes(contacts.shape[:-2], point.shape[:-1], mask.shape[:-1])
    count = contacts.shape[-2]
    places = np.broadcast_to(contacts, (*lead, count, 2)).reshape(-1, count, 2)
    points = np.broadcast_to(point, (*lead, 2)).reshape(-1, 2)
    masks = np.broadcast_to(mask, (*lead, count)).reshape(-1, count)
    static, longitudinal = np.full(len(places), np.nan), np.full(len(places), np.nan)
    # A gait has few different sets of standing legs: one pass for each is faster than masks.
    codes = masks @ (1 << np.arange(count))
    for code in np.flatnonzero(np.bincount(codes)):
        feet = [i for i in range(count) if code >> i & 1]
        rows = np.flatnonzero(codes == code)
        for start in range(0, len(rows) if feet else 0, BLOCK):
            block = rows[start : start + BLOCK]
            x, y = (np.ascontiguousarray((places[block, :, k].T - points[block, k])[feet]) for k in (0, 1))
            static[block], longitudinal[block] = _margins(x, y)
    return Margins(static.reshape(lead), longitudinal.reshape(lead))


def _margins(x: Array, y: Array) -> tuple[Array, Array]:
    """Margins (N,) of the origin over points x, y (P, N)."""
    pairs = list(combinations(range(len(x)), 2))
    # Twice the area of the triangle from the origin to each pair.
    moment = {(i, j): x[i] * y[j] - x[j] * y[i] for i, j in pairs}
    span = {(i, j): (x[j] - x[i], y[j] - y[i]) for i, j in pairs}
    least, most = _sides(moment, len(x))
    static = np.full(x.shape[1], np.inf)
    for pair in pairs:
        length = np.hypot(*span[pair])
        with np.errstate(divide="ignore", invalid="ignore"):
            inwards = moment[pair] / length
        apart = length > 0
        for outer, distance in ((least[pair] >= -FLAT, inwards), (most[pair] <= FLAT, -inwards)):
            np.minimum(static, distance, out=static, where=outer & apart)
    outside = ~(static >= 0) | np.isinf(static)
    if outside.any():
        static[outside] = -_distance(x[:, outside], y[:, outside], pairs)
    front, rear = _crossings(y, x, moment, span)
    return static, np.where(np.isfinite(front), np.minimum(front, -rear), np.nan)


def _sides(
    moment: dict[tuple[int, int], Array], count: int
) -> tuple[dict[tuple[int, int], Array], dict[tuple[int, int], Array]]:
    """For each pair, how far to the left of its line the rightmost and the leftmost other point lies, as areas."""
    nothing = np.zeros(1)
    least, most = dict.fromkeys(moment, nothing), dict.fromkeys(moment, nothing)
    for i, j, k in combinations(range(count), 3):
        area = moment[i, j] + moment[j, k] - moment[i, k]
        for pair, side in (((i, j), area), ((j, k), area), ((i, k), -area)):
            least[pair], most[pair] = np.minimum(least[pair], side), np.maximum(most[pair], side)
    return least, most


def _distance(x: Array, y: Array, pairs: list[tuple[int, int]]) -> Array:
    """The distance (N,) from the origin to the nearest of the points and of the lines between them."""
    nearest = np.hypot(x, y).min(axis=0)
    for i, j in pairs:
        dx, dy = x[j] - x[i], y[j] - y[i]
        square = dx * dx + dy * dy
        share = -(x[i] * dx + y[i] * dy) / np.where(square > 0, square, 1.0)
        share = np.clip(share, 0.0, 1.0)
        nearest = np.minimum(nearest, np.hypot(x[i] + share * dx, y[i] + share * dy))
    return np.asarray(nearest)


def _crossings(
    y: Array, x: Array, moment: dict[tuple[int, int], Array], span: dict[tuple[int, int], tuple[Array, Array]]
) -> tuple[Array, Array]:
    """Where the line y = 0 leaves the hull at the front and at the rear (N,); infinite where it misses."""
    on = y == 0
    front = np.where(on, x, -np.inf).max(axis=0)
    rear = np.where(on, x, np.inf).min(axis=0)
    for i, j in moment:
        across = (y[i] < 0) != (y[j] < 0)
        at = np.divide(moment[i, j], span[i, j][1], out=np.zeros_like(front), where=across)
        np.maximum(front, at, out=front, where=across)
        np.minimum(rear, at, out=rear, where=across)
    return front, rear


def energy_margin(static: ArrayLike, height: ArrayLike) -> Array:
    """The normalised energy stability margin (...), metres: how far the centre of mass rises before it tips.

    Over level ground sqrt(d^2 + z^2) - z for the nearest edge at distance d (Messuri and Klein, 1985;
    Hirose et al., 2001); negative outside.

    Args:
        static: the static margin (...), metres.
        height: of the centre of mass above the ground (...), metres.
    """
    d, z = np.asarray(static, float), np.asarray(height, float)
    return np.asarray(np.sign(d) * (np.hypot(d, z) - z))


def hull(points: ArrayLike) -> Array:
    """The corners (k, 2) of the convex hull of points (P, 2), counter-clockwise; Andrew's monotone chain."""
    ordered = sorted({(float(x), float(y)) for x, y in np.asarray(points, float)})
    chains: list[list[tuple[float, float]]] = []
    for run in (ordered, ordered[::-1]):
        chain: list[tuple[float, float]] = []
        for p in run:
            while len(chain) > 1 and _turns_right(chain[-2], chain[-1], p):
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return np.array(chains[0] + chains[1] or ordered)


def _turns_right(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> bool:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0
