"""The standby current of a servo model, in a robots file."""

import pytest

from kinlab.errors import FileError
from kinlab.robots import load_robot

SPIDER = """
servo_models:
  MY-1: {{protocol: "1.0", positions: [0, 1023], deg_per_step: 0.29, torque_nm: 1, speed_rpm: 60{standby}}}
robots:
  spider:
    kind: hexapod
    legs:
      coxa: 30
      femur: 60
      tibia: 90
      joints: leg
      mountings:
        side:
          coxa: {{model: MY-1, zero: 150, sign: 1}}
          femur: {{model: MY-1, zero: 150, sign: 1}}
          tibia: {{model: MY-1, zero: 150, sign: 1}}
      members:
        R1: {{at: [0, -40, 0], turn: -90, mounting: side, ids: [1, 2, 3]}}
"""


@pytest.fixture
def model(tmp_path):
    """The model of a file that says so much of its standby current."""

    def read(standby):
        path = tmp_path / "mine.yaml"
        path.write_text(SPIDER.format(standby=standby))
        return load_robot("spider", path).servos[0].model

    return read


@pytest.mark.parametrize(
    ("text", "amps", "kind"),
    [
        ("", None, "assumed"),
        (", standby: 40", 0.040, "assumed"),
        (', standby: {ma: 40, printed: "its manual"}', 0.040, "printed"),
    ],
)
def test_a_standby_current(model, text, amps, kind):
    found = model(text)
    assert found.standby == amps
    assert found.standby_source.kind == kind


@pytest.mark.parametrize(
    ("text", "word"),
    [
        (", standby: -1", "expected a current in mA, not below 0"),
        (", standby: much", "expected a current in mA"),
        (", standby: {ma: 1, printed: a, assumed: b}", "printed and assumed"),
        (", standby: {mA: 1}", "no such field; did you mean ma"),
    ],
)
def test_a_standby_current_that_is_none(model, text, word):
    with pytest.raises(FileError, match=word):
        model(text)


def test_ours_have_their_sources():
    models = {
        s.model.name: s.model for name in ("krsri-hexapod", "xl430-hexapod") for s in load_robot(name).servos
    }
    assert {name: m.standby_source.kind for name, m in models.items()} == {
        "AX-12A": "assumed",
        "XL430-W250": "printed",
        "2XL430-W250": "inferred",
    }
