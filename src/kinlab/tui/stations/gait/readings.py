"""What is read off a walk at an instant: lines of text, and the joints' speeds as bars."""

from collections.abc import Callable
from typing import Any

import numpy as np
from textual.content import Content

from kinlab.gait import Cycle
from kinlab.rig import Sample, Treadmill

Say = Callable[..., str]
EIGHTHS = ("", *"▏▎▍▌▋▊▉")
# The share of a servo's speed from which a joint is near its limit.
NEAR = 0.9


def walking(say: Say, cycle: Cycle, frame: int) -> list[str]:
    """Phase, how safely the robot stands, and which legs swing."""
    phase = cycle.phase(frame)
    least = min(found.static for found in cycle.least)
    return [
        say("facts.phase", number=phase.number, count=len(cycle.walk.gait.phases)),
        say("facts.margin", now=f"{cycle.state.static[frame] * 1000:.1f}", least=f"{least * 1000:.1f}"),
        say("facts.swing", legs=" ".join(phase.swing) or "-"),
    ]


def pace(say: Say, cycle: Cycle, frame: int) -> list[str]:
    """The instant, the stride, and the joint that is nearest to its limit."""
    walk, limits = cycle.walk, cycle.limits
    leg, joint = limits.tightest
    at = (frame + 0.5) / len(cycle) * walk.period
    said = [say("facts.time", t=f"{at:.2f}", period=f"{walk.period:.2f}")]
    if limits.model is None:
        said.append(say("facts.fastest_joint", leg=leg, joint=joint, speed=f"{np.degrees(limits.speed):.0f}"))
    else:
        said.append(
            say("facts.tightest", leg=leg, joint=joint, used=f"{limits.used:.0%}", model=limits.model)
        )
    return said


def costs(say: Say, mill: Treadmill, sample: Sample) -> list[str]:
    """What the rig measures."""
    said = [
        say(
            "facts.supply",
            volts=f"{sample.voltage:.1f}",
            amps=f"{sample.current:.2f}",
            watts=f"{sample.power:.1f}",
        ),
        say("facts.energy", wh=f"{sample.energy:.4f}", t=f"{sample.t:.1f}"),
    ]
    if mill.per_metre is not None:
        said.append(say("facts.per_metre", wh=f"{mill.per_metre:.3f}"))
    return said


def joint_speeds(
    say: Say, cycle: Cycle, frame: int, sample: Sample | None, width: int, ascii_only: bool
) -> Content:
    """How fast each joint has to turn now, as bars against the speed of its servo without load.

    Legs are rows; where a leg has many joints they are rows, and the legs columns. Where no servo is
    known the numbers are deg/s, and the bars full at the cycle's fastest joint.
    """
    legs = cycle.walk.robot.legs
    joints = legs[0].joint_names
    known = bool(np.isfinite(cycle.limits.allowed).all())
    speeds = np.abs(cycle.rates[frame])
    shares = cycle.used[frame] if known else speeds / max(float(np.abs(cycle.rates).max()), 1e-12)
    numbers = 100 * shares if known else np.degrees(speeds)
    peaks = cycle.used.max(axis=0) * 100 if known else np.degrees(np.abs(cycle.rates).max(axis=0))
    measured = None
    if sample is not None and known:
        measured = 100 * np.abs(sample.reading.velocity.reshape(speeds.shape)) / cycle.limits.allowed
    rows, columns = [leg.name for leg in legs], list(joints)
    tables: list[Any] = [shares, numbers, peaks, measured]
    if len(joints) > len(legs):
        rows, columns = columns, rows
        tables = [None if table is None else table.T for table in tables]
    shares, numbers, peaks, measured = tables
    head = max(map(len, rows)) + 1
    cell = max((width - head) // len(columns), 9)
    with_measured = measured is not None and cell >= 15
    length = max(cell - (14 if with_measured else 9), 0)
    heading = "measured" if with_measured else "known" if known else "unknown"
    lines = [
        Content.styled(say(f"joints.{heading}"), "$quiet"),
        Content.assemble(" " * head, *((f"{name[: cell - 1]:<{cell}}", "$quiet") for name in columns)),
    ]
    for i, name in enumerate(rows):
        pieces: list[Any] = [f"{name:<{head}}"]
        for j in range(len(columns)):
            bar = _bar(float(shares[i][j]), length, ascii_only)
            colour = "$vermillion" if shares[i][j] > NEAR else "$sky"
            text = f"{numbers[i][j]:3.0f}"
            if with_measured:
                value = float(measured[i][j])
                text += f" {value:4.0f}" if value == value else "    ?"
            pieces += [(bar, f"{colour} on $panel"), text, (f"/{peaks[i][j]:<3.0f} ", "$quiet")]
        lines.append(Content.assemble(*pieces))
    return Content("\n").join(lines)


def _bar(share: float, length: int, ascii_only: bool) -> str:
    """A bar of so many characters, filled to an eighth of one."""
    eighths = round(min(max(share, 0.0), 1.0) * length * 8)
    if ascii_only:
        return f"{'#' * round(eighths / 8):.<{length}}"
    return f"{'█' * (eighths // 8) + EIGHTHS[eighths % 8]:<{length}}"
