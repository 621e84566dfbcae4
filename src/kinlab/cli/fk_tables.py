"""What `kinlab fk` prints for people."""

from typing import Any

from rich.table import Table
from rich.text import Text

from kinlab.cli.printed import printed_table
from kinlab.cli.show import drawing, fixed, number, place, show, table
from kinlab.robots.tip import PoseOfTip


def show_answer(answer: PoseOfTip, *, dh: bool, jacobian: bool, printed: Any) -> None:
    """Place, attitude, and what was asked for beside them."""
    found = answer.to_json(jacobian=jacobian)
    heading = Text(f"{answer.robot.name} {answer.limb.name}", style="bold")
    show(
        heading.append(
            f"   tip at {place(found['position_mm'])} mm in the {answer.frame} frame", style="not bold"
        )
    )
    if answer.outside:
        show(Text(f"beyond the limits: {'; '.join(answer.outside)}", style="bold red"))
    attitude = table("attitude of the tip", ("x", ""), ("y", ""), ("z", ""))
    for row in found["rotation"]:
        attitude.add_row(*(fixed(v, 6) for v in row))
    show("", attitude)
    if jacobian:
        show("", _jacobian(answer))
    if dh:
        show("", _dh(answer))
    if printed is not None:
        for variant in printed:
            show("", printed_table(variant.to_json(answer.limb, answer.frame)))
        if not printed:
            show("", "the paper prints no forward kinematics for this limb")
    show("", drawing(answer.limb, answer.q, None))


def _jacobian(answer: PoseOfTip) -> Table:
    found = table(
        f"Jacobian, v in m/rad and w in rad/rad; manipulability {answer.manipulability:.4g}",
        "row",
        *((j, "") for j in answer.limb.joint_names),
    )
    names = [f"v{a}" for a in "xyz"] + [f"w{a}" for a in "xyz"]
    for name, row in zip(names, answer.jacobian, strict=True):
        found.add_row(name, *(fixed(v, 6) for v in row))
    return found


def _dh(answer: PoseOfTip) -> Table:
    found = table(
        "Denavit-Hartenberg parameters, T = Rz(q + theta) Tz(d) Tx(a) Rx(alpha)",
        "joint",
        ("theta", "deg"),
        ("d", "mm"),
        ("a", "mm"),
        ("alpha", "deg"),
    )
    for row in answer.dh_json()["joints"]:
        found.add_row(row["joint"], *(number(row[key]) for key in ("theta_deg", "d_mm", "a_mm", "alpha_deg")))
    return found
