"""Dynamixel: packets byte by byte, an emulated servo chain, and a client for real ones.

from kinlab.dynamixel import Bus, Chain, MemoryPort, SimulatedClock

chain = Chain.of([("AX-12A", [1])])
bus = Bus(MemoryPort(chain, SimulatedClock()))
bus.write(1, "goal_position", "90deg")
"""

from kinlab.dynamixel.bus import (
    Bus,
    BusError,
    DamagedAnswerError,
    Found,
    NoAnswerError,
    Passage,
    RefusedError,
)
from kinlab.dynamixel.chain import Chain, Faults, RealClock, SimulatedClock
from kinlab.dynamixel.ports import Port, PortError, open_port
from kinlab.dynamixel.ports.memory import MemoryPort
from kinlab.dynamixel.tables import ControlTable, Register, load_table

__all__ = [
    "Bus",
    "BusError",
    "Chain",
    "ControlTable",
    "DamagedAnswerError",
    "Faults",
    "Found",
    "MemoryPort",
    "NoAnswerError",
    "Passage",
    "Port",
    "PortError",
    "RealClock",
    "RefusedError",
    "Register",
    "SimulatedClock",
    "load_table",
    "open_port",
]
