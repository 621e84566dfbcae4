"""Servos on one half-duplex wire: who hears what, who answers when, and what can go wrong on the way."""

from kinlab.dynamixel.chain.chain import Burst, Chain
from kinlab.dynamixel.chain.clock import Clock, RealClock, SimulatedClock
from kinlab.dynamixel.chain.faults import Faults
from kinlab.dynamixel.chain.receiver import Receiver

__all__ = ["Burst", "Chain", "Clock", "Faults", "RealClock", "Receiver", "SimulatedClock"]
