"""Closed forms are recognised from axes and links, whatever robot they belong to."""

import numpy as np
import pytest

from kinlab.kinematics import chain, recognise
from kinlab.kinematics.closed_form import LEG_NAMES

LEG = np.array([[0, 0, 1], [0, -1, 0], [0, -1, 0]])
LINKS = np.array([[0.025, 0, 0], [0.05, 0, 0], [0.07, 0, 0]])


def test_a_leg_is_recognised_and_solved_in_four_named_ways():
    form = recognise(LEG, LINKS)
    assert (form.kind, form.names, form.lengths) == ("leg", LEG_NAMES, (0.025, 0.05, 0.07))
    q, reachable = form.solve([0.06, 0.02, -0.03])
    assert q.shape == (4, 3)
    assert reachable
    known = q[np.isfinite(q[:, 0])]
    np.testing.assert_allclose(chain.fk(LEG, LINKS, known)[:, :3, 3], [[0.06, 0.02, -0.03]] * len(known))


def test_a_foot_that_is_reached_only_backwards_is_reachable():
    links = np.array([[0.3, 0, 0], [0.05, 0, 0], [0.07, 0, 0]])
    foot = chain.fk(LEG, links, [0.3, np.pi, 0.4])[:3, 3]
    q, reachable = recognise(LEG, links).solve(foot)
    assert reachable
    assert np.isfinite(q).any()


@pytest.mark.parametrize(
    ("first", "second"),
    [(a, b) for a in (*np.eye(3), *-np.eye(3)) for b in (*np.eye(3), *-np.eye(3)) if abs(a @ b) < 0.5],
)
def test_a_shoulder_arm_is_solved_whichever_way_its_axes_point(first, second):
    along = np.cross(second, first)
    axes, links = np.array([first, second, first]), np.array([0 * along, 0.185 * along, 0.25 * along])
    form = recognise(axes, links)
    assert form.kind == "shoulder arm"
    assert form.lengths == pytest.approx((0.185, 0.25))
    q = np.random.default_rng(1).uniform(-3, 3, (200, 3))
    hand = chain.fk(axes, links, q)[:, :3, 3]
    found, reachable = form.solve(hand)
    assert reachable.all()
    np.testing.assert_allclose(
        chain.fk(axes, links, found)[..., :3, 3], hand[:, None] + 0 * found, atol=1e-12
    )


@pytest.mark.parametrize(
    ("axes", "links"),
    [
        (-LEG, LINKS),
        (LEG, LINKS + np.array([0, 0, 0.01])),
        (LEG, LINKS * [[1], [1], [-1]]),
        (LEG[:2], LINKS[:2]),
        (np.vstack([LEG, LEG[-1:]]), np.vstack([LINKS, LINKS[-1:]])),
    ],
    ids=["axes reversed", "links off the line", "negative tibia", "two joints", "four joints"],
)
def test_a_chain_that_only_resembles_a_leg_is_not_taken_for_one(axes, links):
    assert recognise(axes, links) is None
