"""What a servo can stands in robots.yaml and in the control tables' list of models: the two agree."""

import re

import numpy as np
import pytest

from kinlab.dynamixel.tables import load_table
from kinlab.robots import load_robot

MODELS = {
    servo.model.name: servo.model
    for robot in ("krsri-hexapod", "xl430-hexapod", "receptionist-arm")
    for servo in load_robot(robot).servos
}


@pytest.mark.parametrize("model", MODELS.values(), ids=MODELS)
def test_a_robots_servo_is_the_one_that_is_emulated(model):
    table = load_table(model.name)
    volts = float(re.search(r"at ([\d.]+) V", model.source.text)[1])
    assert (int(float(model.protocol)), model.deg_per_step) == (table.protocol, table.step_deg)
    assert model.highest - model.lowest + 1 == {1: 1024, 2: 4096}[table.protocol]
    # The manual rounds the figures of each voltage.
    np.testing.assert_allclose(model.torque / volts, table.stall_nm / table.rated_v, rtol=0.02)
    np.testing.assert_allclose(model.speed / volts, table.no_load_rpm * np.pi / 30 / table.rated_v, rtol=0.02)
