"""A target, and everything that follows from it."""
