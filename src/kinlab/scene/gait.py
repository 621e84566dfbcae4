"""A robot that walks: as planned, and as it was measured on its servos."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinlab.dynamixel.bus import Passage, packets
from kinlab.errors import UsageError
from kinlab.gait import Motion, Walk, stability
from kinlab.gait.limits import joint_rates
from kinlab.gait.stability import Stability
from kinlab.kinematics.transforms import Array
from kinlab.rig import Errand, WalkResult
from kinlab.robots import Limb
from kinlab.robots.body import resting
from kinlab.scene import blueprints, colours
from kinlab.scene.bus import log_packets
from kinlab.scene.recording import Recording, Times, part
from kinlab.scene.tree import WORLD, Tree
from kinlab.units import to_mm

# Every packet of a walk is kept, some 40 a tick: of so many ticks at most.
MOST_TICKS = 20_000
# Instants of a cycle, and cycles of a gait.
FRAMES, CYCLES = 100, 3


def gait_scene(
    walk: Walk,
    *,
    each: int = FRAMES,
    cycles: int = CYCLES,
    frames: bool = False,
    into: Recording | None = None,
) -> Recording:
    """A gait as it is planned: cycles of a walk that goes on for ever.

    Args:
        each: how many instants of each cycle.
        cycles: how many of these.
        frames: every frame of the robot as three arrows.
        into: a recording to fill; a new one where not given.
    """
    t = np.arange(each * cycles + 1) / each * walk.period
    motion, rates = walk.at(t), joint_rates(walk, t)
    recording = into or Recording(f"{walk.robot.name} {walk.gait.name}")
    recording.keep()
    recording.stream.send_blueprint(blueprints.gait(walk.robot, motion.body))
    times = Times(t, walk.phase(t))
    _walker(recording, motion, times, frames)
    for i, leg in enumerate(walk.robot.legs):
        _joints(recording, "angles", leg, times, np.degrees(motion.q[:, i]))
        _joints(recording, "speeds", leg, times, np.degrees(rates[:, i]))
    _stands(recording, stability(motion), times)
    return recording


def check_recordable(errand: Errand) -> None:
    """Refuse a walk too long to be recorded.

    Raises:
        UsageError: with the longest that there can be.
    """
    rate = errand.order.rate
    if errand.walk.duration * rate > MOST_TICKS:
        raise UsageError(
            f"a recording holds at most {MOST_TICKS / rate / 60:.1f} min at {rate:g} commands a second, and this walk "
            f"takes {errand.walk.duration / 60:.1f} min"
        )


def walk_scene(result: WalkResult, passages: Sequence[Passage] = ()) -> Recording:
    """A walk as it was measured, on the rig's own time.

    Args:
        passages: what went over the bus meanwhile; those from before the first step are left out.
    """
    record, walk = result.record, result.errand.walk
    robot, wiring = walk.robot, record.wiring
    plan = walk.at(record.way)
    times = Times(record.t, walk.phase(record.way))
    # The rig's limbs are the robot's legs, in their order.
    measured = replace(plan, q=record.q.reshape(plan.q.shape))
    began = record.samples[0].clock - record.samples[0].t
    heard = list(packets(passage for passage in passages if passage.at >= began))
    recording = Recording(f"{robot.name} {walk.gait.name} walk")
    recording.keep()
    recording.stream.send_blueprint(blueprints.walk(robot, plan.body, bool(heard)))
    _walker(recording, measured, times, False)
    curves = {
        "angles": wiring.by_limb(np.degrees(record.q)),
        "speeds": wiring.by_limb(np.degrees(record.velocity)),
        "loads": wiring.by_limb(100 * record.load),
    }
    for kind, limbs in curves.items():
        for name, values in limbs.items():
            _joints(recording, kind, robot.limbs[name], times, values)
    recording.series("tracking", times, to_mm(record.errors), [leg.name for leg in wiring.limbs])
    energy = np.array([[sample.energy, sample.power] for sample in record.samples])
    recording.series("energy", times, energy[:, :1], ["energy [Wh]"])
    recording.series("power", times, energy[:, 1:], ["power [W]"])
    _stands(recording, stability(plan), times)
    at = np.array([packet.at - began for packet in heard])
    ways = np.interp(at, record.t, record.way)
    log_packets(recording, robot, heard, Times(at, walk.phase(ways)))
    return recording


def _joints(recording: Recording, kind: str, limb: Limb, times: Times, values: Array) -> None:
    """Curves (F, n) of a limb's joints."""
    names = [f"{limb.name} {joint}" for joint in limb.joint_names]
    recording.series(f"{kind}/" + part(limb.name), times, values, names)


def _walker(recording: Recording, motion: Motion, times: Times, frames: bool) -> None:
    """The robot and its feet over the ground."""
    robot = motion.walk.robot
    tree = Tree(recording, robot)
    tree.draw(frames=frames)
    recording.pose(tree.body, motion.body, times)
    still = resting(robot)
    for leg in robot.legs:
        del still[leg.name]
    tree.poses(still)
    feet = motion.ground
    for i, leg in enumerate(robot.legs):
        tree.pose(leg, motion.q[:, i], times)
        _trail(tree, leg.name, feet[:, i], times)


def _trail(tree: Tree, name: str, foot: Array, times: Times) -> None:
    """The way of a foot (F, 3), metres, ground frame, piece by piece, so that it grows."""
    rec = tree.recording
    path = f"{WORLD}/trails/" + part(name)
    known = np.asarray(np.isfinite(foot).all(axis=-1))
    foot, times = to_mm(foot[known]), times.at(known)
    if len(foot) > 1:
        look = rec.rr.LineStrips3D.from_fields(radii=tree.thick / 8, colors=colours.TRAIL)
        rec.still(path, look)
        pieces = np.stack([foot[:-1], foot[1:]], axis=1)
        rec.over(path, times.at(np.arange(1, len(foot))), rec.rr.LineStrips3D, strips=pieces)


def _stands(recording: Recording, state: Stability, times: Times) -> None:
    """Who stands, on what polygon, with the mass where, and how safely."""
    rr, motion = recording.rr, state.motion
    thick = Tree(recording, motion.walk.robot).thick
    changes = np.flatnonzero(np.any(np.diff(state.down, axis=0, prepend=~state.down[:1]), axis=-1))
    corners = [to_mm(state.support(frame)) for frame in changes.tolist()]
    path = f"{WORLD}/support"
    recording.still(path, rr.LineStrips3D.from_fields(radii=thick / 4, colors=colours.SUPPORT))
    closed = [np.vstack([polygon, polygon[:1]]) for polygon in corners]
    recording.over(path, times.at(changes), rr.LineStrips3D, strips=closed)
    centre = to_mm(state.over_ground)
    path = f"{WORLD}/centre_of_mass"
    recording.still(path, rr.Arrows3D.from_fields(radii=thick / 4, colors=colours.MASS))
    recording.over(path, times, rr.Arrows3D, origins=centre, vectors=centre * [0.0, 0.0, -1.0])
    path = f"{WORLD}/zero_moment_point"
    recording.still(path, rr.Points3D.from_fields(radii=thick / 2, colors=colours.MOMENT))
    recording.over(path, times, rr.Points3D, positions=to_mm(state.zmp_over_ground))
    margins = to_mm(np.stack([state.static, state.energy, state.zmp_margin], axis=-1))
    names = ["centre of mass to edge", "energy to tip over", "zero moment point to edge"]
    recording.series("margins", times, margins, names)
    for i, leg in enumerate(motion.walk.robot.legs):
        down = state.down[:, i]
        changes = np.flatnonzero(np.diff(down, prepend=~down[0]))
        path = "legs/" + part(leg.name)
        lanes = rr.StateConfiguration(values=["stance", "swing"], colors=[colours.STANCE, colours.SWING])
        recording.still(path, lanes)
        states = ["stance" if down[row] else "swing" for row in changes]
        recording.over(path, times.at(changes), rr.StateChange, state=states)
