"""The path itself: a robot wired to a bus, driven, and measured."""
