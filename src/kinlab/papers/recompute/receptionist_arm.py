"""Compliance control on a receptionist robot's arm (Universitas Indonesia, 2012), recomputed."""

from collections.abc import Iterator

from kinlab.papers.recompute import (
    receptionist_appendix,
    receptionist_control,
    receptionist_kinematics,
    receptionist_links,
    receptionist_newton,
    receptionist_observers,
)
from kinlab.papers.recompute.equation import check
from kinlab.papers.recompute.finding import Finding
from kinlab.papers.recompute.paper import Paper
from kinlab.papers.recompute.receptionist_tables import NAME, tables
from kinlab.papers.recompute.receptionist_text import text


def recompute() -> Iterator[Finding]:
    """Every finding, chapter by chapter."""
    yield from tables()
    yield from equations()
    yield from text()


def equations() -> Iterator[Finding]:
    """All numbered equations, and those of the appendix."""
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
    for equation in receptionist_appendix.EQUATIONS:
        yield from check(NAME, equation, receptionist_appendix.rate_samples(), "appendix")


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
