"""Margins, against another library's polygons and against a robot that is tipped by hand."""

import numpy as np
import pytest
import shapely

from kinlab.gait import find_gait, plan, stability
from kinlab.lessons.answers import margin
from kinlab.robots import load_robot

ROBOT = "krsri-hexapod"


@pytest.mark.parametrize("back", [-25, -10, 15, 25])
def test_the_static_margin_is_the_distance_to_the_triangles_outline(back: float) -> None:
    triangle = shapely.Polygon(margin.feet(ROBOT, back).values())
    assert margin.static(ROBOT, back) == pytest.approx(triangle.exterior.distance(shapely.Point(0, 0)))


def test_only_the_tripod_holds() -> None:
    assert margin.holding(ROBOT) == "tripod"


def test_the_least_margin_is_found_in_no_moment_of_the_walk_undercut() -> None:
    robot = load_robot(ROBOT)
    walk = plan(robot, find_gait(robot, "metachronal"))
    seen = stability(walk.at(np.linspace(0, walk.period, 2001))).static.min() * 1000
    assert margin.least(ROBOT, "metachronal")["static"] == pytest.approx(seen, abs=0.1)
    assert margin.steadier(ROBOT, "wave", "metachronal") == "metachronal"


def test_the_formula_loses_half_the_stroke_in_a_tripod_and_nothing_at_three_quarters() -> None:
    assert margin.formula(3, 1 / 2, 100, 50) == pytest.approx(50 - 25)
    assert margin.formula(3, 3 / 4, 100, 50) == pytest.approx(50)


def test_the_rise_is_that_of_a_point_turned_about_the_edge() -> None:
    angles = np.linspace(0, np.pi / 2, 100_001)
    heights = 60 * np.sin(angles) + 90 * np.cos(angles)
    assert margin.energy(60, 90) == pytest.approx(heights.max() - 90, abs=1e-6)
