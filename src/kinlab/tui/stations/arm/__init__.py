"""An arm on its bus: it follows a line, yields to a hand, and observes what pushes it."""
