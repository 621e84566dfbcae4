"""What `kinlab tour` prints for people."""

from rich.rule import Rule
from rich.text import Text

from kinlab.cli.ik_tables import angles_table, errors_table, show_bytes
from kinlab.cli.show import drawing, place, sentences, show
from kinlab.papers.tour import Stop


def show_tour(stops: list[Stop]) -> None:
    """Every stop: target, angles, servos, error; and the printed equations' share in it."""
    show(
        "target (mm) -> joint angles -> servo angles -> ticks -> packet bytes -> servos -> where the tip lands"
    )
    for i, stop in enumerate(stops, 1):
        _show_stop(i, stop)
    show("", Rule(Text(" Next "), align="left", style="dim"), _next_steps())


def _show_stop(number: int, stop: Stop) -> None:
    path, answer = stop.path, stop.path.answer
    show("", Rule(Text(f" {number}. {answer.robot.name} ", style="bold"), align="left", style="dim"))
    show(f"{answer.robot.title}.")
    show(
        f"Target {place(answer.place_mm(answer.target))} mm for {answer.limb.name}, in the paper's axes: {stop.where}."
    )
    pose = path.pose
    if pose is None:
        show(Text(answer.reason, style="bold red"))
        return
    errors = errors_table(answer, pose, path.printed, path.arrival, path.unsent)
    show("", angles_table(answer, pose), "", errors)
    show_bytes(path.arrival)
    if number == 1:
        show("", drawing(answer.limb, pose.q, answer.target))
    show("", sentences(*((f"printed {variant.variant}:", variant.note) for variant in path.printed)))


def _next_steps() -> Text:
    found = Text()
    for command, meaning in (
        (
            "kinlab ik xl430-hexapod 75 10 -46 --limb R1 --as-printed",
            "each printed equation, and what it costs",
        ),
        ("kinlab ik udiebot 26 0 10 --unit cm --frame paper --compare", "the same target by six iterations"),
        ("kinlab body krsri-hexapod --xyz 0 0 20 --rpy 5 0 10", "tilt a body over fixed feet"),
        ("kinlab robots eros", "every figure with its source"),
        ("kinlab --help", "everything else"),
    ):
        found.append(f"  {command}\n", style="bold").append(f"      {meaning}\n")
    return found
