"""What lessons ask the core to draw, a module for each topic: see `kinlab.lessons.registry`."""
