"""How an X series servo moves: where it is, its profiles, its PID loops, and what it measures."""

import math
from struct import pack_into

from kinlab.dynamixel.servo.firmware import LONGEST_STEP, Servo
from kinlab.dynamixel.servo.motor import RPM
from kinlab.dynamixel.servo.profile import Profile

VELOCITY, POSITION, EXTENDED, PWM = 1, 3, 4, 16
TURN = 4096
FULL_PWM = 885
VELOCITY_TICK = 0.229 * RPM
ACCELERATION_TICK = 214.577 * RPM / 60
NOMINAL_LAG = 0.02  # s; of the velocity, for choosing the control period
IN_POSITION, FOLLOWING_ERROR = 20, 150  # ticks; assumed


class XMotion(Servo):
    """The moving half of the X series firmware.

    Attributes:
        profile: the set-point between present and goal position (in velocity mode its velocity, in rad/s).
    """

    home_ticks = 2048
    telemetry = range(120, 147)
    profile: Profile
    booted = 0.0

    @property
    def position(self) -> float:
        """Present Position, not rounded."""
        return self._sign * self.plant.angle / self._radians_per_tick + self._offset

    @property
    def _sign(self) -> int:
        return -1 if self.memory["drive_mode"] & 1 else 1

    def drop_turns(self) -> None:
        """Count from the turn that the horn is in."""
        self._radians_per_tick = math.tau / TURN
        self._turns = math.floor(self.plant.angle / math.tau) * TURN
        self._place_zero()

    def _place_zero(self) -> None:
        homing = self.memory["homing_offset"]
        if self.memory["operating_mode"] == POSITION and abs(homing) > TURN // 4:
            homing = 0
        sign = self._sign
        self._offset = (0 if sign > 0 else TURN) - sign * self._turns + homing

    def stand_still(self) -> None:
        """Begin with the horn where it is."""
        self.mode, self.enabled, self._integral = self.memory["operating_mode"], False, 0.0
        self.drop_turns()
        self.profile = Profile(self.position)
        self.memory["goal_position"] = round(self.position)

    def tune(self, retarget: bool = False) -> None:
        """Turn the registers into what the control loop computes with.

        Args:
            retarget: a new goal was set.
        """
        memory = self.memory
        mode, enabled = memory["operating_mode"], bool(memory["torque_enable"])
        if mode == POSITION and ((enabled and not self.enabled) or mode != self.mode):
            self.drop_turns()
        self._place_zero()
        if (enabled and not self.enabled) or mode != self.mode:
            self.profile.stop_at(self.position)
            self._integral = 0.0
            if not retarget:
                memory["goal_position"] = round(self.position)
            retarget = True
        self.mode, self.enabled = mode, enabled
        self.follows_position = mode in (POSITION, EXTENDED)
        self._direction = self._sign
        tick = self._radians_per_tick
        speed, ramp = memory["profile_velocity"], memory["profile_acceleration"]
        self._milliseconds = (speed, ramp) if memory["drive_mode"] >> 2 & 1 else None
        self._profile = (speed * VELOCITY_TICK / tick, ramp * ACCELERATION_TICK / tick)
        self._limit = min(abs(memory["goal_pwm"]), memory["pwm_limit"]) / FULL_PWM
        self._goal_pwm = memory["goal_pwm"] / FULL_PWM
        self._goal_velocity = memory["goal_velocity"] * VELOCITY_TICK
        self._acceleration = memory["profile_acceleration"] * ACCELERATION_TICK
        self.moving_above = memory["moving_threshold"] * VELOCITY_TICK
        self._p = memory["position_p_gain"] / 128 / FULL_PWM
        self._i = memory["position_i_gain"] / 65536 / FULL_PWM * 1000
        self._d = memory["position_d_gain"] / 16 / FULL_PWM / 1000
        self._feed = memory["feedforward_1st_gain"] / 4 / FULL_PWM / 1000
        self._vp = memory["velocity_p_gain"] / 128 / FULL_PWM / VELOCITY_TICK
        self._vi = memory["velocity_i_gain"] / 65536 / FULL_PWM / VELOCITY_TICK * 1000
        full_speed = self.table.no_load_rpm * RPM / self._radians_per_tick
        if self.follows_position:
            rate = full_speed * (self._p + self._d / NOMINAL_LAG)
        else:
            rate = full_speed * self._radians_per_tick * (self._vp / NOMINAL_LAG + self._vi)
        self._period = max(0.0005, min(LONGEST_STEP, 0.5 / max(rate, 1e-6)))
        if retarget:
            self.aim()

    def aim(self) -> None:
        """Start a profile towards the goal."""
        goal = float(self.memory["goal_position"])
        speed, ramp = self._profile
        if self._milliseconds and self._milliseconds[0]:
            whole = self._milliseconds[0]
            part = min(self._milliseconds[1], whole / 2)
            speed = abs(goal - self.profile.position) / (whole - part) * 1000
            ramp = speed / part * 1000 if part else 0.0
        self.profile.go_to(goal, speed, ramp)

    def control(self, dt: float) -> float:
        if not self.enabled:
            return 0.0
        if self.follows_position:
            drive = self._position_loop(dt)
        elif self.mode == VELOCITY:
            drive = self._velocity_loop(dt)
        else:
            drive = self._goal_pwm
        limit = self._limit
        return self._direction * (limit if drive > limit else -limit if drive < -limit else drive)

    def _position_loop(self, dt: float) -> float:
        profile, plant, tick = self.profile, self.plant, self._radians_per_tick
        if profile.position != profile.goal or profile.velocity:
            profile.go_on(dt)
        away = profile.position - (self._direction * plant.angle / tick + self._offset)
        if self._i:
            self._integral = max(-1.0, min(1.0, self._integral + self._i * away * dt))
        faster = profile.velocity - self._direction * plant.velocity / tick
        return self._p * away + self._integral + self._d * faster + self._feed * profile.velocity

    def _velocity_loop(self, dt: float) -> float:
        profile = self.profile
        goal, most = self._goal_velocity, self._acceleration * dt
        if most:
            goal = profile.velocity + max(-most, min(most, goal - profile.velocity))
        profile.velocity = goal
        slower = goal - self._direction * self.plant.velocity
        self._integral = max(-1.0, min(1.0, self._integral + self._vi * slower * dt))
        return self._vp * slower + self._integral

    def control_period(self) -> float:
        return self._period

    def measure(self) -> None:
        plant, profile, tick, sign = self.plant, self.profile, self._radians_per_tick, self._direction
        position = self.position
        velocity = sign * plant.velocity
        following = self.follows_position and self.enabled
        trajectory = profile.velocity * tick if following else profile.velocity
        status = (
            (1 if following and abs(profile.goal - position) <= IN_POSITION else 0)
            | (2 if following and not profile.done else 0)
            | (8 if following and abs(profile.position - position) > FOLLOWING_ERROR else 0)
            | profile.shape << 4
        )
        load = sign * plant.torque / self.table.stall_nm * 1000
        pack_into(
            "<HBBhhiiiiHB",
            self.memory.bytes,
            self.telemetry.start,
            int((self.time - self.booted) * 1000) % 32768,
            abs(velocity) > self.moving_above,
            status,
            round(sign * self.drive * FULL_PWM),
            max(-1000, min(1000, round(load))),
            round(velocity / VELOCITY_TICK),
            _wrap(position),
            round(trajectory / VELOCITY_TICK),
            _wrap(profile.position),
            max(0, round(self.volts * 10)),
            max(0, min(255, round(self.health.temperature))),
        )


def _wrap(ticks: float) -> int:
    """Ticks as a 32-bit counter shows them."""
    return (round(ticks) + 0x80000000) % 0x100000000 - 0x80000000
