"""A cycle that is played: its frames, its phases, what joints need at each frame."""

import numpy as np
import pytest

from kinlab.errors import KinlabError
from kinlab.gait import cycle_of, find_gait, gaits_for, plan, stability
from kinlab.gait.drawing import draw_support, draw_swing
from kinlab.robots import load_robot

WALKERS = ("krsri-hexapod", "udiebot", "eros")


@pytest.fixture
def cycle():
    robot = load_robot("krsri-hexapod")
    return cycle_of(plan(robot, find_gait(robot, "wave")))


@pytest.mark.parametrize("name", WALKERS)
def test_every_frame_is_the_walk_at_its_time(name):
    robot = load_robot(name)
    for gait in gaits_for(robot).values():
        cycle = cycle_of(plan(robot, gait, turn=0.05))
        for frame in range(0, len(cycle), 7):
            t = (frame + 0.5) / len(cycle) * cycle.walk.period
            assert cycle.frame_at(t) == cycle.frame_at(t - 3 * cycle.walk.period) == frame
            one, there = cycle.state.frame(frame), stability(cycle.walk.at(t))
            np.testing.assert_allclose(one.motion.level, there.motion.level, atol=1e-12)
            assert one.static == pytest.approx(float(there.static))
            # The legs in the air are those of the gait's own schedule.
            legs = {leg.name for leg, swings in zip(robot.legs, one.motion.swing, strict=True) if swings}
            assert legs == set(cycle.phase(frame).swing)


@pytest.mark.parametrize("name", WALKERS)
def test_steps_by_phase_stop_at_the_beginning_of_every_phase_both_ways(name):
    robot = load_robot(name)
    for gait in gaits_for(robot).values():
        cycle = cycle_of(plan(robot, gait))
        count = len(gait.phases)
        t, seen = 0.3 * cycle.walk.period, []
        for _ in range(count):
            t = cycle.phases_on(t, 1)
            seen.append(cycle.phase(cycle.frame_at(t)).number)
            before = cycle.frames_on(t, -1)
            assert cycle.phase(cycle.frame_at(before)).number != seen[-1]
        assert sorted(seen) == list(range(1, count + 1))
        back = [t := cycle.phases_on(t, -1) for _ in range(count)]
        assert [cycle.phase(cycle.frame_at(at)).number for at in back] == [*seen[-2::-1], seen[-1]]
        # From within a phase the first step back leads to where it began.
        assert cycle.phases_on(cycle.frames_on(t, 2), -1) == pytest.approx(t)


def test_steps_by_frame_go_on_through_the_end_of_the_cycle(cycle):
    last = cycle.frames_on(0.0, -1)
    assert last < 0
    assert cycle.frame_at(last) == len(cycle) - 1
    assert cycle.frame_at(cycle.frames_on(last, 1)) == 0


def test_the_most_that_a_joint_needs_is_what_the_limits_say(cycle):
    assert cycle.used.max() == pytest.approx(cycle.limits.used, rel=0.02)
    assert cycle.used.max() <= cycle.limits.used * (1 + 1e-9)


def test_rates_are_those_of_the_angles_from_frame_to_frame(cycle):
    q, step = cycle.state.motion.q, cycle.walk.period / len(cycle)
    between = np.diff(q, axis=0) / step
    mean = (cycle.rates[1:] + cycle.rates[:-1]) / 2
    # Where a foot lifts or lands the rate jumps within the step.
    steady = ~(np.diff(cycle.state.motion.swing, axis=0) != 0).any(axis=1)
    assert np.abs(between - mean)[steady].max() < 0.1 * np.abs(cycle.rates).max()


def test_a_walk_beyond_the_servos_is_no_cycle():
    robot = load_robot("krsri-hexapod")
    with pytest.raises(KinlabError, match="fastest possible speed"):
        cycle_of(plan(robot, find_gait(robot, "tripod"), forward=0.4))


@pytest.mark.parametrize("name", WALKERS)
def test_the_picture_stands_still_while_the_walk_is_played(name):
    robot = load_robot(name)
    cycle = cycle_of(plan(robot, find_gait(robot)))
    every = range(0, len(cycle), 9)
    tops = [draw_support(cycle.state.frame(f), around=cycle.state) for f in every]
    assert len({canvas.cell_width for canvas in tops}) == 1
    for canvas in tops:
        text = canvas.text()
        assert text.count("■") + text.count("□") == len(robot.legs)
        assert "✚" in text


def test_a_foot_is_seen_high_in_its_swing_and_on_the_ground_in_its_stance(cycle):
    leg = 0
    swings = cycle.state.motion.swing[:, leg]
    high = int(np.argmax(cycle.state.motion.level[:, leg, 2]))
    low = int(np.argmin(swings))
    top, ground = (draw_swing(cycle, leg, f).text().splitlines() for f in (high, low))
    up = next(i for i, row in enumerate(top) if "□" in row)
    down = next(i for i, row in enumerate(ground) if "■" in row)
    assert up < down
    assert draw_swing(cycle, leg, high, ascii_only=True).text().isascii()
