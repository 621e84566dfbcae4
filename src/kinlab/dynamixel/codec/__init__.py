"""Packets as bytes, as values, and as an explanation: Protocol 1.0 and 2.0."""
