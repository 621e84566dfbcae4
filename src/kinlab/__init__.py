"""KinLab: a robotics laboratory for the terminal.

In a notebook, metres and radians, arrays that broadcast over leading dimensions:

    import kinlab
    robot = kinlab.load_robot("xl430-hexapod")
    answer = robot.limbs["R1"].ik([0.075, 0.010, -0.046])
    robot.limbs["R1"].fk(answer.q)
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinlab.errors import KinlabError, UsageError
    from kinlab.robots import Joint, Limb, Robot, load_robot, load_robots

__version__ = "0.1.0"

__all__ = ["Joint", "KinlabError", "Limb", "Robot", "UsageError", "load_robot", "load_robots"]

_HOME = {"KinlabError": "kinlab.errors", "UsageError": "kinlab.errors"}


def __getattr__(name: str) -> Any:
    """Import on first use, so that `kinlab --help` does not pay for numpy."""
    if name not in __all__:
        raise AttributeError(f"module 'kinlab' has no attribute '{name}'")
    return getattr(import_module(_HOME.get(name, "kinlab.robots")), name)
