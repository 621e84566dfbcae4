"""Friction of joints: it resists motion, holds what rests, and never pushes."""

import numpy as np
import pytest

from kinlab.dynamics import Friction
from kinlab.errors import UsageError

FRICTION = Friction(coulomb=0.05, viscous=0.2, static=0.08)


def test_in_motion_it_is_dry_and_viscous_whatever_drives():
    np.testing.assert_allclose(FRICTION.torque([2.0, -2.0], [9.0, 0.0]), [0.45, -0.45])


def test_at_rest_it_equals_the_drive_up_to_its_limit():
    np.testing.assert_allclose(
        FRICTION.torque(0.0, [0.0, 0.03, -0.08, 0.5, -0.5]), [0, 0.03, -0.08, 0.08, -0.08]
    )


def test_it_takes_energy_and_never_gives_any():
    rng = np.random.default_rng(0)
    qd, drive = rng.normal(size=(2, 1000))
    assert (FRICTION.torque(qd, drive) * qd >= 0).all()


@pytest.mark.parametrize(
    "wrong", [{"coulomb": 0.2, "static": 0.1}, {"viscous": -1.0}, {"coulomb": np.nan}, {"static": np.inf}]
)
def test_friction_that_cannot_be_is_refused(wrong):
    with pytest.raises(UsageError, match="friction must be finite"):
        Friction(**wrong)
