"""What `kinlab ik` prints for people."""

from typing import Any

from rich.table import Table
from rich.text import Text

from kinlab.cli.printed import printed_table
from kinlab.cli.show import drawing, fixed, place, sentences, show, table
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.papers import AsPrinted, measured
from kinlab.papers import as_printed as evaluate
from kinlab.papers.path import sent_on
from kinlab.rig.bench import Arrival
from kinlab.robots import Limb
from kinlab.robots.methods import MethodComparison, outcome
from kinlab.robots.target import PoseReport, TargetReport, angles_deg


def show_answer(
    answer: TargetReport,
    *,
    every: bool = False,
    servos: bool = True,
    as_printed: bool = False,
    trace: bool = False,
) -> None:
    """Angles, servos, errors and a drawing; where asked for, all solutions, the steps, the printed equations."""
    show(_heading(answer.robot.name, answer.limb.name, answer.place_mm(answer.target), answer.frame))
    if answer.chosen is None:
        verdict = "not reached" if answer.reachable else "not reachable"
        show(Text(f"{verdict}: {answer.reason}", style="bold red"))
    if answer.nearest is not None and answer.missed_mm < 1e-6:
        show("With its attitude left free, the tip reaches the place.")
    elif answer.nearest is not None:
        nearest = place(answer.place_mm(answer.nearest))
        show(f"nearest reachable point: {nearest} mm, {answer.missed_mm:.3f} mm away")
    chosen = None if answer.chosen is None else answer.poses[answer.chosen]
    for pose in answer.poses:
        if every or chosen is None or pose is chosen:
            show("", angles_table(answer, pose, servos=servos))
    if trace:
        show("", _trace(answer))
    printed = evaluate(answer.robot, answer.limb, answer.target, answer.rotation)
    if chosen is not None:
        arrival, unsent = sent_on(answer.robot, answer.limb, chosen.q)
        show("", errors_table(answer, chosen, printed, arrival, unsent))
        show_bytes(arrival)
        show("", drawing(answer.limb, chosen.q, answer.target))
    if as_printed:
        for variant in printed:
            show("", printed_table(variant.to_json(answer.limb, answer.frame)))


def _heading(robot: str, limb: str, target_mm: list[float], frame: str) -> Text:
    return Text(f"{robot} {limb}", style="bold").append(
        f"   target {place(target_mm)} mm in the {frame} frame", style="not bold"
    )


def angles_table(answer: TargetReport, pose: PoseReport, *, servos: bool = True) -> Table:
    """Joint angles of a pose; with `servos`, their angles and commands."""
    columns: list[str | tuple[str, str]] = ["joint", ("angle", "deg")]
    if servos:
        columns += ["servo", ("servo angle", "deg"), ("command", "")]
    found = table(
        f"{pose.name}, {'within limits' if pose.within_limits else '; '.join(pose.beyond)}", *columns
    )
    for joint, angle in angles_deg(answer.limb, pose.q).items():
        servo = pose.servos.get(joint)
        cells = ["not printed", "", ""]
        if servo is not None:
            command = "beyond its range" if servo.command is None else f"{servo.command} {servo.unit}"
            cells = [f"{servo.model}, id {servo.id}", f"{servo.servo_deg:.3f}", command]
        found.add_row(joint, fixed(angle, 4), *(cells if servos else ()))
    return found


def show_bytes(arrival: Arrival | None) -> None:
    """What went over the wire; nothing where the limb's servos are not on a bus."""
    if arrival is not None:
        show("", sentences((f"sync write, Protocol {arrival.protocol}.0:", show_hex(arrival.sent))))


def errors_table(
    answer: TargetReport,
    pose: PoseReport,
    printed: tuple[AsPrinted, ...],
    arrival: Arrival | None,
    unsent: str,
) -> Table:
    """How far off the tip lands, at each depth; `unsent` says why no emulated servos were sent there."""
    found = table("how far off the tip lands", "error", ("", "mm"), "tip, mm")
    found.add_row("of the mathematics", f"{pose.error_m * 1000:.1e}", place(answer.place_mm(pose.tip)))
    if pose.quantised is None or pose.quantised_error_m is None:
        found.add_row(
            "of the servos' resolution", "-", "beyond their range" if pose.servos else "no servo is printed"
        )
    else:
        tip = place(answer.place_mm(pose.quantised))
        found.add_row("of the servos' resolution", f"{pose.quantised_error_m * 1000:.4f}", tip)
    if arrival is None or not arrival.answered:
        found.add_row("as emulated servos stand", "-", unsent or "they do not answer")
    else:
        reported = ", ".join(f"{tick:g}" for tick in arrival.reported)
        off = f"{arrival.error_m(answer.target) * 1000:.4f}"
        found.add_row(
            "as emulated servos stand",
            off,
            f"{place(answer.place_mm(arrival.tip))}, where they report {reported}",
        )
    for variant in printed:
        if variant.error_m is None or variant.tip is None:
            found.add_row(
                f"of the printed {variant.variant}", "-", "they cannot be evaluated here: see --as-printed"
            )
        else:
            tip = place(answer.place_mm(variant.tip))
            found.add_row(f"of the printed {variant.variant}", f"{variant.error_m * 1000:.4f}", tip)
    paper = measured(answer.robot, answer.limb, answer.target)
    if paper is None:
        found.add_row("as the paper measured", "-", "it measured no tip of this limb")
    else:
        measured_mm, printed_mm = (
            ", ".join(f"{v:.2f}" for v in values) for values in (paper.axes_mm, paper.printed_mm)
        )
        note = f"{paper.where}: {measured_mm} on x, y, z; Table 4 prints {printed_mm}"
        found.add_row("as the paper measured", f"{paper.error_mm:.2f}", note)
    return found


def _trace(answer: TargetReport) -> Table:
    run = answer.attempt
    assert run is not None
    found = table(
        f"{run.method}: {run.reason}", ("step", ""), ("residual", "mm"), _joints(answer.limb), "note"
    )
    for i, step in enumerate(run.trace):
        found.add_row(str(i), f"{step.residual_m * 1000:.3e}", _angles(answer.limb, step.q), step.note)
    return found


def _joints(limb: Limb) -> str:
    return f"{', '.join(limb.joint_names)} [deg]"


def _angles(limb: Limb, q: Any) -> str:
    return ", ".join(fixed(a, 3) for a in angles_deg(limb, q).values())


def show_comparison(report: MethodComparison) -> None:
    """Every method on one target: who gets there, in how many steps, and why not."""
    show(_heading(report.robot.name, report.limb.name, report.place_mm(report.target), report.frame))
    found = table(
        "all methods from the middle of the joints' limits",
        "method",
        ("steps", ""),
        ("residual", "mm"),
        _joints(report.limb),
        "outcome",
    )
    why = []
    exact = report.closed
    if exact is None:
        found.add_row("closed form", "", "", "", "none")
        why.append(("closed form:", report.no_closed_form))
    else:
        angles = _angles(report.limb, exact.q)
        found.add_row("closed form", "0", f"{exact.error_m * 1000:.1e}", angles, exact.name)
    for run in report.runs:
        ended, reason = outcome(report.limb, run)
        residual = f"{run.residual_m * 1000:.1e}"
        found.add_row(run.method, str(run.iterations), residual, _angles(report.limb, run.q), ended)
        if reason:
            why.append((f"{run.method}:", reason))
    show("", found)
    if why:
        show("", sentences(*why))
