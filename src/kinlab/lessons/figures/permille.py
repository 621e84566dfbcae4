"""Udiebot's Table 4, recomputed."""

from kinlab.lessons.answers.permille import exact, printed, ratio

# Of the rows that have an angle, cm.
ROWS = (28, 26, 24, 22, 20, 18, 16, 14, 12)


def rows(robot: str) -> str:
    """Each row's printed theta2, the exact one, and the ratio of the two."""
    lines = ["x, cm   theta2   acos(x/30)   theta2/acos"]
    for x in ROWS:
        shown = printed(robot, x)["theta2"]
        lines.append(f"{x:5d} {shown:8.3f} {exact(robot, x):12.4f} {ratio(robot, x):13.5f}")
    return "\n".join(lines)
