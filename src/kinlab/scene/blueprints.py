"""Which views open, and how they are arranged: one blueprint for each subject."""

from typing import Any

import numpy as np

from kinlab.robots import Robot
from kinlab.scene.bus import BUS
from kinlab.scene.recording import TIME, load_rerun
from kinlab.scene.tree import WORLD, reach, stood
from kinlab.units import to_mm

ANSWER = "answer"


def _rrb() -> Any:
    return load_rerun().blueprint


def _space(
    robot: Robot, root: str = WORLD, name: str = "", growing: tuple[str, ...] = (), **more: Any
) -> Any:
    """A 3-D view of `robot` from the front right; of the entities `growing` all is shown that came until now."""
    rr, rrb = load_rerun(), _rrb()
    mounts = np.array([limb.mount[:3, 3] for limb in robot.limbs.values()])
    size = float(to_mm(reach(robot) + np.abs(mounts).max()))
    middle = to_mm(stood(robot)[:3, 3] * 0.5 + mounts.mean(axis=0) * 0.5)
    until_now = rrb.VisibleTimeRanges(
        timeline=TIME,
        start=rrb.TimeRangeBoundary.infinite(),
        end=rrb.TimeRangeBoundary.cursor_relative(seconds=0),
    )
    eye = rrb.EyeControls3D(
        position=middle + size * np.array([1.1, -1.3, 0.9]), look_target=middle, eye_up=(0, 0, 1), **more
    )
    return rrb.Spatial3DView(
        origin=f"/{root}",
        name=name or f"{robot.name} [mm]",
        eye_controls=eye,
        line_grid=rrb.LineGrid3D(spacing=50.0, stroke_width=0.5),
        overrides={path: [rr.LineStrips3D.from_fields().visualizer(), until_now] for path in growing},
    )


def _plot(origin: str, name: str, contents: str = "$origin/**") -> Any:
    return _rrb().TimeSeriesView(origin=origin, name=name, contents=contents)


def _blueprint(view: Any, timeline: str | None = TIME) -> Any:
    rrb = _rrb()
    panels = [rrb.TimePanel(timeline=timeline, state="collapsed")] if timeline else []
    return rrb.Blueprint(view, *panels, collapse_panels=True)


def leg(robot: Robot, answer: bool) -> Any:
    """A limb: the robot; beside it, where there is one, the answer in numbers."""
    rrb = _rrb()
    space = _space(robot)
    if not answer:
        return _blueprint(space, None)
    text = rrb.TextDocumentView(origin=f"/{ANSWER}", name="angles and errors")
    return _blueprint(rrb.Horizontal(space, text, column_shares=[3, 2]), None)


def bus(robot: Robot, *spaces: Any, path: str = BUS) -> Any:
    """A bus: its packets over the robot that they move, and the joints' angles."""
    rrb = _rrb()
    below = rrb.Horizontal(*(spaces or (_space(robot),)), _plot("/angles", "joint angles [deg]"))
    log = rrb.TextLogView(origin=f"/{path}", contents=f"/**/{BUS}", name="packets")
    return rrb.Vertical(log, below, name="bus")


def gait(robot: Robot) -> Any:
    """A gait as it is planned: the robot, who stands, angles, speeds and margins."""
    rrb = _rrb()
    curves = rrb.Vertical(
        rrb.StateTimelineView(origin="/legs", name="who stands"),
        _plot("/margins", "stability margins [mm]"),
        _plot("/angles", "joint angles [deg]"),
        _plot("/speeds", "joint speeds [deg/s]"),
    )
    return _blueprint(rrb.Horizontal(_walking(robot), curves, column_shares=[3, 2]))


def walk(robot: Robot, packets: bool) -> Any:
    """A walk that was measured: as the gait, with loads, energy and tracking error; the bus in a tab of its own."""
    rrb = _rrb()
    measured = rrb.Vertical(
        rrb.StateTimelineView(origin="/legs", name="who stands"),
        _plot("/tracking", "foot off its place [mm]"),
        _plot("/loads", "loads [% of stall torque]"),
        rrb.Tabs(
            _plot("/energy", "energy [Wh]"), _plot("/power", "power [W]"), _plot("/margins", "margins [mm]")
        ),
        rrb.Tabs(_plot("/angles", "joint angles [deg]"), _plot("/speeds", "joint speeds [deg/s]")),
    )
    whole = rrb.Horizontal(_walking(robot), measured, column_shares=[3, 2], name="walk")
    return _blueprint(rrb.Tabs(whole, bus(robot, _walking(robot))) if packets else whole)


def _walking(robot: Robot) -> Any:
    return _space(robot, growing=tuple(f"/{WORLD}/trails/{leg.name}" for leg in robot.legs))


def arm(robot: Robot, runs: tuple[str, ...], packets: bool) -> Any:
    """An arm: each run in a space of its own, over its angles and torques; the bus in a tab of its own."""
    rrb = _rrb()

    def space(run: str) -> Any:
        return _space(robot, f"{run}/{WORLD}", f"{run} [mm]")

    columns = [
        rrb.Vertical(
            space(run),
            _plot(f"/{run}/error", "command less real [deg]"),
            rrb.Tabs(
                _plot(f"/{run}/torques", "torques [N m]"),
                _plot(f"/{run}/angles", "joint angles [deg]"),
                _plot(f"/{run}/off", "hand off its place [mm]"),
            ),
            row_shares=[3, 2, 2],
        )
        for run in runs
    ]
    whole = rrb.Horizontal(*columns, name="arm")
    if not packets:
        return _blueprint(whole)
    log = rrb.TextLogView(origin="/", contents=[f"/{run}/{BUS}" for run in runs], name="packets")
    below = rrb.Horizontal(*(space(run) for run in runs))
    return _blueprint(rrb.Tabs(whole, rrb.Vertical(log, below, name="bus")))


def live(robot: Robot) -> Any:
    """A robot that is mirrored now."""
    rrb = _rrb()
    both = rrb.Horizontal(_space(robot), _plot("/angles", "joint angles [deg]"), column_shares=[3, 2])
    return rrb.Blueprint(
        both, rrb.TimePanel(timeline=TIME, state="collapsed", play_state="following"), collapse_panels=True
    )
