"""What `kinlab robots` prints for people."""

from typing import Any

from rich.table import Table
from rich.text import Text

from kinlab.cli.show import number, place, sentences, show, table
from kinlab.robots import Robot
from kinlab.robots.describe import describe

SOURCE_STYLES = {"printed": "green", "inferred": "yellow", "assumed": "magenta"}


class Footnotes:
    """Reasons as numbered notes, so that a table stays narrow and a reason that serves often stands once."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.starred = ""

    def mark(self, data: dict[str, Any]) -> Text:
        """`printed 3` for a figure's source; the note itself stands below."""
        if data["why"] not in self.texts:
            self.texts.append(data["why"])
        return Text(
            f"{data['source']} {self.texts.index(data['why']) + 1}", style=SOURCE_STYLES[data["source"]]
        )


def show_list(robots: list[Robot]) -> None:
    """Two lines a robot."""
    found = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=False)
    for robot in robots:
        models = sorted({servo.model.name for servo in robot.servos})
        joints = sum(len(limb.joints) for limb in robot.limbs.values())
        servos = " and ".join(models) or "servos not printed"
        facts = f"{robot.kind}, {joints} joints: {', '.join(robot.limbs)}; {servos}"
        found.add_row(Text(robot.name, style="bold"), f"{robot.title}\n{facts}")
    show(found)
    show("", "One of them in full: kinlab robots NAME")


def show_robot(robot: Robot) -> None:
    """Everything about one robot. Limbs of a group share their tables."""
    data = describe(robot)
    notes = Footnotes()
    show(Text(robot.name, style="bold").append(f"   {robot.title}", style="not bold"))
    if robot.paper:
        show(f"from the paper {robot.paper}")
    show(sentences(*(("-", note) for note in robot.notes)))
    if data["body"]:
        show("", _figures("body", data["body"], notes))
    groups: dict[str, list[dict[str, Any]]] = {}
    for limb in data["limbs"]:
        groups.setdefault(limb["group"], []).append(limb)
    for name, limbs in groups.items():
        show("", _figures(f"{name}: lengths", limbs[0]["lengths"], notes))
        show("", _joints(name, limbs[0], notes))
        show("", _places(name, limbs, notes))
        if limbs[0]["joints"][0]["servo"]:
            show("", _servos(name, limbs, notes))
    show("", Text("where from, and why", style="italic"))
    show(sentences(*((str(i), text) for i, text in enumerate(notes.texts, 1))))
    if notes.starred:
        show(sentences(("*", notes.starred)))


def _figures(title: str, figures: list[dict[str, Any]], notes: Footnotes) -> Table:
    found = table(title, "figure", ("value", ""), "source")
    for figure in figures:
        value = figure["value"]
        shown = place(value) if isinstance(value, list) else number(value)
        found.add_row(figure["name"], f"{shown} {figure['unit']}", notes.mark(figure))
    return found


def _joints(name: str, limb: dict[str, Any], notes: Footnotes) -> Table:
    how = (
        f"solved in closed form, as a {limb['closed_form']}" if limb["closed_form"] else "solved by iteration"
    )
    columns: list[str | tuple[str, str]] = ["joint", "axis", ("link", "mm"), ("limits", "deg"), "source"]
    weighed = any(joint["mass"] is not None for joint in limb["joints"])
    found = table(f"{name}: joints, {how}", *columns, *([("mass", "g")] if weighed else []))
    for joint in limb["joints"]:
        ends = [
            f"{number(end, 1)}{'*' if servo else ''}"
            for end, servo in zip(joint["limits_deg"], joint["set_by_servo"], strict=True)
        ]
        if any(joint["set_by_servo"]):
            notes.starred = "the end of the servo's range, short of the limit of the source"
        mass = Text("not printed")
        if joint["mass"] is not None:
            mass = Text(f"{number(joint['mass_g'])} ").append(notes.mark(joint["mass"]))
        cells = [joint["joint"], _axis_name(joint["axis"]), place(joint["link_mm"]), " to ".join(ends)]
        found.add_row(*cells, notes.mark(joint["limits"]), *([mass] if weighed else []))
    return found


def _places(name: str, limbs: list[dict[str, Any]], notes: Footnotes) -> Table:
    found = table(
        f"{name}: place on the body, and the paper's axes in the limb's",
        "limb",
        ("at", "mm"),
        ("turn", "deg"),
        "source",
        "x, y, z",
        "source",
    )
    for limb in limbs:
        mount, paper = limb["mount"], limb["paper_axes"]
        axes = ", ".join(_axis_name([row[i] for row in paper["to_limb"]]) for i in range(3))
        found.add_row(
            limb["limb"],
            place(mount["at_mm"]),
            number(mount["turn_deg"]),
            notes.mark(mount),
            axes,
            notes.mark(paper),
        )
    return found


def _axis_name(direction: list[float]) -> str:
    """`-y` for an axis of the frame, its components for any other."""
    i = max(range(3), key=lambda k: abs(direction[k]))
    if abs(direction[i]) != 1:
        return place(direction)
    return f"{'-' if direction[i] < 0 else ''}{'xyz'[i]}"


def _servos(name: str, limbs: list[dict[str, Any]], notes: Footnotes) -> Table:
    found = table(
        f"{name}: servos, servo angle = zero + sign x joint angle",
        "limb",
        "joint",
        ("id", ""),
        "model",
        ("zero", "deg"),
        ("sign", ""),
        "source",
    )
    for limb in limbs:
        for joint in limb["joints"]:
            servo = joint["servo"]
            found.add_row(
                limb["limb"], joint["joint"], str(servo["id"]), servo["model"], number(servo["zero_deg"]),
                f"{servo['sign']:+d}", notes.mark(servo),
            )  # fmt: skip
    return found
