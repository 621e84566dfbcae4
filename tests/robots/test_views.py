"""Views of a limb: planes, cuts through the workspace, and what is drawn."""

import numpy as np
import pytest

from kinlab.robots import load_robot
from kinlab.robots.views import SIDE, TOP, Drawn, draw_view, size_of, view
from kinlab.robots.workspace import cut

LIMBS = [
    ("xl430-hexapod", "R1"),
    ("krsri-hexapod", "L2"),
    ("udiebot", "LF"),
    ("eros", "left_leg"),
    ("receptionist-arm", "right_arm"),
]


@pytest.fixture(params=LIMBS, ids=lambda pair: "-".join(pair))
def limb(request):
    robot, name = request.param
    return load_robot(robot).limbs[name]


def test_a_point_of_the_picture_is_the_point_that_is_drawn_there(limb):
    target = limb.fk(limb.limits.mean(axis=0) + 0.1)[:3, 3]
    for name in (SIDE, TOP):
        seen = view(limb, name, target, size_of(limb))
        x, y = seen.flat(target[None])[0]
        np.testing.assert_allclose(seen.point(x, y, target), target, atol=1e-12)


def test_the_cut_says_what_inverse_kinematics_says(limb):
    target = np.array([0.02, 0.01, -0.08])
    seen = view(limb, SIDE, target, size_of(limb), fineness=24)
    for i in (3, 11, 20):
        for j in (4, 9, 15):
            i, j = min(i, len(seen.reach.up) - 1), min(j, len(seen.reach.across) - 1)
            point = seen.reach.across[j] * seen.across + seen.reach.up[i] * seen.up
            assert seen.reach.reachable[i, j] == limb.ik(point).reachable


def test_a_limb_without_a_closed_form_has_no_cut():
    head = load_robot("eros").limbs["head"]
    assert cut(head, np.zeros(3), [1, 0, 0], [0, 0, 1], ((0, 0.1), (0, 0.1))) is None
    seen = view(head, SIDE, np.array([0.02, 0.0, 0.05]), size_of(head))
    assert draw_view(seen, head.limits.mean(axis=0), None, columns=30, rows=10).text().strip()


def test_the_scale_stays_whatever_pose_is_drawn(limb):
    box = size_of(limb)
    target = limb.fk(limb.limits.mean(axis=0))[:3, 3]
    low, high = limb.limits
    widths = {
        draw_view(view(limb, SIDE, target, box), q, None, columns=40, rows=14).cell_width
        for q in (low, high, (low + high) / 2)
    }
    assert len(widths) == 1


def test_every_joint_and_the_tip_are_in_sight_in_any_pose(limb):
    box = size_of(limb)
    rng = np.random.default_rng(1)
    for q in rng.uniform(*limb.limits, (20, len(limb.joints))):
        target = limb.fk(q)[:3, 3]
        if limb.closed_form.needs_pose and not limb.ik(target).reachable:
            continue
        text = draw_view(view(limb, TOP, target, box), q, target, columns=60, rows=30).text()
        assert "▼" in text


def test_other_poses_limits_and_the_nearest_point_are_drawn_with_their_roles():
    limb = load_robot("xl430-hexapod").limbs["R1"]
    answer = limb.ik([0.075, 0.010, -0.046])
    target = np.array([0.075, 0.010, -0.046])
    seen = view(limb, SIDE, target, size_of(limb))
    other = Drawn(answer.solutions[1], "other", "other")
    canvas = draw_view(
        seen,
        answer.q,
        target,
        beside=[other],
        nearest=np.array([0.1, 0.0, 0.05]),
        limits=True,
        columns=60,
        rows=24,
    )
    roles = {role for row in canvas.spans() for _, role in row}
    assert {"outline", "link0", "link1", "link2", "other", "joint", "tip", "bad"} <= roles
    assert "×" in canvas.text()
