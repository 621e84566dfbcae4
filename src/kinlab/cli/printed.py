"""How a paper's equations, as they stand, look beside the truth."""

from typing import Any

from rich.table import Table

from kinlab.cli.show import place, table


def printed_table(shown: dict[str, Any]) -> Table:
    """An entry of the contract's `as_printed`: what it gives, why, and what each misprint costs."""
    found = table(f"as printed: {shown['where']}", "", "")
    found.show_header = False
    if "angles_deg" in shown:
        angles = shown["angles_deg"] or {}
        found.add_row("angles [deg]", ", ".join(f"{k} {v:.4f}" for k, v in angles.items()) or "none")
    if shown.get("fk_mm") is not None:
        found.add_row("lands", f"at {place(shown['fk_mm'])} mm, {shown['error_mm']:.4f} mm off")
    if shown.get("own_fk_mm") is not None:
        own = f"at {place(shown['own_fk_mm'])} mm, {shown['own_error_mm']:.4f} mm off"
        found.add_row("on its own leg", own)
    if shown.get("attitude_error") is not None:
        found.add_row("attitude", f"entries up to {shown['attitude_error']:.4f} off")
    found.add_row("why", shown["note"])
    for fault in shown["faults"]:
        name = fault["equation"]
        what = f"equation {name}" if name[0].isdigit() else name
        cost = [] if fault["cost_mm"] is None else [f"costs {fault['cost_mm']:.4f} mm by itself"]
        remarks = "; ".join(cost + ([fault["reason"]] if fault["reason"] else []))
        found.add_row(what, f"{fault['printed']}   should be   {fault['corrected']}   ({remarks})")
    return found
