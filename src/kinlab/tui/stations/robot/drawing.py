"""What stands in a view: the limb as it is sent on, and beside it what else is to be seen."""

from kinlab.canvas import Canvas
from kinlab.kinematics.transforms import Array
from kinlab.papers.path import angles_of
from kinlab.robots.views import Drawn, View, draw_view
from kinlab.tui.stations.robot.asking import Answer


def draw(
    answer: Answer,
    seen: View,
    columns: int,
    rows: int,
    *,
    stood: Array | None,
    printed: str,
    limits: bool,
    ascii_only: bool,
) -> Canvas:
    """The answer in one of its views.

    Args:
        seen: the view.
        columns, rows: of the picture.
        stood: where the limb stands (n,), rad, while its target is out of reach.
        printed: what the pose of the printed equations is called; empty where it is not to be drawn.
        limits: whether those of the joints are marked.
        ascii_only: without braille.
    """
    path = answer.path
    others = [pose.q for pose in path.answer.poses if pose is not path.pose]
    if not others and path.pose is None and stood is not None:
        others = [stood]
    beside = [Drawn(q, "", "other") for q in others[:1]]
    for variant in path.printed if printed else ():
        q = angles_of(variant, path.answer.limb)
        if q is not None:
            beside.append(Drawn(q, printed, "printed"))
    return draw_view(
        seen, None if path.pose is None else path.pose.q, path.answer.target,
        beside=beside, nearest=path.answer.nearest, limits=limits,
        columns=columns, rows=rows, ascii_only=ascii_only,
    )  # fmt: skip
