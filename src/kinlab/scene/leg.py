"""A robot as it stands, and a limb with its target: all solutions, what the paper's print gives, and the errors."""

from collections.abc import Iterable

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.papers import AsPrinted
from kinlab.robots import Limb, Robot
from kinlab.robots.body import resting
from kinlab.robots.inverse import nearest_pose
from kinlab.robots.target import TargetReport, angles_deg
from kinlab.robots.workspace import reached
from kinlab.scene import blueprints, colours
from kinlab.scene.recording import Recording
from kinlab.scene.tree import Tree, stood
from kinlab.units import to_mm

# Poses that a cloud is tried with.
CLOUD = 6000


def robot_scene(
    robot: Robot, limb: Limb | None = None, *, frames: bool = False, workspace: bool = False
) -> Recording:
    """A robot that stands, or rests.

    Args:
        limb: whose links have their names beside them.
        frames: every frame as three arrows.
        workspace: what `limb`, or every limb, reaches, as a cloud.
    """
    which = [limb] if limb else list(robot.limbs.values())
    clouds = {each.name: reached(each, CLOUD) for each in which} if workspace else {}
    around = [robot.limbs[name].from_limb(cloud, "body") for name, cloud in clouds.items()]
    recording = Recording(robot.name)
    recording.keep()
    recording.stream.send_blueprint(blueprints.leg(robot, False, around))
    tree = Tree(recording, robot)
    tree.draw(limb, frames)
    recording.pose(tree.body, stood(robot))
    tree.poses(resting(robot))
    for name, cloud in clouds.items():
        _cloud(tree, robot.limbs[name], cloud)
    return recording


def target_scene(
    answer: TargetReport,
    printed: Iterable[AsPrinted] = (),
    *,
    frames: bool = False,
    workspace: bool = False,
) -> Recording:
    """A limb at its target, or where it comes nearest; its other solutions and the printed ones as ghosts.

    Args:
        printed: what the paper's equations give for the same target.
        frames, workspace: as `robot_scene`.
    """
    robot, limb, printed = answer.robot, answer.limb, list(printed)
    cloud = reached(limb, CLOUD) if workspace else np.empty((0, 3))
    tips = [variant.tip for variant in printed if variant.tip is not None]
    around = limb.from_limb(np.vstack([answer.target, *tips, cloud]), "body")
    recording = Recording(f"{robot.name} {limb.name}")
    recording.keep()
    recording.stream.send_blueprint(blueprints.leg(robot, True, [around]))
    tree = Tree(recording, robot)
    tree.draw(limb, frames)
    recording.pose(tree.body, stood(robot))
    q = _shown(answer)
    tree.poses(resting(robot) | ({} if q is None else {limb.name: q}))
    home = tree.limb(limb)
    path = tree.beside(home, "target")
    recording.points(path, answer.target, radii=1.5 * tree.thick, colors=colours.TARGET, labels="target")
    if q is not None:
        _error(tree, home, limb.fk(q)[:3, 3], answer.target, "")
    for pose in answer.poses:
        if pose.q is not q:
            tree.draw_limb(limb, ghost=pose.name)
            tree.pose(limb, pose.q, ghost=pose.name)
    for variant in printed:
        if variant.angles is not None and variant.tip is not None:
            ghost = f"printed {variant.variant}"
            tree.draw_limb(limb, ghost=ghost, colour=colours.ERROR)
            tree.pose(limb, [variant.angles[name] for name in limb.joint_names], ghost=ghost)
            _error(tree, tree.limb(limb, ghost), variant.tip, answer.target, f"{ghost}: ")
    if workspace:
        _cloud(tree, limb, cloud)
    rr = recording.rr
    recording.still(blueprints.ANSWER, rr.TextDocument(_told(answer, q, printed), media_type="text/markdown"))
    return recording


def _shown(answer: TargetReport) -> Array | None:
    """The angles of the limb (n,): the chosen ones; else those that bring it nearest; else any."""
    if answer.chosen is not None:
        return answer.poses[answer.chosen].q
    if answer.nearest is not None:
        return nearest_pose(answer.limb, answer.target)
    return answer.poses[0].q if answer.poses else None


def _error(tree: Tree, home: str, tip: Array, target: Array, name: str) -> None:
    off = float(np.linalg.norm(tip - target))
    line = tree.recording.rr.LineStrips3D(
        [to_mm([tip, target])], radii=tree.thick / 4, colors=colours.ERROR,
        labels=f"{name}{off * 1000:.3g} mm off", show_labels=off > 1e-6,
    )  # fmt: skip
    tree.recording.still(tree.beside(home, "error"), line)


def _cloud(tree: Tree, limb: Limb, places: Array) -> None:
    path = tree.beside(tree.limb(limb), "workspace")
    tree.recording.points(path, places, radii=tree.thick / 8, colors=colours.CLOUD)


def _told(answer: TargetReport, shown: Array | None, printed: Iterable[AsPrinted]) -> str:
    """The answer in numbers, as Markdown; the angles `shown` (n,) are those of the limb."""
    limb = answer.limb
    lines = [f"# {answer.robot.name} {limb.name}", "", f"Target ({_place(answer, answer.target)}) mm in the "]
    lines[-1] += f"{answer.frame} frame."
    if answer.chosen is None:
        lines += ["", f"**Not reached: {answer.reason}.**"]
    if answer.nearest is not None and answer.missed_mm < 1e-6:
        lines += ["", "With its attitude left free, the tip reaches the place."]
    elif answer.nearest is not None:
        lines += ["", f"Nearest place ({_place(answer, answer.nearest)}) mm, {answer.missed_mm:.3f} mm away."]
    rows = [
        _row(f"**{pose.name}**" if i == answer.chosen else pose.name, limb, pose.q, pose.error_m)
        for i, pose in enumerate(answer.poses)
    ]
    if answer.nearest is not None and shown is not None:
        rows.append(_row("**nearest**", limb, shown, answer.missed_mm / 1000))
    for variant in printed:
        if variant.angles is not None and variant.error_m is not None:
            q = np.array([variant.angles[name] for name in limb.joint_names])
            rows.append(_row(f"printed {variant.variant}", limb, q, variant.error_m))
    if rows:
        head = ["", "off", *limb.joint_names]
        lines += ["", f"| {' | '.join(head)} |", "|" + "---|" * len(head), *rows]
    notes = [f"- printed {variant.variant}: {variant.note}" for variant in printed]
    return "\n".join([*lines, "", "Angles in deg, distances of the tip from the target in mm.", "", *notes])


def _row(name: str, limb: Limb, q: Array, error_m: float) -> str:
    angles = " | ".join(f"{round(angle, 3) + 0.0:.3f}" for angle in angles_deg(limb, q).values())
    return f"| {name} | {error_m * 1000:.4f} | {angles} |"


def _place(answer: TargetReport, point: Array) -> str:
    return ", ".join(f"{v:g}" for v in answer.place_mm(point))
