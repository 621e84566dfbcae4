"""The arm's experiments: what was asked for, what it did, who pushed, and what went over the bus."""

import numpy as np

from kinlab.dynamixel.bus import packets
from kinlab.kinematics.transforms import Array
from kinlab.papers.receptionist_experiments import Outcome
from kinlab.rig.arm import Push, Record
from kinlab.robots import Robot
from kinlab.robots.body import resting
from kinlab.scene import blueprints, colours
from kinlab.scene.bus import BUS, log_packets
from kinlab.scene.recording import Recording, Times, part
from kinlab.scene.tree import WORLD, Tree, stood
from kinlab.units import to_mm

# How long a force is drawn.
MM_PER_NEWTON = 15.0


def arm_scene(robot: Robot, outcome: Outcome, *, frames: bool = False) -> Recording:
    """An experiment, each of its runs with entities of its own.

    Args:
        frames: every frame of the robot as three arrows.
    """
    recording = Recording(f"{robot.name} {outcome.title}")
    recording.keep()
    talked = any(record.packets for record in outcome.runs.values())
    places = {name: _places(record) for name, record in outcome.runs.items()}
    recording.stream.send_blueprint(blueprints.arm(places, talked))
    for name, record in outcome.runs.items():
        _run(recording, robot, name, record, frames)
    return recording


def _places(record: Record) -> Array:
    """Where the arm's joints and hand came (k, 3), body frame, metres."""
    frames = record.limb.frames(record.angles["real"])[..., :3, 3]
    return record.limb.from_limb(frames, "body").reshape(-1, 3)


def _run(recording: Recording, robot: Robot, name: str, record: Record, frames: bool) -> None:
    rr, limb = recording.rr, record.limb
    times, real, command = Times(record.t), record.angles["real"], record.angles["command"]
    tree = Tree(recording, robot, f"{name}/{WORLD}")
    tree.draw(limb, frames)
    recording.pose(tree.body, stood(robot))
    tree.poses({other: q for other, q in resting(robot).items() if other != limb.name})
    tree.pose(limb, real, times)
    tree.draw_limb(limb, ghost="command", colour=colours.TARGET)
    tree.pose(limb, command, times, ghost="command")
    home = tree.limb(limb)
    wanted = rr.LineStrips3D([to_mm(record.track.points)], radii=tree.thick / 8, colors=colours.TARGET)
    recording.still(tree.beside(home, "line"), wanted)
    hands = to_mm(np.stack([limb.fk(q)[:, :3, 3] for q in (real, command)], axis=1))
    trail = rr.LineStrips3D([hands[:, 0]], radii=tree.thick / 8, colors=colours.LINKS[2])
    recording.still(tree.beside(home, "trail"), trail)
    look = rr.LineStrips3D.from_fields(radii=tree.thick / 5, colors=colours.ERROR)
    path = tree.beside(home, "error")
    recording.still(path, look)
    recording.over(path, times, rr.LineStrips3D, strips=hands)
    for number, push in enumerate(record.pushes, 1):
        _push(tree, tree.beside(home, f"push_{number}"), record, push, times)
    _curves(recording, name, record, times)
    off = np.linalg.norm(hands[:, 0] - hands[:, 1], axis=-1)
    recording.series(f"{name}/off", times, off[:, None], ["hand"])
    heard = list(packets(record.packets))
    at = np.array([packet.at - record.began for packet in heard])
    log_packets(recording, robot, heard, Times(at), f"{name}/{BUS}")


def _push(tree: Tree, path: str, record: Record, push: Push, times: Times) -> None:
    """The force as an arrow whose point is where it acts; no arrow while it does not."""
    limb, rr = record.limb, tree.recording.rr
    acts = np.array([push.acts(t) for t in record.t])
    force = MM_PER_NEWTON * np.array(push.force)
    ends = to_mm(limb.frames(record.angles["real"])[:, push.contact(limb).link + 1, :3, 3])[acts]
    label = f"push of {np.linalg.norm(push.force):g} N at {push.at}"
    look = rr.Arrows3D.from_fields(radii=tree.thick / 2, colors=colours.FORCE, labels=label)
    tree.recording.still(path, look)
    vectors = np.tile(force, (len(ends), 1))
    tree.recording.over(path, times, rr.Arrows3D, acts.astype(int), origins=ends - force, vectors=vectors)


def _curves(recording: Recording, name: str, record: Record, times: Times) -> None:
    joints = record.limb.joint_names
    recording.series(f"{name}/error", times, np.degrees(record.error), list(joints))
    for group, kinds, scale in (
        ("angles", record.angles, 180 / np.pi),
        ("torques", record.torques, 1.0),
    ):
        known = {kind: values for kind, values in kinds.items() if np.isfinite(values).all()}
        for j, joint in enumerate(joints):
            values = np.stack([scale * v[:, j] for v in known.values()], axis=-1)
            path = f"{name}/{group}/" + part(joint)
            recording.series(path, times, values, [f"{joint} {kind}" for kind in known])
