"""X series firmware: both protocols, PID loops, profiles, indirect addresses, shutdown until reboot."""

import math
from struct import pack_into

from kinlab.dynamixel.codec.instructions import ALERT, BACKUP_KEY, CLEAR_KEY, Parameters
from kinlab.dynamixel.servo.firmware import LONGEST_STEP, Servo, Supply
from kinlab.dynamixel.servo.motor import RPM
from kinlab.dynamixel.servo.profile import Profile
from kinlab.dynamixel.tables import ControlTable, Register

RESULT_FAIL, INSTRUCTION, RANGE, LENGTH, LIMIT, ACCESS = 1, 2, 4, 5, 6, 7
RATES = (9600, 57600, 115200, 1_000_000, 2_000_000, 3_000_000, 4_000_000, 4_500_000)
VELOCITY, POSITION, EXTENDED, PWM = 1, 3, 4, 16
TURN = 4096
FURTHEST = 256 * TURN - 1
FULL_PWM = 885
BOOT_TIME = 0.15  # s; assumed, the makers print none
VELOCITY_TICK = 0.229 * RPM
ACCELERATION_TICK = 214.577 * RPM / 60
WATCHDOG_TICK = 0.02
WATCHDOG_TRIPPED = 255
GAINS = (
    "velocity_i_gain",
    "velocity_p_gain",
    "position_d_gain",
    "position_i_gain",
    "position_p_gain",
    "feedforward_2nd_gain",
    "feedforward_1st_gain",
)
MODE_DEFAULTS = (*GAINS, "profile_acceleration", "profile_velocity", "goal_pwm")
GOALS = frozenset({"goal_position", "goal_velocity", "goal_pwm"})
INDIRECT = range(224, 662)
IN_POSITION, FOLLOWING_ERROR = 20, 150  # ticks; assumed
ERROR_BITS_IN_PROTOCOL_1 = (0, 1 << 6, 1 << 6, 1 << 4, 1 << 3, 1 << 3, 1 << 1, 1 << 3)
BACKED_UP = frozenset((*GAINS, "profile_acceleration", "profile_velocity"))


class XServo(Servo):
    """A servo of the X series; each axis of a 2XL430 is one."""

    home_ticks = 2048
    telemetry = range(120, 147)
    error_instruction = INSTRUCTION
    error_access = ACCESS
    registered = "registered_instruction"

    def __init__(self, table: ControlTable, servo: int, supply: Supply) -> None:
        self._backup: dict[str, int] = {}
        super().__init__(table, servo, supply)

    # Identity and errors.

    def rate(self) -> int:
        return RATES[self.memory["baud_rate"]]

    def rate_code(self, bps: int) -> int:
        return min(range(len(RATES)), key=lambda code: abs(RATES[code] - bps))

    def spoken_protocol(self) -> int:
        return self.memory["protocol_type"]

    @property
    def secondary_id(self) -> int | None:
        value = self.memory["secondary_id"]
        return value if value <= 252 else None

    def error_byte(self, error: int) -> int:
        failed = self.memory["hardware_error_status"]
        if self.protocol == 2:
            return error | (ALERT if failed else 0)
        return failed | ERROR_BITS_IN_PROTOCOL_1[error]

    def identity(self) -> bytes:
        return bytes(self.memory.bytes[0:2] + self.memory.bytes[6:7]) if self.protocol == 2 else b""

    def reads_in_turn(self, instruction: str) -> bool:
        return self.table.fast_reads or not instruction.startswith("FAST")

    # Memory.

    def check(self, address: int, data: bytes, by_secondary: bool) -> int:
        targets = self._targets(address, data)
        if isinstance(targets, int):
            return targets
        for register, part in targets:
            if not register.writable:
                return ACCESS
            if register.area == "EEPROM" and (
                by_secondary or any(a.memory["torque_enable"] for a in self.module)
            ):
                return ACCESS
            error = self._check_value(register, register.decode(part))
            if error:
                return error
        return 0

    def _check_value(self, register: Register, value: int) -> int:
        memory, name = self.memory, register.name
        if self._tripped and name in GOALS:
            return RANGE
        match name:
            case "goal_position":
                low, high, error = self._goal_range
                return 0 if low <= value <= high else error
            case "operating_mode" if value not in (VELOCITY, POSITION, EXTENDED, PWM):
                return RANGE
            case "drive_mode" if any(
                value >> bit & 1 for bit in range(8) if bit not in dict(register.values)
            ):
                return RANGE
            case "id" if any(a.id == value for a in self.module if a is not self):
                return LIMIT
            case "torque_enable" if value and memory["hardware_error_status"]:
                return RESULT_FAIL
        least, most = memory.limits(register)
        if least is not None and value < least:
            return RANGE if register.low.lstrip("-").isdigit() else LIMIT
        if most is not None and value > most:
            return RANGE if register.high.isdigit() else LIMIT
        return 0

    def _targets(self, address: int, data: bytes) -> list[tuple[Register, bytes]] | int:
        """The registers that a write reaches, through indirect addresses too, or the error it brings."""
        by_byte = self.table.by_byte
        register = by_byte.get(address)
        if register and register.address == address and register.size == len(data) and not self._indirect:
            return [(register, data)]
        cells = {self._indirect.get(a, a): byte for a, byte in enumerate(data, address)}
        if not cells or any(a not in by_byte for a in cells):
            return ACCESS
        found = sorted({by_byte[a].address: by_byte[a] for a in cells}.items())
        if not all(r.writable for _, r in found):
            return ACCESS
        if any(a not in cells for _, r in found for a in range(r.address, r.end)):
            return LENGTH
        return [(r, bytes(cells[a] for a in range(r.address, r.end))) for _, r in found]

    def store(self, address: int, data: bytes) -> None:
        targets = self._targets(address, data)
        assert not isinstance(targets, int), "only checked writes are stored"
        self.commit([(register, register.address, part) for register, part in targets])

    def read(self, address: int, count: int) -> tuple[int, bytes]:
        end = address + count
        if not self._indirect or end <= INDIRECT.start or not count or end > self.table.size:
            return super().read(address, count)
        self.measure()
        memory = self.memory.bytes
        return 0, bytes(memory[self._indirect.get(a, a)] for a in range(address, end))

    def settle(self, changed: list[Register]) -> None:
        memory = self.memory
        if len(changed) == 1 and changed[0].name == "goal_position" and not self._wakes:
            self._aim()
            return
        names = {register.name for register in changed}
        for shared in names & {"baud_rate", "protocol_type"}:
            for axis in self.module:
                axis.memory[shared] = memory[shared]
                axis.take_over_eeprom()
        if "operating_mode" in names and memory["operating_mode"] != self._mode:
            for name in MODE_DEFAULTS:
                memory[name] = memory.initial(self.table.by_name[name])
            memory["goal_velocity"] = 0
        if names & GOALS and self._wakes and not memory["hardware_error_status"]:
            memory["torque_enable"] = 1
        if any(name.startswith("indirect_address") for name in names):
            self._map_indirect()
        self._tune(retarget="goal_position" in names)

    def _map_indirect(self) -> None:
        """Where each indirect data byte really stands, for those that do not point to themselves."""
        memory, by_name = self.memory, self.table.by_name
        self._indirect = {}
        for name, register in by_name.items():
            if name.startswith("indirect_data"):
                target = memory[name.replace("data", "address")]
                if target != register.address:
                    self._indirect[register.address] = target

    # Life.

    def start_ram(self) -> None:
        memory = self.memory
        self._booted = self.time
        self._mode = memory["operating_mode"]
        self._enabled = False
        self._integral = 0.0
        self._watchdog_due = math.inf
        self._indirect = {}
        if "startup_configuration" in memory:
            startup = memory["startup_configuration"]
            if startup >> 1 & 1:
                self._take_over({n: v for n, v in self._backup.items() if n in BACKED_UP})
            memory["torque_enable"] = startup & 1
            memory["backup_ready"] = int(bool(self._backup))
        self._drop_turns()
        self.profile = Profile(self.position)
        memory["goal_position"] = round(self.position)
        self._tune()

    def react(self, alarms: set[str]) -> None:
        memory = self.memory
        bits = self.alarm_bits(alarms)
        memory["hardware_error_status"] |= bits
        if bits & memory["shutdown"] and memory["torque_enable"]:
            memory["torque_enable"] = 0
            self._tune()

    def perform(self, instruction: str, parameters: Parameters) -> tuple[int, bytes] | None:
        option = parameters.head.get("option", 0xFF)
        key = parameters.head.get("key")
        match instruction:
            case "REBOOT":
                self._reboot()
            case "FACTORY_RESET":
                return self._factory_reset(int(option)), b""
            case "CLEAR":
                if option != 1 or key != CLEAR_KEY:
                    return RANGE, b""
                if abs(self.plant.velocity) > self._moving_above:
                    return RESULT_FAIL, b""
                self._drop_turns()
                self._tune(retarget=True)
            case "CONTROL_TABLE_BACKUP" if self.table.backup:
                return self._back_up(int(option), key), b""
            case _:
                return None
        return 0, b""

    def _reboot(self) -> None:
        for axis in self.module:
            axis.power_cycle()
            axis.sleep(BOOT_TIME)

    def _factory_reset(self, option: int) -> int:
        kept = {0xFF: (), 1: ("id",), 2: ("id", "baud_rate")}.get(option)
        if kept is None:
            return RANGE
        self.memory.reset("EEPROM", keep=frozenset(kept))
        if "id" not in kept:
            self.memory["id"] = self.module.index(self) + 1
        self.eeprom_writes += 1
        self._reboot()
        return 0

    def _back_up(self, option: int, key: int | bytes | None) -> int:
        memory = self.memory
        if key != BACKUP_KEY or option not in (1, 2):
            return RANGE
        if memory["torque_enable"] or (option == 2 and not self._backup):
            return RESULT_FAIL
        if option == 1:
            indirect = (n for n in self.table.by_name if n.startswith("indirect_address"))
            self._backup = memory.eeprom() | {n: memory[n] for n in (*BACKED_UP, *indirect)}
            memory["backup_ready"] = 1
        else:
            self._take_over(self._backup)
            self.eeprom_writes += 1
            self._reboot()
        return 0

    def _take_over(self, values: dict[str, int]) -> None:
        for name, value in values.items():
            self.memory[name] = value

    def heard(self) -> None:
        self._watchdog_due = self.time + self._patience

    def advance(self, now: float) -> None:
        if now >= self._watchdog_due:
            super().advance(self._watchdog_due)
            self._watchdog_due = math.inf
            memory = self.memory
            memory["bus_watchdog"] = WATCHDOG_TRIPPED
            for name in ("goal_velocity", "goal_pwm", "profile_velocity", "profile_acceleration"):
                memory[name] = 0
            memory["goal_position"] = round(self.position)
            self._tune(retarget=True)
        super().advance(now)

    # Motion.

    @property
    def position(self) -> float:
        """Present Position, not rounded."""
        return self._sign * self.plant.angle / self._radians_per_tick + self._offset

    @property
    def _sign(self) -> int:
        return -1 if self.memory["drive_mode"] & 1 else 1

    def _drop_turns(self) -> None:
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

    def _tune(self, retarget: bool = False) -> None:
        """Turn the registers into what the control loop computes with."""
        memory = self.memory
        mode, enabled = memory["operating_mode"], bool(memory["torque_enable"])
        if mode == POSITION and ((enabled and not self._enabled) or mode != self._mode):
            self._drop_turns()
        self._place_zero()
        if (enabled and not self._enabled) or mode != self._mode:
            self.profile.stop_at(self.position)
            self._integral = 0.0
            if not retarget:
                memory["goal_position"] = round(self.position)
            retarget = True
        self._mode, self._enabled = mode, enabled
        self.follows_position = mode in (POSITION, EXTENDED)
        self._direction = self._sign
        self._wakes = bool(memory["drive_mode"] >> 3 & 1)
        watchdog = memory["bus_watchdog"]
        watching = enabled and watchdog not in (0, WATCHDOG_TRIPPED)
        self._patience = watchdog * WATCHDOG_TICK if watching else math.inf
        self._tripped = watchdog == WATCHDOG_TRIPPED
        if mode == POSITION:
            self._goal_range = (memory["min_position_limit"], memory["max_position_limit"], LIMIT)
        else:
            self._goal_range = (-FURTHEST, FURTHEST, RANGE)
        tick = self._radians_per_tick
        speed, ramp = memory["profile_velocity"], memory["profile_acceleration"]
        self._milliseconds = (speed, ramp) if memory["drive_mode"] >> 2 & 1 else None
        self._profile = (speed * VELOCITY_TICK / tick, ramp * ACCELERATION_TICK / tick)
        self._limit = min(abs(memory["goal_pwm"]), memory["pwm_limit"]) / FULL_PWM
        self._goal_pwm = memory["goal_pwm"] / FULL_PWM
        self._goal_velocity = memory["goal_velocity"] * VELOCITY_TICK
        self._acceleration = memory["profile_acceleration"] * ACCELERATION_TICK
        self._moving_above = memory["moving_threshold"] * VELOCITY_TICK
        self._p = memory["position_p_gain"] / 128 / FULL_PWM
        self._i = memory["position_i_gain"] / 65536 / FULL_PWM * 1000
        self._d = memory["position_d_gain"] / 16 / FULL_PWM / 1000
        self._vp = memory["velocity_p_gain"] / 128 / FULL_PWM / VELOCITY_TICK
        self._vi = memory["velocity_i_gain"] / 65536 / FULL_PWM / VELOCITY_TICK * 1000
        full_speed = self.table.no_load_rpm * RPM / self._radians_per_tick
        if self.follows_position:
            rate = full_speed * (self._p + self._d / self.NOMINAL_LAG)
        else:
            rate = full_speed * self._radians_per_tick * (self._vp / self.NOMINAL_LAG + self._vi)
        self._period = max(0.0005, min(LONGEST_STEP, 0.5 / max(rate, 1e-6)))
        if retarget:
            self._aim()

    NOMINAL_LAG = 0.02

    def _aim(self) -> None:
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
        if not self._enabled:
            return 0.0
        if self.follows_position:
            drive = self._position_loop(dt)
        elif self._mode == VELOCITY:
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
        return self._p * away + self._integral + self._d * faster

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
        following = self.follows_position and self._enabled
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
            int((self.time - self._booted) * 1000) % 32768,
            abs(velocity) > self._moving_above,
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
