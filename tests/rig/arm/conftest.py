import numpy as np
import pytest

import kinlab
from kinlab.kinematics.profile import PROFILES
from kinlab.kinematics.resolved_motion import follow, straight_line
from kinlab.rig.arm import ArmServos

START = np.radians([45.0, 0.0, 147.5])


@pytest.fixture(scope="session")
def robot():
    return kinlab.load_robot("receptionist-arm")


@pytest.fixture(scope="session")
def limb(robot):
    return robot.limb()


@pytest.fixture(scope="session")
def line(limb):
    """The paper's 20 cm forwards, one cycle a step."""
    tip = limb.fk(START)[:3, 3]
    _, points = straight_line(tip, tip + np.array([0.2, 0, 0]), PROFILES["steps"], 1.28, 0.016)
    return follow(limb.axes, limb.links, START, points, 0.016)


@pytest.fixture(scope="session")
def stay(limb):
    """Two seconds at a pose away from limits and singularities."""
    q = np.array([0.5, 0.2, 1.0])
    return follow(limb.axes, limb.links, q, np.tile(limb.fk(q)[:3, 3], (125, 1)), 0.016)


@pytest.fixture
def arm_at(robot, limb):
    """An emulated arm at the first point of a track."""
    return lambda track, *pushes, **more: ArmServos.emulated(robot, limb, track.q[0].tolist(), pushes, **more)
