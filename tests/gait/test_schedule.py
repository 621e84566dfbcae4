"""Schedules: who stands when, exactly."""

from fractions import Fraction

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.gait import find_gait, gaits_for, load_gaits, plan, wave_gait
from kinlab.robots import load_robot

GAITS = load_gaits()


def phases_of(name, legs):
    return tuple(GAITS[name].touchdown[leg] for leg in legs.split())


@pytest.mark.parametrize("gait", GAITS.values(), ids=str)
def test_every_leg_swings_exactly_what_the_duty_factor_leaves(gait):
    for leg in gait.legs:
        swung = sum(phase.end - phase.start for phase in gait.phases if leg in phase.swing)
        assert swung == 1 - gait.duty


@pytest.mark.parametrize("gait", GAITS.values(), ids=str)
def test_phases_follow_one_another_and_fill_the_cycle(gait):
    for phase, following in zip(gait.phases, [*gait.phases[1:], gait.phases[0]], strict=True):
        assert phase.end % 1 == following.start
        assert set(phase.swing).isdisjoint(phase.stance)
        assert set(phase.swing) | set(phase.stance) == set(gait.legs)
        assert phase.stance
    assert sum(phase.end - phase.start for phase in gait.phases) == 1


@pytest.mark.parametrize("gait", GAITS.values(), ids=str)
def test_legs_lift_and_land_at_events_and_nowhere_else(gait):
    for event, before in zip(gait.events, [gait.phases[-1], *gait.phases[:-1]], strict=True):
        after = next(phase for phase in gait.phases if phase.start == event.at)
        assert set(after.swing) - set(before.swing) == set(event.lifts)
        assert set(before.swing) - set(after.swing) == set(event.lands)


def test_tripod_stands_on_three_legs_and_the_wave_on_five():
    assert {len(phase.stance) for phase in GAITS["tripod"].phases} == {3}
    assert {len(phase.stance) for phase in GAITS["wave"].phases} == {5}
    assert {len(phase.stance) for phase in GAITS["ripple"].phases} == {4}
    assert {len(phase.stance) for phase in GAITS["tetrapod"].phases} == {4}
    assert min(len(phase.stance) for phase in GAITS["creep"].phases) == 3


def test_the_wave_swings_in_the_order_of_krsris_table_1():
    assert [phase.swing for phase in GAITS["wave"].phases] == [
        ("R1",),
        ("R2",),
        ("R3",),
        ("L1",),
        ("L2",),
        ("L3",),
    ]


def test_the_metachronal_wave_runs_from_the_rear_to_the_front_on_each_side():
    order = [phase.swing[0] for phase in GAITS["metachronal"].phases]
    assert [leg for leg in order if leg[0] == "R"] == ["R3", "R2", "R1"]
    assert [leg for leg in order if leg[0] == "L"] == ["L3", "L2", "L1"]


@pytest.mark.parametrize(
    ("name", "duty"),
    [("tripod", Fraction(1, 2)), ("ripple", Fraction(2, 3)), ("metachronal", Fraction(5, 6))],
)
def test_tripod_ripple_and_metachronal_are_wave_gaits(name, duty):
    assert GAITS[name].duty == duty
    assert phases_of(name, "L1 R1 L2 R2 L3 R3") == wave_gait(3, duty)


def test_creep_is_the_wave_gait_of_four_legs():
    assert phases_of("creep", "LF RF LH RH") == wave_gait(2, GAITS["creep"].duty)


def test_dynamic_quadruped_gaits_move_pairs():
    assert {frozenset(p.swing) for p in GAITS["trot"].phases} == {
        frozenset({"LF", "RH"}),
        frozenset({"RF", "LH"}),
    }
    assert {frozenset(p.swing) for p in GAITS["pace"].phases} == {
        frozenset({"LF", "LH"}),
        frozenset({"RF", "RH"}),
    }
    assert {frozenset(p.swing) for p in GAITS["bound"].phases} == {
        frozenset({"LF", "RF"}),
        frozenset({"LH", "RH"}),
    }


def test_the_humanoid_has_four_steps_of_single_and_double_support():
    assert [phase.swing for phase in GAITS["four-step"].phases] == [(), ("left_leg",), (), ("right_leg",)]
    assert [event.lands for event in GAITS["four-step"].events] == [("right_leg",), (), ("left_leg",), ()]


def test_swing_flags_of_frames_agree_with_the_exact_schedule():
    robot = load_robot("krsri-hexapod")
    for gait in gaits_for(robot).values():
        walk = plan(robot, gait)
        at = [Fraction(i, 240) for i in range(-240, 480)]
        swing = walk.at(np.array([float(x) for x in at]) * walk.period).swing
        expected = [[gait.swings(leg.name, x) for leg in robot.legs] for x in at]
        assert (swing == expected).all()


def test_period_times_speed_is_the_stride():
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, GAITS["wave"], forward=0.030, stride=0.060)
    assert walk.period == pytest.approx(2.0)
    assert walk.period * walk.speed == pytest.approx(walk.stride)
    assert walk.stroke == pytest.approx(0.050)
    assert plan(robot, GAITS["wave"], forward=0.030, period=1.5).stride == pytest.approx(0.045)


def test_the_first_gait_of_a_kind_is_its_default():
    assert find_gait(load_robot("krsri")).name == "tripod"
    assert find_gait(load_robot("udiebot")).name == "creep"
    assert find_gait(load_robot("eros")).name == "four-step"


def test_a_gait_for_another_kind_is_answered_with_those_that_fit():
    with pytest.raises(UsageError, match=r"tripod is a gait for a hexapod; .* creep, trot, pace, bound"):
        find_gait(load_robot("udiebot"), "tripod")


def test_a_mistyped_gait_is_answered_with_the_nearest():
    with pytest.raises(UsageError, match="did you mean tripod"):
        find_gait(load_robot("krsri"), "tripode")
    assert find_gait(load_robot("krsri"), "meta").name == "metachronal"


def test_a_robot_without_legs_does_not_walk():
    with pytest.raises(UsageError, match="receptionist-arm has no legs"):
        find_gait(load_robot("receptionist-arm"))


OWN = """
gaits:
  waddle:
    kind: {kind}
    duty: {duty}
    touchdown: {touchdown}
"""


def own(tmp_path, kind="quadruped", duty="3/4", touchdown="{LF: 0, RF: 1/2, LH: 0.75, RH: 1/4}"):
    file = tmp_path / "own.yaml"
    file.write_text(OWN.format(kind=kind, duty=duty, touchdown=touchdown))
    return file


def test_a_file_of_ones_own_adds_gaits(tmp_path):
    gait = find_gait(load_robot("udiebot"), "waddle", own(tmp_path))
    assert gait.duty == Fraction(3, 4)
    assert gait.touchdown["LH"] == Fraction(3, 4)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (
            {"touchdown": "{LF: 0, RF: 1, LH: 0, RH: 0}"},
            "own.yaml:6: gaits.waddle.touchdown.RF: expected a phase .* 1",
        ),
        ({"touchdown": "{LF: -0.1, RF: 0, LH: 0, RH: 0}"}, "touchdown.LF: expected a phase"),
        ({"touchdown": "{LF: soon}"}, "touchdown.LF: expected a fraction such as 5/6, got 'soon'"),
        ({"touchdown": "{LF: 1/0}"}, "touchdown.LF: '1/0' divides by zero"),
        ({"touchdown": "{LF: [1]}"}, "touchdown.LF: expected a fraction of the cycle such as 1/6"),
        ({"touchdown": "{}"}, "a gait needs at least one leg"),
        (
            {"duty": "1/4", "touchdown": "{LF: 0, RF: 0, LH: 1/2, RH: 1/2}"},
            "own.yaml:5: gaits.waddle.duty: .* no leg on",
        ),
        ({"duty": "1"}, "expected a duty factor between 0 and 1, got 1"),
        ({"duty": "much"}, "gaits.waddle.duty: expected a fraction"),
        ({"kind": "hexpod"}, "own.yaml:4: gaits.waddle.kind: expected one of hexapod"),
    ],
)
def test_a_wrong_gait_is_refused_with_its_line_and_field(tmp_path, wrong, message):
    with pytest.raises(UsageError, match=message):
        load_gaits(own(tmp_path, **wrong))


def test_legs_that_do_not_exist_are_named(tmp_path):
    file = own(tmp_path, touchdown="{LF: 0, RF: 1/2, LH: 3/4, RX: 1/4}")
    with pytest.raises(
        UsageError, match="moves a leg RX, which udiebot has not: its legs are LF, RF, LH, RH"
    ):
        find_gait(load_robot("udiebot"), "waddle", file)
    file = own(tmp_path, touchdown="{LF: 0, RF: 1/2, LH: 3/4}")
    with pytest.raises(UsageError, match="says nothing of leg RH"):
        find_gait(load_robot("udiebot"), "waddle", file)
