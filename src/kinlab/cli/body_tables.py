"""What `kinlab body` prints for people."""

from typing import Any

from rich.text import Text

from kinlab.cli.printed import printed_table
from kinlab.cli.show import fixed, place, sentences, show, table
from kinlab.robots.body import Stand


def show_answer(answer: Stand, printed: Any, *, asked: bool) -> None:
    """Every leg's foot and joints; where asked for, the paper's feet beside them."""
    data = answer.to_json()
    heading = Text(answer.robot.name, style="bold")
    show(
        heading.append(
            f"   body moved by {place(data['xyz_mm'])} mm, turned by {place(data['rpy_deg'])} deg",
            style="not bold",
        )
    )
    joints = ", ".join(answer.robot.legs[0].joint_names)
    found = table("legs over fixed feet", "leg", ("foot", "mm"), f"{joints} [deg]", "servo commands")
    beyond = []
    for name, leg in data["legs"].items():
        foot = place(leg["foot_mm"], 2)
        if leg["reachable"]:
            commands = ", ".join("-" if c is None else str(c) for c in leg["commands"].values())
            angles = ", ".join(fixed(a, 2) for a in leg["angles_deg"].values())
            found.add_row(name, foot, angles, commands or "not printed")
        else:
            found.add_row(Text(name, style="bold red"), foot, "not reachable", "-")
            beyond.append((name, leg["reason"]))
    show("", found)
    if beyond:
        show("", sentences(*beyond))
    if not asked:
        return
    if printed is None:
        show("", "the paper prints no equations for the pose of the body")
        return
    shown = printed.to_json()
    beside = table(
        "where the paper's equations put the feet", "leg", ("printed foot", "mm"), ("off by", "mm")
    )
    for name, leg in shown["legs"].items():
        beside.add_row(name, place(leg["foot_mm"], 2), f"{leg['error_mm']:.3f}")
    show("", beside, "", printed_table(shown))
