"""Which robots lessons speak of."""

import pytest

from kinlab.errors import UsageError
from kinlab.lessons.answers.leg import lengths
from kinlab.lessons.robots import load_robot

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


def test_a_robot_that_nobody_has_is_refused_with_the_nearest_names():
    with pytest.raises(UsageError, match="did you mean krsri-hexapod"):
        load_robot("krsri-hexapot")
