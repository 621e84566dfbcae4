"""What the firmware of every model does; the families of models differ in `ax` and `x`."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

from kinlab.dynamixel.codec.instructions import BY_CODE, Instruction, Parameters, unpack
from kinlab.dynamixel.codec.packets import Packet
from kinlab.dynamixel.servo.health import Health
from kinlab.dynamixel.servo.memory import Memory
from kinlab.dynamixel.servo.motor import GearMotor, Plant
from kinlab.dynamixel.tables import ControlTable, Register
from kinlab.errors import UsageError

LONGEST_STEP = 0.005  # s; control period of the position loop at most
# Where nothing changes but the temperature; and where that lasts only until an overload is one.
IDLE_STEP, STRAINED_STEP = 10.0, 0.1  # s


# What a supply for servos may give, V: beyond that nobody means it.
MOST_VOLTS = 48.0


@dataclass
class Supply:
    """What feeds a chain: `volts` at the source, and the resistance of the cable to each servo in ohms."""

    volts: float = 12.0
    ohms: float = 0.1


class Servo(ABC):
    """One servo (one axis): its memory, firmware and motor. Nothing happens in it until it is asked.

    `advance` brings it up to a moment; whatever was due before then happens in order.

    Attributes:
        module: the axes that share this servo's case, bus interface and power; itself among them.
        plant: what the firmware drives; another one may be put in its place.
        forced: alarms that a fault injection holds on, by name ("overheating").
        dead: it neither hears nor answers.
        baud, protocol: of the bus, in bps and as 1 or 2; `return_delay`: before an answer, s.
        eeprom_writes: counts changes of what outlives a power cycle.
    """

    def __init__(self, table: ControlTable, servo: int, supply: Supply) -> None:
        self.table = table
        self.memory = Memory(table)
        self.memory["id"] = servo
        self.supply = supply
        self.plant: Plant = GearMotor(table, math.radians(table.step_deg * self.home_ticks))
        self.health = Health(table)
        self.module: list[Servo] = [self]
        self.forced: set[str] = set()
        self.dead = False
        self.eeprom_writes = 0
        self.time = 0.0
        self.drive = 0.0
        self._id_address = table.by_name["id"].address
        self._spans: dict[tuple[int, int], list[Register]] = {}
        self._kept_back: tuple[int, bytes] | None = None
        self._asleep_until = 0.0
        self._start()

    # What a family of models must say.

    home_ticks: int
    telemetry: range  # the addresses that measured values stand at

    @abstractmethod
    def measure(self) -> None:
        """Write the measured values into the memory."""

    @abstractmethod
    def check(self, address: int, data: bytes, by_secondary: bool) -> int:
        """The error that writing `data` at `address` would bring, 0 for none."""

    @abstractmethod
    def settle(self, changed: list[Register]) -> None:
        """Take note of registers that were written."""

    @abstractmethod
    def control(self, dt: float) -> float:
        """The drive (-1 to 1) for the next `dt` seconds."""

    @abstractmethod
    def control_period(self) -> float:
        """The longest step, s, that keeps the loop that `control` closes true."""

    @abstractmethod
    def react(self, alarms: set[str]) -> None:
        """Report alarms, and switch the torque off where the Shutdown register says so."""

    @abstractmethod
    def start_ram(self) -> None:
        """Set up what follows from the RAM's initial values after power-on."""

    @abstractmethod
    def perform(self, instruction: str, parameters: Parameters) -> tuple[int, bytes] | None:
        """Carry out an instruction beyond those below: error and data, None if it is not known."""

    @abstractmethod
    def rate(self) -> int:
        """Speed of the bus in bps, as the memory has it."""

    @abstractmethod
    def rate_code(self, bps: int) -> int:
        """The value of the Baud Rate register that comes nearest to a speed."""

    @abstractmethod
    def spoken_protocol(self) -> int:
        """1 or 2, as the memory has it."""

    @abstractmethod
    def error_byte(self, error: int) -> int:
        """An answer's error byte: `error`, and what tells of alarms."""

    @abstractmethod
    def heard(self) -> None:
        """Take note that the bus is alive."""

    @abstractmethod
    def reads_in_turn(self, instruction: str) -> bool:
        """Whether it takes part in a read of many servos of that kind."""

    @property
    @abstractmethod
    def secondary_id(self) -> int | None:
        """The second address, which is obeyed without an answer; None when there is none."""

    error_instruction: int  # what an unknown instruction brings
    error_access: int  # what an address that cannot be reached brings
    registered: str  # the register that tells of a pending REG_WRITE
    follows_position: bool  # whether the drive depends on where the horn is

    # Power.

    @property
    def id(self) -> int:
        return self.memory.bytes[self._id_address]

    @property
    def volts(self) -> float:
        """At the servo, with what its current costs on the cable."""
        return max(0.0, self.supply.volts - self.supply.ohms * self.plant.current)

    @property
    def powered(self) -> bool:
        return self.supply.volts >= self.table.lowest_v

    @property
    def hears(self) -> bool:
        """Whether it is powered, alive and not just restarting."""
        return self.powered and not self.dead and self.time >= self._asleep_until

    def begin(self, now: float) -> None:
        """Be switched on at `now` (s, on the chain's clock)."""
        self.time = now
        self.power_cycle()

    def power_cycle(self) -> None:
        """What a loss of power leaves: the EEPROM, and the horn where it was."""
        self.memory.reset("RAM")
        self._start()

    def sleep(self, seconds: float) -> None:
        """Be deaf for a while, as a restarting servo is."""
        self._asleep_until = self.time + seconds

    def restore(self, eeprom: dict[str, int]) -> None:
        """Take over what an earlier life stored.

        Raises:
            UsageError: a value that its register cannot hold.
            KeyError: a register that there is not.
        """
        for name, value in eeprom.items():
            low, high = self.memory.limits(self.table.by_name[name])
            if not (low is None or low <= value) or not (high is None or value <= high):
                raise UsageError(f"{name} cannot be {value}")
            self.memory[name] = value
        self.power_cycle()

    def set_baud(self, bps: int) -> None:
        """Take the nearest speed that the model has."""
        self.memory["baud_rate"] = self.rate_code(bps)
        self.take_over_eeprom()

    def take_over_eeprom(self) -> None:
        """Note what the EEPROM says about bus and alarms: it is needed too often to be decoded each time."""
        memory = self.memory
        self.baud = self.rate()
        self.protocol = self.spoken_protocol()
        self.return_delay = memory["return_delay_time"] * 2e-6
        self._bounds = (
            memory["min_voltage_limit"] / 10,
            memory["max_voltage_limit"] / 10,
            float(memory["temperature_limit"]),
        )

    def _start(self) -> None:
        self._kept_back = None
        self.take_over_eeprom()
        self.drive = 0.0
        self.health.strained = 0.0
        self.start_ram()
        self.measure()

    # Time.

    def advance(self, now: float) -> None:
        """Let time pass until `now` (s, on the chain's clock)."""
        left = now - self.time
        if left <= 0.0:
            return
        plant, health = self.plant, self.health
        supply, control = self.supply, self.control
        low, high, hot = self._bounds
        powered = self.powered
        period = self.control_period()
        while left > 0.0:
            step = left if left <= period else left / math.ceil(left / period)
            velocity, angle, drive = plant.velocity, plant.angle, self.drive
            volts = supply.volts - supply.ohms * plant.current
            self.drive = control(step) if powered else 0.0
            plant.step(self.drive, volts, step)
            health.go_on(plant.torque, plant.current, step)
            left = left - step if left > step else 0.0
            self.time = now - left
            if not low <= volts <= high or health.temperature > hot or health.overloaded or self.forced:
                self.react(self.alarms())
            # Where nothing changes any more, long steps are as good as short ones.
            if self.drive == drive and abs(plant.velocity - velocity) < 1e-9:
                if plant.angle == angle or not self.follows_position:
                    period = STRAINED_STEP if health.strained else IDLE_STEP
            elif period > LONGEST_STEP:
                period = self.control_period()
        self.time = now

    def alarms(self) -> set[str]:
        """What is wrong now, by the names that the Shutdown register's bits have."""
        low, high, hot = self._bounds
        found = set(self.forced)
        if not low <= self.volts <= high:
            found.add("input voltage")
        if self.health.temperature > hot:
            found.add("overheating")
        if self.health.overloaded:
            found.add("overload")
        return found

    def alarm_bits(self, names: set[str]) -> int:
        """Alarms as the bits that this model gives them."""
        return sum(1 << bit for bit, name in self.table.by_name["shutdown"].values if name in names)

    # Instructions.

    def obey(self, packet: Packet, by_secondary: bool = False) -> tuple[int, bytes]:
        """Carry out an instruction addressed to this servo: the error and the data of its answer."""
        instruction = BY_CODE[packet.protocol].get(packet.code)
        parameters = unpack(instruction, packet.params) if instruction else None
        if instruction is None or parameters is None:
            return self.error_instruction, b""
        return self._dispatch(instruction, parameters, by_secondary)

    def _dispatch(
        self, instruction: Instruction, parameters: Parameters, by_secondary: bool
    ) -> tuple[int, bytes]:
        head = parameters.head
        match instruction.name:
            case "PING":
                return 0, self.identity()
            case "READ":
                return self.read(int(head["address"]), int(head["count"]))
            case "WRITE":
                return self.write(int(head["address"]), bytes(head["data"]), by_secondary), b""
            case "REG_WRITE":
                return self._keep_back(int(head["address"]), bytes(head["data"]), by_secondary), b""
            case "ACTION":
                return self._act(), b""
        done = self.perform(instruction.name, parameters)
        return (self.error_instruction, b"") if done is None else done

    def identity(self) -> bytes:
        """What PING returns besides the id: nothing, or (Protocol 2.0) model number and firmware version."""
        return b""

    def read(self, address: int, count: int) -> tuple[int, bytes]:
        """The bytes that stand at `address` now."""
        end = address + count
        if count == 0 or end > self.table.size:
            return self.error_access, b""
        if address < self.telemetry.stop and end > self.telemetry.start:
            self.measure()
        return 0, bytes(self.memory.bytes[address:end])

    def write(self, address: int, data: bytes, by_secondary: bool = False) -> int:
        """Store bytes if the rules allow it: all of them, or none; the error."""
        error = self.check(address, data, by_secondary)
        if not error:
            self.store(address, data)
        return error

    def store(self, address: int, data: bytes) -> None:
        """Store bytes that have been checked; those that cannot be written are skipped."""
        parts = []
        for register in self.registers_at(address, len(data)):
            if register.writable:
                first, last = max(address, register.address), min(address + len(data), register.end)
                parts.append((register, first, data[first - address : last - address]))
        self.commit(parts)

    def commit(self, parts: list[tuple[Register, int, bytes]]) -> None:
        """Put bytes of registers at their addresses, and let the firmware take note."""
        for register, address, part in parts:
            self.memory.bytes[address : address + len(part)] = part
            if register.area == "EEPROM":
                self.eeprom_writes += 1
                self.take_over_eeprom()
        self.settle([register for register, _, _ in parts])

    def registers_at(self, address: int, count: int) -> list[Register]:
        """The registers that those bytes belong to."""
        found = self._spans.get((address, count))
        if found is None:
            found = self._spans[address, count] = list(self.table.over(address, count))
        return found

    def _keep_back(self, address: int, data: bytes, by_secondary: bool) -> int:
        error = self.check(address, data, by_secondary)
        if not error:
            self._kept_back = (address, data)
            self.memory[self.registered] = 1
        return error

    def _act(self) -> int:
        if self._kept_back is None:
            return self.error_instruction
        address, data = self._kept_back
        self._kept_back = None
        self.memory[self.registered] = 0
        return self.write(address, data)
