"""What the papers print, evaluated as it stands, beside what is true."""

from kinlab.papers.as_printed import as_printed, body_as_printed, fk_as_printed
from kinlab.papers.footsteps import FootstepAsPrinted, footstep_as_printed
from kinlab.papers.measurements import Measured, measured
from kinlab.papers.results import AsPrinted, BodyAsPrinted, Fault, FkAsPrinted

__all__ = [
    "AsPrinted",
    "BodyAsPrinted",
    "Fault",
    "FkAsPrinted",
    "FootstepAsPrinted",
    "Measured",
    "as_printed",
    "body_as_printed",
    "fk_as_printed",
    "footstep_as_printed",
    "measured",
]
