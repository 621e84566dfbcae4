"""Which robots and gaits lessons speak of."""

from fractions import Fraction

import pytest

from kinlab.errors import UsageError
from kinlab.lessons.answers.leg import lengths
from kinlab.lessons.robots import find_gait, load_robot

MINE = """
robots:
  {name}:
    arm:
      shoulder: 100
      joints:
        - {{name: shoulder, axis: z, link: {{x: shoulder}}}}
      members:
        arm: {{at: [0, 0, 0]}}
"""

# Five legs stand, in the gait of three: the name alone is the same.
MY_TRIPOD = """
gaits:
  tripod:
    kind: hexapod
    duty: 5/6
    touchdown: {L1: 0, L2: 1/6, L3: 2/6, R1: 3/6, R2: 4/6, R3: 5/6}
  strut:
    kind: hexapod
    duty: 5/6
    touchdown: {L1: 0, L2: 1/6, L3: 2/6, R1: 3/6, R2: 4/6, R3: 5/6}
"""


@pytest.fixture
def mine(tmp_path, monkeypatch):
    def write(name):
        path = tmp_path / "mine.yaml"
        path.write_text(MINE.format(name=name))
        monkeypatch.setenv("KINLAB_ROBOTS", str(path))

    return write


def test_a_robots_file_that_replaces_one_of_ours_changes_no_answer(mine):
    before = lengths("xl430-hexapod")
    mine("xl430-hexapod")
    assert lengths("xl430-hexapod") == before


def test_a_lesson_of_ones_own_may_speak_of_a_robot_of_ones_own(mine):
    mine("turntable")
    assert list(load_robot("turntable").limbs) == ["arm"]


def test_a_gait_of_ours_is_the_same_though_a_robots_file_replaces_it(tmp_path, monkeypatch):
    path = tmp_path / "mine.yaml"
    path.write_text(MY_TRIPOD)
    monkeypatch.setenv("KINLAB_ROBOTS", str(path))
    robot = load_robot("krsri-hexapod")
    assert find_gait(robot, "tripod").duty == Fraction(1, 2)
    assert find_gait(robot, "strut").duty == Fraction(5, 6)
    with pytest.raises(UsageError, match="tripot"):
        find_gait(robot, "tripot")


def test_a_robot_that_nobody_has_is_refused_with_the_nearest_names():
    with pytest.raises(UsageError, match="did you mean krsri-hexapod"):
        load_robot("krsri-hexapot")
