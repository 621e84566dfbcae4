"""The master: asks servos on any port, by the names of their registers."""

from kinlab.dynamixel.bus.bus import Bus, Found
from kinlab.dynamixel.bus.errors import BusError, DamagedAnswerError, NoAnswerError, RefusedError
from kinlab.dynamixel.bus.passages import Passage, packets

__all__ = [
    "Bus",
    "BusError",
    "DamagedAnswerError",
    "Found",
    "NoAnswerError",
    "Passage",
    "RefusedError",
    "packets",
]
