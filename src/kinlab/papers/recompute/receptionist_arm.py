"""Compliance control on a receptionist robot's arm (Universitas Indonesia, 2012), recomputed."""

from collections.abc import Iterator

from kinlab.papers.recompute import (
    receptionist_control,
    receptionist_kinematics,
    receptionist_links,
    receptionist_newton,
    receptionist_observers,
)
from kinlab.papers.recompute.equation import check
from kinlab.papers.recompute.finding import Finding
from kinlab.papers.recompute.paper import Paper

NAME = "receptionist-arm"


def recompute() -> Iterator[Finding]:
    """Every finding, chapter by chapter."""
    yield from equations()


def equations() -> Iterator[Finding]:
    """All numbered equations."""
    control = receptionist_control.control_samples()
    for samples, listed in (
        (control, receptionist_control.EQUATIONS),
        (control, receptionist_observers.EQUATIONS),
        (receptionist_newton.newton_samples(), receptionist_newton.EQUATIONS),
        (receptionist_kinematics.arm_samples(), receptionist_kinematics.EQUATIONS),
        (receptionist_links.link_samples(), receptionist_links.EQUATIONS),
    ):
        for equation in listed:
            yield from check(NAME, equation, samples)


PAPER = Paper(
    name=NAME,
    title="Haris Kasminto Aji, Rancang bangun compliance control pada tangan robot penerima tamu, "
    "Universitas Indonesia, 2012",
    equations=(
        *(f"2.{n}" for n in range(1, 51)),
        *(f"3.{n}" for n in range(8, 37)),
    ),
    recompute=recompute,
)
