"""The path station by station, as rows: what stands there for each joint, and the error at that depth."""

from collections.abc import Iterable, Sequence

import numpy as np
from textual.content import Content

from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.sandbox.display import byte_spans
from kinlab.papers.path import WholePath
from kinlab.robots.target import TargetReport, angles_deg, place_mm
from kinlab.tui.numbers import shown
from kinlab.tui.stations.robot.naming import Say, short

# The fields of a packet in the theme's colours; they are told apart by their places as well.
BYTES = {
    "header": "$quiet",
    "id": "$sky",
    "length": "$green",
    "instruction": "bold $purple",
    "address": "$orange",
    "data": "$foreground",
    "check": "$green",
}


class Rows:
    """Rows of one label, a column for each joint, and an error, for a width."""

    def __init__(self, width: int, columns: int) -> None:
        self.label = 12 if width >= 70 else 11
        self.error = 12 if width >= 70 else 10
        self.cell = max(min((width - self.label - self.error) // max(columns, 1), 16), 5)
        # In a wide terminal an error stands near what it belongs to.
        self.width = min(width, max(100, self.label + self.cell * columns + self.error))
        self.lines: list[Content] = []

    @property
    def digits(self) -> int:
        """Decimals that a cell has room for."""
        return 3 if self.cell >= 10 else 2 if self.cell >= 8 else 1

    def numbers(self, values: Iterable[float]) -> list[str]:
        """Numbers with as many decimals as all of them have room for: half a number is another number."""
        numbers = list(values)
        for digits in range(self.digits, -1, -1):
            cells = [f"{round(value, digits) + 0.0:.{digits}f}" for value in numbers]  # no -0
            if self.holds(cells):
                break
        return cells

    def holds(self, cells: Iterable[str]) -> bool:
        """Whether none of these cells has to be cut."""
        return all(len(cell) < self.cell for cell in cells)

    def places(self, values: Sequence[float]) -> list[str]:
        """The coordinates of a place, on all the room of the row where the joints' cells are too small."""
        cells = [f"{axis} {shown(value, self.digits)}" for axis, value in zip("xyz", values, strict=True)]
        wide = (self.width - self.label - self.error) // len(cells)
        return cells if self.holds(cells) else ["".join(f"{cell:>{wide}}" for cell in cells)]

    def row(self, label: str, cells: Iterable[str], error: str = "", style: str = "") -> None:
        """A row of cells, one for each joint; a single one may take the whole row."""
        cells = list(cells)
        room = self.cell - 1 if len(cells) > 1 else self.width
        body = "".join(f"{cell[:room]:>{self.cell}}" for cell in cells)
        self.line(label, Content.styled(body, style), error)

    def line(self, label: str, body: Content, error: str = "") -> None:
        """A row of free text."""
        gap = self.width - self.label - self.error - body.cell_length
        end = Content.styled(f"{error:>{self.error}}", "bold") if error else Content("")
        head = Content.styled(f"{label[: self.label - 1]:<{self.label}}", "$quiet")
        self.lines.append(Content.assemble(head, body, " " * max(gap, 1) if error else "", end))

    def text(self, label: str, words: str, error: str = "", style: str = "") -> None:
        """A sentence, folded beside its label."""
        room = self.width - self.label - (self.error if error else 0) - 1
        for i, part in enumerate(Content.styled(words, style).wrap(max(room, 20))):
            self.line("" if i else label, part, "" if i else error)


def error_mm(metres: float | None) -> str:
    """A distance, as an error."""
    if metres is None:
        return ""
    error = metres * 1000
    return (
        "0 mm"
        if not error
        else f"{error:.0e} mm"
        if error < 1e-4
        else f"{error:.4f} mm"
        if error < 10
        else f"{error:.1f} mm"
    )


def path_rows(path: WholePath, say: Say, width: int) -> Content:
    """The path itself, from the target to where the servos stand.

    Args:
        say: gives the words.
        width: of the table, in characters.
    """
    answer, pose = path.answer, path.pose
    limb = answer.limb
    rows = Rows(width, max(len(limb.joints), 3))
    frame = say(f"frame.{answer.frame}")
    rows.row(say("row.target"), rows.places(answer.place_mm(answer.target)), f"mm {frame}")
    rows.row("", (short(name, rows.cell - 1) for name in limb.joint_names), style="bold")
    if pose is not None:
        _solved(rows, path, say)
    elif answer.poses:
        for other in answer.poses[:2]:
            rows.row(
                say("row.angles"), rows.numbers(_degrees(answer, other.q)), say("row.beyond"), "$vermillion"
            )
    return Content("\n").join(rows.lines)


def print_rows(path: WholePath, say: Say, width: int, *, roomy: bool) -> Content:
    """What stands beside the path: the paper's own equations and measurements, the limits, the command line.

    Args:
        say: gives the words.
        width: of the table, in characters.
        roomy: whether there is room for what explains the print.
    """
    answer = path.answer
    rows = Rows(width, max(len(answer.limb.joints), 3))
    _printed(rows, path, say, roomy)
    if path.measured is not None:
        rows.text(say("row.measured"), path.measured.where, f"{path.measured.error_mm:.2f} mm", "$quiet")
    if roomy:
        low, high = ([f"{angle:.0f}" for angle in ends] for ends in np.degrees(answer.limb.limits))
        both = [f"{a}..{b}" for a, b in zip(low, high, strict=True)]
        first, *rest = [both] if rows.holds(both) else [low, high]
        rows.row(say("row.limits"), first, "deg", "$quiet")
        for cells in rest:
            rows.row("", cells, "", "$quiet")
    rows.text(say("row.command"), command(path), style="$quiet")
    return Content("\n").join(rows.lines)


def _solved(rows: Rows, path: WholePath, say: Say) -> None:
    answer, pose = path.answer, path.pose
    assert pose is not None
    limb = answer.limb
    rows.row(say("row.angles"), rows.numbers(_degrees(answer, pose.q)), error_mm(pose.error_m))
    if not pose.servos:
        rows.text(say("row.servos"), say("no_servos"), style="$quiet")
        return
    servos = [pose.servos.get(name) for name in limb.joint_names]
    rows.row(
        say("row.servos"),
        (shown(s.servo_deg, rows.digits) if s else "" for s in servos),
        " ".join(f"#{s.id}" for s in servos if s)[: rows.error - 1],
    )
    unit = next(s.unit for s in servos if s)
    rows.row(
        say("row.ticks") if unit == "tick" else say("row.pulses"),
        ("-" if s is None or s.command is None else str(s.command) for s in servos),
        error_mm(pose.quantised_error_m),
    )
    arrival = path.arrival
    if arrival is None:
        rows.text(say("row.sent"), say("unsent.pwm") if unit == "us" else path.unsent, style="$quiet")
        return
    spans = byte_spans(dissect(arrival.sent, arrival.protocol))
    rows.lines += _folded(say("row.sent"), spans, rows)
    if not arrival.answered:
        rows.text(say("row.reported"), say("no_answer"), style="$vermillion")
        return
    rows.row(say("row.reported"), (f"{tick:.0f}" for tick in arrival.reported), f"{arrival.seconds:.2f} s")
    tip = place_mm(limb, arrival.tip, answer.frame)
    rows.row(say("row.foot"), rows.places(tip), error_mm(path.arrival_error_m))


def _folded(label: str, spans: Sequence[tuple[str, str]], rows: Rows) -> list[Content]:
    """Bytes in their fields' colours, as many in a line as there is room for."""
    room = rows.width - rows.label - 1
    lines: list[list[Content]] = [[]]
    used = 0
    for style, text in spans:
        for byte in text.split():
            if used + 3 > room:
                lines.append([])
                used = 0
            lines[-1].append(Content.styled(f"{byte} ", BYTES.get(style, "")))
            used += 3
    heads = [label, *[""] * (len(lines) - 1)]
    return [
        Content.assemble(Content.styled(f"{head:<{rows.label}}", "$quiet"), *line)
        for head, line in zip(heads, lines, strict=True)
    ]


def _printed(rows: Rows, path: WholePath, say: Say, roomy: bool) -> None:
    answer = path.answer
    for variant in path.printed:
        label = say(f"printed.{variant.variant}")
        if variant.angles is None:
            rows.text(label, variant.note if roomy else say("not_computable"), style="$vermillion")
        else:
            cells = rows.numbers(np.degrees(list(variant.angles.values())).tolist())
            rows.row(label, cells, error_mm(variant.error_m), "$vermillion")
        if roomy:
            for fault in variant.faults:
                text = say("fault", equation=fault.equation, printed=fault.printed, corrected=fault.corrected)
                rows.text("", text, error_mm(fault.cost_m), "$quiet")
    for forward in path.printed_fk:
        if forward.pose is None:
            rows.text(say("printed.forward"), say("not_computable"), style="$vermillion")
        else:
            tip = place_mm(answer.limb, forward.pose[:3, 3], answer.frame)
            rows.row(say("printed.forward"), rows.places(tip), error_mm(forward.error_m), "$vermillion")
    if not path.printed and not path.printed_fk:
        rows.text(say("row.printed"), say("nothing_printed"), style="$quiet")


def command(path: WholePath) -> str:
    """The command line that gives the same answer."""
    answer = path.answer
    name, limb = answer.robot.name, answer.limb.name
    frame = "" if answer.frame == "limb" else f" --frame {answer.frame}"
    if answer.poses and answer.poses[0].name == "as given":
        numbers = " ".join(shown(a) for a in angles_deg(answer.limb, answer.poses[0].q).values())
        return f"kinlab fk {name} {numbers} --limb {limb}{frame}"
    numbers = " ".join(shown(v) for v in answer.place_mm(answer.target))
    return f"kinlab ik {name} {numbers} --limb {limb}{frame} --as-printed"


def _degrees(answer: TargetReport, q: object) -> list[float]:
    return list(angles_deg(answer.limb, q).values())  # type: ignore[arg-type]
