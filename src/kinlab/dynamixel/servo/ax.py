"""AX and RX firmware: Protocol 1.0, compliance margin and slope instead of a PID loop."""

import math
from struct import pack_into

from kinlab.dynamixel.codec.instructions import Parameters
from kinlab.dynamixel.servo.firmware import LONGEST_STEP, Servo
from kinlab.dynamixel.servo.motor import RPM
from kinlab.dynamixel.tables import BIT10, Register

RANGE, ANGLE_LIMIT, INSTRUCTION = 1 << 3, 1 << 1, 1 << 6
FULL = 1023
FIRST_UNLOCKED, LAST_UNLOCKED = 24, 35
TURN_TICKS = 1228  # a whole turn, of which the potentiometer sees 1024 ticks
SPEED_TICK = 0.111 * RPM


class AxServo(Servo):
    """A servo whose firmware pushes harder the further it is from its goal, up to the torque limit.

    Three things the manuals leave open are settled here as the makers' own libraries and users' reports
    suggest: a goal outside the angle limits is refused, a goal switches the torque on, and bytes that
    cannot be written are skipped when others in the same packet can.
    """

    home_ticks = 512
    telemetry = range(36, 47)
    error_instruction = INSTRUCTION
    error_access = RANGE
    registered = "registered"

    def rate(self) -> int:
        return round(2_000_000 / (self.memory["baud_rate"] + 1))

    def rate_code(self, bps: int) -> int:
        return max(0, min(254, round(2_000_000 / bps) - 1))

    def spoken_protocol(self) -> int:
        return 1

    def error_byte(self, error: int) -> int:
        return error | self.alarm_bits(self.alarms())

    secondary_id = None

    def heard(self) -> None:
        """Nothing: it has no watchdog."""

    def reads_in_turn(self, instruction: str) -> bool:
        return False

    def start_ram(self) -> None:
        ticks = self._ticks()
        self.memory["goal_position"] = max(0, min(FULL, round(ticks)))
        self._setpoint = ticks
        self._tune()

    def measure(self) -> None:
        ticks = self._ticks() % TURN_TICKS if self._wheel else self._ticks()
        plant, health = self.plant, self.health
        load = min(FULL, round(abs(plant.torque) / self.table.stall_nm * 1000))
        speed = min(FULL, round(abs(plant.velocity) / SPEED_TICK))
        pack_into(
            "<HHHBB",
            self.memory.bytes,
            self.telemetry.start,
            max(0, min(FULL, round(ticks))),
            speed if plant.velocity >= 0 or not speed else speed | BIT10,
            load if plant.torque >= 0 or not load else load | BIT10,
            max(0, min(255, round(self.volts * 10))),
            max(0, min(255, round(health.temperature))),
        )
        goal = self.memory["goal_position"]
        away = self._enabled and not self._wheel and abs(goal - ticks) > max(*self._margins, 3)
        self.memory["moving"] = int(away)

    def check(self, address: int, data: bytes, by_secondary: bool) -> int:
        end = address + len(data)
        memory = self.memory
        if self._locked and not FIRST_UNLOCKED <= address < end <= LAST_UNLOCKED + 1:
            return RANGE
        written = [r for r in self.registers_at(address, len(data)) if r.writable]
        if not written or end > self.table.size:
            return RANGE
        # One byte of a two-byte register may be written: what counts is the value that comes of it.
        after = memory.bytes[: self.table.size]
        after[address:end] = data
        for register in written:
            value = int.from_bytes(after[register.address : register.end], "little")
            low, high = memory.limits(register)
            if (low is not None and value < low) or (high is not None and value > high):
                return RANGE
            if register.name == "goal_position" and not self._wheel:
                lowest, highest = self._goal_range
                if not lowest <= value <= highest:
                    return ANGLE_LIMIT
        return 0

    def settle(self, changed: list[Register]) -> None:
        if self._enabled and len(changed) == 1 and changed[0].name == "goal_position":
            self._goal = float(self.memory["goal_position"])
            return
        names = {register.name for register in changed}
        if self._enabled and not self._wheel and names == {"goal_position", "moving_speed"}:
            self._aim()
            return
        if "goal_position" in names and "torque_enable" not in names:
            self.memory["torque_enable"] = 1
        if "torque_limit" in names and self.memory["torque_limit"]:
            self.health.strained = 0.0
        self._tune()

    def react(self, alarms: set[str]) -> None:
        if self.alarm_bits(alarms) & self.memory["shutdown"]:
            self.memory["torque_limit"] = 0
            self._tune()

    def perform(self, instruction: str, parameters: Parameters) -> tuple[int, bytes] | None:
        if instruction != "FACTORY_RESET":
            return None
        self.memory.reset("EEPROM")
        self.eeprom_writes += 1
        self.power_cycle()
        return 0, b""

    def control(self, dt: float) -> float:
        if not self._enabled or not self._limit:
            self._setpoint = self._ticks()
            return 0.0
        if self._wheel:
            return self._wheel_drive
        ticks = self.plant.angle / self._radians_per_tick
        goal, reach = self._goal, self._speed * dt
        behind = goal - self._setpoint
        if not reach or -reach <= behind <= reach:
            self._setpoint = goal
        else:
            self._setpoint += reach if behind > 0 else -reach
        away = self._setpoint - ticks
        margin, slope = self._ccw if away > 0 else self._cw
        beyond = abs(away) - margin
        if beyond <= 0.0:
            return 0.0
        push = min(self._punch + beyond / slope, self._limit)
        return push if away > 0 else -push

    def control_period(self) -> float:
        return self._period

    def _ticks(self) -> float:
        return math.degrees(self.plant.angle) / self.table.step_deg

    def _tune(self) -> None:
        """Turn the registers into what the control loop computes with."""
        memory = self.memory
        self._radians_per_tick = math.radians(self.table.step_deg)
        self._enabled = bool(memory["torque_enable"])
        self._locked = bool(memory["lock"])
        self._goal_range = (memory["cw_angle_limit"], memory["ccw_angle_limit"])
        self._wheel = self._goal_range == (0, 0)
        self.follows_position = not self._wheel
        self._limit = min(memory["torque_limit"], memory["max_torque"]) / FULL
        self._punch = memory["punch"] / FULL
        self._aim()
        self._wheel_drive = max(-self._limit, min(self._limit, memory["moving_speed"] / FULL))
        self._margins = (memory["cw_compliance_margin"], memory["ccw_compliance_margin"])
        slopes = (_slope(memory["cw_compliance_slope"]), _slope(memory["ccw_compliance_slope"]))
        self._cw, self._ccw = zip(self._margins, slopes, strict=True)
        full_speed = self.table.no_load_rpm * RPM / self._radians_per_tick
        self._period = max(0.0005, min(LONGEST_STEP, 0.5 * min(slopes) / full_speed))

    def _aim(self) -> None:
        """Take over where to go, and how fast."""
        self._goal = float(self.memory["goal_position"])
        self._speed = abs(self.memory["moving_speed"]) * SPEED_TICK / self._radians_per_tick


def _slope(value: int) -> int:
    """The step, of seven, that a compliance slope falls into: the ticks until full torque."""
    return 2 if value < 4 else 1 << value.bit_length() - 1
