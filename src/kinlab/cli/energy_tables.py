"""What `kinlab gait --energy` prints for people."""

from rich.text import Text

from kinlab.cli.show import sentences, show, table
from kinlab.papers.energy import GAITS, Ground
from kinlab.robots import Robot


def show_energy(robot: Robot, grounds: tuple[Ground, ...]) -> None:
    """Each ground: the measured runs beside the model, the model, the crossover, the averages."""
    show(
        Text(robot.name, style="bold").append(
            "   measured by its paper, over 1 m; not by KinLab", style="not bold"
        )
    )
    for ground in grounds:
        _show_ground(ground)
    show(
        "",
        "E = P0 t + E1 d: P0 is what a gait costs by the second, standing included, E1 what each metre costs.",
    )


def _show_ground(ground: Ground) -> None:
    data = ground.to_json()
    runs = table(
        f"{ground.name} ground, {data['where']}", ("speed", "mm/s"), ("time", "s"),
        *(column for gait in GAITS for column in ((gait, "Wh"), ("model", "Wh"), ("way", "%"))),
    )  # fmt: skip
    for row in data["rows"]:
        cells = [f"{row['speed_mm_s']:g}", f"{row['duration_s']:g}"]
        for gait in GAITS:
            cells += [
                f"{row[f'{gait}_wh']:.3f}",
                f"{row[f'{gait}_model_wh']:.3f}",
                f"{row[f'{gait}_reached_percent']:.1f}",
            ]
        runs.add_row(*cells)
    models = table(
        "model", "gait", ("P0", "W"), ("+-", ""), ("E1", "Wh/m"), ("+-", ""), ("residual", "Wh"), ("mean way", "%"),
        ("printed", "%"),
    )  # fmt: skip
    for gait in GAITS:
        model, average = data["models"][gait], data["averages"][gait]
        models.add_row(
            gait, f"{model['power_w']:.2f}", f"{model['power_error_w']:.2f}", f"{model['per_metre_wh']:.4f}",
            f"{model['per_metre_error_wh']:.4f}", f"{model['residual_wh']:.4f}",
            f"{average['recomputed_percent']:.1f}", f"{average['printed_percent']:.1f}",
        )  # fmt: skip
    show("", runs, "", models)
    if data["crossover_mm_s"] is None:
        show("", "the models do not cross")
    else:
        where = f"{data['crossover_mm_s']:.1f} +- {data['crossover_error_mm_s']:.1f} mm/s"
        show("", sentences(("crossover", f"{where}: below it the wave costs less, above it the tripod")))
