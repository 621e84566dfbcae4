"""Straight-line code says what the arrays say."""

import numpy as np
import pytest

from kinlab.dynamics import Contact, inverse_dynamics, mass_matrix
from kinlab.dynamics.straight_line import contact_equations, inverse_equations, motion_equations


def test_it_is_the_recursion_and_the_mass_matrix(chain, motion):
    n = chain.count
    inverse, equations = inverse_equations(chain), motion_equations(chain)
    torque, M = inverse_dynamics(chain, *motion), mass_matrix(chain, motion[0])
    still = inverse_dynamics(chain, motion[0], motion[1], np.zeros(n))
    for i, (q, qd, qdd) in enumerate(zip(*motion.tolist(), strict=True)):
        np.testing.assert_allclose(inverse(*q, *qd, *qdd), torque[i], atol=1e-12)
        found = equations(*q, *qd)
        np.testing.assert_allclose(np.reshape(found[: n * n], (n, n)), M[i], atol=1e-12)
        np.testing.assert_allclose(found[n * n :], still[i], atol=1e-12)


@pytest.mark.parametrize("at", [Contact(), Contact(1), Contact(2, (0.0, 0.0, -0.1))])
def test_a_push_has_the_torques_of_its_wrench(arm, at):
    push = contact_equations(arm, at)
    rng = np.random.default_rng(0)
    for q, force in rng.normal(size=(10, 2, 3)).tolist():
        rest = np.zeros(3)
        with_it = inverse_dynamics(arm, q, rest, rest, [*force, 0, 0, 0], at)
        expected = inverse_dynamics(arm, q, rest, rest) - with_it
        np.testing.assert_allclose(push(*q, *force), expected, atol=1e-14)
