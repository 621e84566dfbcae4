"""Which views open, and how they are arranged: one blueprint for each subject."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.robots import Robot
from kinlab.robots.body import resting
from kinlab.scene.bus import BUS
from kinlab.scene.recording import PHASE, TIME, load_rerun, part
from kinlab.scene.tree import WORLD, stood
from kinlab.units import to_mm

ANSWER = "answer"


def _rrb() -> Any:
    return load_rerun().blueprint


def _space(around: Array, name: str, root: str = WORLD, growing: tuple[str, ...] = ()) -> Any:
    """A 3-D view of the entities under `root`, from the front right.

    Args:
        around: places (k, 3), metres, that shall be in the picture.
        growing: entities of which all is shown that came until now.
    """
    rr, rrb = load_rerun(), _rrb()
    low, high = to_mm(around.min(axis=0)), to_mm(around.max(axis=0))
    middle, size = (low + high) / 2, float(np.linalg.norm(high - low))
    first = rrb.TimeRangeBoundary.infinite()
    until_now = rrb.VisibleTimeRanges([
        rrb.VisibleTimeRange(TIME, start=first, end=rrb.TimeRangeBoundary.cursor_relative(seconds=0)),
        rrb.VisibleTimeRange(PHASE, start=first, end=rrb.TimeRangeBoundary.cursor_relative(seq=0)),
    ])  # fmt: skip
    eye = rrb.EyeControls3D(
        position=middle + size * np.array([0.62, -0.72, 0.5]), look_target=middle, eye_up=(0, 0, 1)
    )
    return rrb.Spatial3DView(
        origin=f"/{root}",
        name=f"{name} [mm]",
        eye_controls=eye,
        line_grid=rrb.LineGrid3D(spacing=50.0, stroke_width=0.5),
        overrides={path: [rr.LineStrips3D.from_fields().visualizer(), until_now] for path in growing},
    )


def _resting(robot: Robot) -> Array:
    """The joints and tips (k, 3) of a robot that stands or rests, metres, over the ground."""
    body = np.concatenate(
        [robot.limbs[name].mount @ robot.limbs[name].frames(q) for name, q in resting(robot).items()]
    )
    return np.asarray((stood(robot) @ body)[:, :3, 3])


def _walked(robot: Robot, body: Array) -> Array:
    """The same, wherever its body comes (F, 4, 4)."""
    rest, way = _resting(robot) - stood(robot)[:3, 3], body[:, :3, 3]
    return np.concatenate([rest + way.min(axis=0), rest + way.max(axis=0)])


def _plot(origin: str, name: str, legend: bool = False) -> Any:
    """Curves, their names beside them, or where they are pointed at."""
    rrb = _rrb()
    return rrb.TimeSeriesView(origin=origin, name=name, plot_legend=rrb.PlotLegend(visible=legend))


def _blueprint(view: Any, timeline: str | None = TIME) -> Any:
    rrb = _rrb()
    state = "collapsed" if timeline else "hidden"
    return rrb.Blueprint(view, rrb.TimePanel(timeline=timeline, state=state), collapse_panels=True)


def leg(robot: Robot, answer: bool, places: Iterable[Array] = ()) -> Any:
    """A limb: the robot; beside it, where there is one, the answer in numbers.

    Args:
        places: sets of them, each (k, 3), body frame, metres, that shall be in the picture too.
    """
    rrb = _rrb()
    space = _space(
        np.vstack([_resting(robot), *(stood(robot)[:3, 3] + place for place in places)]), robot.name
    )
    if not answer:
        return _blueprint(space, None)
    text = rrb.TextDocumentView(origin=f"/{ANSWER}", name="angles and errors")
    return _blueprint(rrb.Horizontal(space, text, column_shares=[3, 2]), None)


def bus(paths: list[str]) -> Any:
    """One bus, or several: their packets, line by line.

    A view that is not to be seen from the beginning, as in a tab, gets columns too narrow to be read.
    """
    rrb = _rrb()
    columns = rrb.TextLogColumns(text_log_columns=["entitypath", "body"] if len(paths) > 1 else ["body"])
    contents = [f"/{path}" for path in paths]
    return rrb.TextLogView(origin="/", contents=contents, name="packets", columns=columns)


def gait(robot: Robot, body: Array) -> Any:
    """A gait as it is planned: the robot, who stands, angles, speeds and margins."""
    rrb = _rrb()
    curves = rrb.Vertical(
        rrb.StateTimelineView(origin="/legs", name="who stands"),
        _plot("/margins", "stability margins [mm]", legend=True),
        _plot("/angles", "joint angles [deg]"),
        _plot("/speeds", "joint speeds [deg/s]"),
        row_shares=[_lanes(robot), 3, 2, 2],
    )
    return _blueprint(rrb.Horizontal(_walking(robot, body), curves, column_shares=[3, 2]))


def walk(robot: Robot, body: Array, packets: bool) -> Any:
    """A walk that was measured: as the gait, with loads, energy and tracking error, and the bus below the robot."""
    rrb = _rrb()
    measured = rrb.Vertical(
        rrb.StateTimelineView(origin="/legs", name="who stands"),
        _plot("/tracking", "foot off its place [mm]"),
        _plot("/loads", "loads [% of stall torque]"),
        rrb.Tabs(
            _plot("/energy", "energy [Wh]"),
            _plot("/power", "power [W]"),
            _plot("/margins", "stability margins [mm]", legend=True),
        ),
        rrb.Tabs(_plot("/angles", "joint angles [deg]"), _plot("/speeds", "joint speeds [deg/s]")),
        row_shares=[_lanes(robot), 2, 2, 2, 2],
    )
    space = _walking(robot, body)
    shown = rrb.Vertical(space, bus([BUS]), row_shares=[7, 3]) if packets else space
    return _blueprint(rrb.Horizontal(shown, measured, column_shares=[3, 2]))


def _lanes(robot: Robot) -> int:
    """The share of the height in which the lanes of all legs are seen, where a plot has 2."""
    return len(robot.legs) + 1


def _walking(robot: Robot, body: Array) -> Any:
    trails = tuple(f"/{WORLD}/trails/{part(leg.name)}" for leg in robot.legs)
    return _space(_walked(robot, body), robot.name, growing=trails)


def arm(runs: dict[str, Array], packets: bool) -> Any:
    """An arm: each run in a space of its own, over its angles and torques; the bus below.

    Args:
        runs: by name, where the arm came (k, 3), metres.
    """
    rrb = _rrb()
    columns = [
        rrb.Vertical(
            _space(runs[run], run, f"{run}/{WORLD}"),
            _plot(f"/{run}/error", "command less real [deg]", legend=True),
            rrb.Tabs(
                _plot(f"/{run}/torques", "torques [N m]"),
                _plot(f"/{run}/angles", "joint angles [deg]"),
                _plot(f"/{run}/off", "hand off its place [mm]"),
            ),
            row_shares=[4, 2, 2],
        )
        for run in runs
    ]
    shown = rrb.Horizontal(*columns)
    if packets:
        shown = rrb.Vertical(shown, bus([f"{run}/{BUS}" for run in runs]), row_shares=[4, 1])
    return _blueprint(shown)


def live(robot: Robot) -> Any:
    """A robot that is mirrored now."""
    rrb = _rrb()
    space = _space(_resting(robot), robot.name)
    both = rrb.Horizontal(space, _plot("/angles", "joint angles [deg]"), column_shares=[3, 2])
    return rrb.Blueprint(
        both, rrb.TimePanel(timeline=TIME, state="collapsed", play_state="following"), collapse_panels=True
    )
