"""X series firmware: what may be written, indirect addresses, watchdog, shutdown until reboot."""

import math

from kinlab.dynamixel.codec.instructions import ALERT, BACKUP_KEY, CLEAR_KEY, Parameters
from kinlab.dynamixel.servo.firmware import Supply
from kinlab.dynamixel.servo.x_motion import EXTENDED, POSITION, PWM, TURN, VELOCITY, XMotion
from kinlab.dynamixel.tables import ControlTable, Register

RESULT_FAIL, INSTRUCTION, RANGE, LENGTH, LIMIT, ACCESS = 1, 2, 4, 5, 6, 7
RATES = (9600, 57600, 115200, 1_000_000, 2_000_000, 3_000_000, 4_000_000, 4_500_000)
FURTHEST = 256 * TURN - 1
BOOT_TIME = 0.15  # s; assumed, the makers print none
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
ERROR_BITS_IN_PROTOCOL_1 = (0, 1 << 6, 1 << 6, 1 << 4, 1 << 3, 1 << 3, 1 << 1, 1 << 3)
BACKED_UP = frozenset((*GAINS, "profile_acceleration", "profile_velocity"))


class XServo(XMotion):
    """A servo of the X series; each axis of a 2XL430 is one."""

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
            self.aim()
            return
        names = {register.name for register in changed}
        for shared in names & {"baud_rate", "protocol_type"}:
            for axis in self.module:
                axis.memory[shared] = memory[shared]
                axis.take_over_eeprom()
        if "operating_mode" in names and memory["operating_mode"] != self.mode:
            for name in MODE_DEFAULTS:
                memory[name] = memory.initial(self.table.by_name[name])
            memory["goal_velocity"] = 0
        if names & GOALS and self._wakes and not memory["hardware_error_status"]:
            memory["torque_enable"] = 1
        if any(name.startswith("indirect_address") for name in names):
            self._map_indirect()
        self._take_note(retarget="goal_position" in names)

    def _take_note(self, retarget: bool = False) -> None:
        """Let registers take effect: those that rule writing, and those that rule motion."""
        memory = self.memory
        watchdog = memory["bus_watchdog"]
        watching = memory["torque_enable"] and watchdog not in (0, WATCHDOG_TRIPPED)
        self._patience = watchdog * WATCHDOG_TICK if watching else math.inf
        self._tripped = watchdog == WATCHDOG_TRIPPED
        self._wakes = bool(memory["drive_mode"] >> 3 & 1)
        if memory["operating_mode"] == POSITION:
            self._goal_range = (memory["min_position_limit"], memory["max_position_limit"], LIMIT)
        else:
            self._goal_range = (-FURTHEST, FURTHEST, RANGE)
        self.tune(retarget)

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
        self.booted = self.time
        self._watchdog_due = math.inf
        self._indirect = {}
        if "startup_configuration" in memory:
            startup = memory["startup_configuration"]
            if startup >> 1 & 1:
                self._take_over({n: v for n, v in self._backup.items() if n in BACKED_UP})
            memory["torque_enable"] = startup & 1
            memory["backup_ready"] = int(bool(self._backup))
        self.stand_still()
        self._take_note()

    def react(self, alarms: set[str]) -> None:
        memory = self.memory
        bits = self.alarm_bits(alarms)
        memory["hardware_error_status"] |= bits
        if bits & memory["shutdown"] and memory["torque_enable"]:
            memory["torque_enable"] = 0
            self._take_note()

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
                if abs(self.plant.velocity) > self.moving_above:
                    return RESULT_FAIL, b""
                self.drop_turns()
                self._take_note(retarget=True)
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
            self._take_note(retarget=True)
        super().advance(now)
