"""What `kinlab gait` prints for people."""

from typing import Any

import numpy as np
from rich.table import Table
from rich.text import Text

from kinlab.cli.show import console, number, picture, plotted, sentences, show, table
from kinlab.gait.drawing import bars, draw_support
from kinlab.gait.report import GaitReport
from kinlab.gait.schedule import Phase


def show_gait(answer: GaitReport) -> None:
    """The diagram, the phases, the margins, the limits, the curves."""
    show(*_heading(answer), "", _diagram(answer, None), "", _phases(answer), "", _margins(answer))
    show("", *_margin_plot(answer))
    show("", _jumps(answer), "", _landings(answer))
    if answer.walk.robot.kind == "humanoid":
        show("", _support(answer))
    show("", _limits(answer), "", sentences(*(("-", note) for note in answer.notes)))


def show_phase(answer: GaitReport, phase: Phase) -> None:
    """One phase: the diagram with its place marked, the feet from above, every leg's foot and joints."""
    least = next(found for found in answer.least if found.phase.number == phase.number)
    state = answer.still(phase)
    motion, walk = state.motion, answer.walk
    show(*_heading(answer), "", _diagram(answer, phase), "")
    end = float(phase.end) * walk.period
    show(
        Text(f"phase {phase.number} of {len(walk.gait.phases)}", style="bold").append(
            f"   {phase.start} to {phase.end} of the cycle, {float(phase.start) * walk.period:.3f} to {end:.3f} s",
            style="not bold",
        ),
        f"swing {' '.join(phase.swing) or 'none'}   stance {' '.join(phase.stance)}   "
        f"smallest margin {number(least.static * 1000, 1)} mm",
    )
    joints = ", ".join(walk.robot.legs[0].joint_names)
    found = table(f"in its middle, {float(motion.t):.3f} s", "leg", "", ("foot", "mm"), f"{joints} [deg]")
    for i, leg in enumerate(walk.robot.legs):
        found.add_row(
            leg.name,
            "stance" if state.down[i] else "swing",
            "(" + ", ".join(f"{v:.1f}" for v in motion.feet[i] * 1000) + ")",
            ", ".join(f"{a:.2f}" for a in np.degrees(motion.q[i])),
        )
    canvas = draw_support(state, ascii_only=_plain())
    scale = f"from above, one character is {number(canvas.cell_width, 1)} mm wide; the cross is the centre of mass"
    show("", found, "", Text(scale, style="italic"), picture(canvas))


def _plain() -> bool:
    return not console().encoding.lower().startswith("utf")


def _heading(answer: GaitReport) -> list[Text | str]:
    walk = answer.walk
    asked = [f"{number(walk.velocity[0] * 1000)} mm/s forwards"]
    if walk.velocity[1]:
        asked.append(f"{number(walk.velocity[1] * 1000)} mm/s to the left")
    if walk.turn:
        asked.append(f"turning left at {number(float(np.degrees(walk.turn)))} deg/s")
    sway = f", sway {number(walk.sway * 1000, 1)} mm" if walk.sway else ""
    return [
        Text(f"{walk.robot.name}, {walk.gait.name}", style="bold").append(
            f"   {', '.join(asked)}; duty factor {walk.gait.duty}, period {walk.period:.3f} s",
            style="not bold",
        ),
        f"stride {number(walk.stride * 1000, 1)} mm, stroke {number(walk.stroke * 1000, 1)} mm, "
        f"lift {number(walk.lift * 1000, 1)} mm{sway}; foot trajectory {walk.curve.name}",
    ]


def _diagram(answer: GaitReport, now: Phase | None) -> Table:
    """Bars over one cycle; the phase shown stands out."""
    gait, plain = answer.walk.gait, _plain()
    width = 60
    found = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=False)
    drawn = bars(gait, width, ascii_only=plain)
    for leg in answer.walk.robot.legs:
        bar = Text(drawn[leg.name], style="link0", no_wrap=True)
        if now is not None:
            bar.stylize("reverse", round(float(now.start) * width), round(float(now.end) * width))
        found.add_row(leg.name, bar)
    air, ground = ("#", ".") if plain else ("█", "·")
    foot = f"0{'one cycle':^{width - 2}}1"
    found.add_row("", foot)
    if now is not None:
        marks = [" "] * width
        for i in range(round(float(now.start) * width), round(float(now.end) * width)):
            marks[i % width] = "^"
        found.add_row("", "".join(marks))
    found.add_row("", f"{air} swing   {ground} stance")
    return found


def _mm(value: float | None) -> str:
    return "-" if value is None else f"{round(value * 1000, 1) + 0.0:.1f}"


def _phases(answer: GaitReport) -> Table:
    found = table(
        "phases, and the smallest margins of each in mm: static, longitudinal (ahead), energy",
        ("phase", ""), ("from", ""), ("t", "s"), "swing", "stance", ("static", ""), ("ahead", ""), ("energy", ""),
    )  # fmt: skip
    for least in answer.least:
        phase = least.phase
        found.add_row(
            str(phase.number), str(phase.start), f"{float(phase.start) * answer.walk.period:.3f}",
            " ".join(phase.swing) or "-", " ".join(phase.stance),
            _mm(least.static), _mm(least.longitudinal), _mm(least.energy),
        )  # fmt: skip
    return found


def _margins(answer: GaitReport) -> Table:
    data = answer.to_json(1)["margins"]
    found = table("over the cycle", "margin", ("smallest", "mm"), "what it is")
    for key, name, meaning in (
        ("static_mm", "static", "centre of mass to the edge of the support polygon"),
        ("longitudinal_mm", "longitudinal", "the same along the body"),
        ("theory_mm", "by theory", "(n/2 - 1) P + (1 - 3/(4 beta)) R, of wave gaits"),
        ("energy_mm", "energy", "rise of the centre of mass before it tips"),
        ("zmp_mm", "zmp", "zero moment point to the edge, cart-table model"),
    ):
        shown = "-" if data[key] is None else f"{data[key] + 0.0:.1f}"
        found.add_row(name, shown, meaning)
    found.add_row("slip", f"{answer.slip * 1000:.1e}", "farthest move of a standing foot over the ground")
    return found


def _margin_plot(answer: GaitReport) -> list[Any]:
    margins = (answer.trace * 1000).tolist()
    points = [(i / (len(margins) - 1), margin) for i, margin in enumerate(margins)]
    return plotted("static margin over one cycle", {"margin": points}, "cycle", "mm")


def _jumps(answer: GaitReport) -> Table:
    found = table(
        "jumps of velocity and acceleration at lift-off / touch-down, by foot trajectory", "trajectory",
        "along [mm/s]", "up [mm/s]", "along [mm/s2]", "up [mm/s2]",
    )  # fmt: skip
    for name, jump in answer.jumps.items():
        used = name == answer.walk.curve.name
        cells = [" / ".join(f"{v * 1000 + 0.0:.0f}" for v in pair) for pair in jump]
        found.add_row(Text(f"{name} *" if used else name, style="bold" if used else ""), *cells)
    return found


def _landings(answer: GaitReport) -> Table:
    found = table(
        "touch-down, without and with eros's optimisations",
        "optimisation",
        ("down", "mm/s"),
        ("over ground", "mm/s"),
        ("toe down", "deg"),
        ("toe up", "deg"),
    )
    for name, landing in answer.landings.items():
        found.add_row(
            name, f"{landing.down * 1000 + 0.0:.1f}", f"{landing.along * 1000:.1f}",
            f"{np.degrees(landing.toe_down):.1f}", f"{np.degrees(landing.toe_up):.1f}",
        )  # fmt: skip
    return found


def _support(answer: GaitReport) -> Table:
    found = table("support of two legs", "support", ("centre of mass", "mm"), ("zmp", "mm"))
    for name, (static, zmp) in answer.support.items():
        found.add_row(name, _mm(static), _mm(zmp))
    return found


def _limits(answer: GaitReport) -> str:
    limits = answer.limits
    leg, joint = limits.tightest
    if limits.fastest is None:
        if limits.model is None:
            speed = f"{np.degrees(limits.speed):.0f} deg/s"
            return f"fastest joint: the {joint} of {leg}, {speed}; no servo is known to compare it with"
        return f"the {joint} of {leg} needs {limits.used:.0%} of the speed of its {limits.model}"
    return (
        f"the {joint} of {leg} needs {limits.used:.0%} of the speed of its {limits.model}; at this stride and lift "
        f"the fastest possible speed is {limits.fastest * 1000:.1f} mm/s"
    )


def show_as_printed(printed: Any) -> None:
    """The paper's foot trajectory letter for letter beside the corrected one."""
    if printed is None:
        show("", "the paper prints no foot trajectory")
        return
    data = printed.to_json()
    found = table(
        f"as printed: {data['where']}", ("s", ""), ("along", "mm"), ("height", "mm"),
        ("corrected along", "mm"), ("height", "mm"),
    )  # fmt: skip
    for row in data["rows"]:
        found.add_row(f"{row['s']:g}", *(number(row[key], 3) for key in (
            "along_mm", "height_mm", "corrected_along_mm", "corrected_height_mm")))  # fmt: skip
    show("", found, data["note"])
