"""A hexapod on an emulated chain in simulated time, and short walks of it."""

from collections.abc import Callable

import pytest

from kinlab.gait import find_gait
from kinlab.rig import Errand, Order, Record, Rig, prepare, walk_on
from kinlab.robots import Robot, load_robot


@pytest.fixture(scope="session")
def krsri() -> Robot:
    """Eighteen AX-12A."""
    return load_robot("krsri-hexapod")


@pytest.fixture
def errand(krsri) -> Callable[..., Errand]:
    """An order of a short walk, in mm and mm/s."""

    def make(gait: str = "tripod", speed: float = 40, distance: float = 60, rate: float = 50, robot=krsri):
        return prepare(Order(robot, find_gait(robot, gait), speed / 1000, 0.0, distance / 1000, rate))

    return make


@pytest.fixture
def walked() -> Callable[..., Record]:
    """What a rig measures on an errand; `meddle` may do something to the rig before."""

    def walk(errand: Errand, meddle: Callable[[Rig], None] = lambda rig: None) -> Record:
        with Rig.open(errand.order.robot) as rig:
            meddle(rig)
            return Record(rig.wiring, list(walk_on(rig, errand)))

    return walk
