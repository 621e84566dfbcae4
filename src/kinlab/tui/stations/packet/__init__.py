"""The Packet station: Dynamixel packets byte by byte, on an emulated chain of servos."""
