"""What lessons ask the core to compute, a module for each topic: see `kinlab.lessons.registry`."""
