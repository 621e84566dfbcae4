"""The hand on the arm: a key pushes for a moment, the mouse pulls for as long as it is held."""

from kinlab.canvas import Point
from kinlab.rig.arm import Lab
from kinlab.rig.arm.drawing import VIEWS, pull

# How long a key pushes, s of the arm's own time; a key that is held goes on pushing.
PULSE = 0.3
# Where keys push: in the plane of the side view, and across it.
DIRECTIONS = {
    "left": -VIEWS["side"][0],
    "right": VIEWS["side"][0],
    "up": VIEWS["side"][1],
    "down": -VIEWS["side"][1],
    "in": -VIEWS["behind"][0],
    "out": VIEWS["behind"][0],
}


class Hand:
    """What pushes the arm.

    Attributes:
        force: (3,), N, limb frame; None: nothing does.
    """

    def __init__(self) -> None:
        self.force: tuple[float, float, float] | None = None
        self._until = 0.0
        self._held: tuple[str, Point] | None = None

    def push(self, way: str, newtons: float, t: float) -> None:
        """Push one of DIRECTIONS for a moment, from time `t` (s) on."""
        x, y, z = (DIRECTIONS[way] * newtons).tolist()
        self.force, self._until = (x, y, z), t + PULSE

    def hold(self, view: str, place: Point) -> None:
        """Pull towards a place of a view, in mm, until `let_go`."""
        self._held = view, place

    def let_go(self) -> None:
        """Push and pull no more."""
        self.force = self._held = None

    def act(self, lab: Lab) -> None:
        """Lean on the arm of `lab` for its next cycle."""
        if lab.moments:
            last = lab.moments[-1]
            if self._held:
                self.force = pull(lab.limb, last.angles["real"], *self._held)
            elif last.t >= self._until:
                self.force = None
        lab.lean(self.force)
