"""The master: asks servos on any port, by the names of their registers."""

from kinlab.dynamixel.bus.bus import Bus, Found
from kinlab.dynamixel.bus.conversation import Passage
from kinlab.dynamixel.bus.errors import BusError, DamagedAnswerError, NoAnswerError, RefusedError

__all__ = ["Bus", "BusError", "DamagedAnswerError", "Found", "NoAnswerError", "Passage", "RefusedError"]
