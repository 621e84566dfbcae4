"""The curves of the arm's plots, and the lines that sum up what it does."""

from collections.abc import Callable

import numpy as np

from kinlab.canvas import Point
from kinlab.control import SecondOrder
from kinlab.rig.arm import Lab

Say = Callable[..., str]
# By plot: its unit, what a unit of the core is worth in it, and its columns; a minus turns a column round.
PLOTS: dict[str, tuple[str, float, tuple[str, ...]]] = {
    "position": ("deg", 180 / np.pi, ("command", "reference", "real")),
    "torque": ("N m", 1.0, ("load", "dynamic", "disturbance")),
    "estimate": ("N m", 1.0, ("-pushed", "external", "reaction")),
}
POINTS = 90  # of a curve


def curves(say: Say, lab: Lab, plot: str, joint: int) -> dict[str, list[Point]]:
    """The curves of one joint over the time that is kept, in the unit of the plot, by what they are called."""
    _, scale, columns = PLOTS[plot]
    every = max(len(lab.moments) // POINTS, 1)
    times = lab.times[::-every][::-1].tolist()
    found = {}
    for column in columns:
        name = column.removeprefix("-")
        values = lab.column(name)[::-every, joint][::-1] * (scale if name == column else -scale)
        found[say(f"curve.{name}")] = list(zip(times, values.tolist(), strict=True))
    return found


def facts(say: Say, lab: Lab) -> list[str]:
    """The instant, how far the arm is off, what pushes it, and what its gains make of it by the linear model."""
    said = [say("facts.time", t=f"{lab.moments[-1].t if lab.moments else 0:.2f}")]
    said.append(say("facts.off", off=f"{lab.off * 1000:.0f}"))
    kp, kv = lab.settings.gains
    if lab.settings.law != "none" and kp > 0:
        model = SecondOrder.of_position(kp, kv)
        said.append(say("facts.model", omega=f"{model.omega:.1f}", zeta=f"{model.zeta:.2f}"))
    return said
