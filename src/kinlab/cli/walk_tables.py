"""What `kinlab walk` prints for people."""

from collections.abc import Sequence
from typing import Any

from rich.text import Text

from kinlab.cli.show import number, plotted, sentences, show, table
from kinlab.papers.comparison import Comparison, Curves
from kinlab.rig import WalkResult


def show_walk(result: WalkResult) -> None:
    """Energy, tracking, joints, what went wrong, what is assumed."""
    data = result.to_json()
    show(*_heading(data), "", _energy(data), "", _tracking(data), "", _joints(data))
    show("", *plotted("error of the foot over two cycles", result.error_curves(), "s", "mm"))
    rows = [("possible", _possible(data))]
    if not data["complete"]:
        rows.append(("stopped", f"after {data['duration_s']:.1f} s, before its end"))
    rows += [("no answer", f"servo {number}: {count} times") for number, count in data["lost"].items()]
    rows += [("alarm", f"servo {number}: {', '.join(names)}") for number, names in data["alarms"].items()]
    rows += [("-", note) for note in data["notes"]]
    show("", sentences(*rows))


def _heading(data: dict[str, Any]) -> list[Text | str]:
    asked = f"{number(data['speed_mm_s'])} mm/s"
    if data["turn_deg_s"]:
        asked += f", turning {number(data['turn_deg_s'])} deg/s"
    far = f"{number(data['distance_mm'])} mm" if data["distance_mm"] else "once round"
    where = "emulated servos in memory" if data["emulated"] else f"the servos on {data['port']}"
    return [
        Text(f"{data['robot']}, {data['gait']}", style="bold").append(
            f"   {asked}, {far}, period {data['period_s']:.3f} s", style="not bold"
        ),
        f"{where}, {data['ticks']} commands in {data['duration_s']:.2f} s ({data['achieved_rate_hz']:.1f} per s)",
    ]


def _energy(data: dict[str, Any]) -> Any:
    found = table("energy, krsri-hexapod (28): the sum of I V dt", "", ("", ""), "")
    found.show_header = False
    energy = data["energy"]
    found.add_row("energy", f"{energy['wh']:.4f} Wh", f"mean {energy['mean_power_w']:.2f} W")
    found.add_row("idle share", f"{energy['idle_wh']:.4f} Wh", "standby currents alone")
    if energy["wh_per_m"] is not None:
        found.add_row(
            "steady",
            f"{energy['wh_per_m']:.4f} Wh/m",
            f"{energy['steady_power_w']:.2f} W in whole cycles",
        )
    found.add_row("voltage", _amount(energy["mean_voltage_v"], "V"), "mean, as the servos report it")
    found.add_row(
        "current", _amount(energy["mean_current_a"], "A"), f"peak {_amount(energy['peak_current_a'], 'A')}"
    )
    found.add_row(
        "upper bound", f"{energy['motor_current_wh']:.4f} Wh", "did the supply give all the motors' current"
    )
    return found


def _tracking(data: dict[str, Any]) -> Any:
    tracking = data["tracking"]
    found = table(
        "tracking error at the foot: read back against planned", "leg", ("mean", "mm"), ("max", "mm")
    )
    for leg, off in tracking["legs"].items():
        found.add_row(leg, _plain(off["mean_mm"]), _plain(off["max_mm"]))
    found.add_row("all", _plain(tracking["mean_mm"]), _plain(tracking["max_mm"]), style="bold")
    return found


def _joints(data: dict[str, Any]) -> Any:
    found = table(
        "joints, each kind by the leg that works hardest",
        "joint",
        ("speed", "deg/s"),
        ("limit", "deg/s"),
        ("used", "%"),
        ("load", "%"),
        ("torque", "N m"),
    )
    for name in dict.fromkeys(joint["joint"] for joint in data["joints"]):
        same = [joint for joint in data["joints"] if joint["joint"] == name]
        fast = max(same, key=lambda joint: joint["used"])
        hard = max(same, key=lambda joint: joint["peak_load"] or 0.0)
        found.add_row(
            name,
            f"{fast['leg']} {fast['planned_deg_s']:.0f}",
            f"{fast['limit_deg_s']:.0f}",
            f"{fast['used'] * 100:.0f}",
            f"{hard['leg']} {_share(hard['peak_load'])}",
            _plain(hard["peak_torque_nm"]),
        )
    return found


def _possible(data: dict[str, Any]) -> str:
    tightest = max(data["joints"], key=lambda joint: joint["used"])
    text = (
        f"the {tightest['joint']} of {tightest['leg']} needs {tightest['used'] * 100:.0f} % of what its "
        f"{tightest['model']} does without load"
    )
    fastest = data["fastest_mm_s"]
    return text if fastest is None else f"{text}; at this stride {fastest:.1f} mm/s would need all of it"


ASKED = {
    "speed_mm_s": ("speed", "mm/s"),
    "turn_deg_s": ("turn", "deg/s"),
    "distance_mm": ("way", "mm"),
    "rate_hz": ("rate", "Hz"),
}


def show_sweep(robot: str, results: Sequence[WalkResult]) -> None:
    """One line for each walk: what was varied, and what came of it."""
    rows = [result.row() for result in results]
    varied = [key for key in ASKED if len({row[key] for row in rows}) > 1] or ["speed_mm_s"]
    found = table(
        f"{robot}, {results[0].errand.order.gait.name}",
        *(ASKED[key] for key in varied),
        ("energy", "Wh"),
        ("steady", "Wh/m"),
        ("error", "mm"),
        ("used", "%"),
        ("lost", ""),
    )
    for row in rows:
        found.add_row(
            *(number(row[key] or 0.0) for key in varied),
            _plain(row["wh"], 4),
            _plain(row["wh_per_m"], 4),
            _plain(row["mean_error_mm"]),
            _share(row["joint_speed_used"]),
            number(row["lost"] or 0),
        )
    used = ("used", "of the servos' speed without load, by the joint that needs most of it")
    show(found, "", sentences(used, *(("-", note) for note in results[0].notes)))


def show_comparison(answer: Comparison) -> None:
    """The curves side by side, what is fitted to them, where they cross, why they differ."""
    rig, *papers = answer.sources
    gaits = list(rig.energy)
    heads = [f"{name} {gaits[0]}" if gait == gaits[0] else gait for name in _short(answer) for gait in gaits]
    found = table(
        f"{answer.robot.name}: Wh per metre; the rig is KinLab's, the others are the paper's",
        ("mm/s", ""),
        *((head, "") for head in heads),
    )
    printed = [{row["speed_mm_s"]: row for row in source.to_json()["rows"]} for source in papers]
    for row in rig.to_json()["rows"]:
        cells = [_plain(row[f"{gait}_wh_per_m"], 4) for gait in gaits]
        for rows in printed:
            near = next((r for v, r in rows.items() if abs(v - row["speed_mm_s"]) < 1e-6), None)
            cells += [_plain(near[f"{gait}_wh_per_m"] if near else None, 3) for gait in gaits]
        found.add_row(number(row["speed_mm_s"]), *cells)
    show(found)
    lines = {
        f"{name} {gait}": list(zip((source.speed * 1000).tolist(), energy.tolist(), strict=True))
        for name, source in zip(_short(answer)[:2], answer.sources, strict=False)
        for gait, energy in source.energy.items()
    }
    show("", *plotted("what a metre costs", lines, "mm/s", "Wh"))
    for source in answer.sources:
        _show_source(source)
    show("", sentences(*(("-", note) for note in answer.notes)))


def _short(answer: Comparison) -> list[str]:
    grounds = [source.label.rpartition(" measured on ")[2] for source in answer.sources[1:]]
    return ["rig", *(ground.removesuffix(" ground") for ground in grounds)]


def _show_source(source: Curves) -> None:
    data = source.to_json()
    if data["models"]:
        models = table(
            f"{source.label}; fitted: E = P0 t + E1 d", "gait", ("P0", "W"), ("+-", ""), ("E1", "Wh/m"), ("+-", ""),
            ("residual", "Wh"),
        )  # fmt: skip
        for gait, model in data["models"].items():
            models.add_row(
                gait, f"{model['power_w']:.2f}", f"{model['power_error_w']:.2f}", f"{model['per_metre_wh']:.4f}",
                f"{model['per_metre_error_wh']:.4f}", f"{model['residual_wh']:.4f}",
            )  # fmt: skip
        show("", models)
    else:
        show("", Text(source.label, style="italic"))
    show(sentences(*_crossings(source, data)))


def _crossings(source: Curves, data: dict[str, Any]) -> list[tuple[str, str]]:
    first, second = source.energy
    if data["crossings_mm_s"]:
        places = " and ".join(f"{v:.1f}" for v in data["crossings_mm_s"])
        rows = [("crossover", f"the points themselves cross at {places} mm/s")]
    elif data["cheaper"]:
        rows = [("crossover", f"none in this range: {data['cheaper']} costs less at every speed")]
    else:
        rows = [("crossover", "none in this range")]
    if data["crossover_mm_s"] is not None:
        where = f"{data['crossover_mm_s']:.1f} +- {data['crossover_error_mm_s']:.1f} mm/s"
        rows.append(("fitted", f"{first} and {second} cost the same at {where}"))
    elif data["models"]:
        rows.append(("fitted", "the models do not cross"))
    return rows


def _plain(value: float | None, digits: int = 2) -> str:
    return "-" if value is None else f"{value:.{digits}f}"


def _share(value: float | None) -> str:
    return "-" if value is None else f"{value * 100:.0f}"


def _amount(value: float | None, unit: str) -> str:
    return "-" if value is None else f"{value:.2f} {unit}"
