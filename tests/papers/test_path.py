"""The whole path for one target or one pose."""

import numpy as np
import pytest

from kinlab.papers.path import angles_of, whole_path
from kinlab.papers.tour import TARGETS, first_target
from kinlab.rig.bench import bench_of
from kinlab.robots import load_robot
from kinlab.robots.target import solve_angles
from kinlab.units import to_metres


@pytest.mark.parametrize(("name", "limb_name", "target", "unit", "frame", "where"), TARGETS)
def test_every_limb_begins_where_its_paper_does(name, limb_name, target, unit, frame, where):
    robot = load_robot(name)
    limb = robot.limbs[limb_name]
    np.testing.assert_allclose(limb.from_limb(first_target(robot, limb), frame), to_metres(target, unit))


def test_limbs_without_a_printed_target_begin_within_reach():
    for name in ("xl430-hexapod", "udiebot", "eros"):
        robot = load_robot(name)
        for limb in robot.limbs.values():
            if limb.closed_form is not None:
                assert limb.ik(first_target(robot, limb)).reachable


def test_the_errors_grow_from_depth_to_depth():
    robot = load_robot("krsri-hexapod")
    limb = robot.limbs["R1"]
    bench, _ = bench_of(robot, limb)
    path = whole_path(robot, limb, target=[0.13, 0.01, -0.09], bench=bench)
    assert path.pose.error_m < 1e-12 < path.pose.quantised_error_m
    assert path.pose.quantised_error_m < path.arrival_error_m < 2e-3


def test_a_wished_solution_is_sent_on_where_it_is_within_the_limits():
    robot = load_robot("xl430-hexapod")
    limb = robot.limbs["R1"]
    target = limb.fk(np.radians([0.0, 10.0, -30.0]))[:3, 3]
    names = [p.name for p in whole_path(robot, limb, target=target).answer.poses if p.within_limits]
    assert names == ["knee-up", "knee-down"]
    for name in names:
        assert whole_path(robot, limb, target=target, solution=name).pose.name == name
    assert whole_path(robot, limb, target=target, solution="sideways").pose.name == names[0]


def test_begun_at_angles_the_target_is_where_they_lead():
    robot = load_robot("udiebot")
    limb = robot.limbs["LF"]
    q = np.radians([10.0, 30.0, -70.0])
    path = whole_path(robot, limb, q=q)
    np.testing.assert_allclose(path.answer.target, limb.fk(q)[:3, 3])
    np.testing.assert_allclose(path.pose.q, q)
    assert path.printed_fk
    assert {pose.name for pose in path.answer.poses} == {"as given", "knee-down"}


def test_angles_beyond_a_limit_are_told_and_not_sent():
    robot = load_robot("xl430-hexapod")
    limb = robot.limbs["R1"]
    answer = solve_angles(robot, limb, np.radians([80.0, 0.0, 0.0]))
    assert answer.chosen is None
    assert "coxa 80.00 deg is above its limit of 60.0" in answer.reason
    assert whole_path(robot, limb, q=np.radians([80.0, 0.0, 0.0])).pose is None


def test_printed_angles_come_in_the_order_of_the_joints():
    robot = load_robot("udiebot")
    limb = robot.limbs["LF"]
    path = whole_path(robot, limb, target=first_target(robot, limb))
    found = [angles_of(variant, limb) for variant in path.printed]
    assert found[0] is None
    assert list(found[1]) == [path.printed[1].angles[name] for name in limb.joint_names]
