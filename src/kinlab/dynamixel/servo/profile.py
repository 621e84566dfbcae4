"""The set-point between a position and its goal: at once, at a speed, or with ramps."""

import math


class Profile:
    """A set-point that moves to its goal no faster, and speeding up no harder, than it may.

    Attributes:
        position, velocity: of the set-point, ticks and ticks per second.
        shape: 0 at once, 1 rectangle, 2 triangle, 3 trapezoid.
    """

    def __init__(self, position: float) -> None:
        self.position = position
        self.velocity = 0.0
        self.goal = position
        self.shape = 0
        self._speed = 0.0
        self._acceleration = 0.0

    @property
    def done(self) -> bool:
        return self.position == self.goal

    def stop_at(self, position: float) -> None:
        """Be at rest at `position`."""
        self.position = self.goal = position
        self.velocity = 0.0

    def go_to(self, goal: float, speed: float, acceleration: float) -> None:
        """Aim at `goal` with at most `speed` (ticks/s) and `acceleration` (ticks/s2); 0: at once."""
        self.goal = goal
        self._speed = speed
        self._acceleration = acceleration
        if not speed:
            self.shape = 0
        elif not acceleration:
            self.shape = 1
        else:
            ramps = speed * speed / acceleration
            self.shape = 3 if abs(goal - self.position) > ramps else 2

    def go_on(self, dt: float) -> None:
        """Let `dt` seconds pass."""
        away = self.goal - self.position
        if not away:
            self.velocity = 0.0
            return
        if not self._speed:
            self.stop_at(self.goal)
            return
        wanted = math.copysign(self._speed, away)
        if self._acceleration:
            # Slow enough to stop at the goal, with the distance of this step taken off.
            room = self._acceleration * dt / 2
            braking = math.sqrt(room * room + 2 * self._acceleration * abs(away)) - room
            wanted = math.copysign(min(self._speed, braking), away)
            most = self._acceleration * dt
            wanted = self.velocity + max(-most, min(most, wanted - self.velocity))
        moved = (wanted + self.velocity) / 2 * dt if self._acceleration else wanted * dt
        if moved * away > 0 and abs(moved) >= abs(away) - 1e-9:
            self.stop_at(self.goal)
        else:
            self.position += moved
            self.velocity = wanted
            if abs(self.goal - self.position) < 0.5 and abs(self.velocity) <= 2 * self._acceleration * dt:
                self.stop_at(self.goal)
