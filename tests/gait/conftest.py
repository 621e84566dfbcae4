"""Robots to walk with: those of KinLab, and one whose feet stand in two straight lines."""

import pytest

from kinlab.robots import Robot, load_robot

STRAIGHT = """
robots:
  straight:
    kind: hexapod
    legs:
      coxa: 20
      femur: 60
      tibia: 90
      joints: leg
      stance: [90, 0, -70]
      members:
        R1: {at: [80, -40, 0], turn: -90}
        R2: {at: [0, -40, 0], turn: -90}
        R3: {at: [-80, -40, 0], turn: -90}
        L1: {at: [80, 40, 0], turn: 90}
        L2: {at: [0, 40, 0], turn: 90}
        L3: {at: [-80, 40, 0], turn: 90}
"""


@pytest.fixture
def straight(tmp_path) -> Robot:
    """A hexapod whose feet stand on a pitch of 80 mm, 130 mm to each side: Song and Waldron's vehicle."""
    file = tmp_path / "straight.yaml"
    file.write_text(STRAIGHT)
    return load_robot("straight", file)
