"""Where a foot can be, checked against the search for the nearest point and against the inverse."""

import numpy as np
import pytest

from kinlab.lessons.answers import leg, reach
from kinlab.robots import load_robot
from kinlab.robots.inverse import nearest

ROBOT = "xl430-hexapod"


@pytest.mark.parametrize("place", [(150, 0, -60), (140, -40, -80), (160, 20, -70)])
def test_what_is_missing_is_the_way_from_the_nearest_point_within_reach(
    place: tuple[float, float, float],
) -> None:
    found = nearest(load_robot(ROBOT).limb(), np.array(place) / 1000) * 1000
    assert reach.missing(ROBOT, *place) == pytest.approx(np.linalg.norm(found - place), abs=1e-6)


@pytest.mark.parametrize("z", [-90, -60, -40])
def test_the_outermost_place_is_the_last_one_within_reach(z: float) -> None:
    x = reach.outermost(ROBOT, z)
    assert leg.reachable(ROBOT, x - 1e-6, 0, z)
    assert not leg.reachable(ROBOT, x + 1e-6, 0, z)


def test_the_ring_is_as_narrow_as_the_limits_make_it() -> None:
    ring = reach.ring(ROBOT)
    x, _, z = leg.foot(ROBOT, 0, 0, ring["limit"])
    assert np.hypot(x - 25, z) == pytest.approx(ring["folded"])
    assert (ring["inner"], ring["outer"]) == (20, 120)


def test_the_cosine_is_one_for_a_straight_leg_and_says_which_way_a_place_is_wrong() -> None:
    assert reach.cosine(ROBOT, 145, 0, 0) == pytest.approx(1)
    assert reach.why(ROBOT, 150, 0, -60) == "far"
    assert reach.why(ROBOT, 30, 0, -1) == "near"
    assert reach.why(ROBOT, 75, 0, -60) == "nothing"


def test_equation_19_leads_the_foot_astray_so_that_21_has_no_value() -> None:
    assert reach.misprint("krsri-hexapod", 130, 0, -90, ["17", "18", "19", "21"]) == 3
    assert reach.asked_of_the_acos("krsri-hexapod", 130, 0, 90) == pytest.approx(90 / 78)
