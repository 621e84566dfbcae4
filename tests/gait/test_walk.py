"""Walking: feet on the ground stay where they are, feet in the air go where they should."""

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.gait import CURVES, find_gait, gaits_for, load_gaits, plan
from kinlab.robots import load_robot

ROBOTS = {"hexapod": "krsri-hexapod", "quadruped": "udiebot", "humanoid": "eros"}
NANOMETRE = 1e-9  # m, which is 1e-6 mm
COMMANDS = {
    "forwards": {},
    "backwards": {"forward": -0.02},
    "sideways": {"forward": 0.0, "sideways": 0.015},
    "turning": {"forward": 0.0, "turn": -0.2},
    "all at once": {"forward": 0.02, "sideways": -0.01, "turn": 0.15},
}


def a_walk(gait, **options):
    return plan(load_robot(ROBOTS[gait.kind]), gait, **options)


@pytest.mark.parametrize("gait", load_gaits().values(), ids=str)
@pytest.mark.parametrize("command", COMMANDS)
def test_standing_feet_do_not_move_over_the_ground(gait, command):
    walk = a_walk(gait, **COMMANDS[command])
    motion = walk.at(np.linspace(-0.3, 2.2, 701) * walk.period)
    assert motion.reachable.all()
    assert motion.slip() < NANOMETRE
    assert np.abs(motion.ground[..., 2][~motion.swing]).max() < NANOMETRE


@pytest.mark.parametrize("kind", ROBOTS)
@pytest.mark.parametrize("curve", CURVES)
def test_a_walk_starts_from_standing_and_ends_standing_without_a_slip(kind, curve):
    robot = load_robot(ROBOTS[kind])
    walk = plan(robot, find_gait(robot), sideways=0.005, turn=0.1, curve=CURVES[curve]).over(0.15)
    motion = walk.at(np.linspace(-0.1, walk.duration, 1500))
    assert motion.reachable.all()
    assert motion.slip() < NANOMETRE
    standing = robot.standing_feet
    for end in (0, -1):
        assert not motion.swing[end].any()
        assert motion.feet[end] == pytest.approx(standing, abs=NANOMETRE)
    assert motion.body[0] == pytest.approx(walk.at(-1.0).body, abs=NANOMETRE)
    assert motion.q[-1] == pytest.approx(motion.q[0], abs=1e-9)


def test_the_body_goes_as_far_as_it_is_asked_to():
    robot = load_robot("krsri-hexapod")
    # Further than, and less than, what it takes to reach full speed.
    for distance in (1.0, 0.03):
        walk = plan(robot, find_gait(robot)).over(distance)
        assert walk.at(walk.duration).body[0, 3] == pytest.approx(distance)
    turn = plan(robot, find_gait(robot), forward=0.0, turn=0.3).over(np.pi / 2)
    assert turn.at(turn.duration).body[:2, :2] == pytest.approx(np.array([[0, -1], [1, 0]]), abs=1e-12)


def test_feet_are_continuous_and_their_steps_shrink_with_the_time_between_frames():
    robot = load_robot("krsri-hexapod")
    for walk in (plan(robot, find_gait(robot, "wave"), turn=0.1), plan(robot, find_gait(robot)).over(0.2)):
        end = min(walk.duration, 2 * walk.period)
        leaps = [np.abs(np.diff(walk.at(np.linspace(0, end, n)).feet, axis=0)).max() for n in (1000, 100_000)]
        assert leaps[1] < leaps[0] / 50


def test_joint_angles_put_the_feet_where_they_are_said_to_be():
    for name in ROBOTS.values():
        robot = load_robot(name)
        motion = plan(robot, find_gait(robot), turn=0.1, rpy=(0.03, -0.02, 0), height=-0.005).at(
            np.linspace(0, 3, 50)
        )
        for i, leg in enumerate(robot.legs):
            assert leg.fk(motion.q[:, i], "body")[..., :3, 3] == pytest.approx(motion.feet[:, i], abs=1e-12)


def test_a_turn_is_an_arc():
    robot = load_robot("krsri-hexapod")
    # A circle of 100 mm radius, once around: where it began, and heading as it began.
    walk = plan(robot, find_gait(robot), forward=0.02, turn=0.2)
    body = walk.at(np.array([0.0, 2 * np.pi / 0.2, np.pi / 0.2])).body
    assert body[1] == pytest.approx(body[0], abs=1e-12)
    assert body[2, :2, 3] == pytest.approx([0, 0.2], abs=1e-12)


def test_a_slight_turn_is_nearly_straight():
    robot = load_robot("krsri-hexapod")
    t = np.linspace(0, 5, 40)
    straight, slight = (plan(robot, find_gait(robot), turn=turn).at(t).feet for turn in (0.0, 1e-12))
    assert slight == pytest.approx(straight, abs=1e-9)


def test_feet_stand_under_the_body_in_the_middle_of_their_stance():
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot, "ripple"), turn=0.2, sideways=0.01)
    for i, leg in enumerate(robot.legs):
        middle = float(walk.gait.touchdown[leg.name] + walk.gait.duty / 2) * walk.period
        assert walk.at(middle).feet[i] == pytest.approx(robot.standing_feet[i], abs=1e-12)


def test_height_and_attitude_move_the_body_and_not_the_feet():
    robot = load_robot("krsri-hexapod")
    gait = find_gait(robot)
    plain, posed = (
        plan(robot, gait, **o).at(0.7) for o in ({}, {"height": 0.01, "rpy": (0.05, 0.02, -0.03)})
    )
    assert posed.ground == pytest.approx(plain.ground, abs=1e-12)
    assert posed.body[2, 3] - plain.body[2, 3] == pytest.approx(0.01)


def test_one_frame_is_a_row_of_many():
    robot = load_robot("udiebot")
    walk = plan(robot, find_gait(robot))
    t = np.linspace(0, 4, 12).reshape(3, 4)
    motion = walk.at(t)
    assert motion.feet.shape == (3, 4, 4, 3)
    assert motion.q.shape == (3, 4, 4, 3)
    assert motion.swing.shape == (3, 4, 4)
    assert motion.body.shape == (3, 4, 4, 4)
    assert walk.at(t[1, 2]).q == pytest.approx(motion.q[1, 2], abs=1e-12)


def test_a_standing_sole_does_not_turn_on_the_ground():
    robot = load_robot("eros")
    walk = plan(robot, find_gait(robot), turn=0.3, heel_strike=True)
    motion = walk.at(np.linspace(0, walk.period, 400))
    for i, leg in enumerate(robot.legs):
        sole = (motion.body @ leg.fk(motion.q[:, i], "body"))[:, :3, :3]
        stands = ~motion.swing[:, i]
        for hold in np.unique(motion.hold[stands, i]):
            of_one = sole[stands & (motion.hold[:, i] == hold)]
            assert np.abs(of_one - of_one[0]).max() < 1e-9
            assert of_one[0, 2] == pytest.approx([0, 0, 1], abs=1e-9)


def test_every_gait_of_a_kind_walks_every_robot_of_it():
    for name in ("xl430-hexapod", "krsri-hexapod", "udiebot", "eros"):
        robot = load_robot(name)
        for gait in gaits_for(robot).values():
            assert plan(robot, gait).at(np.linspace(0, 10, 300)).reachable.all()


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ({"forward": np.nan}, "speed must be finite"),
        ({"stride": -0.1}, "stride must be above 0"),
        ({"period": np.inf}, "period must be above 0"),
        ({"forward": 1e300}, "within 100 .*; is the unit right"),
        ({"forward": 1e-300}, "a cycle would take"),
        ({"stride": 0.1, "period": 1.0}, "name one of them"),
        ({"heel_strike": True}, "soles; krsri-hexapod is a hexapod"),
    ],
)
def test_numbers_that_make_no_walk_are_refused(asked, message):
    robot = load_robot("krsri-hexapod")
    with pytest.raises(UsageError, match=message):
        plan(robot, find_gait(robot), **asked)


def test_a_robot_may_step_in_place():
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot), forward=0.0)
    motion = walk.at(np.linspace(0, walk.period, 100))
    assert motion.level[..., :2] == pytest.approx(np.broadcast_to(walk.neutral[:, :2], (100, 6, 2)))
    assert motion.level[..., 2].max() == pytest.approx(walk.lift, rel=1e-2)
    journey = walk.over(3.0)
    assert journey.at(np.linspace(0, journey.duration, 500)).slip() < NANOMETRE
