"""Following a path: one command and one reading at every tick of the bus's own time."""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from kinlab.kinematics.transforms import Array
from kinlab.rig.ground import Ground
from kinlab.rig.path import Path
from kinlab.rig.rig import Reading, Rig

SETTLING = 1.0  # s that the servos have to take up the weight before anything is measured
SECONDS = 3600.0
INSTANT = 1e-6  # s; what rounding may leave of a path
NIMBLE = 1.0  # how fast the tempo may change, in times the path's own per s


@dataclass(frozen=True, eq=False, repr=False)
class Sample:
    """One tick.

    Attributes:
        t: since the first tick, s.
        clock: what the bus's clock said, s.
        way: how far the path has come, s; `tempo`: how fast it goes, 1 for its own speed.
        planned: where each joint should have been when it was asked (J,), rad.
        reading: what the servos said.
        watts: voltage times current of each servo (J,); of one that does not answer, the last known.
        joules: since the first tick.
        alarms: by servo, what its last answer said about its state.
    """

    t: float
    clock: float
    way: float
    tempo: float
    planned: Array
    reading: Reading
    watts: Array
    joules: float
    alarms: Mapping[int, list[str]]

    @property
    def voltage(self) -> float:
        """Mean of the servos that answered, V; NaN where none did."""
        known = self.reading.volts[~self.reading.missing]
        return float(known.mean()) if known.size else np.nan

    @property
    def current(self) -> float:
        """Of all servos that answered, A."""
        return float(np.nansum(self.reading.amps))

    @property
    def power(self) -> float:
        """Of all servos, W."""
        return float(self.watts.sum())

    @property
    def energy(self) -> float:
        """Since the first tick, Wh."""
        return self.joules / SECONDS


def follow(rig: Rig, path: Path, rate: float, tempo: Callable[[], float] = lambda: 1.0) -> Iterator[Sample]:
    """Go along `path`, from its first frame on, where the joints must be already.

    A bus too slow for `rate` loses ticks, and never time: every command is the one for its moment.
    krsri-hexapod, (28): the energy is the sum of I V dt.

    Args:
        rate: ticks per second.
        tempo: how fast to go, 1 for the path's own speed; asked at every tick.

    Raises:
        PortError: the port is gone.
    """
    clock, chain = rig.clock, rig.chain
    ground = Ground(rig, chain) if chain else None
    if ground:
        ground.press(path.load(0.0))
    try:
        clock.wait(SETTLING)
        start = before = clock.now()
        way, speed, joules, tick = 0.0, tempo(), 0.0, 0
        watts = np.zeros(len(rig.wiring.ids))
        while True:
            now = clock.now()
            dt = now - before
            if ground:
                ground.press(path.load(way))
            rig.command(path.commands(way))
            reading = rig.read()
            planned = path.angles(way + speed * (reading.at - now))
            watts = np.where(reading.missing, watts, reading.volts * reading.amps)
            joules += float(watts.sum()) * dt
            yield Sample(now - start, now, way, speed, planned, reading, watts, joules, dict(rig.bus.alarms))
            if way > path.end - INSTANT:
                return
            tick = max(tick + 1, math.ceil((clock.now() - start) * rate - 1e-9))
            clock.wait(start + tick / rate - clock.now())
            before, passed = now, clock.now() - now
            way = min(way + speed * passed, path.end)
            speed += float(np.clip(tempo() - speed, -NIMBLE * passed, NIMBLE * passed))
    finally:
        if ground:
            ground.lift()
