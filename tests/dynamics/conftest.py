import numpy as np
import pytest

import kinlab
from kinlab.dynamics import Mechanism


@pytest.fixture(scope="session")
def arm():
    return Mechanism.of(kinlab.load_robot("receptionist-arm").limb())


def random_mechanism(seed, joints, sliding):
    """Skew axes, masses off the links, full inertias, a tilted base: nothing that could hide a wrong term."""
    rng = np.random.default_rng(seed)
    axes = rng.normal(size=(joints, 3))
    factors = rng.normal(size=(joints, 3, 3))
    return Mechanism(
        axes=axes / np.linalg.norm(axes, axis=1, keepdims=True),
        links=rng.uniform(-0.3, 0.3, (joints, 3)),
        mass=rng.uniform(0.1, 1, joints),
        centres=rng.uniform(-0.1, 0.1, (joints, 3)),
        inertia=1e-3 * factors @ np.swapaxes(factors, 1, 2) + 1e-2 * np.eye(3),
        slides=tuple(i in sliding for i in range(joints)),
        gravity=rng.normal(size=3) * 5,
    )


@pytest.fixture(
    params=[(1, ()), (1, (0,)), (2, (1,)), (3, ()), (4, (0, 2)), (6, ()), (6, (1, 2, 5))],
    ids=lambda p: f"{p[0]} joints, sliding {p[1]}",
)
def chain(request):
    joints, sliding = request.param
    return random_mechanism(joints, joints, sliding)


@pytest.fixture
def motion(chain):
    """Positions, rates and accelerations of 30 states."""
    return np.random.default_rng(7).normal(size=(3, 30, chain.count))
