"""What a bad wire does to bytes. Seeded: the same faults on the same bytes, every time."""

import random
from dataclasses import dataclass, field


@dataclass
class Faults:
    """Disturbances of the wire, in both directions.

    Attributes:
        drop, flip: the chance that a byte is lost, or has one bit turned over.
        noise: the chance that a random byte stands before a byte.
        delay: s by which every answer is late.
        echo: what is sent comes back, as through an adapter that hears itself.
    """

    drop: float = 0.0
    flip: float = 0.0
    noise: float = 0.0
    delay: float = 0.0
    echo: bool = False
    seed: int = 0
    _random: random.Random = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.reseed(self.seed)

    def reseed(self, seed: int) -> None:
        """Begin the same sequence of accidents again."""
        self.seed = seed
        self._random = random.Random(seed)

    def pass_on(self, data: bytes) -> bytes:
        """What arrives of `data`."""
        if not (self.drop or self.flip or self.noise):
            return data
        chance, arrived = self._random.random, bytearray()
        for byte in data:
            if chance() < self.noise:
                arrived.append(self._random.randrange(256))
            if chance() < self.drop:
                continue
            arrived.append(byte ^ 1 << self._random.randrange(8) if chance() < self.flip else byte)
        return bytes(arrived)
