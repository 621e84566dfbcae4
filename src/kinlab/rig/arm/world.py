"""The links on the horns of an emulated chain: gravity, inertia and hands load the servos' motors."""

import math
from collections.abc import Sequence

from kinlab.dynamics import Contact, Mechanism
from kinlab.dynamics.straight_line import contact_equations, motion_equations
from kinlab.dynamixel import Chain, SimulatedClock
from kinlab.dynamixel.servo.breaking import motor_of
from kinlab.errors import UsageError
from kinlab.rig.arm.push import Push
from kinlab.robots.model import Limb

# How often (s) the links' torques are worked out anew. Between, every motor turns under constant ones.
GRID = 0.004


class World:
    """A limb on the servos of a chain.

    The motors' own model (`GearMotor`) turns each joint with its own inertia, friction and back-EMF. What
    couples the joints is worked out every GRID seconds, M and h of M qdd + h = tau + push: the motor of
    joint i carries M_ii, and is loaded with h_i, with the pushes, and with M_ij times the acceleration
    that joint j had on the last stretch.
    """

    def __init__(self, limb: Limb, chain: Chain, pushes: Sequence[Push] = ()) -> None:
        """Put the limb on the chain.

        Raises:
            UsageError: a joint has no servo, or a push acts where there is nothing.
        """
        self.mechanism = Mechanism.of(limb)
        self.pushes = tuple(pushes)
        self._equations = motion_equations(self.mechanism)
        self._pushes = [(p, contact_equations(self.mechanism, p.contact(limb))) for p in pushes]
        self._motors, self._zeros, self._signs = [], [], []
        for joint in limb.joints:
            if joint.servo is None:
                raise UsageError(f"the {joint.name} of {limb.name} has no servo")
            self._motors.append(motor_of(chain.servo(joint.servo.id)))
            self._zeros.append(math.radians(joint.servo.zero_deg))
            self._signs.append(joint.servo.sign)
        self._rates = [0.0] * len(self._motors)
        self._leaning: tuple[float, float, float] | None = None
        self._at_hand = contact_equations(self.mechanism, Contact(len(limb.joints) - 1))
        self.began = math.inf

    def place(self, q: Sequence[float]) -> None:
        """Put the joints at `q` (n,), rad, at rest."""
        for motor, zero, sign, angle in zip(self._motors, self._zeros, self._signs, q, strict=True):
            motor.angle, motor.velocity = zero + sign * angle, 0.0
        self._rates = [0.0] * len(self._rates)
        self.couple(0.0)

    def angles(self) -> list[float]:
        """Where the joints are (n,), rad: the truth, which no register holds."""
        return [s * (m.angle - z) for m, z, s in zip(self._motors, self._zeros, self._signs, strict=True)]

    def lean(self, force: tuple[float, float, float] | None) -> None:
        """From now on somebody leans on the hand with `force` (3,), N, in the limb frame; None: nobody does."""
        self._leaning = force

    def pushed(self, t: float) -> list[float]:
        """The torques (n,), N m, that the hands that push `t` seconds after `began` have on the joints."""
        total = [0.0] * len(self._motors)
        acting = [(torques, push.force) for push, torques in self._pushes if push.acts(t)]
        if self._leaning:
            acting.append((self._at_hand, self._leaning))
        for torques, force in acting:
            total = [a + b for a, b in zip(total, torques(*self.angles(), *force), strict=True)]
        return total

    def couple(self, now: float) -> None:
        """Load the motors as the links and hands do at `now`, s on the chain's clock."""
        motors, signs, n = self._motors, self._signs, len(self._motors)
        rates = [s * motor.velocity for s, motor in zip(signs, motors, strict=True)]
        change = [(rate - before) / GRID for rate, before in zip(rates, self._rates, strict=True)]
        self._rates = rates
        found = self._equations(*self.angles(), *rates)
        pushed = self.pushed(now - self.began)
        for i, motor in enumerate(motors):
            others = sum(found[n * i + j] * change[j] for j in range(n) if j != i)
            motor.load_inertia = found[n * i + i]
            motor.external = signs[i] * (pushed[i] - found[n * n + i] - others)


class WorldClock(SimulatedClock):
    """Simulated time in which a world goes on: whoever waits lets the links swing."""

    def __init__(self, chain: Chain, world: World) -> None:
        super().__init__()
        self._chain, self._world = chain, world
        self._steps = 0

    def wait(self, seconds: float) -> None:
        """Let that much time pass, from one point of the grid to the next."""
        end = self.now() + max(0.0, seconds)
        while (self._steps + 1) * GRID <= end:
            self._steps += 1
            self._now = self._steps * GRID
            self._chain.advance(self._now)
            self._world.couple(self._now)
        self._now = end
