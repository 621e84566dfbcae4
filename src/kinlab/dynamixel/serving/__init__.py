"""An emulated chain for other programs: on a pty that looks like a serial port, or on TCP."""

from kinlab.dynamixel.serving.links import Link
from kinlab.dynamixel.serving.server import Server

__all__ = ["Link", "Server"]
