"""Margins: against shapely, against the theory of wave gaits, and what order and height do to them."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import shapely

from kinlab.gait import find_gait, gaits_for, least_margins, plan, stability, theory, wave_gait, wave_margin
from kinlab.gait.schedule import Gait
from kinlab.gait.support import energy_margin, hull, margins
from kinlab.kinematics.transforms import apply
from kinlab.robots import load_robot

LEGS = ("L1", "R1", "L2", "R2", "L3", "R3")


def by_shapely(contacts, point):
    """The static and the longitudinal margin, as shapely's geometry has them."""
    polygon = shapely.convex_hull(shapely.MultiPoint(contacts))
    here = shapely.Point(point)
    distance = here.distance(polygon.boundary if polygon.geom_type == "Polygon" else polygon)
    static = distance if polygon.contains(here) else -here.distance(polygon)
    along = shapely.intersection(polygon, shapely.LineString([(-99, point[1]), (99, point[1])]))
    if along.is_empty:
        return static, np.nan
    rear, _, front, _ = along.bounds
    return static, min(front - point[0], point[0] - rear)


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 6, 8])
def test_margins_are_those_of_shapely(count):
    rng = np.random.default_rng(count)
    contacts, points = rng.uniform(-1, 1, (300, count, 2)), rng.uniform(-1, 1, (300, 2))
    found = margins(contacts, points)
    expected = np.array([by_shapely(c, p) for c, p in zip(contacts, points, strict=True)])
    assert found.static == pytest.approx(expected[:, 0], abs=1e-12)
    assert found.longitudinal == pytest.approx(expected[:, 1], abs=1e-9, nan_ok=True)


def test_only_contacts_that_are_down_count():
    rng = np.random.default_rng(0)
    contacts, down = rng.uniform(-1, 1, (200, 6, 2)), rng.random((200, 6)) < 0.6
    found = margins(contacts, [0.1, 0.0], down)
    for i in range(200):
        if down[i].any():
            static, longitudinal = by_shapely(contacts[i][down[i]], (0.1, 0.0))
            assert found.static[i] == pytest.approx(static, abs=1e-12)
            assert found.longitudinal[i] == pytest.approx(longitudinal, abs=1e-9, nan_ok=True)
        else:
            assert np.isnan(found.static[i])


def test_a_foot_within_the_polygon_and_feet_in_a_row_change_nothing():
    square = [[1, 1], [-1, 1], [-1, -1], [1, -1]]
    for extra in ([0.2, 0.1], [1, 0], [1, 1]):
        assert margins([*square, extra], [0, 0]).static == pytest.approx(1)
    assert margins([[-1, 0], [0, 0], [1, 0]], [0.5, 0.5]).static == pytest.approx(-0.5)


def test_the_hull_is_that_of_shapely():
    points = np.random.default_rng(1).uniform(-1, 1, (20, 2))
    corners = shapely.Polygon(hull(points))
    assert corners.equals(shapely.convex_hull(shapely.MultiPoint(points)))
    assert corners.exterior.is_ccw
    assert hull([[0, 0], [0, 0]]).tolist() == [[0, 0]]
    assert hull([[0, 0], [2, 0], [1, 0]]).tolist() == [[0, 0], [2, 0]]


# 20 mm from an edge: what it is worth in height, at centres 30, 60, 100, 300 mm up.
@pytest.mark.parametrize(("height", "rise"), [(30, 6.1), (60, 3.3), (100, 2.0), (300, 0.7)])
def test_a_high_centre_of_mass_makes_an_edge_cheap_to_tip_over(height, rise):
    assert energy_margin(20, height) == pytest.approx(rise, abs=0.06)
    assert energy_margin(-20, height) == pytest.approx(-rise, abs=0.06)


@pytest.mark.parametrize("twelfths", range(6, 12))
@pytest.mark.parametrize("stroke", [0.02, 0.05, 0.08])
def test_the_least_margin_of_a_wave_gait_follows_the_formula(straight, twelfths, stroke):
    duty = Fraction(twelfths, 12)
    gait = Gait("wave", "hexapod", duty, dict(zip(LEGS, wave_gait(3, duty), strict=True)))
    walk = plan(straight, gait, stride=stroke / float(duty))
    expected = wave_margin(3, float(duty), 0.080, stroke)
    assert theory(walk) == pytest.approx(expected)
    assert min(found.longitudinal for found in least_margins(walk)) == pytest.approx(expected, abs=1e-12)


def test_the_formula_holds_for_four_legs_too():
    robot = load_robot("udiebot")
    walk = plan(robot, find_gait(robot, "creep"))
    assert min(found.longitudinal for found in least_margins(walk)) == pytest.approx(theory(walk), abs=1e-12)


def test_the_formula_is_not_claimed_where_it_does_not_apply(straight):
    gaits = gaits_for(straight)
    assert theory(plan(straight, gaits["wave"])) is None
    assert theory(plan(straight, gaits["tripod"], turn=0.1)) is None
    assert theory(plan(straight, gaits["tripod"], sideways=0.01)) is None
    assert theory(plan(straight, gaits["tripod"], stride=0.2)) is None


def test_the_least_margin_is_that_of_many_instants(straight):
    for name in ("tripod", "wave", "ripple", "tetrapod", "metachronal"):
        walk = plan(straight, gaits_for(straight)[name])
        sampled = stability(walk.at(np.linspace(0, walk.period, 4001)))
        least = least_margins(walk)
        assert min(f.static for f in least) == pytest.approx(sampled.static.min(), abs=2e-5)
        assert min(f.longitudinal for f in least) == pytest.approx(sampled.longitudinal.min(), abs=2e-5)


def reversed_order(gait):
    """The same gait with its events in the opposite order."""
    return replace(gait, touchdown={leg: -phase % 1 for leg, phase in gait.touchdown.items()})


def test_reversing_the_order_of_a_wave_costs_margin(straight):
    gait = find_gait(straight, "metachronal")
    there, back = (
        min(f.longitudinal for f in least_margins(plan(straight, g, stride=0.048)))
        for g in (gait, reversed_order(gait))
    )
    # With a stroke of half the pitch: 0.55 and 0.35 of the pitch.
    assert there == pytest.approx(0.55 * 0.080)
    assert back == pytest.approx(0.35 * 0.080)


@pytest.mark.parametrize(
    ("name", "static", "longitudinal"),
    [
        ("tripod", 0.192, 0.25),
        ("tetrapod", 0.318, 0.375),
        ("ripple", 0.354, 0.4375),
        ("metachronal", 0.458, 0.55),
    ],
)
def test_gaits_on_one_body_have_the_margins_measured_elsewhere(tmp_path, name, static, longitudinal):
    # Pitch 1, half width 0.6, stroke 0.5, in units of 100 mm.
    sides = (("R", 20, -90), ("L", -20, 90))
    members = [
        f"{s}{i + 1}: {{at: [{100 - 100 * i}, {y}, 0], turn: {a}}}" for s, y, a in sides for i in range(3)
    ]
    file = tmp_path / "body.yaml"
    file.write_text(
        "robots:\n  body:\n    kind: hexapod\n    legs:\n      coxa: 20\n      femur: 60\n      tibia: 90\n"
        "      joints: leg\n      stance: [80, 0, -60]\n      members: {" + ", ".join(members) + "}\n"
    )
    robot = load_robot("body", file)
    gait = find_gait(robot, name)
    walk = plan(robot, gait, stride=0.05 / float(gait.duty))
    least = least_margins(walk)
    assert min(f.static for f in least) * 10 == pytest.approx(static, abs=6e-4)
    assert min(f.longitudinal for f in least) * 10 == pytest.approx(longitudinal, abs=1e-9)


def test_the_wave_has_more_margin_than_the_tripod(straight):
    least = {
        name: min(f.static for f in least_margins(plan(straight, gait, stride=0.05 / float(gait.duty))))
        for name, gait in gaits_for(straight).items()
    }
    assert least["metachronal"] > least["ripple"] > least["tetrapod"] > least["tripod"] > 0


def test_the_centre_of_mass_is_that_of_its_parts():
    robot = load_robot("eros")
    q = np.radians([[0, 5, -30, 60, -30, -5], [0, 0, -10, 20, -10, 0]])
    parts, weights = [], []
    for leg, angles in zip(robot.legs, q, strict=True):
        ends = apply(leg.mount, leg.frames(angles)[:, :3, 3])
        for i, joint in enumerate(leg.joints):
            parts.append((ends[i] + ends[i + 1]) / 2)
            weights.append(joint.mass)
    parts.append(np.array(robot.centre))
    weights.append(robot.mass - sum(weights))
    from kinlab.gait.stability import centre_of_mass

    assert centre_of_mass(robot, q) == pytest.approx(np.average(parts, axis=0, weights=weights))


def test_standing_still_the_zero_moment_point_is_below_the_centre_of_mass():
    for name in ("krsri-hexapod", "eros"):
        robot = load_robot(name)
        walk = plan(robot, find_gait(robot)).over(0.1)
        state = stability(walk.at(np.array([-1.0, walk.duration + 1])))
        assert state.zmp == pytest.approx(state.centre[:, :2], abs=1e-9)


def test_the_cart_of_a_swaying_humanoid_has_its_zero_moment_point_over_the_standing_foot():
    robot = load_robot("eros")
    walk = plan(robot, find_gait(robot))
    # In the middle of the left leg's swing: (1/10 + 1/2) / 2 of the cycle.
    motion = walk.at(0.3 * walk.period)
    right = motion.level[0]
    body = motion.place[1]
    z = stability(walk.at(0.0)).centre[2]
    expected = body * (1 + (2 * np.pi / walk.period) ** 2 * z / 9.80665)
    assert expected == pytest.approx(right[1], rel=0.02)
    assert stability(motion).zmp_margin > 0


def test_going_round_a_circle_pushes_the_zero_moment_point_outwards():
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot), forward=0.08, turn=0.5)
    state = stability(walk.at(0.4))
    # Outwards is to the right of a turn to the left: p - c = z / g v omega.
    assert state.zmp - state.centre[:2] == pytest.approx(
        [0, -state.centre[2] / 9.80665 * 0.08 * 0.5], abs=1e-7
    )


def test_polygon_and_mass_are_where_the_body_has_carried_them_over_the_ground():
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot, "tripod"), turn=0.2)
    motion = walk.at(np.linspace(0, 2 * walk.period, 9))
    state = stability(motion)
    for frame in range(9):
        feet = motion.ground[frame][state.down[frame]]
        corners = state.support(frame)
        assert len(corners) == len(feet) == 3 or len(feet) == 6
        for corner in corners:
            assert np.linalg.norm(feet - corner, axis=-1).min() < 1e-12
    np.testing.assert_allclose(state.over_ground, motion.body[:, :3, 3], atol=1e-12)
    assert not state.zmp_over_ground[:, 2].any()
